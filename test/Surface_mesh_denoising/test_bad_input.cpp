// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_meshes.h"

#include <CGAL/Surface_mesh_denoising/anisotropic_neighborhood.h>
#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/denoise_isotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/filter_vertex_normals.h>

#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>

const double infinity = std::numeric_limits<double>::infinity();
const double nan_value = std::numeric_limits<double>::quiet_NaN();

// the exception is a std::invalid_argument whose text has all the parts
template <typename Call>
void expect_invalid_argument(const Call& call, const std::vector<std::string>& parts)
{
  try
  {
    call();
    ADD_FAILURE() << "nothing thrown, expected: " << parts.front();
  }
  catch(const std::invalid_argument& e)
  {
    for(const std::string& part : parts)
      EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what() << "\nlacks: " << part;
  }
}

void denoise_anisotropic(Mesh& mesh, const Anisotropic_parameters& parameters = {})
{
  SMD::denoise_anisotropic_fitting(mesh, parameters.named());
}

void denoise_isotropic(Mesh& mesh, const Isotropic_parameters& parameters = {})
{
  SMD::denoise_isotropic_fitting(mesh, parameters.named());
}

typedef std::function<void(Mesh&)> Function;

std::vector<Function> denoising_functions()
{
  return { [](Mesh& mesh) { SMD::denoise_anisotropic_fitting(mesh); },
           [](Mesh& mesh) { denoise_anisotropic(mesh); },
           [](Mesh& mesh) { denoise_isotropic(mesh); } };
}

void filter_normals(Mesh& mesh)
{
  SMD::filter_vertex_normals(mesh, mesh.add_property_map<Vertex, Vector>("v:filtered").first);
}

void find_neighborhood(Mesh& mesh)
{
  std::vector<Face> found;
  SMD::anisotropic_neighborhood(*faces(mesh).begin(), mesh, std::back_inserter(found));
}

// a cube of 56 vertices, enough to tell the noise level, and uneven enough for each vertex to move
Mesh small_mesh() { return noisy_mesh(generated_models::cube, 50, 0.1); }

// ---- parameters

template <typename Parameters>
struct Out_of_range
{
  std::function<void(Parameters&)> set;
  std::string name, value, range;
};

template <typename Parameters, typename Denoise>
void expect_refused(const std::vector<Out_of_range<Parameters> >& cases, const Denoise& denoise)
{
  const Mesh original = small_mesh();
  for(const Out_of_range<Parameters>& c : cases)
  {
    Parameters parameters;
    c.set(parameters);
    Mesh mesh = original;
    expect_invalid_argument([&]() { denoise(mesh, parameters); }, { c.name + " is " + c.value, c.range });
    EXPECT_EQ(points_of(mesh), points_of(original));
  }
}

template <typename Parameters>
std::vector<Out_of_range<Parameters> > common_cases()
{
  typedef Parameters P;
  return {
    { [](P& p) { p.number_of_iterations = -1; }, "number_of_iterations", "-1", "at least 0" },
    { [](P& p) { p.number_of_normal_iterations = -2; }, "number_of_normal_iterations", "-2", "at least 0" },
    { [](P& p) { p.convergence_threshold = 0; }, "convergence_threshold", "0", "positive" },
    { [](P& p) { p.convergence_threshold = -0.25; }, "convergence_threshold", "-0.25", "positive" },
    { [](P& p) { p.convergence_threshold = nan_value; }, "convergence_threshold", "nan", "positive" },
    { [](P& p) { p.convergence_threshold = infinity; }, "convergence_threshold", "inf", "finite" },
    { [](P& p) { p.relaxation_factor = 0; }, "relaxation_factor", "0", "(0, 1]" },
    { [](P& p) { p.relaxation_factor = -0.5; }, "relaxation_factor", "-0.5", "(0, 1]" },
    { [](P& p) { p.relaxation_factor = 1.0000000000000002; }, "relaxation_factor", "1.0000000000000002", "(0, 1]" },
    { [](P& p) { p.relaxation_factor = nan_value; }, "relaxation_factor", "nan", "(0, 1]" }
  };
}

TEST(Bad_input, Parameters_of_anisotropic_fitting)
{
  typedef Anisotropic_parameters P;
  expect_refused(common_cases<P>(), denoise_anisotropic);
  expect_refused<P>({
    { [](P& p) { p.neighborhood_size = 0; }, "neighborhood_size", "0", "at least 1" },
    { [](P& p) { p.neighborhood_size = -40; }, "neighborhood_size", "-40", "at least 1" },
    { [](P& p) { p.normal_weight = 0; }, "normal_weight", "0", "positive" },
    { [](P& p) { p.normal_weight = -1; }, "normal_weight", "-1", "positive" },
    { [](P& p) { p.normal_weight = nan_value; }, "normal_weight", "nan", "positive" },
    { [](P& p) { p.normal_weight = infinity; }, "normal_weight", "inf", "finite" },
    { [](P& p) { p.angle_threshold = 0; }, "angle_threshold", "0", "(0, 1)" },
    { [](P& p) { p.angle_threshold = 1; }, "angle_threshold", "1", "(0, 1)" },
    { [](P& p) { p.angle_threshold = -0.5; }, "angle_threshold", "-0.5", "(0, 1)" },
    { [](P& p) { p.angle_threshold = nan_value; }, "angle_threshold", "nan", "(0, 1)" },
    { [](P& p) { p.normal_exponent = 3; }, "normal_exponent", "3", "2 or 4" },
    { [](P& p) { p.normal_exponent = 0; }, "normal_exponent", "0", "2 or 4" }
  }, denoise_anisotropic);
}

TEST(Bad_input, Parameters_of_isotropic_fitting)
{
  typedef Isotropic_parameters P;
  expect_refused(common_cases<P>(), denoise_isotropic);
  expect_refused<P>({
    { [](P& p) { p.neighborhood_ring_size = 0; }, "neighborhood_ring_size", "0", "at least 1" },
    { [](P& p) { p.neighborhood_ring_size = -1; }, "neighborhood_ring_size", "-1", "at least 1" },
    { [](P& p) { p.spatial_sigma = 0; }, "spatial_sigma", "0", "positive" },
    { [](P& p) { p.spatial_sigma = nan_value; }, "spatial_sigma", "nan", "positive" },
    { [](P& p) { p.normal_sigma = -3; }, "normal_sigma", "-3", "positive" },
    { [](P& p) { p.normal_sigma = infinity; }, "normal_sigma", "inf", "finite" }
  }, denoise_isotropic);
}

TEST(Bad_input, Parameters_of_filter_vertex_normals)
{
  Mesh mesh = small_mesh();
  auto normals = mesh.add_property_map<Vertex, Vector>("v:filtered").first;
  const auto filter = [&](const int number_of_iterations, const double spatial_sigma, const double normal_sigma)
  {
    SMD::filter_vertex_normals(mesh, normals, params::number_of_iterations(number_of_iterations)
                                                     .spatial_sigma(spatial_sigma).normal_sigma(normal_sigma));
  };
  expect_invalid_argument([&]() { filter(-1, 1, 1); }, { "number_of_iterations is -1", "at least 0" });
  expect_invalid_argument([&]() { filter(1, 0, 1); }, { "spatial_sigma is 0", "positive" });
  expect_invalid_argument([&]() { filter(1, nan_value, 1); }, { "spatial_sigma is nan", "positive" });
  expect_invalid_argument([&]() { filter(1, 1, -1); }, { "normal_sigma is -1", "positive" });
  expect_invalid_argument([&]() { filter(1, 1, infinity); }, { "normal_sigma is inf", "finite" });
}

TEST(Bad_input, Parameters_of_anisotropic_neighborhood)
{
  const Mesh mesh = small_mesh();
  const auto find = [&](const int neighborhood_size, const double normal_weight)
  {
    std::vector<Face> found;
    SMD::anisotropic_neighborhood(Face(0), mesh, std::back_inserter(found),
                                  params::neighborhood_size(neighborhood_size).normal_weight(normal_weight));
  };
  expect_invalid_argument([&]() { find(0, 1); }, { "neighborhood_size is 0", "at least 1" });
  expect_invalid_argument([&]() { find(-1, 1); }, { "neighborhood_size is -1", "at least 1" });
  expect_invalid_argument([&]() { find(1, 0); }, { "normal_weight is 0", "positive" });
  expect_invalid_argument([&]() { find(1, nan_value); }, { "normal_weight is nan", "positive" });
}

TEST(Bad_input, Parameters_of_the_thresholded_normal_filter)
{
  for(const double threshold : { 0., 1., -1., 2., nan_value })
    expect_invalid_argument([&]() { SMD::Thresholded_normal_filter filter(threshold); },
                            { "angle_threshold is ", "(0, 1)" });
  for(const int exponent : { -2, 0, 1, 3, 5 })
    expect_invalid_argument([&]() { SMD::Thresholded_normal_filter filter(0.5, exponent); },
                            { "normal_exponent is " + std::to_string(exponent), "2 or 4" });
}

TEST(Bad_input, Neighborhoods_may_be_larger_than_the_mesh)
{
  Mesh mesh = small_mesh(), same = mesh;
  SMD::denoise_anisotropic_fitting(mesh, params::neighborhood_size(num_faces(mesh)));
  SMD::denoise_anisotropic_fitting(same, params::neighborhood_size(std::size_t(1) << 61));
  EXPECT_EQ(points_of(mesh), points_of(same));

  std::vector<Face> found;
  SMD::anisotropic_neighborhood(Face(0), mesh, std::back_inserter(found),
                                params::neighborhood_size(std::size_t(1) << 61));
  EXPECT_EQ(found.size(), num_faces(mesh));
}

TEST(Bad_input, Rings_may_be_larger_than_the_mesh)
{
  Mesh mesh = small_mesh(), same = mesh;
  SMD::denoise_isotropic_fitting(mesh, params::neighborhood_ring_size(100u));
  SMD::denoise_isotropic_fitting(same, params::neighborhood_ring_size(4000000000u));
  EXPECT_EQ(points_of(mesh), points_of(same));
}

// ---- meshes that are refused

TEST(Bad_input, Not_a_triangle_mesh)
{
  Mesh mesh;
  std::vector<Vertex> v;
  for(const Point& p : { Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(2, 0, 0.1) })
    v.push_back(mesh.add_vertex(p));
  mesh.add_face(v[1], v[4], v[2]);
  mesh.add_face(v[0], v[1], v[2], v[3]);
  const std::vector<Point> points = points_of(mesh);

  std::vector<Function> functions = denoising_functions();
  functions.push_back(filter_normals);
  functions.push_back(find_neighborhood);
  for(const Function& function : functions)
    expect_invalid_argument([&]() { function(mesh); }, { "not a triangle mesh" });
  EXPECT_EQ(points_of(mesh), points);
}

TEST(Bad_input, Coordinates_that_are_not_finite)
{
  std::vector<Function> functions = denoising_functions();
  functions.push_back(filter_normals);
  for(const double x : { nan_value, infinity, -infinity })
    for(int k=0; k<3; ++k)
    {
      Mesh mesh = small_mesh();
      std::array<double, 3> p = {{ 0.25, 0.5, 0.75 }};
      p[k] = x;
      mesh.point(Vertex(7)) = mesh.point(Vertex(11)) = Point(p[0], p[1], p[2]);
      for(const Function& function : functions)
        expect_invalid_argument([&]() { function(mesh); }, { "vertex 7 has the coordinates", "finite" });
    }
}

// ---- meshes that are accepted

// a pyramid without its base; the apex comes first
Mesh fan(const std::size_t number_of_faces, const double height)
{
  Mesh mesh;
  const Vertex center = mesh.add_vertex(Point(0, 0, height));
  std::vector<Vertex> rim;
  for(std::size_t i=0; i<number_of_faces; ++i)
  {
    const double angle = 2 * generated_models::pi * double(i) / double(number_of_faces);
    rim.push_back(mesh.add_vertex(Point(std::cos(angle), std::sin(angle), 0)));
  }
  for(std::size_t i=0; i<number_of_faces; ++i)
    mesh.add_face(center, rim[i], rim[(i+1) % number_of_faces]);
  return mesh;
}

// two strips of faces that share nothing but one vertex
Mesh two_fans_with_a_common_center()
{
  Mesh mesh;
  const Vertex center = mesh.add_vertex(Point(0, 0, 0));
  for(const double side : { 1., -1. })
  {
    std::vector<Vertex> rim;
    for(int i=-3; i<=3; ++i)
      rim.push_back(mesh.add_vertex(Point(side * (1 + 0.1*i*i), side * 0.4*i, 0.1 * (i % 2))));
    for(std::size_t i=0; i+1<rim.size(); ++i)
      mesh.add_face(center, rim[i], rim[i+1]);
  }
  return mesh;
}

struct Named_mesh
{
  std::string name;
  Mesh mesh;
};

std::vector<Named_mesh> awkward_meshes()
{
  using namespace generated_models;
  std::vector<Named_mesh> meshes = {
    { "empty", Mesh() },
    { "a border", noisy_mesh(saddle, 300, 0.2) },
    { "a vertex that is not manifold", two_fans_with_a_common_center() },
    { "noise that makes the surface cross itself", noisy_mesh(thin_plate, 600, 1) }
  };
  const auto add = [&](const std::string& name) -> Mesh&
  {
    meshes.push_back({ name, noisy_mesh(cube, 300, 0.2) });
    return meshes.back().mesh;
  };
  {
    Mesh& m = add("isolated vertices");
    m.add_vertex(Point(0, 0, 0));
    m.add_vertex(Point(5, 0, 0));
  }
  {
    Mesh& m = add("isolated vertices alone");
    m.clear();
    m.add_vertex(Point(0, 0, 0));
    m.add_vertex(Point(5, 0, 0));
  }
  {
    Mesh& m = add("two components that intersect");
    m.join(noisy_mesh(sphere, 300, 0.2));
  }
  {
    Mesh& m = add("faces on a line");
    for(std::size_t f=0; f<num_faces(m); f += 10)
    {
      const std::array<Vertex, 3> t = vertices_of(m, Face(Mesh::size_type(f)));
      m.point(t[0]) = CGAL::midpoint(m.point(t[1]), m.point(t[2]));
    }
  }
  {
    Mesh& m = add("faces in a point");
    for(std::size_t f=0; f<num_faces(m); f += 10)
    {
      const std::array<Vertex, 3> t = vertices_of(m, Face(Mesh::size_type(f)));
      m.point(t[0]) = m.point(t[1]) = m.point(t[2]);
    }
  }
  {
    Mesh& m = add("all vertices in a point");
    for(const Vertex v : vertices(m))
      m.point(v) = Point(3, 4, 5);
  }
  {
    Mesh& m = add("all vertices on a line");
    for(const Vertex v : vertices(m))
      m.point(v) = Point(m.point(v).x(), 0, 0);
  }
  {
    Mesh& m = add("all vertices in a plane, the one side over the other");
    for(const Vertex v : vertices(m))
      m.point(v) = Point(m.point(v).x(), m.point(v).y(), 0);
  }
  {
    Mesh& m = add("a vertex far away");
    m.point(Vertex(0)) = Point(1e9, 0, 0);
  }
  {
    Mesh& m = add("a vertex with many faces");
    m.join(fan(2000, 0.1));
  }
  {
    Mesh& m = add("triangles without a neighbor");
    m.clear();
    for(int i=0; i<4; ++i)
      m.add_face(m.add_vertex(Point(i, 0, 0)), m.add_vertex(Point(i, 1, 0.2)), m.add_vertex(Point(i, 0.3, 1)));
  }
  return meshes;
}

TEST(Bad_input, Awkward_meshes_are_accepted)
{
  for(const Named_mesh& awkward : awkward_meshes())
  {
    SCOPED_TRACE(awkward.name);
    Mesh mesh = awkward.mesh;
    auto face_normals = mesh.add_property_map<Face, Vector>("f:normal").first;
    auto vertex_normals = mesh.add_property_map<Vertex, Vector>("v:normal").first;
    const auto expect_unit_or_null = [](const Vector& n)
    {
      const double length = std::sqrt(n.squared_length());
      ASSERT_TRUE(length == 0 || std::abs(length - 1) < 1e-12) << n;
    };

    const auto expect_accepted = [&](const auto& denoise)
    {
      for(const Vertex v : vertices(mesh))
        mesh.point(v) = awkward.mesh.point(v);
      EXPECT_NO_THROW(denoise(params::face_normal_map(face_normals).vertex_normal_map(vertex_normals)));
      EXPECT_TRUE(has_finite_points(mesh));
      for(const Face f : faces(mesh))
        expect_unit_or_null(face_normals[f]);
      for(const Vertex v : vertices(mesh))
        expect_unit_or_null(vertex_normals[v]);
    };
    expect_accepted([&](const auto& np) { SMD::denoise_anisotropic_fitting(mesh, np); });
    expect_accepted([&](const auto& np) { SMD::denoise_anisotropic_fitting(mesh, np.number_of_iterations(30)); });
    expect_accepted([&](const auto& np) { SMD::denoise_isotropic_fitting(mesh, np); });
    expect_accepted([&](const auto&) { SMD::filter_vertex_normals(mesh, vertex_normals); });

    for(const Face seed : faces(mesh))
    {
      std::vector<Face> found;
      EXPECT_NO_THROW(SMD::anisotropic_neighborhood(seed, mesh, std::back_inserter(found)));
      ASSERT_FALSE(found.empty());
      ASSERT_EQ(found.front(), seed);
    }
  }
}

TEST(Bad_input, An_empty_mesh_has_converged)
{
  Mesh mesh;
  EXPECT_TRUE(SMD::denoise_anisotropic_fitting(mesh, params::number_of_iterations(30)).has_converged);
  EXPECT_TRUE(SMD::denoise_isotropic_fitting(mesh).has_converged);
}

TEST(Bad_input, Isolated_vertices_stay)
{
  for(const Function& denoise : denoising_functions())
  {
    Mesh mesh = small_mesh();
    const Vertex v = mesh.add_vertex(Point(0.1, 0.2, 0.3));
    denoise(mesh);
    EXPECT_EQ(mesh.point(v), Point(0.1, 0.2, 0.3));
  }
}

TEST(Bad_input, A_degenerate_mesh_stays)
{
  for(const Named_mesh& awkward : awkward_meshes())
    if(awkward.name == "all vertices in a point" || awkward.name == "all vertices on a line")
      for(const Function& denoise : denoising_functions())
      {
        Mesh mesh = awkward.mesh;
        denoise(mesh);
        EXPECT_EQ(points_of(mesh), points_of(awkward.mesh));
      }
}

TEST(Bad_input, A_single_triangle_stays)
{
  Mesh original;
  original.add_face(original.add_vertex(Point(0.3, 1, 2)), original.add_vertex(Point(4, 0.1, -1)),
                    original.add_vertex(Point(-1, 2, 0.7)));
  for(const Function& denoise : denoising_functions())
  {
    Mesh mesh = original;
    denoise(mesh);
    EXPECT_LT(largest_distance(mesh, original), 1e-14);
  }
}

// Five points are too few for a quadratic surface. In the plane that fits best, the center has the weight 1 and the
// four points around it exp(-1).
TEST(Bad_input, A_vertex_with_few_neighbors_goes_to_a_plane)
{
  const double height = 0.25, e = std::exp(1.);
  Mesh mesh = fan(4, height);
  Anisotropic_parameters one_full_step;
  one_full_step.number_of_iterations = 1;
  one_full_step.relaxation_factor = 1;
  denoise_anisotropic(mesh, one_full_step);
  EXPECT_LT(distance(mesh.point(Vertex(0)), Point(0, 0, height * e / (e + 4))), 1e-14);

  mesh = fan(4, height);
  Isotropic_parameters one_full_isotropic_step;
  one_full_isotropic_step.number_of_iterations = 1;
  one_full_isotropic_step.relaxation_factor = 1;
  denoise_isotropic(mesh, one_full_isotropic_step);
  EXPECT_LT(distance(mesh.point(Vertex(0)), Point(0, 0, height * e / (e + 4))), 1e-14);
}

TEST(Bad_input, Fit_of_points_that_do_not_determine_a_surface)
{
  using SMD::internal::height_of_fit;
  const Point o(0, 0, 0);
  const Vector up(0, 0, 1);
  EXPECT_EQ(height_of_fit(o, up, {}), 0);
  EXPECT_EQ(height_of_fit(o, up, { o, o, o, o, o, o, o }), 0);
  // as seen along the axis, all on a line: not even a plane
  std::vector<Point> line, two_lines;
  for(int i=-5; i<=5; ++i)
  {
    line.emplace_back(i, 2*i, 1);
    two_lines.emplace_back(i, 0, 1);
    two_lines.emplace_back(i, 1, 3);
  }
  EXPECT_EQ(height_of_fit(o, up, line), 0);
  // on two lines: a plane through both, but no quadratic surface
  EXPECT_NEAR(height_of_fit(o, up, two_lines), 1, 1e-12);
  // the line is nearly one only
  for(Point& p : line)
    p = Point(p.x(), p.y() + 1e-7 * std::sin(p.x()), p.z());
  EXPECT_EQ(height_of_fit(o, up, line), 0);
}

TEST(Bad_input, Random_points_give_finite_results)
{
  std::mt19937 random(1);
  const Mesh connectivity = irregular_mesh(generated_models::sphere, 200);
  for(int i=0; i<6; ++i)
  {
    SCOPED_TRACE(i);
    Mesh garbage = connectivity;
    // the fewer places there are, the more vertices coincide
    const int number_of_places = (i % 3 == 0) ? 1 << 30 : (i % 3 == 1) ? 6 : 2;
    std::uniform_int_distribution<int> place(0, number_of_places - 1);
    const auto coordinate = [&]() { return double(place(random)); };
    for(const Vertex v : vertices(garbage))
    {
      const double x = coordinate(), y = coordinate(), z = coordinate();
      garbage.point(v) = Point(x, y, z);
    }
    {
      Mesh mesh = garbage;
      EXPECT_NO_THROW(SMD::denoise_anisotropic_fitting(mesh));
      EXPECT_TRUE(has_finite_points(mesh));
    }
    for(const int size : { 1, 3, 6, 40 })
    {
      Anisotropic_parameters parameters;
      parameters.neighborhood_size = size;
      parameters.relaxation_factor = (i % 2 == 0) ? 1 : 0.5;
      Mesh mesh = garbage;
      EXPECT_NO_THROW(denoise_anisotropic(mesh, parameters));
      EXPECT_TRUE(has_finite_points(mesh));
    }
    for(const int size : { 1, 2, 4 })
    {
      Isotropic_parameters parameters;
      parameters.neighborhood_ring_size = size;
      parameters.normal_sigma = (i % 2 == 0) ? 1e-3 : 1e3;
      Mesh mesh = garbage;
      EXPECT_NO_THROW(denoise_isotropic(mesh, parameters));
      EXPECT_TRUE(has_finite_points(mesh));
    }
  }
}

// ---- sizes of coordinates

TEST(Bad_input, Extreme_parameters_give_finite_results)
{
  const Mesh noisy = noisy_mesh(generated_models::cube, 200, 0.3);
  for(const double extreme : { 1e-300, 1e300 })
  {
    Anisotropic_parameters a;
    a.normal_weight = extreme;
    a.convergence_threshold = extreme;
    a.angle_threshold = (extreme < 1) ? extreme : 1 - 1e-16;
    Mesh mesh = noisy;
    EXPECT_NO_THROW(denoise_anisotropic(mesh, a));
    EXPECT_TRUE(has_finite_points(mesh));

    Isotropic_parameters i;
    i.spatial_sigma = i.normal_sigma = extreme;
    mesh = noisy;
    EXPECT_NO_THROW(denoise_isotropic(mesh, i));
    EXPECT_TRUE(has_finite_points(mesh));
  }
}

// powers of two: nothing is rounded
TEST(Bad_input, Very_large_and_very_small_coordinates)
{
  const Mesh noisy = noisy_mesh(generated_models::cube, 200, 0.2);
  const auto scaled = [](Mesh mesh, const int exponent)
  {
    for(const Vertex v : vertices(mesh))
      mesh.point(v) = Point(std::ldexp(mesh.point(v).x(), exponent), std::ldexp(mesh.point(v).y(), exponent),
                            std::ldexp(mesh.point(v).z(), exponent));
    return mesh;
  };
  for(const Function& denoise : denoising_functions())
  {
    Mesh denoised = noisy;
    denoise(denoised);
    for(const int exponent : { -900, -500, 500, 1000 }) // 1e-271, 1e-151, 1e150, 1e301
    {
      Mesh mesh = scaled(noisy, exponent);
      denoise(mesh);
      EXPECT_EQ(points_of(mesh), points_of(scaled(denoised, exponent)));
    }
  }
}

TEST(Bad_input, The_largest_and_the_smallest_numbers)
{
  const Mesh noisy = noisy_mesh(generated_models::cube, 200, 0.2);
  double extent = 0;
  for(const Point& p : points_of(noisy))
    extent = (std::max)({ extent, std::abs(p.x()), std::abs(p.y()), std::abs(p.z()) });
  for(const double size : { std::numeric_limits<double>::max(), std::numeric_limits<double>::min(),
                            std::numeric_limits<double>::denorm_min() })
  {
    Mesh mesh = noisy;
    for(const Vertex v : vertices(mesh))
      mesh.point(v) = Point(mesh.point(v).x() / extent * size, mesh.point(v).y() / extent * size,
                            mesh.point(v).z() / extent * size);
    ASSERT_TRUE(has_finite_points(mesh));
    for(const Function& denoise : denoising_functions())
    {
      Mesh denoised = mesh;
      EXPECT_NO_THROW(denoise(denoised));
      EXPECT_TRUE(has_finite_points(denoised));
    }
  }
}

TEST(Bad_input, Large_offsets)
{
  const Mesh noisy = noisy_mesh(generated_models::cube, 200, 0.2);
  Anisotropic_parameters parameters;
  parameters.number_of_iterations = 3;
  Mesh denoised = noisy;
  denoise_anisotropic(denoised, parameters);
  for(const double offset : { 1e3, 1e6, 1e15, 1e200 })
  {
    const Vector shift(offset, -offset, 0.5 * offset);
    Mesh mesh = noisy;
    for(const Vertex v : vertices(mesh))
      mesh.point(v) = mesh.point(v) + shift;
    for(const Function& denoise : denoising_functions())
    {
      Mesh same = mesh;
      EXPECT_NO_THROW(denoise(same));
      EXPECT_TRUE(has_finite_points(same));
    }
    denoise_anisotropic(mesh, parameters);
    if(offset > 1e6) // most digits of the mesh are lost
      continue;
    for(const Vertex v : vertices(mesh))
      ASSERT_LT(distance(mesh.point(v) - shift, denoised.point(v)), 1e-11 * offset);
  }
}

TEST(Bad_input, Float_coordinates_near_the_end_of_their_range)
{
  typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3> Float_mesh;
  generated_models::Model model = irregular_model(generated_models::cube, 200);
  for(const float size : { 1e30f, 3.4e38f, 1e-38f })
  {
    Float_mesh mesh = generated_models::to_mesh<Float_mesh>(model);
    for(const auto v : vertices(mesh))
    {
      // shrunk at random
      const float s = size * (0.9f + 0.1f * float(v.idx() * 37 % 11) / 10);
      mesh.point(v) = Float_mesh::Point(mesh.point(v).x() * s, mesh.point(v).y() * s, mesh.point(v).z() * s);
    }
    ASSERT_TRUE(has_finite_points(mesh));
    Float_mesh same = mesh;
    const auto before = points_of(mesh);
    SMD::denoise_anisotropic_fitting(mesh);
    EXPECT_TRUE(has_finite_points(mesh));
    EXPECT_NE(points_of(mesh), before);
    SMD::denoise_anisotropic_fitting(same, params::number_of_iterations(30));
    EXPECT_TRUE(has_finite_points(same));
    EXPECT_NE(points_of(same), before);
  }
}

// ---- whatever is thrown, the points are as before

struct Thrown {};

// counts down with each call, and throws at zero
struct Fuse
{
  int number_of_calls_left = -1; // less than zero: never
  void burn()
  {
    if(number_of_calls_left == 0)
    {
      number_of_calls_left = -1;
      throw Thrown();
    }
    if(number_of_calls_left > 0)
      --number_of_calls_left;
  }
};

// the points of a mesh. Throws at some access, writing or reading
struct Throwing_point_map
{
  typedef Vertex                           key_type;
  typedef Point                            value_type;
  typedef Point                            reference;
  typedef boost::read_write_property_map_tag category;

  Mesh* mesh;
  Fuse* fuse;
  bool writes_before_it_throws;

  friend Point get(const Throwing_point_map& map, const Vertex v)
  {
    map.fuse->burn();
    return map.mesh->point(v);
  }
  friend void put(const Throwing_point_map& map, const Vertex v, const Point& p)
  {
    if(map.writes_before_it_throws)
      map.mesh->point(v) = p;
    map.fuse->burn();
    map.mesh->point(v) = p;
  }
};

template <typename Denoise>
void expect_points_as_before(const bool writes_before_it_throws, const Denoise& denoise)
{
  const Mesh original = small_mesh();
  int number_of_throws = 0;
  for(bool has_thrown = true; has_thrown; )
  {
    Mesh mesh = original;
    Fuse fuse{number_of_throws};
    has_thrown = false;
    try
    {
      denoise(mesh, params::vertex_point_map(Throwing_point_map{&mesh, &fuse, writes_before_it_throws}));
    }
    catch(const Thrown&)
    {
      has_thrown = true;
      ++number_of_throws;
      ASSERT_EQ(points_of(mesh), points_of(original));
    }
    if(!has_thrown)
    {
      EXPECT_NE(points_of(mesh), points_of(original));
    }
  }
  // each vertex is read before, and written after
  EXPECT_GE(number_of_throws, 2 * int(num_vertices(original)));
}

TEST(Bad_input, Point_maps_that_throw_at_any_access)
{
  for(const bool writes_before_it_throws : { false, true })
  {
    expect_points_as_before(writes_before_it_throws, [](Mesh& mesh, const auto& np)
                            { SMD::denoise_anisotropic_fitting(mesh, np); });
    expect_points_as_before(writes_before_it_throws, [](Mesh& mesh, const auto& np)
                            { SMD::denoise_anisotropic_fitting(mesh, np.number_of_iterations(3)); });
    expect_points_as_before(writes_before_it_throws, [](Mesh& mesh, const auto& np)
                            { SMD::denoise_isotropic_fitting(mesh, np.number_of_iterations(3)); });
  }
}

// a vertex that cannot be written at all
struct Locked_point_map
{
  typedef Vertex                           key_type;
  typedef Point                            value_type;
  typedef Point                            reference;
  typedef boost::read_write_property_map_tag category;

  Mesh* mesh;
  Vertex locked;

  friend Point get(const Locked_point_map& map, const Vertex v) { return map.mesh->point(v); }
  friend void put(const Locked_point_map& map, const Vertex v, const Point& p)
  {
    if(v == map.locked)
      throw Thrown();
    map.mesh->point(v) = p;
  }
};

TEST(Bad_input, A_vertex_that_cannot_be_written)
{
  const Mesh original = small_mesh();
  for(const Vertex locked : vertices(original))
  {
    Mesh mesh = original;
    EXPECT_THROW(SMD::denoise_anisotropic_fitting(
                   mesh, params::number_of_iterations(3).vertex_point_map(Locked_point_map{&mesh, locked})), Thrown);
    ASSERT_EQ(points_of(mesh), points_of(original));
  }
}

struct Throwing_visitor
{
  std::size_t iteration_that_throws;
  bool iteration_completed(const std::size_t iteration, double, bool) const
  {
    if(iteration == iteration_that_throws)
      throw Thrown();
    return true;
  }
};

TEST(Bad_input, Visitors_that_throw)
{
  const Mesh original = small_mesh();
  Mesh mesh = original;
  EXPECT_THROW(SMD::denoise_anisotropic_fitting(mesh, params::visitor(Throwing_visitor{1})), Thrown);
  EXPECT_EQ(points_of(mesh), points_of(original));
  for(const std::size_t iteration : { 1, 2 })
  {
    EXPECT_THROW(SMD::denoise_anisotropic_fitting(
                   mesh, params::number_of_iterations(3).visitor(Throwing_visitor{iteration})), Thrown);
    EXPECT_EQ(points_of(mesh), points_of(original));
    EXPECT_THROW(SMD::denoise_isotropic_fitting(mesh, params::visitor(Throwing_visitor{iteration})), Thrown);
    EXPECT_EQ(points_of(mesh), points_of(original));
  }
}

// throws at the first access to the key that is handed in
template <typename Key, typename Value>
struct Throwing_map
{
  typedef Key                                key_type;
  typedef Value                              value_type;
  typedef Value                              reference;
  typedef boost::read_write_property_map_tag category;

  Key key;

  friend Value get(const Throwing_map& map, const Key& k)
  {
    if(k == map.key)
      throw Thrown();
    return Value();
  }
  friend void put(const Throwing_map& map, const Key& k, const Value&)
  {
    if(k == map.key)
      throw Thrown();
  }
};

struct Throwing_filter
{
  template <typename ConcurrencyTag>
  void operator()(const SMD::Indexed_triangle_mesh&, std::vector<SMD::Indexed_triangle_mesh::Vector_3>&,
                  std::size_t, ConcurrencyTag) const
  {
    throw Thrown();
  }
};

TEST(Bad_input, Other_maps_and_filters_that_throw)
{
  const Mesh original = small_mesh();
  Mesh mesh = original;
  const auto expect_thrown = [&](const auto& np)
  {
    EXPECT_THROW(SMD::denoise_anisotropic_fitting(mesh, np), Thrown);
    EXPECT_EQ(points_of(mesh), points_of(original));
  };
  const Face f(Mesh::size_type(num_faces(mesh) - 1));
  const Vertex v(Mesh::size_type(num_vertices(mesh) - 1));
  expect_thrown(params::face_normal_map(Throwing_map<Face, Vector>{f}));
  expect_thrown(params::vertex_normal_map(Throwing_map<Vertex, Vector>{v}));
  expect_thrown(params::vertex_is_constrained_map(Throwing_map<Vertex, bool>{v}));
  expect_thrown(params::edge_is_constrained_map(Throwing_map<Edge, bool>{Edge(Mesh::size_type(num_edges(mesh) - 1))}));
  expect_thrown(params::vertex_index_map(Throwing_map<Vertex, std::size_t>{*vertices(mesh).begin()}));
  expect_thrown(params::face_index_map(Throwing_map<Face, std::size_t>{*faces(mesh).begin()}));
  expect_thrown(params::face_normal_filter(Throwing_filter()));
}

// breaks its contract
struct Garbage_filter
{
  template <typename ConcurrencyTag>
  void operator()(const SMD::Indexed_triangle_mesh&, std::vector<SMD::Indexed_triangle_mesh::Vector_3>& normals,
                  std::size_t, ConcurrencyTag) const
  {
    typedef SMD::Indexed_triangle_mesh::Vector_3 Vector_3;
    const double values[] = { nan_value, infinity, -infinity, 1e300, 0 };
    for(std::size_t f=0; f<normals.size(); ++f)
      if(f % 3 == 0)
        normals[f] = Vector_3(values[f % 5], values[f % 2], 1);
  }
};

TEST(Bad_input, A_filter_that_returns_garbage_gives_finite_results)
{
  Mesh mesh = noisy_mesh(generated_models::cube, 200, 0.2);
  EXPECT_NO_THROW(SMD::denoise_anisotropic_fitting(mesh, params::face_normal_filter(Garbage_filter())));
  EXPECT_TRUE(has_finite_points(mesh));
}
