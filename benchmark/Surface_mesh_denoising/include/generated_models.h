// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangle meshes of known surfaces, for tests, benchmarks and the demo. Each vertex lies on the surface, sharp edges
// of the surface are edges of the mesh, the normals point outwards, and no face is degenerate.

#ifndef SURFACE_MESH_DENOISING_GENERATED_MODELS_H
#define SURFACE_MESH_DENOISING_GENERATED_MODELS_H

#include <CGAL/Surface_mesh_denoising/internal/Random_numbers.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace generated_models {

typedef CGAL::Simple_cartesian<double>::Point_3  Point;
typedef CGAL::Simple_cartesian<double>::Vector_3 Vector;

constexpr double pi = 3.14159265358979323846;

enum class Triangles
{
  REGULAR,  // a grid, all diagonals in the same direction
  IRREGULAR // vertices shifted at random along the surface, or along the sharp edge, and random diagonals
};

struct Options
{
  std::size_t number_of_vertices = 10000; // approximately
  Triangles triangles = Triangles::REGULAR;
  std::uint64_t seed = 0;
};

struct Model
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3> > triangles;
};

template <typename TriangleMesh>
TriangleMesh to_mesh(const Model& model)
{
  typedef typename CGAL::GetVertexPointMap<TriangleMesh>::type Point_map;
  typedef typename boost::property_traits<Point_map>::value_type Mesh_point;
  typedef typename CGAL::Kernel_traits<Mesh_point>::Kernel::FT FT;

  std::vector<Mesh_point> points;
  points.reserve(model.points.size());
  for(const Point& p : model.points)
    points.emplace_back(FT(p.x()), FT(p.y()), FT(p.z()));
  TriangleMesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, model.triangles, mesh);
  return mesh;
}

// the vertices where x is larger than in the mean
template <typename TriangleMesh>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices_on_one_side(const TriangleMesh& mesh)
{
  const auto points = get(CGAL::vertex_point, mesh);
  double sum = 0;
  for(const auto v : vertices(mesh))
    sum += CGAL::to_double(get(points, v).x());
  const double mean = sum / double(num_vertices(mesh));
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> result;
  for(const auto v : vertices(mesh))
    if(get(points, v).x() > mean)
      result.push_back(v);
  return result;
}

// the model, scaled by the square of the distance from its first point: triangles are small there, and large far away
inline Model uneven(Model model)
{
  const Point center = model.points.front();
  for(Point& p : model.points)
    p = center + (p - center).squared_length() * (p - center);
  return model;
}

// a surface made of patches. Each patch is the image of the unit square, covered with a grid.
// Patches are sewn where a side of the one has the same end points and the same midpoint as a side of the other
class Patchwork
{
  typedef std::vector<std::pair<std::size_t, double> > Side; // vertices, and their parameters along the side
  typedef std::array<long long, 3> Point_key;
  typedef std::function<Point(double, double)> Map;
  struct Patch { double length_u, length_v; Map map; };

public:
  // adds the image of the unit square under `map(u, v)`. The derivative by u, the derivative by v and the outward
  // normal are right-handed. The lengths are about those of the sides; patches state the same for a common side
  void add(const double length_u, const double length_v, const Map& map)
  {
    m_patches.push_back(Patch{ length_u, length_v, map });
  }

  Model sew(const Options& options)
  {
    double area = 0;
    for(const Patch& p : m_patches)
      area += p.length_u * p.length_v;
    const double edge_length = std::sqrt(area / double(options.number_of_vertices));
    const auto number_of_edges = [=](const double length)
    {
      return (std::max)(1, int(std::lround(length / edge_length)));
    };

    m_jitter = (options.triangles == Triangles::IRREGULAR) ? 0.2 : 0;
    m_random = Random(options.seed);
    for(const Patch& p : m_patches)
      add_grid(number_of_edges(p.length_u), number_of_edges(p.length_v), p.map);
    return std::move(m_model);
  }

private:
  typedef CGAL::Surface_mesh_denoising::internal::Random_numbers Random;

  void add_grid(const int nu, const int nv, const Map& map)
  {
    const Side bottom = side(nu, [&](const double t) { return map(t, 0); });
    const Side top = side(nu, [&](const double t) { return map(t, 1); });
    const Side left = side(nv, [&](const double t) { return map(0, t); });
    const Side right = side(nv, [&](const double t) { return map(1, t); });

    std::vector<std::size_t> lower, upper;
    for(const auto& vertex : bottom)
      lower.push_back(vertex.first);
    for(int j=1; j<=nv; ++j)
    {
      upper.clear();
      for(int i=0; i<=nu; ++i)
      {
        if(j == nv)
          upper.push_back(top[i].first);
        else if(i == 0)
          upper.push_back(left[j].first);
        else if(i == nu)
          upper.push_back(right[j].first);
        else
        {
          const double u = shifted(i, nu);
          upper.push_back(add_point(map(u, shifted(j, nv))));
        }
      }
      for(int i=0; i<nu; ++i)
        add_cell(lower[i], lower[i+1], upper[i+1], upper[i]);
      lower.swap(upper);
    }
  }

  double shifted(const int i, const int n)
  {
    return (m_jitter > 0) ? (i + m_jitter * (2 * m_random.uniform() - 1)) / n : double(i) / n;
  }

  std::size_t add_point(const Point& p)
  {
    m_model.points.push_back(p);
    return m_model.points.size() - 1;
  }

  void add_cell(const std::size_t a, const std::size_t b, const std::size_t c, const std::size_t d)
  {
    if(m_jitter > 0 && m_random.uniform() < 0.5)
    {
      m_model.triangles.push_back({{ a, b, d }});
      m_model.triangles.push_back({{ b, c, d }});
    }
    else
    {
      m_model.triangles.push_back({{ a, b, c }});
      m_model.triangles.push_back({{ a, c, d }});
    }
  }

  // equal for points that differ by rounding; the odd offset keeps the models' points off the borders of the cells
  static Point_key key(const Point& p)
  {
    Point_key k;
    for(int i=0; i<3; ++i)
      k[i] = std::llround(p[i] * 1e7 + 0.1415926535);
    return k;
  }

  std::size_t corner(const Point& p)
  {
    const auto found = m_corners.emplace(key(p), m_model.points.size());
    return found.second ? add_point(p) : found.first->second;
  }

  template <typename Curve>
  Side side(const int n, const Curve& curve)
  {
    const Point_key first = key(curve(0)), middle = key(curve(0.5)), last = key(curve(1));
    const bool is_reversed = last < first;
    const std::array<Point_key, 3> side_key = {{ is_reversed ? last : first, middle, is_reversed ? first : last }};

    auto found = m_sides.find(side_key);
    if(found == m_sides.end())
    {
      const auto from_lower_end = [&](const double t) { return curve(is_reversed ? 1 - t : t); };
      Side s;
      for(int i=0; i<=n; ++i)
      {
        const double t = (i == 0 || i == n) ? double(i / n) : shifted(i, n);
        s.emplace_back((i == 0 || i == n) ? corner(from_lower_end(t)) : add_point(from_lower_end(t)), t);
      }
      found = m_sides.emplace(side_key, s).first;
    }
    if(found->second.size() != std::size_t(n) + 1)
      throw std::logic_error("two patches divide their common side differently");

    Side result = found->second;
    if(is_reversed)
      std::reverse(result.begin(), result.end());
    return result;
  }

  std::vector<Patch> m_patches;
  Model m_model;
  double m_jitter = 0;
  Random m_random = Random(0);
  std::map<Point_key, std::size_t> m_corners;
  std::map<std::array<Point_key, 3>, Side> m_sides;
};

inline Point lerp(const Point& p, const Point& q, const double t) { return p + t * (q - p); }

// a planar or ruled patch between four corners, counterclockwise
inline void add_quad(Patchwork& patches, const double length_u, const double length_v,
                     const Point& a, const Point& b, const Point& c, const Point& d)
{
  patches.add(length_u, length_v, [=](const double u, const double v)
  {
    return lerp(lerp(a, b, u), lerp(d, c, u), v);
  });
}

// a planar polygon, counterclockwise, in one patch for each corner; `length` is that of half a side
inline void add_polygon(Patchwork& patches, const double length, const std::vector<Point>& corners)
{
  const std::size_t m = corners.size();
  Vector sum(0, 0, 0);
  for(const Point& p : corners)
    sum = sum + (p - CGAL::ORIGIN);
  const Point center = CGAL::ORIGIN + sum / double(m);
  for(std::size_t i=0; i<m; ++i)
  {
    const Point& p = corners[i];
    add_quad(patches, length, length, p, lerp(p, corners[(i+1)%m], 0.5), center, lerp(p, corners[(i+m-1)%m], 0.5));
  }
}

// the image of a disc under `map(x, y)`: a square of `pieces` times `pieces` patches and 4 `pieces` patches around it.
// `rim(t)`, t in [0, 4], runs once around the disc, counterclockwise, a quarter turn for each unit, from -135 degrees.
// `length` is that of a piece of the rim, `radial_length` that of the way from the rim to the square
template <typename Rim, typename Map>
void add_disc(Patchwork& patches, const int pieces, const double length, const double radial_length,
              const Rim& rim, const Map& map)
{
  // the sides bulge, for all the angles at a corner of the square to be about the same
  const auto inner = [](const double x, const double y)
  {
    return std::array<double, 2>{{ 0.45 * x * (1 + 0.15 * (1 - y*y)), 0.45 * y * (1 + 0.15 * (1 - x*x)) }};
  };
  for(int i=0; i<pieces; ++i)
    for(int j=0; j<pieces; ++j)
      patches.add(length, length, [=](const double u, const double v)
      {
        const std::array<double, 2> p = inner(2 * (i + u) / pieces - 1, 2 * (j + v) / pieces - 1);
        return map(p[0], p[1]);
      });

  for(int quarter=0; quarter<4; ++quarter)
    for(int i=0; i<pieces; ++i)
      patches.add(length, radial_length, [=](const double u, const double v)
      {
        // u runs clockwise, v outwards
        const double s = (i + 1 - u) / pieces;
        const double x[4] = { 2*s - 1, 1, 1 - 2*s, -1 }, y[4] = { -1, 2*s - 1, 1, 1 - 2*s };
        const std::array<double, 2> p = inner(x[quarter], y[quarter]), q = rim(quarter + s);
        return map(p[0] + v * (q[0] - p[0]), p[1] + v * (q[1] - p[1]));
      });
}

inline std::array<double, 2> unit_circle(const double t)
{
  const double angle = (t - 1.5) * (pi / 2);
  return {{ std::cos(angle), std::sin(angle) }};
}

// the box [-a, a] x [-b, b] x [-c, c]
inline Model box(const Options& options, const double a, const double b, const double c)
{
  Patchwork patches;
  const auto p = [=](const int i, const int j, const int k) { return Point(i*a, j*b, k*c); };
  add_quad(patches, a, b, p(-1, -1, 1), p(1, -1, 1), p(1, 1, 1), p(-1, 1, 1));
  add_quad(patches, b, a, p(-1, -1, -1), p(-1, 1, -1), p(1, 1, -1), p(1, -1, -1));
  add_quad(patches, b, c, p(1, -1, -1), p(1, 1, -1), p(1, 1, 1), p(1, -1, 1));
  add_quad(patches, c, b, p(-1, -1, -1), p(-1, -1, 1), p(-1, 1, 1), p(-1, 1, -1));
  add_quad(patches, c, a, p(-1, 1, -1), p(-1, 1, 1), p(1, 1, 1), p(1, 1, -1));
  add_quad(patches, a, c, p(-1, -1, -1), p(1, -1, -1), p(1, -1, 1), p(-1, -1, 1));
  return patches.sew(options);
}

// the cube [-1, 1]^3
inline Model cube(const Options& options) { return box(options, 1, 1, 1); }

// a square plate of side 2, as thick as a thirtieth of that
constexpr double plate_thickness = 2. / 30;
inline Model thin_plate(const Options& options) { return box(options, 1, 1, plate_thickness / 2); }

// radius 1, height 2, the axis of z
inline Model cylinder(const Options& options)
{
  Patchwork patches;
  const double quarter = pi / 2, radial = 0.42;
  for(int k=0; k<4; ++k)
    patches.add(quarter, 2, [=](const double u, const double v)
    {
      const std::array<double, 2> p = unit_circle(k + u);
      return Point(p[0], p[1], 2*v - 1);
    });
  add_disc(patches, 1, quarter, radial, unit_circle, [](const double x, const double y) { return Point(x, y, 1); });
  add_disc(patches, 1, quarter, radial, unit_circle, [](const double x, const double y) { return Point(x, -y, -1); });
  return patches.sew(options);
}

// base radius 1 at z = 0, apex at z = 1.5
constexpr double cone_height = 1.5;
inline Model cone(const Options& options)
{
  Patchwork patches;
  const double eighth = pi / 4, radial = 0.6;
  // the middle of an even number of patches is a vertex: the apex
  add_disc(patches, 2, eighth, radial, unit_circle, [](const double x, const double y)
  {
    return Point(x, y, cone_height * (1 - std::sqrt(x*x + y*y)));
  });
  add_disc(patches, 2, eighth, radial, unit_circle, [](const double x, const double y) { return Point(x, -y, 0); });
  return patches.sew(options);
}

// `m` faces meet at the apex (0, 0, 1); the base is a regular polygon in the unit circle
inline Model pyramid(const Options& options, const int m)
{
  Patchwork patches;
  const double length = (2 * std::sin(pi / m) + std::sqrt(2.)) / 4; // the mean of the two kinds of edges
  std::vector<Point> base;
  for(int k=0; k<m; ++k)
    base.emplace_back(std::cos(2 * pi * k / m), std::sin(2 * pi * k / m), 0);
  for(int k=0; k<m; ++k)
    add_polygon(patches, length, { base[k], base[(k+1)%m], Point(0, 0, 1) });
  std::reverse(base.begin(), base.end());
  add_polygon(patches, length, base);
  return patches.sew(options);
}

inline Model pyramid_3(const Options& options) { return pyramid(options, 3); }
inline Model pyramid_4(const Options& options) { return pyramid(options, 4); }
inline Model pyramid_5(const Options& options) { return pyramid(options, 5); }
inline Model pyramid_6(const Options& options) { return pyramid(options, 6); }

// a prism of height 2 over a regular polygon with 12 sides in the unit circle: edges of 150 degrees
inline Model obtuse_prism(const Options& options)
{
  const double side = 2 * std::sin(pi / 12), radial = 0.4;
  const auto rim = [](const double t)
  {
    const double k = (std::min)(std::floor(3 * t), 11.), s = 3*t - k;
    const std::array<double, 2> p = unit_circle(k / 3), q = unit_circle((k + 1) / 3);
    return std::array<double, 2>{{ p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1]) }};
  };
  Patchwork patches;
  for(int k=0; k<12; ++k)
    patches.add(side, 2, [=](const double u, const double v)
    {
      const std::array<double, 2> p = rim((k + u) / 3);
      return Point(p[0], p[1], 2*v - 1);
    });
  add_disc(patches, 3, side, radial, rim, [](const double x, const double y) { return Point(x, y, 1); });
  // the polygon is its own mirror image
  add_disc(patches, 3, side, radial, rim, [](const double x, const double y) { return Point(x, -y, -1); });
  return patches.sew(options);
}

// the corners of the square [-1, 1]^2, counterclockwise, the first one again at the end
constexpr double square_x[5] = { -1, 1, 1, -1, -1 };
constexpr double square_y[5] = { -1, -1, 1, 1, -1 };

// a square prism of side 2 and height 4, twisted by a quarter turn
constexpr double twirl_height = 4;
inline Model twirl(const Options& options)
{
  const double helix_length = 1.1 * twirl_height;
  const auto twisted = [](const double x, const double y, const double z)
  {
    const double angle = (pi / 2) * z / twirl_height, c = std::cos(angle), s = std::sin(angle);
    return Point(c*x - s*y, s*x + c*y, z);
  };
  Patchwork patches;
  for(int k=0; k<4; ++k)
    patches.add(2, helix_length, [=](const double u, const double v)
    {
      return twisted(square_x[k] + u * (square_x[k+1] - square_x[k]),
                     square_y[k] + u * (square_y[k+1] - square_y[k]), v * twirl_height);
    });
  patches.add(2, 2, [=](const double u, const double v) { return twisted(2*u - 1, 2*v - 1, twirl_height); });
  patches.add(2, 2, [=](const double u, const double v) { return twisted(2*v - 1, 2*u - 1, 0); });
  return patches.sew(options);
}

// the saddle z = (x^2 - y^2) / 2 over [-1, 1]^2: a surface with a border
inline Model saddle(const Options& options)
{
  Patchwork patches;
  patches.add(1, 1, [](const double u, const double v)
  {
    const double x = 2*u - 1, y = 2*v - 1;
    return Point(x, y, (x*x - y*y) / 2);
  });
  return patches.sew(options);
}

// radii 1 and 0.4
constexpr double torus_minor_radius = 0.4;
inline Model torus(const Options& options)
{
  const double r = torus_minor_radius;
  Patchwork patches;
  for(int i=0; i<3; ++i)
    for(int j=0; j<3; ++j)
      patches.add(1, r, [=](const double u, const double v)
      {
        const double a = 2 * pi * (i + u) / 3, b = 2 * pi * (j + v) / 3;
        return Point((1 + r * std::cos(b)) * std::cos(a), (1 + r * std::cos(b)) * std::sin(a), r * std::sin(b));
      });
  return patches.sew(options);
}

// the unit vector given by a face of the cube around the unit sphere and equiangular coordinates in [-1, 1]
inline Vector cube_direction(const int face, const double a, const double b)
{
  const double x = std::tan(a * pi / 4), y = std::tan(b * pi / 4);
  const Vector v = (face == 0) ? Vector(1, x, y)  : (face == 1) ? Vector(y, 1, x)  : (face == 2) ? Vector(x, y, 1)
                 : (face == 3) ? Vector(-1, y, x) : (face == 4) ? Vector(x, -1, y) : Vector(y, x, -1);
  return v / std::sqrt(v.squared_length());
}

// the surface with the given radius in each direction
template <typename Radius>
Model star_shaped(const Options& options, const Radius& radius)
{
  Patchwork patches;
  for(int face=0; face<6; ++face)
    patches.add(1, 1, [=](const double u, const double v)
    {
      const Vector d = cube_direction(face, 2*u - 1, 2*v - 1);
      return CGAL::ORIGIN + radius(d) * d;
    });
  return patches.sew(options);
}

// radius 1
inline Model sphere(const Options& options)
{
  return star_shaped(options, [](const Vector&) { return 1.; });
}

// the distance of the surface of organic_shape() from the origin: long waves, bumps, and short waves in some places
inline double organic_radius(const Vector& d)
{
  const double waves = 0.16 * std::sin(2.1 * d.x() + 1.3 * d.y() - 0.4)
                     + 0.10 * std::sin(3.7 * d.z() - 1.9 * d.x() + 0.8);
  const double bumps = 0.06 * std::sin(6.3 * d.y() + 5.1 * d.z() + 2.2) * std::sin(6.7 * d.x() - 0.3);
  const double place = 0.5 + 0.5 * std::sin(2.3 * d.x() - 2.9 * d.z() + 0.5);
  const double detail = std::sin(19 * d.x() + 7 * d.y()) * std::sin(17 * d.y() - 8 * d.z() + 1);
  return 1 + waves + bumps + 0.015 * place * place * detail;
}

// smooth, with fine detail: what a scan of something grown looks like
inline Model organic_shape(const Options& options) { return star_shaped(options, organic_radius); }

// the unit sphere with three flat cuts, and opposite to each a cylindrical hole with a flat bottom
constexpr double cut_radius = 0.5;
constexpr double hole_depth = 0.3;
inline Model cut_sphere(const Options& options)
{
  const double cut_height = std::sqrt(1 - cut_radius * cut_radius);
  const double quarter_length = 1, ring = 0.3, radial = 0.42 * cut_radius;
  Patchwork patches;
  for(int face=0; face<6; ++face)
  {
    // two directions in the face, and the one away from the center
    const Vector z = cube_direction(face, 0, 0);
    const Vector x = (face % 3 == 0) ? Vector(0, 1, 0) : (face % 3 == 1) ? Vector(0, 0, 1) : Vector(1, 0, 0);
    const Vector y = cross_product(z, x);
    const auto at = [=](const double a, const double b, const double c) { return CGAL::ORIGIN + a*x + b*y + c*z; };
    const bool is_hole = face < 3;

    for(int quarter=0; quarter<4; ++quarter)
    {
      patches.add(quarter_length, ring, [=](const double u, const double v)
      {
        const double s = 1 - u, along = std::tan((2*s - 1) * pi / 4);
        const double a[4] = { along, 1, -along, -1 }, b[4] = { -1, along, 1, -along };
        const Vector outer = a[quarter] * x + b[quarter] * y + z;
        const std::array<double, 2> rim = unit_circle(quarter + s);
        const Vector inner = cut_radius * (rim[0] * x + rim[1] * y) + cut_height * z;
        const Vector d = (1 - v) * inner + v * outer / std::sqrt(outer.squared_length());
        return CGAL::ORIGIN + d / std::sqrt(d.squared_length());
      });
      if(is_hole)
        patches.add(quarter_length, hole_depth, [=](const double u, const double v)
        {
          const std::array<double, 2> rim = unit_circle(quarter + u);
          return at(cut_radius * rim[0], cut_radius * rim[1], cut_height - hole_depth * v);
        });
    }
    const double height = is_hole ? cut_height - hole_depth : cut_height;
    add_disc(patches, 1, quarter_length, radial, unit_circle, [=](const double a, const double b)
    {
      return at(cut_radius * a, cut_radius * b, height);
    });
  }
  return patches.sew(options);
}

// a block [-1, 1]^2 x [-0.5, 0.5] with a hole of radius 0.5 along the axis of z
constexpr double drill_radius = 0.5;
inline Model drilled_block(const Options& options)
{
  const double length = 1.5, height = 1, ring = 0.65;
  Patchwork patches;
  for(int k=0; k<4; ++k)
  {
    const auto outer = [=](const double s, const double z)
    {
      return Point(square_x[k] + s * (square_x[k+1] - square_x[k]), square_y[k] + s * (square_y[k+1] - square_y[k]), z);
    };
    const auto inner = [=](const double s, const double z)
    {
      const std::array<double, 2> p = unit_circle(k + s);
      return Point(drill_radius * p[0], drill_radius * p[1], z);
    };
    patches.add(length, height, [=](const double u, const double v) { return outer(u, v - 0.5); });
    patches.add(length, height, [=](const double u, const double v) { return inner(1 - u, v - 0.5); });
    patches.add(length, ring, [=](const double u, const double v) { return lerp(outer(u, 0.5), inner(u, 0.5), v); });
    patches.add(length, ring, [=](const double u, const double v) { return lerp(inner(u, -0.5), outer(u, -0.5), v); });
  }
  return patches.sew(options);
}

// a piece of the outline of cad_part() in the plane of x and z: a segment, or an arc around a center
struct Outline_piece
{
  std::array<double, 2> start, end, center;
  double angle; // of the arc, positive counterclockwise; 0 for a segment

  std::array<double, 2> at(const double t) const
  {
    if(angle == 0)
      return {{ start[0] + t * (end[0] - start[0]), start[1] + t * (end[1] - start[1]) }};
    const double x = start[0] - center[0], y = start[1] - center[1], c = std::cos(t * angle), s = std::sin(t * angle);
    return {{ center[0] + c*x - s*y, center[1] + s*x + c*y }};
  }

  double radius() const { return std::hypot(start[0] - center[0], start[1] - center[1]); }
  double length() const
  {
    return (angle == 0) ? std::hypot(end[0] - start[0], end[1] - start[1]) : std::abs(angle) * radius();
  }
};

constexpr double cad_part_width = 2;   // along y
constexpr double cad_part_slope = 0.3; // of the ramp, where it is steepest

// the pieces of the upper outline of cad_part(), each with the piece of the lower one below it, from the left to the
// right; the ramp is level here
inline std::vector<std::pair<Outline_piece, Outline_piece> > cad_part_outline()
{
  const auto segment = [](const double x0, const double z0, const double x1, const double z1)
  {
    return Outline_piece{ {{ x0, z0 }}, {{ x1, z1 }}, {{ 0, 0 }}, 0 };
  };
  const auto arc = [](const double x0, const double z0, const double cx, const double cz, const double angle)
  {
    Outline_piece p{ {{ x0, z0 }}, {{ 0, 0 }}, {{ cx, cz }}, angle };
    p.end = p.at(1);
    return p;
  };

  // a rounding, a steep plane that is tangent to it, and a fillet that is tangent to both planes around it
  const double slope = pi / 4, c = std::cos(slope);
  const Outline_piece rounding = arc(1.3, 1.5, 1.3, 1.1, -slope);
  const Outline_piece steep = segment(rounding.end[0], rounding.end[1],
                                      rounding.end[0] + 0.6*c, rounding.end[1] - 0.6*c);
  const Outline_piece fillet = arc(steep.end[0], steep.end[1], steep.end[0] + 0.5*c, steep.end[1] + 0.5*c, slope);
  const double floor = fillet.end[1];
  // a cylindrical groove
  const double groove_angle = 5 * pi / 18, groove_center = -0.35 / std::tan(groove_angle);
  const Outline_piece groove_start = arc(0.9, 0, 1.25, groove_center, -groove_angle);
  const Outline_piece groove_end = arc(1.25, groove_start.end[1], 1.25, groove_center, -groove_angle);

  return {
    { segment(0, 1.5, 0.3, 1.5),                 segment(0, 0, 0.3, 0) },
    { segment(0.3, 1.5, 0.45, 1.25),             segment(0.3, 0, 0.45, 0) },
    { segment(0.45, 1.25, 0.6, 1.5),             segment(0.45, 0, 0.6, 0) },
    { segment(0.6, 1.5, 1, 1.5),                 segment(0.6, 0, 0.9, 0) },
    { segment(1, 1.5, 1.3, 1.5),                 groove_start },
    { rounding,                                  groove_end },
    { steep,                                     segment(1.6, 0, 1.95, 0) },
    { fillet,                                    segment(1.95, 0, 2.3, 0) },
    { segment(fillet.end[0], floor, 3.1, floor), segment(2.3, 0, 3.1, 0) },
    { segment(3.1, floor, 4, floor),             segment(3.1, 0, 4, 0) }
  };
}

// a part with planes, cylinders, sharp edges, convex and concave, blends without an edge, and an edge that vanishes:
// at the right, the top turns from level to a ramp
inline Model cad_part(const Options& options)
{
  const auto outline = cad_part_outline();
  const std::size_t last = outline.size() - 1;
  const double height = 1.1, width = cad_part_width;
  const auto top = [=](const std::size_t i, const double t, const double s)
  {
    const std::array<double, 2> p = outline[i].first.at(t);
    return Point(p[0], s * width, (i == last) ? p[1] - cad_part_slope * s * (p[0] - outline[i].first.start[0]) : p[1]);
  };
  const auto bottom = [=](const std::size_t i, const double t, const double s)
  {
    const std::array<double, 2> p = outline[i].second.at(t);
    return Point(p[0], s * width, p[1]);
  };

  Patchwork patches;
  for(std::size_t i=0; i<=last; ++i)
  {
    const double length = (std::max)(outline[i].first.length(), outline[i].second.length());
    patches.add(length, width, [=](const double u, const double v) { return top(i, u, v); });
    patches.add(width, length, [=](const double u, const double v) { return bottom(i, v, u); });
    patches.add(length, height, [=](const double u, const double v) { return lerp(bottom(i, u, 0), top(i, u, 0), v); });
    patches.add(height, length, [=](const double u, const double v) { return lerp(bottom(i, v, 1), top(i, v, 1), u); });
  }
  patches.add(height, width, [=](const double u, const double v) { return lerp(bottom(0, 0, v), top(0, 0, v), u); });
  patches.add(width, height, [=](const double u, const double v)
  {
    return lerp(bottom(last, 1, u), top(last, 1, u), v);
  });
  return patches.sew(options);
}

struct Generator
{
  std::string name;
  Model (*generate)(const Options&);
  bool is_closed;
};

inline const std::vector<Generator>& all()
{
  static const std::vector<Generator> generators = {
    { "cube", cube, true },
    { "cylinder", cylinder, true },
    { "sphere", sphere, true },
    { "saddle", saddle, false },
    { "twirl", twirl, true },
    { "cut_sphere", cut_sphere, true },
    { "cad_part", cad_part, true },
    { "organic_shape", organic_shape, true },
    { "thin_plate", thin_plate, true },
    { "cone", cone, true },
    { "pyramid_3", pyramid_3, true },
    { "pyramid_4", pyramid_4, true },
    { "pyramid_5", pyramid_5, true },
    { "pyramid_6", pyramid_6, true },
    { "obtuse_prism", obtuse_prism, true },
    { "drilled_block", drilled_block, true },
    { "torus", torus, true }
  };
  return generators;
}

inline Model generate(const std::string& name, const Options& options)
{
  for(const Generator& g : all())
    if(g.name == name)
      return g.generate(options);
  throw std::invalid_argument("there is no generated model of the name " + name);
}

} // namespace generated_models

#endif // SURFACE_MESH_DENOISING_GENERATED_MODELS_H
