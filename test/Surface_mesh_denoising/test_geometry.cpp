// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What denoising does, and does not do, to surfaces that are known.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_denoising/anisotropic_neighborhood.h>
#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/denoise_isotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/filter_vertex_normals.h>
#include <CGAL/Surface_mesh_denoising/measure_error.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <numeric>
#include <ostream>
#include <random>
#include <set>

using generated_models::cube;
using generated_models::cylinder;
using generated_models::saddle;
using generated_models::sphere;

enum class Method
{
  ADAPTIVE,  // anisotropic fitting without parameters
  ITERATIVE, // anisotropic fitting with parameters
  ISOTROPIC
};

const Method all_methods[] = { Method::ADAPTIVE, Method::ITERATIVE, Method::ISOTROPIC };

std::ostream& operator<<(std::ostream& out, const Method method)
{
  return out << (method == Method::ADAPTIVE ? "adaptive" : method == Method::ITERATIVE ? "iterative" : "isotropic");
}

Mesh denoised(Mesh mesh, const Anisotropic_parameters& parameters = {})
{
  SMD::denoise_anisotropic_fitting(mesh, parameters.named());
  return mesh;
}

Mesh isotropically_denoised(Mesh mesh, const Isotropic_parameters& parameters = {})
{
  SMD::denoise_isotropic_fitting(mesh, parameters.named());
  return mesh;
}

template <typename Range, typename NamedParameters>
Mesh denoised_range(const Method method, Mesh mesh, const Range& range, const NamedParameters& np)
{
  if(method == Method::ADAPTIVE)
    SMD::denoise_anisotropic_fitting(range, mesh, np);
  else if(method == Method::ITERATIVE)
    SMD::denoise_anisotropic_fitting(range, mesh, np.number_of_iterations(30));
  else
    SMD::denoise_isotropic_fitting(range, mesh, np);
  return mesh;
}

Mesh denoised_by(const Method method, const Mesh& mesh)
{
  return denoised_range(method, mesh, vertices(mesh), params::default_values());
}

// a square in a plane that no axis is parallel to
Mesh plane(const std::size_t number_of_vertices)
{
  Mesh mesh = irregular_mesh(saddle, number_of_vertices);
  for(const Vertex v : vertices(mesh))
  {
    const Point p = mesh.point(v);
    mesh.point(v) = Point(p.x() + 0.3 * p.y(), p.y() - 0.2 * p.x(), 0.7 * p.x() + 0.4 * p.y() + 3);
  }
  return mesh;
}

// two halves of a square with an angle between their normals, along the axis of y
struct Roof
{
  Mesh mesh;
  std::vector<bool> is_crease; // of the edges

  Roof(const int number_of_cells, const double angle_in_degrees)
  {
    // of each half
    const double half_angle = angle_in_degrees * generated_models::pi / 360;
    std::vector<std::vector<Vertex> > rows;
    for(int j=0; j<=number_of_cells; ++j)
    {
      rows.emplace_back();
      for(int i=-number_of_cells; i<=number_of_cells; ++i)
        rows.back().push_back(mesh.add_vertex(Point(i * std::cos(half_angle), j + 0.1 * (i % 2),
                                                    -std::abs(i) * std::sin(half_angle))));
    }
    for(int j=0; j<number_of_cells; ++j)
      for(int i=0; i<2*number_of_cells; ++i)
      {
        mesh.add_face(rows[j][i], rows[j][i+1], rows[j+1][i+1]);
        mesh.add_face(rows[j][i], rows[j+1][i+1], rows[j+1][i]);
      }
    for(const Edge e : edges(mesh))
      is_crease.push_back(mesh.point(mesh.vertex(e, 0)).x() == 0 && mesh.point(mesh.vertex(e, 1)).x() == 0);
  }

  auto crease_map() const
  {
    return boost::make_function_property_map<Edge>([this](const Edge e) -> bool { return is_crease[e]; });
  }

  bool is_left(const Face f) const
  {
    const std::array<Vertex, 3> t = vertices_of(mesh, f);
    return mesh.point(t[0]).x() + mesh.point(t[1]).x() + mesh.point(t[2]).x() < 0;
  }
};

// the angles between the normals at the edges that are sharp in `truth`, in degrees
std::vector<double> angles_at_sharp_edges(const Mesh& mesh, const Mesh& truth)
{
  std::vector<double> angles;
  for(const Edge e : edges(mesh))
  {
    const Face f = mesh.face(mesh.halfedge(e, 0)), g = mesh.face(mesh.halfedge(e, 1));
    if(angle_between(normal_of(truth, f), normal_of(truth, g)) > 30)
      angles.push_back(angle_between(normal_of(mesh, f), normal_of(mesh, g)));
  }
  return angles;
}

double mean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.) / double(values.size());
}

double angular_error(const Mesh& mesh, const Mesh& truth) { return SMD::angular_error(mesh, truth).mean; }

double distance_error(const Mesh& mesh, const Mesh& truth)
{
  return SMD::vertex_distance_error(mesh, truth).root_mean_square;
}

// ---- surfaces without noise

TEST(Geometry, A_plane_with_a_border_stays)
{
  const Mesh mesh = plane(600);
  for(const Method method : all_methods)
    EXPECT_LT(largest_distance(denoised_by(method, mesh), mesh), 1e-13);
}

TEST(Geometry, Polyhedra_with_sharp_edges_stay)
{
  using namespace generated_models;
  for(const Model_generator generate : { cube, thin_plate, pyramid_4, pyramid_5, pyramid_6 })
    for(const Mesh& mesh : { irregular_mesh(generate, 1000), regular_mesh(generate, 1000) })
      for(const Method method : { Method::ADAPTIVE, Method::ITERATIVE })
        EXPECT_LT(largest_distance(denoised_by(method, mesh), mesh), 1e-12);
}

TEST(Geometry, Curved_surfaces_hardly_change)
{
  for(const Model_generator generate : { cylinder, sphere, saddle })
    for(const Mesh& mesh : { irregular_mesh(generate, 1500), regular_mesh(generate, 1500) })
      for(const Method method : { Method::ADAPTIVE, Method::ITERATIVE })
      {
        EXPECT_LT(angular_error(denoised_by(method, mesh), mesh), 0.1);
        EXPECT_LT(largest_distance(denoised_by(method, mesh), mesh), 0.01 * mean_edge_length(mesh));
      }
  for(const Model_generator generate : { sphere, saddle })
    EXPECT_LT(angular_error(isotropically_denoised(irregular_mesh(generate, 1500)), irregular_mesh(generate, 1500)),
              0.1);
}

// ---- surfaces with noise

void expect_less_noise(const Method method, const Model_generator generate, const double largest_angular_error,
                       const double largest_share_of_distances)
{
  const Mesh truth = irregular_mesh(generate, 1500), noisy = with_noise(truth, 0.2), result = denoised_by(method, noisy);
  SCOPED_TRACE(testing::Message() << method << ", " << name_of(generate));
  EXPECT_GT(angular_error(noisy, truth), 20);
  EXPECT_LT(angular_error(result, truth), largest_angular_error);
  EXPECT_LT(distance_error(result, truth), largest_share_of_distances * distance_error(noisy, truth));
  if(is_closed(truth))
  {
    EXPECT_LT(std::abs(SMD::relative_volume_change(result, truth)), 0.01);
  }
}

TEST(Geometry, Noise_goes_away)
{
  for(const Method method : { Method::ADAPTIVE, Method::ITERATIVE })
    for(const Model_generator generate : { cube, cylinder, sphere, saddle })
      expect_less_noise(method, generate, 2.5, 0.33);
}

TEST(Geometry, Isotropic_fitting_removes_noise_where_there_are_no_edges)
{
  for(const Model_generator generate : { sphere, saddle })
    expect_less_noise(Method::ISOTROPIC, generate, 5, 0.5);
}

TEST(Geometry, Faces_of_a_noisy_cube_become_flat_and_its_edges_sharp)
{
  const Mesh truth = irregular_mesh(cube, 2000), noisy = with_noise(truth, 0.2);
  for(const Method method : { Method::ADAPTIVE, Method::ITERATIVE })
  {
    const Mesh result = denoised_by(method, noisy);
    double largest_angle = 0;
    for(const Face f : faces(truth))
      largest_angle = (std::max)(largest_angle, angle_between(normal_of(result, f), normal_of(truth, f)));
    EXPECT_LT(largest_angle, 25);

    std::vector<double> deviations;
    for(const double angle : angles_at_sharp_edges(result, truth))
      deviations.push_back(std::abs(angle - 90));
    EXPECT_LT(mean(deviations), 5);
  }
  // which is why there are two methods
  EXPECT_LT(mean(angles_at_sharp_edges(isotropically_denoised(noisy), truth)), 70);
}

// the adaptive method moves vertices further, and may leave a face in a thousand behind
TEST(Geometry, Denoising_flips_hardly_any_faces)
{
  using namespace generated_models;
  const auto expect_no_more_flips = [](const Method method, const Model_generator generate)
  {
    for(const double level : { 0.2, 0.3 })
    {
      const Mesh truth = irregular_mesh(generate, 1500), noisy = with_noise(truth, level);
      const std::size_t tolerated = (method == Method::ADAPTIVE) ? num_faces(truth) / 1000 : 0;
      EXPECT_LE(SMD::number_of_flipped_faces(denoised_by(method, noisy), truth),
                SMD::number_of_flipped_faces(noisy, truth) + tolerated)
        << method << ", " << name_of(generate) << ", noise " << level;
    }
  };
  for(const Model_generator generate : { cube, cylinder, sphere, saddle, torus, pyramid_5, obtuse_prism })
    for(const Method method : { Method::ADAPTIVE, Method::ITERATIVE })
      expect_no_more_flips(method, generate);
  for(const Model_generator generate : { sphere, saddle, torus })
    expect_no_more_flips(Method::ISOTROPIC, generate);
}

TEST(Geometry, Steps_that_would_flip_a_face_are_shortened)
{
  using SMD::Indexed_triangle_mesh;
  typedef Indexed_triangle_mesh::Index Index;
  const Index none = Indexed_triangle_mesh::null_index();
  const std::vector<Point> points = { Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0) };
  const Indexed_triangle_mesh mesh(points, { {{ 0, 1, 2 }} }, { {{ none, none, none }} });
  const std::vector<Vector> up(1, Vector(0, 0, 1)), down(1, Vector(0, 0, -1));

  const auto shortened = [&](const std::vector<Vector>& normals, const Vector& displacement)
  {
    std::vector<Vector> displacements = { displacement, Vector(0, 0, 0), Vector(0, 0, 0) };
    SMD::internal::prevent_flips<CGAL::Sequential_tag>(mesh, normals, displacements);
    return displacements[0];
  };
  // the opposite edge is half the way along the displacement (1, 1, 0)
  EXPECT_EQ(shortened(up, Vector(0.4, 0.4, 0)), Vector(0.4, 0.4, 0));
  EXPECT_EQ(shortened(up, Vector(0.8, 0.8, 0)), Vector(0.4, 0.4, 0));
  EXPECT_EQ(shortened(up, Vector(1.6, 1.6, 0)), Vector(0.4, 0.4, 0));
  EXPECT_EQ(shortened(up, Vector(16, 16, 0)), Vector(0, 0, 0));
  EXPECT_EQ(shortened(up, Vector(0, 0, 7)), Vector(0, 0, 7));
  // a face that does not agree with its normal may turn
  EXPECT_EQ(shortened(down, Vector(0.8, 0.8, 0)), Vector(0.8, 0.8, 0));
}

// ---- what commutes with denoising

template <typename Transformation>
Mesh transformed(Mesh mesh, const Transformation& transformation)
{
  for(const Vertex v : vertices(mesh))
    mesh.point(v) = transformation(mesh.point(v));
  return mesh;
}

std::vector<Mesh> noisy_meshes()
{
  return { noisy_mesh(cube, 500, 0.2), noisy_mesh(sphere, 500, 0.2), noisy_mesh(saddle, 500, 0.2) };
}

// in mean edge lengths. In the adaptive method rounding has more decisions to sway
double tolerance(const Method method) { return (method == Method::ADAPTIVE) ? 1e-6 : 1e-9; }

template <typename Transformation>
void expect_to_commute(const Method method, const Mesh& noisy, const Transformation& transformation)
{
  const Mesh moved = transformed(noisy, transformation);
  EXPECT_LT(largest_distance(denoised_by(method, moved), transformed(denoised_by(method, noisy), transformation)),
            tolerance(method) * mean_edge_length(moved)) << method;
}

TEST(Geometry, Rigid_motions_commute_with_denoising)
{
  const auto move = [](const Point& p)
  {
    // rotations about the axes of z and x
    const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(-2.1), t = std::sin(-2.1);
    const double x = c * p.x() - s * p.y(), y = s * p.x() + c * p.y();
    return Point(x + 3, d * y - t * p.z() - 1, t * y + d * p.z() + 0.5);
  };
  for(const Method method : all_methods)
    for(const Mesh& noisy : noisy_meshes())
      expect_to_commute(method, noisy, move);
}

TEST(Geometry, Scaling_commutes_with_denoising)
{
  const auto scale_by = [](const double factor)
  {
    return [factor](const Point& p) { return Point(factor * p.x(), factor * p.y(), factor * p.z()); };
  };
  for(const Method method : all_methods)
    for(const Mesh& noisy : noisy_meshes())
    {
      expect_to_commute(method, noisy, scale_by(3.7));
      // by a power of two: no digit changes
      for(const double factor : { 1. / 1024, 8. })
        EXPECT_EQ(points_of(denoised_by(method, transformed(noisy, scale_by(factor)))),
                  points_of(transformed(denoised_by(method, noisy), scale_by(factor))));
    }
}

TEST(Geometry, Reversing_the_orientation_commutes_with_denoising)
{
  for(const Method method : { Method::ITERATIVE, Method::ISOTROPIC })
    for(const Mesh& noisy : noisy_meshes())
    {
      Mesh reversed = noisy;
      CGAL::Polygon_mesh_processing::reverse_face_orientations(reversed);
      EXPECT_LT(largest_distance(denoised_by(method, reversed), denoised_by(method, noisy)),
                tolerance(method) * mean_edge_length(noisy));
    }
}

TEST(Geometry, Renumbering_commutes_with_denoising)
{
  std::mt19937 random(1);
  for(const Method method : all_methods)
    for(const Mesh& noisy : noisy_meshes())
    {
      std::vector<Vertex> order(vertices(noisy).begin(), vertices(noisy).end());
      std::shuffle(order.begin(), order.end(), random);
      Mesh renumbered;
      std::vector<Vertex> new_vertex(num_vertices(noisy));
      for(const Vertex v : order)
        new_vertex[v] = renumbered.add_vertex(noisy.point(v));
      std::vector<Face> face_order(faces(noisy).begin(), faces(noisy).end());
      std::shuffle(face_order.begin(), face_order.end(), random);
      for(const Face f : face_order)
      {
        const std::array<Vertex, 3> t = vertices_of(noisy, f);
        const int first = int(f % 3);
        renumbered.add_face(new_vertex[t[first]], new_vertex[t[(first+1)%3]], new_vertex[t[(first+2)%3]]);
      }
      ASSERT_EQ(num_faces(renumbered), num_faces(noisy));

      const Mesh expected = denoised_by(method, noisy), result = denoised_by(method, renumbered);
      for(const Vertex v : vertices(noisy))
        ASSERT_LT(distance(result.point(new_vertex[v]), expected.point(v)), tolerance(method) * mean_edge_length(noisy));
    }
}

TEST(Geometry, Components_do_not_disturb_each_other)
{
  // the mean edge length, on which convergence depends, is that of both
  Mesh one = noisy_mesh(cube, 400, 0.2);
  const std::size_t n = num_vertices(one);
  Mesh both = one;
  both.join(transformed(one, [](const Point& p) { return Point(p.x() + 0.5, p.y(), p.z()); }));
  one = denoised(one);
  both = denoised(both);
  for(std::size_t i=0; i<n; ++i)
  {
    ASSERT_LT(distance(both.point(Vertex(Mesh::size_type(i))), one.point(Vertex(Mesh::size_type(i)))), 1e-9);
    ASSERT_LT(distance(both.point(Vertex(Mesh::size_type(n + i))),
                       one.point(Vertex(Mesh::size_type(i))) + Vector(0.5, 0, 0)), 1e-9);
  }
}

// ---- which vertices move

TEST(Geometry, Ranges_and_constraints)
{
  const Mesh noisy = noisy_mesh(cube, 500, 0.2);
  std::vector<Vertex> upper;
  std::vector<Face> upper_faces;
  std::set<Vertex> touched_from_below;
  for(const Face f : faces(noisy))
  {
    bool is_upper = true;
    for(const Vertex v : vertices_of(noisy, f))
      is_upper = is_upper && noisy.point(v).z() > 0;
    if(is_upper)
      upper_faces.push_back(f);
    else
      for(const Vertex v : vertices_of(noisy, f))
        touched_from_below.insert(v);
  }
  for(const Vertex v : vertices(noisy))
    if(touched_from_below.count(v) == 0)
      upper.push_back(v);
  const auto is_lower
    = boost::make_function_property_map<Vertex>([&](const Vertex v) -> bool { return touched_from_below.count(v) > 0; });

  for(const Method method : all_methods)
  {
    const Mesh of_range = denoised_range(method, noisy, upper, params::default_values());
    for(const Vertex v : vertices(noisy))
    {
      ASSERT_EQ(of_range.point(v) == noisy.point(v), touched_from_below.count(v) > 0);
    }
    // three ways to say the same
    EXPECT_EQ(points_of(denoised_range(method, noisy, upper_faces, params::default_values())), points_of(of_range));
    EXPECT_EQ(points_of(denoised_range(method, noisy, vertices(noisy), params::vertex_is_constrained_map(is_lower))),
              points_of(of_range));

    // all, and none
    EXPECT_EQ(points_of(denoised_range(method, noisy, std::vector<Vertex>(vertices(noisy).begin(),
                                                                          vertices(noisy).end()),
                                       params::default_values())), points_of(denoised_by(method, noisy)));
    EXPECT_EQ(points_of(denoised_range(method, noisy, std::vector<Face>(faces(noisy).begin(), faces(noisy).end()),
                                       params::default_values())), points_of(denoised_by(method, noisy)));
    EXPECT_EQ(points_of(denoised_range(method, noisy, std::vector<Vertex>(), params::default_values())),
              points_of(noisy));
    EXPECT_EQ(points_of(denoised_range(method, noisy, std::vector<Face>(), params::default_values())),
              points_of(noisy));
  }
}

TEST(Geometry, Constrained_edges_separate)
{
  // at 2 degrees little but the constraint tells the two sides apart
  const Roof roof(10, 2);
  const auto crossings = [&](const auto& np)
  {
    std::size_t number_of_crossings = 0;
    for(const Face seed : faces(roof.mesh))
    {
      std::vector<Face> found;
      SMD::anisotropic_neighborhood(seed, roof.mesh, std::back_inserter(found), np);
      EXPECT_EQ(found.size(), 40u);
      for(const Face f : found)
        number_of_crossings += (roof.is_left(f) != roof.is_left(seed));
    }
    return number_of_crossings;
  };
  EXPECT_GT(crossings(params::default_values()), 500u);
  EXPECT_EQ(crossings(params::edge_is_constrained_map(roof.crease_map())), 0u);

  for(const Method method : all_methods)
  {
    if(method != Method::ADAPTIVE) // which sees that there is no noise
    {
      EXPECT_GT(largest_distance(denoised_by(method, roof.mesh), roof.mesh), 1e-4);
    }
    EXPECT_LT(largest_distance(denoised_range(method, roof.mesh, vertices(roof.mesh),
                                              params::edge_is_constrained_map(roof.crease_map())), roof.mesh), 1e-12);
  }
}

// so shallow an edge drowns in the noise, unless it is constrained
TEST(Geometry, Constrained_edges_of_a_noisy_mesh_stay)
{
  const Roof roof(15, 20);
  const Mesh noisy = with_noise(roof.mesh, 0.2);
  const Mesh constrained = denoised_range(Method::ITERATIVE, noisy, vertices(noisy),
                                          params::edge_is_constrained_map(roof.crease_map()));
  const auto mean_crease_angle = [&](const Mesh& mesh)
  {
    std::vector<double> angles;
    for(const Edge e : edges(mesh))
      if(roof.is_crease[e])
        angles.push_back(angle_between(normal_of(mesh, mesh.face(mesh.halfedge(e, 0))),
                                       normal_of(mesh, mesh.face(mesh.halfedge(e, 1)))));
    return mean(angles);
  };
  EXPECT_LT(std::abs(mean_crease_angle(constrained) - 20), 8);
  EXPECT_LT(mean_crease_angle(denoised(noisy)), 12);
  EXPECT_LT(angular_error(constrained, roof.mesh), angular_error(denoised(noisy), roof.mesh));
}

// ---- named parameters

// an explicit default changes no bit; any other value changes the result
template <typename Parameters, typename Denoise>
void expect_effect(const std::vector<std::pair<const char*, std::function<void(Parameters&)> > >& changes,
                   const Denoise& denoise_with, const Mesh& with_defaults, const Mesh& noisy)
{
  EXPECT_EQ(points_of(denoise_with(noisy, Parameters())), points_of(with_defaults));
  for(const auto& change : changes)
  {
    Parameters parameters;
    change.second(parameters);
    EXPECT_NE(points_of(denoise_with(noisy, parameters)), points_of(with_defaults)) << change.first;
  }
}

TEST(Geometry, Every_parameter_of_anisotropic_fitting_has_an_effect)
{
  typedef Anisotropic_parameters P;
  const Mesh noisy = noisy_mesh(cube, 500, 0.2);
  const std::vector<std::pair<const char*, std::function<void(P&)> > > changes = {
    { "number_of_iterations", [](P& p) { p.number_of_iterations = 2; } },
    { "convergence_threshold", [](P& p) { p.convergence_threshold = 0.5; } },
    { "neighborhood_size", [](P& p) { p.neighborhood_size = 39; } },
    { "normal_weight", [](P& p) { p.normal_weight = 100; } },
    { "angle_threshold", [](P& p) { p.angle_threshold = 0.45; } },
    { "normal_exponent", [](P& p) { p.normal_exponent = 2; } },
    { "number_of_normal_iterations", [](P& p) { p.number_of_normal_iterations = 6; } },
    { "relaxation_factor", [](P& p) { p.relaxation_factor = 0.6; } }
  };
  Mesh defaults = noisy, range_defaults = noisy;
  SMD::denoise_anisotropic_fitting(defaults, params::number_of_iterations(30));
  expect_effect(changes, denoised, defaults, noisy);

  const std::vector<Face> some_faces(faces(noisy).begin(), std::next(faces(noisy).begin(), 300));
  SMD::denoise_anisotropic_fitting(some_faces, range_defaults, params::number_of_iterations(30));
  EXPECT_NE(points_of(range_defaults), points_of(defaults));
  expect_effect(changes, [&](Mesh mesh, const P& p)
  {
    SMD::denoise_anisotropic_fitting(some_faces, mesh, p.named());
    return mesh;
  }, range_defaults, noisy);
}

TEST(Geometry, Every_parameter_of_isotropic_fitting_has_an_effect)
{
  typedef Isotropic_parameters P;
  const Mesh noisy = noisy_mesh(sphere, 500, 0.2);
  const std::vector<std::pair<const char*, std::function<void(P&)> > > changes = {
    { "number_of_iterations", [](P& p) { p.number_of_iterations = 2; } },
    { "convergence_threshold", [](P& p) { p.convergence_threshold = 0.5; } },
    { "neighborhood_ring_size", [](P& p) { p.neighborhood_ring_size = 3; } },
    { "number_of_normal_iterations", [](P& p) { p.number_of_normal_iterations = 4; } },
    { "spatial_sigma", [](P& p) { p.spatial_sigma = 1.1; } },
    { "normal_sigma", [](P& p) { p.normal_sigma = 0.5; } },
    { "relaxation_factor", [](P& p) { p.relaxation_factor = 0.6; } }
  };
  Mesh defaults = noisy, range_defaults = noisy;
  SMD::denoise_isotropic_fitting(defaults);
  expect_effect(changes, isotropically_denoised, defaults, noisy);

  const std::vector<Face> some_faces(faces(noisy).begin(), std::next(faces(noisy).begin(), 300));
  SMD::denoise_isotropic_fitting(some_faces, range_defaults);
  EXPECT_NE(points_of(range_defaults), points_of(defaults));
  expect_effect(changes, [&](Mesh mesh, const P& p)
  {
    SMD::denoise_isotropic_fitting(some_faces, mesh, p.named());
    return mesh;
  }, range_defaults, noisy);
}

TEST(Geometry, Without_iterations_nothing_moves)
{
  const Mesh noisy = noisy_mesh(cube, 300, 0.2);
  Mesh mesh = noisy;
  const auto result = SMD::denoise_anisotropic_fitting(mesh, params::number_of_iterations(0));
  EXPECT_EQ(points_of(mesh), points_of(noisy));
  EXPECT_EQ(result.number_of_iterations, 0u);
  EXPECT_FALSE(result.has_converged);
}

// the normals of a mesh without the noise
struct True_normals
{
  std::vector<Vector> normals;

  template <typename ConcurrencyTag>
  void operator()(const SMD::Indexed_triangle_mesh&, std::vector<Vector>& n, std::size_t, ConcurrencyTag) const
  {
    n = normals;
  }
};

TEST(Geometry, Any_face_normal_filter_can_be_passed)
{
  const Mesh truth = irregular_mesh(cube, 1000), noisy = with_noise(truth, 0.3);
  Anisotropic_parameters other;
  other.angle_threshold = 0.4;
  other.normal_exponent = 2;
  Mesh mesh = noisy;
  SMD::denoise_anisotropic_fitting(mesh, params::face_normal_filter(SMD::Thresholded_normal_filter(0.4, 2)));
  EXPECT_EQ(points_of(mesh), points_of(denoised(noisy, other)));

  True_normals filter;
  for(const Face f : faces(truth))
    filter.normals.push_back(normal_of(truth, f));
  mesh = noisy;
  SMD::denoise_anisotropic_fitting(mesh, params::face_normal_filter(filter));
  EXPECT_LT(angular_error(mesh, truth), angular_error(denoised(noisy), truth));
}

TEST(Geometry, Normals_on_return_are_those_of_the_result)
{
  for(const Method method : { Method::ITERATIVE, Method::ISOTROPIC })
  {
    Mesh mesh = noisy_mesh(cylinder, 1000, 0.2);
    auto face_normals = mesh.add_property_map<Face, Vector>("f:normal").first;
    auto vertex_normals = mesh.add_property_map<Vertex, Vector>("v:normal").first;
    auto same_face_normals = mesh.add_property_map<Face, Vector>("f:same").first;
    auto same_vertex_normals = mesh.add_property_map<Vertex, Vector>("v:same").first;
    const auto denoise = [&](const auto& np)
    {
      if(method == Method::ITERATIVE)
        SMD::denoise_anisotropic_fitting(mesh, np);
      else
        SMD::denoise_isotropic_fitting(mesh, np);
    };
    denoise(params::face_normal_map(face_normals).vertex_normal_map(vertex_normals).number_of_iterations(30));
    denoise(params::face_normal_map(same_face_normals).vertex_normal_map(same_vertex_normals).number_of_iterations(0));

    std::vector<double> angles;
    std::vector<Vector> sums(num_vertices(mesh), Vector(0, 0, 0));
    for(const Face f : faces(mesh))
    {
      ASSERT_NEAR(face_normals[f].squared_length(), 1, 1e-12);
      ASSERT_LT((face_normals[f] - same_face_normals[f]).squared_length(), 1e-18);
      angles.push_back(angle_between(face_normals[f], normal_of(mesh, f)));
      const std::array<Vertex, 3> t = vertices_of(mesh, f);
      const double area = std::sqrt(CGAL::squared_area(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2])));
      for(const Vertex v : t)
        sums[v] += area * face_normals[f];
    }
    EXPECT_LT(mean(angles), 8);
    for(const Vertex v : vertices(mesh))
    {
      ASSERT_NEAR(vertex_normals[v].squared_length(), 1, 1e-12);
      ASSERT_LT((vertex_normals[v] - same_vertex_normals[v]).squared_length(), 1e-18);
      if(method == Method::ITERATIVE)
      {
        ASSERT_LT(angle_between(vertex_normals[v], sums[v]), 1e-6);
      }
    }
  }
}

TEST(Geometry, Filtered_vertex_normals_of_a_range)
{
  Mesh mesh = noisy_mesh(sphere, 500, 0.2);
  auto raw = mesh.add_property_map<Vertex, Vector>("v:raw").first;
  auto all = mesh.add_property_map<Vertex, Vector>("v:all").first;
  auto once = mesh.add_property_map<Vertex, Vector>("v:once").first;
  auto some = mesh.add_property_map<Vertex, Vector>("v:some").first;
  auto constrained = mesh.add_property_map<Vertex, Vector>("v:constrained").first;
  const std::size_t n = 100;
  const std::vector<Vertex> range(vertices(mesh).begin(), std::next(vertices(mesh).begin(), n));
  const auto is_outside
    = boost::make_function_property_map<Vertex>([](const Vertex v) -> bool { return std::size_t(v) >= n; });

  SMD::filter_vertex_normals(mesh, raw, params::number_of_iterations(0));
  SMD::filter_vertex_normals(mesh, once, params::number_of_iterations(1));
  SMD::filter_vertex_normals(mesh, all);
  SMD::filter_vertex_normals(range, mesh, some, params::number_of_iterations(1));
  SMD::filter_vertex_normals(mesh, constrained,
                             params::number_of_iterations(1).vertex_is_constrained_map(is_outside));

  std::vector<double> before, after;
  for(const Vertex v : vertices(mesh))
  {
    ASSERT_EQ(some[v], (std::size_t(v) < n) ? once[v] : raw[v]);
    ASSERT_EQ(constrained[v], some[v]);
    // the normal of the sphere
    before.push_back(angle_between(raw[v], mesh.point(v) - CGAL::ORIGIN));
    after.push_back(angle_between(all[v], mesh.point(v) - CGAL::ORIGIN));
  }
  EXPECT_LT(mean(after), 0.5 * mean(before));
}
