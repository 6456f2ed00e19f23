// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The methods that fit no surfaces: their formulas, written down a second time, and what is known of their results.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_denoising/denoise_bilateral.h>
#include <CGAL/Surface_mesh_denoising/denoise_noniterative.h>
#include <CGAL/Surface_mesh_denoising/denoise_prescribed_mean_curvature.h>
#include <CGAL/Surface_mesh_denoising/denoise_taubin.h>
#include <CGAL/Surface_mesh_denoising/denoise_with_normals.h>
#include <CGAL/Surface_mesh_denoising/measure_error.h>

#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <set>
#include <stdexcept>
#include <string>

using generated_models::cube;
using generated_models::saddle;
using generated_models::sphere;

struct Thrown {};

// what all functions take, in calls that have one type
struct Setting
{
  std::vector<bool> is_movable, is_constrained, is_crease; // empty: all, none, none
  int number_of_iterations = -1;                            // of the method's own
  std::function<bool(std::size_t, double, bool)> visit;

  bool iteration_completed(const std::size_t iteration, const double largest, const bool has_converged) const
  { return !visit || visit(iteration, largest, has_converged); }
};

// all that a function returns or writes
struct Outcome
{
  Mesh mesh;
  SMD::Denoising_result result;
  std::vector<Vector> face_normals, vertex_normals;

  bool operator==(const Outcome& other) const
  {
    return points_of(mesh) == points_of(other.mesh) && face_normals == other.face_normals
        && vertex_normals == other.vertex_normals
        && result.number_of_iterations == other.result.number_of_iterations
        && result.has_converged == other.result.has_converged;
  }
};

template <typename Call>
Outcome run(const Mesh& mesh, const Setting& setting, const int default_number_of_iterations, const Call& call)
{
  Outcome outcome{mesh, {}, {}, {}};
  Mesh& m = outcome.mesh;
  auto face_normals = m.add_property_map<Face, Vector>("f:n", Vector(7, 7, 7)).first;
  auto vertex_normals = m.add_property_map<Vertex, Vector>("v:n", Vector(7, 7, 7)).first;
  auto is_constrained = m.add_property_map<Vertex, bool>("v:constrained", false).first;
  auto is_crease = m.add_property_map<Edge, bool>("e:crease", false).first;
  std::vector<Vertex> range;
  for(const Vertex v : vertices(m))
  {
    if(!setting.is_constrained.empty())
      is_constrained[v] = setting.is_constrained[v];
    if(setting.is_movable.empty() || setting.is_movable[v])
      range.push_back(v);
  }
  if(!setting.is_crease.empty())
    for(const Edge e : edges(m))
      is_crease[e] = setting.is_crease[e];
  const auto np
    = params::number_of_iterations(setting.number_of_iterations < 0 ? default_number_of_iterations
                                                                    : setting.number_of_iterations)
             .visitor(std::cref(setting)).face_normal_map(face_normals).vertex_normal_map(vertex_normals)
             .vertex_is_constrained_map(is_constrained).edge_is_constrained_map(is_crease);
  outcome.result = call(range, m, np);
  outcome.face_normals.assign(face_normals.begin(), face_normals.end());
  outcome.vertex_normals.assign(vertex_normals.begin(), vertex_normals.end());
  return outcome;
}

template <typename ConcurrencyTag>
Outcome with_normals(const Mesh& mesh, const Setting& setting)
{
  return run(mesh, setting, 10, [](const auto& range, Mesh& m, const auto& np)
  { return SMD::denoise_with_normals<ConcurrencyTag>(range, m, np); });
}

template <typename ConcurrencyTag>
Outcome bilateral(const Mesh& mesh, const Setting& setting)
{
  return run(mesh, setting, 5, [](const auto& range, Mesh& m, const auto& np)
  { return SMD::denoise_bilateral<ConcurrencyTag>(range, m, np); });
}

template <typename ConcurrencyTag>
Outcome noniterative(const Mesh& mesh, const Setting& setting)
{
  return run(mesh, setting, 1, [](const auto& range, Mesh& m, const auto& np)
  {
    SMD::denoise_noniterative<ConcurrencyTag>(range, m, np);
    return SMD::Denoising_result();
  });
}

template <typename ConcurrencyTag>
Outcome taubin(const Mesh& mesh, const Setting& setting)
{
  return run(mesh, setting, 20, [](const auto& range, Mesh& m, const auto& np)
  { return SMD::denoise_taubin<ConcurrencyTag>(range, m, np); });
}

template <typename ConcurrencyTag>
Outcome prescribed_mean_curvature(const Mesh& mesh, const Setting& setting)
{
  return run(mesh, setting, 40, [](const auto& range, Mesh& m, const auto& np)
  { return SMD::denoise_prescribed_mean_curvature<ConcurrencyTag>(range, m, np); });
}

struct Method
{
  typedef Outcome (*Function)(const Mesh&, const Setting&);
  const char* name;
  Function sequential, parallel;
  bool is_iterative;
  bool moves_along_the_surface;

  Mesh operator()(const Mesh& mesh) const { return sequential(mesh, Setting()).mesh; }
};

#define METHOD(NAME, IS_ITERATIVE, MOVES_ALONG_THE_SURFACE) \
  { #NAME, NAME<CGAL::Sequential_tag>, NAME<CGAL::Parallel_if_available_tag>, IS_ITERATIVE, MOVES_ALONG_THE_SURFACE }

const Method methods[] = {
  METHOD(with_normals, true, false),
  METHOD(bilateral, true, false),
  METHOD(noniterative, false, false),
  METHOD(taubin, true, true),
  METHOD(prescribed_mean_curvature, true, false)
};

template <typename Transformation>
Mesh transformed(Mesh mesh, const Transformation& transformation)
{
  for(const Vertex v : vertices(mesh))
    mesh.point(v) = transformation(mesh.point(v));
  return mesh;
}

// ---- the formulas

Vector unit(const Vector& v) { return v / std::sqrt(v.squared_length()); }

double gaussian(const double x, const double sigma) { return std::exp(-x*x / (2 * sigma*sigma)); }

std::set<Vertex> neighbors_of(const Mesh& mesh, const Vertex v)
{
  std::set<Vertex> result;
  for(const Vertex w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
    result.insert(w);
  return result;
}

std::set<Face> faces_of(const Mesh& mesh, const Vertex v)
{
  std::set<Face> result;
  for(const Face f : CGAL::faces_around_target(mesh.halfedge(v), mesh))
    if(f != Mesh::null_face())
      result.insert(f);
  return result;
}

Point center_of(const Mesh& mesh, const Face f)
{
  const std::array<Vertex, 3> t = vertices_of(mesh, f);
  return centroid(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]));
}

double area_of(const Mesh& mesh, const Face f)
{
  const std::array<Vertex, 3> t = vertices_of(mesh, f);
  return std::sqrt(cross_product(mesh.point(t[1]) - mesh.point(t[0]),
                                 mesh.point(t[2]) - mesh.point(t[0])).squared_length()) / 2;
}

TEST(Other_methods, Formula_of_the_normal_driven_update)
{
  const Mesh mesh = noisy_mesh(sphere, 150, 0.2);
  Setting setting;
  setting.number_of_iterations = 1;
  const Outcome outcome = with_normals<CGAL::Sequential_tag>(mesh, setting);
  Mesh expected = mesh;
  for(const Vertex v : vertices(mesh))
  {
    Vector sum(0, 0, 0);
    for(const Face f : faces_of(mesh, v))
    {
      const Vector n = outcome.face_normals[f];
      sum += (n * (center_of(mesh, f) - mesh.point(v))) * n;
    }
    expected.point(v) = mesh.point(v) + sum / double(faces_of(mesh, v).size());
  }
  EXPECT_LT(largest_distance(outcome.mesh, expected), 1e-12);
  EXPECT_GT(largest_distance(outcome.mesh, mesh), 0.01);
}

TEST(Other_methods, Formula_of_bilateral_denoising)
{
  const Mesh mesh = noisy_mesh(sphere, 150, 0.1);
  Mesh expected = mesh, result = mesh;
  for(const Vertex v : vertices(mesh))
  {
    Vector n(0, 0, 0);
    for(const Face f : faces_of(mesh, v))
      n += normal_of(mesh, f);
    n = unit(n);
    double shortest = std::numeric_limits<double>::infinity();
    for(const Vertex w : neighbors_of(mesh, v))
      shortest = (std::min)(shortest, distance(mesh.point(v), mesh.point(w)));
    const double sigma_c = 1.2 * shortest;

    std::vector<double> distances, heights;
    for(const Vertex w : vertices(mesh))
      if(distance(mesh.point(v), mesh.point(w)) <= 2 * sigma_c)
      {
        distances.push_back(distance(mesh.point(v), mesh.point(w)));
        heights.push_back(n * (mesh.point(w) - mesh.point(v)));
      }
    double mean = 0, variance = 0;
    for(const double h : heights)
      mean += std::abs(h) / double(heights.size());
    for(const double h : heights)
      variance += std::pow(std::abs(h) - mean, 2) / double(heights.size());

    double sum = 0, weights = 0;
    for(std::size_t i=0; i<heights.size(); ++i)
    {
      const double weight = gaussian(distances[i], sigma_c) * gaussian(heights[i], std::sqrt(variance));
      sum += weight * heights[i];
      weights += weight;
    }
    expected.point(v) = mesh.point(v) + (sum / weights) * n;
  }
  SMD::denoise_bilateral(result, params::number_of_iterations(1).spatial_sigma(1.2));
  EXPECT_LT(largest_distance(result, expected), 1e-12);
  EXPECT_GT(largest_distance(result, mesh), 0.01);
}

TEST(Other_methods, Formula_of_noniterative_denoising)
{
  const Mesh mesh = noisy_mesh(sphere, 150, 0.1);
  const double unit_length = mean_edge_length(mesh), sigma_f = 0.9 * unit_length, sigma_g = 0.4 * unit_length;
  const auto near_faces = [&](const Vertex v)
  {
    std::set<Face> result = faces_of(mesh, v);
    for(const Face f : faces(mesh))
      if(distance(mesh.point(v), center_of(mesh, f)) <= 2 * sigma_f)
        result.insert(f);
    return result;
  };

  Mesh mollified = mesh, expected = mesh, result = mesh;
  for(const Vertex v : vertices(mesh))
  {
    Vector sum(0, 0, 0);
    double weights = 0;
    for(const Face f : near_faces(v))
    {
      const Vector d = center_of(mesh, f) - mesh.point(v);
      const double weight = area_of(mesh, f) * gaussian(std::sqrt(d.squared_length()), sigma_f / 2);
      sum += weight * d;
      weights += weight;
    }
    mollified.point(v) = mesh.point(v) + sum / weights;
  }
  for(const Vertex v : vertices(mesh))
  {
    Vector sum(0, 0, 0);
    double weights = 0;
    for(const Face f : near_faces(v))
    {
      const Vector d = center_of(mesh, f) - mesh.point(v), n = normal_of(mollified, f), prediction = (d * n) * n;
      const double weight = area_of(mesh, f) * gaussian(std::sqrt(d.squared_length()), sigma_f)
                          * gaussian(std::sqrt(prediction.squared_length()), sigma_g);
      sum += weight * prediction;
      weights += weight;
    }
    expected.point(v) = mesh.point(v) + sum / weights;
  }
  SMD::denoise_noniterative(result, params::spatial_sigma(0.9).height_sigma(0.4));
  EXPECT_LT(largest_distance(result, expected), 1e-12);
  EXPECT_GT(largest_distance(result, mesh), 0.01);
}

TEST(Other_methods, Formula_of_lambda_mu_smoothing)
{
  const Mesh mesh = noisy_mesh(sphere, 150, 0.2);
  const auto smoothed = [](const Mesh& m, const double share)
  {
    Mesh result = m;
    for(const Vertex v : vertices(m))
    {
      Vector sum(0, 0, 0);
      for(const Vertex w : neighbors_of(m, v))
        sum += m.point(w) - m.point(v);
      result.point(v) = m.point(v) + share / double(neighbors_of(m, v).size()) * sum;
    }
    return result;
  };
  Mesh result = mesh, laplacian = mesh;
  SMD::denoise_taubin(result, params::number_of_iterations(2).lambda(0.4).mu(-0.45));
  EXPECT_LT(largest_distance(result, smoothed(smoothed(smoothed(smoothed(mesh, 0.4), -0.45), 0.4), -0.45)), 1e-12);
  SMD::denoise_taubin(laplacian, params::number_of_iterations(2).lambda(0.7).mu(0));
  EXPECT_LT(largest_distance(laplacian, smoothed(smoothed(mesh, 0.7), 0.7)), 1e-12);
}

// where no edge counts as a feature, the mean curvature vector is the gradient of the area
TEST(Other_methods, Prescribed_mean_curvature_flow_descends_along_the_gradient_of_the_area)
{
  const Mesh mesh = noisy_mesh(sphere, 150, 0.02);
  Mesh result = mesh;
  SMD::denoise_prescribed_mean_curvature(result, params::number_of_iterations(1).angle_threshold(1e-9)
                                                        .relaxation_factor(0.3));
  struct Star { Vector gradient, normal; double area, stiffness; };
  std::vector<Star> stars;
  for(const Vertex v : vertices(mesh))
  {
    Star star{ Vector(0, 0, 0), Vector(0, 0, 0), 0, 0 };
    for(const Halfedge h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh))
    {
      const Point p = mesh.point(v), q = mesh.point(mesh.target(mesh.next(h))), r = mesh.point(mesh.source(h));
      const Vector n = unit(cross_product(q - p, r - p));
      const double area = std::sqrt(cross_product(q - p, r - p).squared_length()) / 2;
      star.gradient += 0.5 * cross_product(n, r - q);
      star.normal += area * n;
      star.area += area / 3;
      star.stiffness += (std::abs((p - q) * (r - q)) + std::abs((p - r) * (q - r))) / (4 * area);
    }
    star.normal = unit(star.normal);
    stars.push_back(star);
  }
  Mesh expected = mesh;
  for(const Vertex v : vertices(mesh))
  {
    const Star& star = stars[v];
    double curvature = star.gradient * star.normal, area = star.area;
    for(const Vertex w : neighbors_of(mesh, v))
    {
      curvature += stars[w].gradient * stars[w].normal;
      area += stars[w].area;
    }
    expected.point(v) = mesh.point(v)
                      + 0.3 / star.stiffness * (curvature / area * star.area * star.normal - star.gradient);
  }
  EXPECT_LT(largest_distance(result, expected), 1e-12);
  EXPECT_GT(largest_distance(result, mesh), 1e-3);
}

// ---- what is known of the results

TEST(Other_methods, A_plane_stays_a_plane)
{
  Mesh mesh = irregular_mesh(saddle, 400);
  for(const Vertex v : vertices(mesh))
  {
    const Point p = mesh.point(v);
    mesh.point(v) = Point(p.x() + 0.3 * p.y(), p.y() - 0.2 * p.x(), 0.5 * p.x() + 0.25 * p.y() + 3);
  }
  // the gradient of a linear function that vanishes on it
  const Point o = mesh.point(Vertex(0)), a = mesh.point(Vertex(20)), b = mesh.point(Vertex(133));
  const Vector n = unit(cross_product(a - o, b - o));
  for(const Method& method : methods)
  {
    const Mesh result = method(mesh);
    for(const Vertex v : vertices(result))
      ASSERT_LT(std::abs(n * (result.point(v) - o)), 1e-13) << method.name;
    if(!method.moves_along_the_surface)
    {
      EXPECT_LT(largest_distance(result, mesh), 1e-13) << method.name;
    }
  }
}

TEST(Other_methods, Noise_falls)
{
  for(const Model_generator generate : { sphere, saddle })
  {
    const Mesh truth = irregular_mesh(generate, 1500), noisy = with_noise(truth, 0.2);
    for(const Method& method : methods)
    {
      const Mesh result = method(noisy);
      EXPECT_LT(SMD::angular_error(result, truth).mean, 0.5 * SMD::angular_error(noisy, truth).mean) << method.name;
      EXPECT_LT(SMD::vertex_distance_error(result, truth).root_mean_square,
                0.75 * SMD::vertex_distance_error(noisy, truth).root_mean_square) << method.name;
      EXPECT_LE(SMD::number_of_flipped_faces(result, truth), SMD::number_of_flipped_faces(noisy, truth))
        << method.name;
    }
  }
}

TEST(Other_methods, Edges_of_a_cube_stay_where_the_method_says_so)
{
  const Mesh truth = irregular_mesh(cube, 1500), noisy = with_noise(truth, 0.2);
  const double smoothed = SMD::angular_error(taubin<CGAL::Sequential_tag>(noisy, Setting()).mesh, truth).mean;
  for(const auto& method : { with_normals<CGAL::Sequential_tag>, prescribed_mean_curvature<CGAL::Sequential_tag> })
    EXPECT_LT(SMD::angular_error(method(noisy, Setting()).mesh, truth).mean, 0.6 * smoothed);

  EXPECT_LT(largest_distance(with_normals<CGAL::Sequential_tag>(truth, Setting()).mesh, truth), 1e-13);
}

TEST(Other_methods, The_second_step_of_lambda_mu_smoothing_keeps_the_volume)
{
  const Mesh truth = irregular_mesh(sphere, 500);
  Mesh with_mu = truth, without_mu = truth;
  SMD::denoise_taubin(with_mu);
  SMD::denoise_taubin(without_mu, params::mu(0.));
  EXPECT_LT(SMD::relative_volume_change(without_mu, truth), -0.1);
  EXPECT_LT(std::abs(SMD::relative_volume_change(with_mu, truth)), 0.03);
}

TEST(Other_methods, Curvature_is_kept_where_it_is_even)
{
  const Mesh truth = irregular_mesh(sphere, 1500);
  Mesh result = truth;
  SMD::denoise_prescribed_mean_curvature(result);
  EXPECT_LT(std::abs(SMD::relative_volume_change(result, truth)), 0.003);
}

// Laplacian smoothing moves the vertices of curves along them
TEST(Other_methods, Curves_of_constrained_edges_are_smoothed_as_curves)
{
  const Mesh mesh = irregular_mesh(cube, 500);
  Setting setting;
  for(const Edge e : edges(mesh))
    setting.is_crease.push_back(normal_of(mesh, mesh.face(mesh.halfedge(e, 0)))
                                * normal_of(mesh, mesh.face(mesh.halfedge(e, 1))) < 0.5);
  const Mesh result = taubin<CGAL::Sequential_tag>(mesh, setting).mesh;
  // so the cube stays a cube
  EXPECT_LT(SMD::angular_error(result, mesh).maximum, 1e-6);
  EXPECT_NEAR(SMD::relative_volume_change(result, mesh), 0, 1e-12);
  EXPECT_GT(largest_distance(result, mesh), 0.1 * mean_edge_length(mesh));
  EXPECT_GT(SMD::angular_error(taubin<CGAL::Sequential_tag>(mesh, Setting()).mesh, mesh).maximum, 10);
}

// ---- what commutes with denoising

TEST(Other_methods, Rigid_motions_and_scaling)
{
  const auto move = [](const Point& p)
  {
    const double c = std::cos(0.7), s = std::sin(0.7);
    return Point(7 * (c * p.x() - s * p.z()) + 3, 7 * p.y() - 1, 7 * (s * p.x() + c * p.z()) + 0.5);
  };
  const auto scale = [](const Point& p) { return Point(p.x() / 1024, p.y() / 1024, p.z() / 1024); };
  for(const Model_generator generate : { cube, saddle })
  {
    const Mesh noisy = noisy_mesh(generate, 400, 0.2);
    for(const Method& method : methods)
    {
      const Mesh result = method(noisy);
      EXPECT_LT(largest_distance(method(transformed(noisy, move)), transformed(result, move)), 1e-9) << method.name;
      // by a power of two: no digit changes
      EXPECT_EQ(points_of(method(transformed(noisy, scale))), points_of(transformed(result, scale))) << method.name;
    }
  }
}

TEST(Other_methods, Renumbering)
{
  const Mesh noisy = noisy_mesh(cube, 400, 0.2);
  std::mt19937 random(1);
  std::vector<Vertex> order(vertices(noisy).begin(), vertices(noisy).end()), new_vertex(order.size());
  std::vector<Face> face_order(faces(noisy).begin(), faces(noisy).end());
  std::shuffle(order.begin(), order.end(), random);
  std::shuffle(face_order.begin(), face_order.end(), random);
  Mesh renumbered;
  for(const Vertex v : order)
    new_vertex[v] = renumbered.add_vertex(noisy.point(v));
  for(const Face f : face_order)
  {
    const std::array<Vertex, 3> t = vertices_of(noisy, f);
    renumbered.add_face(new_vertex[t[f % 3]], new_vertex[t[(f + 1) % 3]], new_vertex[t[(f + 2) % 3]]);
  }
  for(const Method& method : methods)
  {
    const Mesh expected = method(noisy), result = method(renumbered);
    for(const Vertex v : vertices(noisy))
      ASSERT_LT(distance(result.point(new_vertex[v]), expected.point(v)), 1e-9) << method.name;
  }
}

TEST(Other_methods, Parallel_runs_give_the_same_bits)
{
  const Mesh noisy = noisy_mesh(cube, 3000, 0.3);
  for(const Method& method : methods)
  {
    const Outcome sequential = method.sequential(noisy, Setting());
    EXPECT_TRUE(sequential == method.parallel(noisy, Setting())) << method.name;
    for(const Vector& n : sequential.face_normals)
      ASSERT_NEAR(n.squared_length(), 1, 1e-12) << method.name;
    for(const Vector& n : sequential.vertex_normals)
      ASSERT_NEAR(n.squared_length(), 1, 1e-12) << method.name;
  }
}

// ---- which vertices move

TEST(Other_methods, Ranges_and_constraints)
{
  const Mesh noisy = noisy_mesh(sphere, 300, 0.2);
  std::vector<bool> is_upper, is_lower;
  for(const Vertex v : vertices(noisy))
  {
    is_upper.push_back(noisy.point(v).z() > 0);
    is_lower.push_back(!is_upper.back());
  }
  for(const Method& method : methods)
  {
    Setting range, constraints;
    range.is_movable = is_upper;
    constraints.is_constrained = is_lower;
    const Mesh of_range = method.sequential(noisy, range).mesh;
    EXPECT_EQ(points_of(of_range), points_of(method.sequential(noisy, constraints).mesh)) << method.name;
    std::size_t number_moved = 0;
    for(const Vertex v : vertices(noisy))
    {
      if(is_lower[v])
      {
        ASSERT_EQ(of_range.point(v), noisy.point(v)) << method.name;
      }
      number_moved += (of_range.point(v) != noisy.point(v));
    }
    EXPECT_GT(number_moved, 100u) << method.name;
  }
}

// ---- the iterations

TEST(Other_methods, Visitors)
{
  const Mesh noisy = noisy_mesh(sphere, 300, 0.2);
  for(const Method& method : methods)
  {
    if(!method.is_iterative)
      continue;
    Setting two, stopped, throwing;
    two.number_of_iterations = 2;
    const Outcome expected = method.sequential(noisy, two);
    EXPECT_EQ(expected.result.number_of_iterations, 2u) << method.name;
    EXPECT_FALSE(expected.result.has_converged) << method.name;

    stopped.visit = [](const std::size_t iteration, const double largest, const bool has_converged)
    {
      EXPECT_GT(largest, 0.001);
      EXPECT_FALSE(has_converged);
      return iteration < 2;
    };
    EXPECT_TRUE(method.sequential(noisy, stopped) == expected) << method.name;

    throwing.visit = [](std::size_t, double, bool) -> bool { throw Thrown(); };
    EXPECT_THROW(method.sequential(noisy, throwing), Thrown) << method.name;
  }
  Mesh mesh = noisy;
  Setting throwing;
  throwing.visit = [](std::size_t, double, bool) -> bool { throw Thrown(); };
  EXPECT_THROW(SMD::denoise_taubin(mesh, params::visitor(std::cref(throwing))), Thrown);
  EXPECT_EQ(points_of(mesh), points_of(noisy));
}

TEST(Other_methods, Rounds_begin_with_the_normals_of_the_mesh)
{
  const Mesh noisy = noisy_mesh(sphere, 300, 0.2);
  Mesh twice = noisy, two_rounds = noisy;
  for(int i=0; i<2; ++i)
    SMD::denoise_with_normals(twice, params::number_of_normal_iterations(3).number_of_iterations(4));
  const SMD::Denoising_result result = SMD::denoise_with_normals(
    two_rounds, params::number_of_normal_iterations(3).number_of_iterations(4).number_of_rounds(2));
  EXPECT_EQ(result.number_of_iterations, 8u);
  EXPECT_LT(largest_distance(twice, two_rounds), 1e-12);
}

TEST(Other_methods, Iterations_end_when_nothing_moves)
{
  Mesh mesh;
  mesh.add_face(mesh.add_vertex(Point(0, 0, 0)), mesh.add_vertex(Point(1, 0, 0)), mesh.add_vertex(Point(0, 1, 0)));
  const SMD::Denoising_result result = SMD::denoise_with_normals(mesh);
  EXPECT_EQ(result.number_of_iterations, 1u);
  EXPECT_TRUE(result.has_converged);
}

// ---- bad input

template <typename Denoise>
void expect_refused(Mesh mesh, const Denoise& denoise, const std::string& part)
{
  const std::vector<Point> points = points_of(mesh);
  try
  {
    denoise(mesh);
    ADD_FAILURE() << "nothing thrown, expected: " << part;
  }
  catch(const std::invalid_argument& e)
  {
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
  }
  EXPECT_TRUE(points == points_of(mesh) || part == "not all finite"); // what is not a number equals nothing
}

TEST(Other_methods, Parameters_out_of_range)
{
  const Mesh noisy = noisy_mesh(cube, 20, 0.1);
  for(const double x : { 0., -1., std::numeric_limits<double>::infinity(), std::nan("") })
  {
    expect_refused(noisy, [x](Mesh& m) { SMD::denoise_bilateral(m, params::spatial_sigma(x)); }, "spatial_sigma is ");
    expect_refused(noisy, [x](Mesh& m) { SMD::denoise_noniterative(m, params::spatial_sigma(x)); }, "spatial_sigma is ");
    expect_refused(noisy, [x](Mesh& m) { SMD::denoise_noniterative(m, params::height_sigma(x)); }, "height_sigma is ");
    expect_refused(noisy, [x](Mesh& m) { SMD::denoise_taubin(m, params::lambda(x)); }, "lambda is ");
    expect_refused(noisy, [x](Mesh& m)
                   { SMD::denoise_prescribed_mean_curvature(m, params::relaxation_factor(x)); }, "relaxation_factor is ");
    expect_refused(noisy, [x](Mesh& m)
                   { SMD::denoise_prescribed_mean_curvature(m, params::angle_threshold(x)); }, "angle_threshold is ");
  }
  for(const double x : { 0.1, -30., -std::numeric_limits<double>::infinity(), std::nan("") })
    expect_refused(noisy, [x](Mesh& m) { SMD::denoise_taubin(m, params::lambda(0.7).mu(x)); }, "mu is ");
  expect_refused(noisy, [](Mesh& m) { SMD::denoise_taubin(m, params::lambda(0.1).mu(-1.)); }, "mu is ");
  expect_refused(noisy, [](Mesh& m) { SMD::denoise_with_normals(m, params::number_of_rounds(0)); },
                 "number_of_rounds is 0");
  expect_refused(noisy, [](Mesh& m) { SMD::denoise_with_normals(m, params::number_of_normal_iterations(-1)); },
                 "number_of_normal_iterations is -1");
}

TEST(Other_methods, Meshes_that_are_refused)
{
  Mesh not_finite = noisy_mesh(cube, 20, 0.1), quad;
  not_finite.point(Vertex(3)) = Point(0, std::nan(""), 0);
  quad.add_face(quad.add_vertex(Point(0, 0, 0)), quad.add_vertex(Point(1, 0, 0)), quad.add_vertex(Point(1, 1, 0)),
                quad.add_vertex(Point(0, 1, 0)));
  for(const Method& method : methods)
  {
    expect_refused(not_finite, [&](Mesh& m) { m = method(m); }, "not all finite");
    expect_refused(quad, [&](Mesh& m) { m = method(m); }, "not a triangle mesh");
  }
}

TEST(Other_methods, Meshes_with_flaws_give_finite_results)
{
  Mesh triangle, point, flawed = noisy_mesh(cube, 300, 0.2);
  triangle.add_face(triangle.add_vertex(Point(0, 0, 0)), triangle.add_vertex(Point(1, 0, 0)),
                    triangle.add_vertex(Point(0, 1, 0)));
  point.add_face(point.add_vertex(Point(1, 2, 3)), point.add_vertex(Point(1, 2, 3)), point.add_vertex(Point(1, 2, 3)));
  // an isolated vertex, an edge of length zero, a spike
  const Vertex isolated = flawed.add_vertex(Point(5, 5, 5));
  flawed.point(flawed.vertex(Edge(0), 0)) = flawed.point(flawed.vertex(Edge(0), 1));
  flawed.point(Vertex(100)) = Point(1e6, 0, 0);
  for(const Method& method : methods)
  {
    EXPECT_TRUE(points_of(method(Mesh())).empty()) << method.name;
    EXPECT_TRUE(has_finite_points(method(triangle))) << method.name;
    EXPECT_EQ(points_of(method(point)), points_of(point)) << method.name;
    const Mesh result = method(flawed);
    EXPECT_TRUE(has_finite_points(result)) << method.name;
    EXPECT_EQ(result.point(isolated), Point(5, 5, 5)) << method.name;
  }
}

TEST(Other_methods, Extreme_parameters_give_finite_results)
{
  const Mesh noisy = noisy_mesh(cube, 20, 0.3);
  for(const double sigma : { 1e-200, 1e200 })
  {
    Mesh a = noisy, b = noisy;
    SMD::denoise_bilateral(a, params::spatial_sigma(sigma));
    SMD::denoise_noniterative(b, params::spatial_sigma(sigma).height_sigma(1 / sigma));
    EXPECT_TRUE(has_finite_points(a));
    EXPECT_TRUE(has_finite_points(b));
  }
  Mesh c = noisy, d = noisy;
  SMD::denoise_taubin(c, params::lambda(0.5).mu(-0.9).number_of_iterations(9000));
  SMD::denoise_prescribed_mean_curvature(d, params::angle_threshold(1 - 1e-16).relaxation_factor(1)
                                                   .number_of_iterations(200));
  EXPECT_TRUE(has_finite_points(c));
  EXPECT_TRUE(has_finite_points(d));
}

// ---- other meshes

TEST(Other_methods, Single_precision)
{
  typedef CGAL::Polyhedron_3<CGAL::Simple_cartesian<float> > Polyhedron;
  const generated_models::Model model = irregular_model(sphere, 200);
  const auto expect_close = [&](const auto& denoise)
  {
    Mesh mesh = generated_models::to_mesh<Mesh>(model);
    Polyhedron polyhedron = generated_models::to_mesh<Polyhedron>(model);
    denoise(mesh);
    denoise(polyhedron);
    EXPECT_LT(largest_distance(points_of(mesh), points_of(polyhedron)), 1e-5);
  };
  expect_close([](auto& m) { SMD::denoise_with_normals(m); });
  expect_close([](auto& m) { SMD::denoise_taubin(m); });
}
