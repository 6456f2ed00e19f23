// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "generated_models.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace models = generated_models;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef models::Point Point;
typedef models::Vector Vector;
typedef CGAL::Surface_mesh<Point> Mesh;

namespace {

const double pi = models::pi;

double box(const Point& p, const double a, const double b, const double c)
{
  return (std::max)({ std::abs(p.x()) - a, std::abs(p.y()) - b, std::abs(p.z()) - c });
}

double pyramid(const Point& p, const int m)
{
  // the faces are as far from the axis as the middles of the sides of the base, at the height zero
  double d = -p.z();
  for(int k=0; k<m; ++k)
  {
    const double angle = 2 * pi * (k + 0.5) / m;
    d = (std::max)(d, p.x() * std::cos(angle) + p.y() * std::sin(angle) - std::cos(pi / m) * (1 - p.z()));
  }
  return d;
}

double obtuse_prism(const Point& p)
{
  double d = std::abs(p.z()) - 1;
  for(int k=0; k<12; ++k)
  {
    const double angle = pi / 6 * k;
    d = (std::max)(d, p.x() * std::cos(angle) + p.y() * std::sin(angle) - std::cos(pi / 12));
  }
  return d;
}

double twirl(const Point& p)
{
  const double angle = -(pi / 2) * p.z() / 4, c = std::cos(angle), s = std::sin(angle);
  return (std::max)({ std::abs(c * p.x() - s * p.y()) - 1, std::abs(s * p.x() + c * p.y()) - 1, -p.z(), p.z() - 4 });
}

double cut_sphere(const Point& p)
{
  const double height = std::sqrt(0.75);
  double d = std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1;
  for(int i=0; i<3; ++i)
  {
    const double to_axis = std::hypot(p[(i+1)%3], p[(i+2)%3]);
    const double inside_hole = (std::min)(0.5 - to_axis, p[i] - (height - 0.3));
    d = (std::max)({ d, -p[i] - height, inside_hole });
  }
  return d;
}

double cad_part_top(const double x, const double y)
{
  const double c = std::sqrt(0.5);
  const double rounding_end = 1.3 + 0.4*c, fillet_start = rounding_end + 0.6*c, fillet_end = fillet_start + 0.5*c;
  const double fillet_center_z = 1.1 + 0.4*c - 0.6*c + 0.5*c;
  if(x < 0.6)
    return 1.5 - (std::max)(0., 0.15 - std::abs(x - 0.45)) * (0.25 / 0.15);
  if(x < 1.3)
    return 1.5;
  if(x < rounding_end)
    return 1.1 + std::sqrt(0.16 - (x - 1.3) * (x - 1.3));
  if(x < fillet_start)
    return 1.1 + 0.4*c - (x - rounding_end);
  if(x < fillet_end)
    return fillet_center_z - std::sqrt((std::max)(0., 0.25 - (x - fillet_end) * (x - fillet_end)));
  return fillet_center_z - 0.5 - 0.3 * (y / 2) * (std::max)(0., x - 3.1);
}

double cad_part_bottom(const double x)
{
  const double radius = 0.35 / std::sin(pi * 50 / 180), center = -0.35 / std::tan(pi * 50 / 180);
  return (std::abs(x - 1.25) < 0.35) ? center + std::sqrt(radius * radius - (x - 1.25) * (x - 1.25)) : 0;
}

double cad_part(const Point& p)
{
  return (std::max)({ -p.x(), p.x() - 4, -p.y(), p.y() - 2,
                   p.z() - cad_part_top(p.x(), p.y()), cad_part_bottom(p.x()) - p.z() });
}

double integral(const int n, const double from, const double to, const std::function<double(double)>& f)
{
  double sum = 0;
  for(int i=0; i<n; ++i)
    sum += f(from + (i + 0.5) * (to - from) / n);
  return sum * (to - from) / n;
}

double organic_shape_volume()
{
  return integral(200, 0, 2 * pi, [](const double longitude)
  {
    return integral(200, -1, 1, [=](const double z)
    {
      const double r = std::sqrt(1 - z*z);
      return std::pow(models::organic_radius(Vector(r * std::cos(longitude), r * std::sin(longitude), z)), 3) / 3;
    });
  });
}

struct Facts
{
  // negative inside, zero on the surface, positive outside; near the surface about the distance to it
  std::function<double(Point)> distance;
  double largest_curvature;
  double volume;
};

Facts facts(const std::string& name)
{
  static const std::map<std::string, Facts> all = {
    { "cube", { [](const Point& p) { return box(p, 1, 1, 1); }, 0, 8 } },
    { "thin_plate", { [](const Point& p) { return box(p, 1, 1, 1/30.); }, 0, 8/30. } },
    { "cylinder", { [](const Point& p)
                    { return (std::max)({ std::hypot(p.x(), p.y()) - 1, std::abs(p.z()) - 1 }); }, 1, 2 * pi } },
    { "sphere", { [](const Point& p) { return std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1; }, 1, 4 * pi / 3 } },
    { "saddle", { [](const Point& p) { return p.z() - (p.x() * p.x() - p.y() * p.y()) / 2; }, 1, 0 } },
    { "torus", { [](const Point& p) { return std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - 0.4; }, 2.5,
                 2 * pi * pi * 0.16 } },
    { "cone", { [](const Point& p)
                { return (std::max)({ -p.z(), p.z() - 1.5 * (1 - std::hypot(p.x(), p.y())) }); }, 1e3, pi / 2 } },
    { "pyramid_3", { [](const Point& p) { return pyramid(p, 3); }, 0, std::sqrt(3.) / 4 } },
    { "pyramid_4", { [](const Point& p) { return pyramid(p, 4); }, 0, 2 / 3. } },
    { "pyramid_5", { [](const Point& p) { return pyramid(p, 5); }, 0, 5 / 6. * std::sin(2 * pi / 5) } },
    { "pyramid_6", { [](const Point& p) { return pyramid(p, 6); }, 0, std::sqrt(3.) / 2 } },
    { "obtuse_prism", { obtuse_prism, 0, 6 } },
    { "twirl", { twirl, 0.5, 16 } },
    { "drilled_block", { [](const Point& p)
                         { return (std::max)(box(p, 1, 1, 0.5), 0.5 - std::hypot(p.x(), p.y())); }, 2, 4 - pi / 4 } },
    { "cut_sphere", { cut_sphere, 2,
                      // three caps more than the holes' mouths are cut off, then three cylinders
                      4 * pi / 3 - 6 * pi / 3 * std::pow(1 - std::sqrt(0.75), 2) * (2 + std::sqrt(0.75))
                        - 3 * pi * 0.25 * 0.3 } },
    { "cad_part", { cad_part, 2.5, integral(100000, 0, 4, [](const double x)
                                   { return 2 * (cad_part_top(x, 1) - cad_part_bottom(x)); }) } },
    { "organic_shape", { [](const Point& p)
                         {
                           const double r = std::sqrt((p - CGAL::ORIGIN).squared_length());
                           return r - models::organic_radius((p - CGAL::ORIGIN) / r);
                         }, 15, organic_shape_volume() } }
  };
  return all.at(name);
}

Point centroid(const Mesh& mesh, const Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))));
}

double longest_edge(const Mesh& mesh, const Mesh::Face_index f)
{
  double l = 0;
  for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
    l = (std::max)(l, PMP::edge_length(h, mesh));
  return l;
}

class Generated_model : public testing::TestWithParam<std::tuple<models::Generator, models::Triangles> >
{
protected:
  Generated_model()
  {
    options.number_of_vertices = 8000;
    options.triangles = std::get<1>(GetParam());
    options.seed = 7;
    mesh = models::to_mesh<Mesh>(generator.generate(options));
  }

  const models::Generator generator = std::get<0>(GetParam());
  const Facts fact = facts(generator.name);
  models::Options options;
  Mesh mesh;
};

TEST_P(Generated_model, has_about_the_number_of_vertices_asked_for)
{
  EXPECT_NEAR(double(mesh.number_of_vertices()), 8000, 0.1 * 8000);
}

TEST_P(Generated_model, is_a_valid_triangle_mesh_in_one_piece)
{
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
  EXPECT_EQ(CGAL::is_closed(mesh), generator.is_closed);
  std::vector<std::size_t> component(mesh.number_of_faces());
  EXPECT_EQ(PMP::connected_components(mesh, CGAL::make_property_map(component)), 1u);
}

TEST_P(Generated_model, has_its_vertices_on_the_surface)
{
  for(const auto v : mesh.vertices())
    ASSERT_NEAR(fact.distance(mesh.point(v)), 0, 1e-9) << mesh.point(v);
}

TEST_P(Generated_model, has_the_sharp_edges_on_edges)
{
  // a face across a sharp edge would be farther from the surface than the curvature explains
  const bool is_apex_curved = generator.name == "cone";
  for(const auto f : mesh.faces())
  {
    const double l = longest_edge(mesh, f);
    const double curvature
      = is_apex_curved ? 1 / (0.5 * std::hypot(centroid(mesh, f).x(), centroid(mesh, f).y())) : fact.largest_curvature;
    ASSERT_NEAR(fact.distance(centroid(mesh, f)), 0, 1e-12 + curvature * l * l / 2);
  }
}

TEST_P(Generated_model, has_its_normals_outwards)
{
  for(const auto f : mesh.faces())
  {
    const Vector step = 0.1 * longest_edge(mesh, f) * PMP::compute_face_normal(f, mesh);
    const Point c = centroid(mesh, f);
    ASSERT_LT(fact.distance(c - step), fact.distance(c + step));
  }
}

TEST_P(Generated_model, has_no_face_near_degenerate)
{
  for(const auto f : mesh.faces())
  {
    const double l = longest_edge(mesh, f);
    ASSERT_GT(PMP::face_area(f, mesh), 0.02 * l * l);
  }
}

TEST_P(Generated_model, encloses_the_volume_of_the_surface)
{
  if(!generator.is_closed)
    return;
  const double tolerance = (fact.largest_curvature == 0) ? 1e-12 : 3e-3;
  EXPECT_NEAR(PMP::volume(mesh) / fact.volume, 1, tolerance);
}

TEST_P(Generated_model, depends_on_the_options_alone)
{
  const models::Model model = generator.generate(options), again = generator.generate(options);
  EXPECT_EQ(model.points, again.points);
  EXPECT_EQ(model.triangles, again.triangles);

  options.seed = 8;
  const models::Model other = generator.generate(options);
  EXPECT_EQ(model.points == other.points, options.triangles == models::Triangles::REGULAR);
}

INSTANTIATE_TEST_SUITE_P(All, Generated_model,
                         testing::Combine(testing::ValuesIn(models::all()),
                                          testing::Values(models::Triangles::REGULAR, models::Triangles::IRREGULAR)),
                         [](const testing::TestParamInfo<Generated_model::ParamType>& info)
                         {
                           return std::get<0>(info.param).name
                             + (std::get<1>(info.param) == models::Triangles::REGULAR ? "_regular" : "_irregular");
                         });

// the angle between the normals of the two faces at an edge, in degrees
double turn_at(const Mesh& mesh, const Mesh::Halfedge_index h)
{
  return CGAL::approximate_angle(PMP::compute_face_normal(mesh.face(h), mesh),
                                 PMP::compute_face_normal(mesh.face(mesh.opposite(h)), mesh));
}

std::multiset<double> turns_around(const Mesh& mesh, const Mesh::Vertex_index v)
{
  std::multiset<double> turns;
  for(const auto h : CGAL::halfedges_around_target(v, mesh))
    turns.insert(turn_at(mesh, h));
  return turns;
}

TEST(Generated_models, pyramids_have_apexes_of_3_to_6_sharp_edges)
{
  for(int m=3; m<=6; ++m)
  {
    const Mesh mesh = models::to_mesh<Mesh>(models::pyramid({}, m));
    const auto apex = std::find_if(mesh.vertices().begin(), mesh.vertices().end(),
                                   [&](const auto v) { return mesh.point(v) == Point(0, 0, 1); });
    ASSERT_NE(apex, mesh.vertices().end());
    const std::multiset<double> turns = turns_around(mesh, *apex);
    EXPECT_EQ(std::distance(turns.upper_bound(20), turns.end()), m);
    EXPECT_EQ(std::distance(turns.upper_bound(1e-3), turns.end()), m);
  }
}

TEST(Generated_models, obtuse_prism_has_edges_of_150_degrees)
{
  const Mesh mesh = models::to_mesh<Mesh>(models::obtuse_prism({}));
  double length = 0;
  for(const auto e : mesh.edges())
  {
    if(std::abs(turn_at(mesh, mesh.halfedge(e)) - 30) < 1e-6)
      length += PMP::edge_length(e, mesh);
  }
  EXPECT_NEAR(length, 12 * 2, 1e-9);
}

TEST(Generated_models, cad_part_has_an_edge_that_vanishes)
{
  const Mesh mesh = models::to_mesh<Mesh>(models::cad_part({}));
  double least = 180, greatest = 0;
  for(const auto e : mesh.edges())
  {
    const auto h = mesh.halfedge(e);
    const Point& p = mesh.point(mesh.source(h));
    const Point& q = mesh.point(mesh.target(h));
    const bool is_on_crease = std::abs(p.x() - 3.1) < 1e-9 && std::abs(q.x() - 3.1) < 1e-9
      && p.z() > 0.8 && q.z() > 0.8;
    if(!is_on_crease)
      continue;
    const double turn = turn_at(mesh, h);
    const double expected = std::atan(0.3 * (p.y() + q.y()) / 4) * 180 / pi;
    EXPECT_NEAR(turn, expected, 0.6);
    least = (std::min)(least, turn);
    greatest = (std::max)(greatest, turn);
  }
  EXPECT_LT(least, 1);
  EXPECT_GT(greatest, 15);
}

TEST(Generated_models, unknown_names_are_refused)
{
  EXPECT_THROW(models::generate("no such model", {}), std::invalid_argument);
}

} // namespace
