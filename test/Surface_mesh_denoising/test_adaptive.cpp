// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The adaptive method, which denoise_anisotropic_fitting() runs without parameters, and the noise estimate.

#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/denoise_taubin.h>
#include <CGAL/Surface_mesh_denoising/estimate_noise_level.h>
#include <CGAL/Surface_mesh_denoising/measure_error.h>

#include "test_meshes.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/transform.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#if defined(__GNUC__) && !defined(__clang__)
// g++ takes empty optional vectors there for uninitialized ones
#  pragma GCC diagnostic push
#  pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#if defined(__GNUC__) && !defined(__clang__)
#  pragma GCC diagnostic pop
#endif

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace models = generated_models;
namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

Mesh denoised(Mesh mesh)
{
  SMD::denoise_anisotropic_fitting(mesh);
  return mesh;
}

template <typename NamedParameters>
Mesh denoised(Mesh mesh, const NamedParameters& np)
{
  SMD::denoise_anisotropic_fitting(mesh, np);
  return mesh;
}

Mesh with_noise_in_all_directions(Mesh mesh, const double level)
{
  SMD::add_noise(mesh, params::noise_level(level).noise_direction(SMD::Noise_direction::RANDOM).random_seed(1));
  return mesh;
}

// in the coordinates of the mesh
SMD::Indexed_triangle_mesh indexed_mesh(const Mesh& mesh)
{
  typedef SMD::Indexed_triangle_mesh::Index Index;
  std::vector<SMD::Indexed_triangle_mesh::Point_3> points;
  for(const Vertex v : mesh.vertices())
    points.emplace_back(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  std::vector<std::array<Index, 3> > faces, neighbors;
  for(const Face f : mesh.faces())
  {
    faces.emplace_back();
    neighbors.emplace_back();
    Mesh::Halfedge_index h = mesh.halfedge(f);
    for(int i=0; i<3; ++i, h=mesh.next(h))
    {
      const Face other = mesh.face(mesh.opposite(h));
      faces.back()[i] = Index(mesh.source(h));
      neighbors.back()[i] = (other == Mesh::null_face()) ? SMD::Indexed_triangle_mesh::null_index() : Index(other);
    }
  }
  return SMD::Indexed_triangle_mesh(points, faces, neighbors);
}

Mesh with_points_of(const SMD::Indexed_triangle_mesh& indexed, Mesh mesh)
{
  for(const Vertex v : mesh.vertices())
  {
    const SMD::Indexed_triangle_mesh::Point_3& p = indexed.point(std::size_t(v));
    mesh.point(v) = Point(p.x(), p.y(), p.z());
  }
  return mesh;
}

// what no named parameter sets
Mesh denoised_by(const SMD::internal::Adaptive_parameters& parameters, const Mesh& mesh)
{
  SMD::Indexed_triangle_mesh indexed = indexed_mesh(mesh);
  SMD::internal::Adaptive_fitting<CGAL::Sequential_tag>(parameters, -1).run(
    indexed, std::vector<bool>(indexed.number_of_vertices(), true), [](std::size_t, double, bool) { return true; });
  return with_points_of(indexed, mesh);
}

double error(const Mesh& mesh, const Mesh& truth) { return SMD::angular_error(mesh, truth).mean; }

std::size_t number_of_flips(const Mesh& mesh, const Mesh& truth)
{
  return SMD::angular_error(mesh, truth).number_of_flipped_faces;
}

Mesh plane()
{
  const int n = 60;
  Mesh mesh;
  for(int i=0; i<=n; ++i)
    for(int j=0; j<=n; ++j)
      mesh.add_vertex(Point(i, j, 0));
  const auto at = [](const int i, const int j) { return Vertex(i * (n + 1) + j); };
  for(int i=0; i<n; ++i)
    for(int j=0; j<n; ++j)
    {
      mesh.add_face(at(i, j), at(i+1, j), at(i+1, j+1));
      mesh.add_face(at(i, j), at(i+1, j+1), at(i, j+1));
    }
  return mesh;
}

CGAL::Aff_transformation_3<Kernel> rotation_and_shift()
{
  const double a = 0.7, b = 1.1;
  return CGAL::Aff_transformation_3<Kernel>(
    std::cos(a), -std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), 3.5,
    std::sin(a), std::cos(a) * std::cos(b), -std::cos(a) * std::sin(b), -2.25,
    0., std::sin(b), std::cos(b), 7.125);
}

// the same surface with other numbers for vertices and faces; `vertex[i]` is the new number of vertex i
Mesh renumbered(const Mesh& mesh, std::vector<std::size_t>& vertex)
{
  std::mt19937 random(5);
  vertex.resize(num_vertices(mesh));
  for(std::size_t i=0; i<vertex.size(); ++i)
    vertex[i] = i;
  std::shuffle(vertex.begin(), vertex.end(), random);
  std::vector<Face> faces(mesh.faces().begin(), mesh.faces().end());
  std::shuffle(faces.begin(), faces.end(), random);

  std::vector<Point> points(vertex.size());
  for(const Vertex v : mesh.vertices())
    points[vertex[std::size_t(v)]] = mesh.point(v);
  Mesh result;
  for(const Point& p : points)
    result.add_vertex(p);
  for(const Face f : faces)
  {
    const auto t = vertices_of(mesh, f);
    result.add_face(Vertex(std::uint32_t(vertex[std::size_t(t[1])])), Vertex(std::uint32_t(vertex[std::size_t(t[2])])),
                    Vertex(std::uint32_t(vertex[std::size_t(t[0])])));
  }
  return result;
}

struct Counting_visitor
{
  std::size_t last = std::numeric_limits<std::size_t>::max();
  std::size_t number_of_calls = 0, number_of_converged = 0;
  bool displacements_are_positive = true;
  std::function<void(std::size_t)> see = [](std::size_t) {};

  bool iteration_completed(const std::size_t iteration, const double largest_displacement, const bool has_converged)
  {
    ++number_of_calls;
    EXPECT_EQ(iteration, number_of_calls);
    number_of_converged += has_converged;
    displacements_are_positive = displacements_are_positive && largest_displacement > 0;
    see(iteration);
    return iteration < last;
  }
};

// ---- the noise level

TEST(Estimate_noise_level, Is_that_of_the_noise)
{
  std::vector<std::pair<Mesh, double> > cases; // the share by which the estimate may be off
  cases.emplace_back(plane(), 0.1);
  cases.emplace_back(irregular_mesh(models::sphere, 6000), 0.1);
  cases.emplace_back(irregular_mesh(models::torus, 6000), 0.1);
  cases.emplace_back(irregular_mesh(models::cad_part, 10000), 0.15);
  for(const auto& c : cases)
    for(const double level : {0.1, 0.3, 0.5})
      for(const unsigned int seed : {1, 2})
        EXPECT_NEAR(SMD::estimate_noise_level(with_noise(c.first, level, seed)), level, c.second * level);
}

// with triangles of very different sizes
Mesh uneven_mesh(const Model_generator model)
{
  return models::to_mesh<Mesh>(models::uneven(irregular_model(model, 6000)));
}

TEST(Estimate_noise_level, Sees_noise_that_is_longer_than_edges)
{
  for(const Model_generator model : {models::organic_shape, models::cut_sphere})
    for(const unsigned int seed : {1, 2})
      EXPECT_NEAR(SMD::estimate_noise_level(with_noise(uneven_mesh(model), 0.6, seed)), 0.55, 0.05);
}

TEST(Estimate_noise_level, Strong_noise_does_not_hide_itself)
{
  for(const double level : {0.5, 0.6, 0.8})
  {
    double sum = 0;
    for(const models::Generator& g : models::all())
      sum += SMD::estimate_noise_level(with_noise(irregular_mesh(g.generate, 1500), level));
    EXPECT_NEAR(sum / double(models::all().size()), level, 0.025 * level);
  }
}

TEST(Estimate_noise_level, Knows_surfaces_without_noise)
{
  EXPECT_LT(SMD::estimate_noise_level(plane()), 1e-12);
  EXPECT_LT(SMD::estimate_noise_level(irregular_mesh(models::cube, 5000)), 1e-12);
  EXPECT_LT(SMD::estimate_noise_level(irregular_mesh(models::sphere, 5000)), 1e-3);
}

// little detail here, more of it there
TEST(Estimate_noise_level, Tells_detail_of_the_shape_from_noise)
{
  const Mesh detail = irregular_mesh(models::organic_shape, 1500);
  EXPECT_EQ(SMD::estimate_noise_level(detail), 0);
  EXPECT_EQ(points_of(denoised(detail)), points_of(detail));
  EXPECT_NEAR(SMD::estimate_noise_level(with_noise(detail, 0.05)), 0.055, 0.01);
}

// detail as large as triangles, everywhere: what neighbors have in common tells it
TEST(Estimate_noise_level, Tells_detail_of_coarse_meshes_from_noise)
{
  for(const Mesh& detail : {irregular_mesh(models::organic_shape, 400), irregular_mesh(models::organic_shape, 1000),
                            irregular_mesh(models::torus, 400), irregular_mesh(models::cut_sphere, 1000)})
  {
    EXPECT_EQ(SMD::estimate_noise_level(detail), 0);
    EXPECT_EQ(points_of(denoised(detail)), points_of(detail));
    for(const unsigned int seed : {1, 2})
      EXPECT_GT(SMD::estimate_noise_level(with_noise(detail, 0.1, seed)), 0.09);
  }
}

// cubics leave nothing of what bends smoothly, and detail is not white
TEST(Level_of_white_noise, Is_told_from_what_bends)
{
  const auto level = [](const Mesh& mesh)
  {
    const SMD::Indexed_triangle_mesh indexed = indexed_mesh(mesh);
    const double length = indexed.mean_edge_length<CGAL::Sequential_tag>();
    return SMD::internal::level_of_white_noise<CGAL::Sequential_tag>(
             indexed, indexed.points(), length, SMD::internal::Vertex_neighbors(indexed),
             std::vector<bool>(indexed.number_of_vertices(), true)) / length;
  };
  for(const Model_generator model : {models::torus, models::sphere})
    for(const std::size_t size : {600, 2000})
    {
      const Mesh truth = irregular_mesh(model, size);
      EXPECT_EQ(level(truth), 0);
      for(const double noise : {0.04, 0.08})
        EXPECT_NEAR(level(with_noise(truth, noise)), noise, 0.15 * noise) << size;
    }
  for(const std::size_t size : {400, 1500, 6000})
    EXPECT_EQ(level(irregular_mesh(models::organic_shape, size)), 0);
}

// A part made on a lathe, with few long triangles: `profile` holds radii and heights, from axis to axis or once around
Mesh turned_part(const std::vector<std::array<double, 2> >& profile, const std::size_t number_of_segments)
{
  Mesh mesh;
  std::vector<std::vector<Vertex> > rings;
  for(const std::array<double, 2>& p : profile)
  {
    rings.emplace_back();
    for(std::size_t i=0; i<number_of_segments; ++i)
    {
      const double angle = 2 * CGAL_PI * double(i) / double(number_of_segments);
      rings.back().push_back(i > 0 && p[0] == 0 ? rings.back()[0]
                                                : mesh.add_vertex(Point(p[0] * std::cos(angle), p[0] * std::sin(angle), p[1])));
    }
  }
  const std::size_t number_of_bands = profile[0][0] > 0 ? rings.size() : rings.size() - 1;
  for(std::size_t k=0; k<number_of_bands; ++k)
    for(std::size_t i=0; i<number_of_segments; ++i)
    {
      const std::size_t j = (i + 1) % number_of_segments;
      const std::vector<Vertex> &a = rings[k], &b = rings[(k + 1) % rings.size()];
      if(a[i] != a[j])
        mesh.add_face(a[i], a[j], b[j]);
      if(b[i] != b[j])
        mesh.add_face(a[i], b[j], b[i]);
    }
  return mesh;
}

Mesh shaft()
{
  return turned_part({{{0, 0}}, {{0.25, 0}}, {{0.5, 0}}, {{0.5, 0.5}}, {{0.5, 1}}, {{0.8, 1}}, {{0.8, 1.2}}, {{0.8, 1.4}},
                      {{0.3, 1.4}}, {{0.3, 1.9}}, {{0.3, 2.5}}, {{0, 2.5}}}, 100);
}

Mesh ring()
{
  return turned_part({{{1, 0}}, {{1.5, 0}}, {{2, 0}}, {{2, 0.25}}, {{2, 0.5}}, {{1.5, 0.5}}, {{1, 0.5}}, {{1, 0.25}}}, 90);
}

// Quadrics of two rings cross edges of the shape everywhere; edges of triangles do not
TEST(Estimate_noise_level, Knows_parts_of_few_long_triangles)
{
  for(const Mesh& part : {shaft(), ring()})
  {
    ASSERT_TRUE(CGAL::is_closed(part));
    EXPECT_EQ(SMD::estimate_noise_level(part), 0);
    EXPECT_EQ(points_of(denoised(part)), points_of(part));
    for(const double level : {0.02, 0.05})
      for(const unsigned int seed : {1, 2})
      {
        const Mesh noisy = with_noise(part, level, seed);
        EXPECT_LT(error(denoised(noisy), part), 0.1 * error(noisy, part));
      }
  }
}

// a sphere with twelve rings around it, each as wide as six triangles
Mesh ringed_sphere()
{
  std::vector<std::array<double, 2> > profile(1, {{0, -1.03}});
  const int number_of_rings = 70;
  for(int k=1; k<number_of_rings; ++k)
  {
    const double t = CGAL_PI * k / number_of_rings, radius = 1 + 0.03 * std::cos(24 * t);
    profile.push_back({{radius * std::sin(t), -radius * std::cos(t)}});
  }
  profile.push_back({{0, 1.03}});
  return turned_part(profile, 72);
}

// Patches leave as much of the noise as quadrics, for these leave as much of the rings: but that is as strong everywhere, and white
TEST(Estimate_noise_level, Knows_noise_among_detail)
{
  const Mesh sphere = ringed_sphere();
  ASSERT_TRUE(CGAL::is_closed(sphere));
  EXPECT_EQ(points_of(denoised(sphere)), points_of(sphere));
  for(const double level : {0.03, 0.1})
    for(const unsigned int seed : {1, 2})
    {
      const Mesh noisy = with_noise(sphere, level, seed);
      EXPECT_LT(error(denoised(noisy), sphere), 0.5 * error(noisy, sphere)) << level;
    }
}

TEST(Residuals_of_edges, Have_the_deviation_of_the_noise)
{
  // regular or not, in whatever position
  for(const bool is_regular : {false, true})
    for(const double noise : {0.01, 0.1})
    {
      const Mesh truth = is_regular ? regular_mesh(models::thin_plate, 6000) : irregular_mesh(models::thin_plate, 6000);
      Mesh mesh = with_noise(truth, noise);
      PMP::transform(rotation_and_shift(), mesh);
      const SMD::Indexed_triangle_mesh indexed = indexed_mesh(mesh);
      const std::vector<double> residuals = SMD::internal::residuals_of_edges<CGAL::Sequential_tag>(
        indexed, std::vector<bool>(indexed.number_of_vertices(), true));
      EXPECT_EQ(residuals.size(), mesh.number_of_edges());
      const double median = SMD::internal::median_of_absolutes(residuals, std::vector<bool>(residuals.size(), true));
      EXPECT_NEAR(median / 0.6745 / indexed.mean_edge_length<CGAL::Sequential_tag>(), noise, 0.15 * noise);
    }
}

TEST(Residuals_of_edges, Leave_out_borders_and_vertices_that_do_not_count)
{
  const Mesh mesh = plane();
  const SMD::Indexed_triangle_mesh indexed = indexed_mesh(mesh);
  std::vector<bool> counts(indexed.number_of_vertices(), true);
  const auto number = [&]()
  { return SMD::internal::residuals_of_edges<CGAL::Sequential_tag>(indexed, counts).size(); };
  std::size_t number_of_inner_edges = 0;
  for(const Edge e : mesh.edges())
    number_of_inner_edges += !mesh.is_border(e);
  EXPECT_EQ(number(), number_of_inner_edges);
  counts.assign(counts.size(), false);
  EXPECT_EQ(number(), 0u);
}

// Simplified CAD models have few triangles that are as large as edges allow
TEST(Adaptive_fitting, Leaves_simplified_parts_without_noise)
{
  const std::size_t number_of_edges = 2100;
  const auto stop = [&](const auto&, const auto&, const std::size_t, const std::size_t current)
  { return current < number_of_edges; };
  for(const Model_generator model : {models::drilled_block, models::cut_sphere})
  {
    Mesh part = irregular_mesh(model, 6000);
    CGAL::Surface_mesh_simplification::edge_collapse(part, stop);
    part.collect_garbage();
    EXPECT_LT(error(denoised(part), part), 0.1);
  }
}

// impulses, too, are not everywhere alike
TEST(Estimate_noise_level, Tells_small_impulses_from_detail)
{
  const Mesh truth = irregular_mesh(models::cad_part, 6000);
  Mesh noisy = truth;
  SMD::add_noise(noisy, params::noise_level(0.1).noise_share(0.1).random_seed(1));
  EXPECT_GT(SMD::estimate_noise_level(noisy), 0);
  EXPECT_LT(error(denoised(noisy), truth), 0.5 * error(noisy, truth));
}

TEST(Estimate_noise_level, Does_not_depend_on_numbers_position_and_scale)
{
  const Mesh mesh = noisy_mesh(models::cad_part, 4000, 0.2);
  const double level = SMD::estimate_noise_level(mesh);
  std::vector<std::size_t> vertex;
  EXPECT_NEAR(SMD::estimate_noise_level(renumbered(mesh, vertex)), level, 1e-9);
  Mesh moved = mesh;
  PMP::transform(rotation_and_shift(), moved);
  EXPECT_NEAR(SMD::estimate_noise_level(moved), level, 1e-9);
  Mesh scaled = mesh;
  PMP::transform(CGAL::Aff_transformation_3<Kernel>(CGAL::SCALING, 1e-5), scaled);
  EXPECT_NEAR(SMD::estimate_noise_level(scaled), level, 1e-9);
}

TEST(Estimate_noise_level, Leaves_constrained_vertices_out)
{
  const Mesh smooth = irregular_mesh(models::sphere, 5000);
  Mesh mesh = with_noise(smooth, 0.2);
  auto constrained = mesh.add_property_map<Vertex, bool>("v:constrained", false).first;
  for(const Vertex v : mesh.vertices())
    if(smooth.point(v).z() < 0.3)
    {
      mesh.point(v) = smooth.point(v);
      constrained[v] = true;
    }
  EXPECT_LT(SMD::estimate_noise_level(mesh), 0.1);
  EXPECT_NEAR(SMD::estimate_noise_level(mesh, params::vertex_is_constrained_map(constrained)), 0.2, 0.03);
}

TEST(Estimate_noise_level, Is_zero_where_nothing_can_be_told)
{
  Mesh triangle;
  EXPECT_EQ(SMD::estimate_noise_level(triangle), 0);
  triangle.add_face(triangle.add_vertex(Point(0, 0, 0)), triangle.add_vertex(Point(1, 0, 0)),
                    triangle.add_vertex(Point(0, 1, 0)));
  EXPECT_EQ(SMD::estimate_noise_level(triangle), 0);
  Mesh point = triangle;
  for(const Vertex v : point.vertices())
    point.point(v) = Point(1, 1, 1);
  EXPECT_EQ(SMD::estimate_noise_level(point), 0);
}

// ---- quality

TEST(Adaptive_fitting, Meshes_without_noise_come_back)
{
  for(const models::Generator& g : models::all())
  {
    models::Options options;
    options.number_of_vertices = 5000;
    options.triangles = models::Triangles::IRREGULAR;
    const Mesh mesh = models::to_mesh<Mesh>(g.generate(options));
    EXPECT_LT(error(denoised(mesh), mesh), 0.5) << g.name;
  }
  // planes all over: not a vertex moves
  const Mesh cube = irregular_mesh(models::cube, 5000);
  EXPECT_EQ(points_of(denoised(cube)), points_of(cube));
}

// where even patches find detail that is smaller than they are, until the level is low enough
TEST(Adaptive_fitting, Coarse_meshes_without_noise_come_back)
{
  for(const models::Generator& g : models::all())
    for(unsigned int seed=0; seed<3; ++seed)
    {
      models::Options options;
      options.number_of_vertices = 500;
      options.triangles = models::Triangles::IRREGULAR;
      options.seed = seed;
      const Mesh mesh = models::to_mesh<Mesh>(g.generate(options));
      EXPECT_LT(error(denoised(mesh), mesh), 0.5) << g.name << " with seed " << seed;
    }
}

// few residuals seem to have little in common now and then
TEST(Adaptive_fitting, Small_smooth_meshes_without_noise_come_back)
{
  const auto radius = [](const models::Vector& d)
  { return 1 + 0.2 * std::sin(3 * d.x() + 1) * std::cos(2.5 * d.y()) + 0.12 * std::sin(4 * d.z() - d.x()); };
  for(unsigned int seed=0; seed<5; ++seed)
  {
    models::Options options;
    options.number_of_vertices = 150;
    options.triangles = models::Triangles::IRREGULAR;
    options.seed = seed;
    const Mesh mesh = models::to_mesh<Mesh>(models::star_shaped(options, radius));
    EXPECT_LT(error(denoised(mesh), mesh), 0.5) << "with seed " << seed;
  }
}

// as linear interpolation on grids leaves them
TEST(Adaptive_fitting, Vertices_on_chords_come_back)
{
  for(const std::size_t number_of_vertices : {800, 1500, 3000})
    for(const unsigned int seed : {1, 2, 3})
    {
      models::Options options;
      options.number_of_vertices = number_of_vertices;
      options.triangles = models::Triangles::IRREGULAR;
      options.seed = seed;
      Mesh mesh = models::to_mesh<Mesh>(models::torus(options));
      const double length = mean_edge_length(mesh);
      std::mt19937 random(seed);
      for(const Vertex v : mesh.vertices())
      {
        const double t = double(random()) / 4294967296.;
        mesh.point(v) = mesh.point(v) - t * (1 - t) * length * length / (2 * models::torus_minor_radius)
                                        * PMP::compute_vertex_normal(v, mesh);
      }
      EXPECT_LT(error(denoised(mesh), mesh), 0.5) << number_of_vertices << " with seed " << seed;
      const Mesh noisy = with_noise(mesh, 0.05);
      EXPECT_LT(error(denoised(noisy), mesh), 0.5 * error(noisy, mesh)) << number_of_vertices << " with seed " << seed;
    }
}

TEST(Adaptive_fitting, Is_better_than_the_iterative_method)
{
  for(const Model_generator model : {models::cube, models::sphere, models::cad_part, models::organic_shape})
    for(const double level : {0.2, 0.5})
    {
      const Mesh truth = irregular_mesh(model, 6000), noisy = with_noise(truth, level);
      const Mesh result = denoised(noisy);
      EXPECT_LT(error(result, truth), 0.8 * error(denoised(noisy, Anisotropic_parameters().named()), truth));
      // the mean of the noise is not zero, but small
      const double chance = level * mean_edge_length(truth) / std::sqrt(double(num_vertices(truth)))
                          * PMP::area(noisy) / PMP::volume(noisy);
      EXPECT_NEAR(PMP::volume(result) / PMP::volume(noisy), 1, chance);
      EXPECT_NEAR(PMP::volume(result) / PMP::volume(truth), 1, 0.01 * level);
    }
}

// what smoothing takes, but not what noise did to the volume
TEST(Adaptive_fitting, Volume_is_kept_beyond_chance)
{
  const Mesh torus = irregular_mesh(models::torus, 1500), noisy = with_noise_in_all_directions(torus, 0.6);
  const auto change_of_volume = [&](const Mesh& mesh) { return std::abs(SMD::relative_volume_change(mesh, torus)); };
  EXPECT_LT(change_of_volume(denoised(noisy)),
            0.5 * change_of_volume(denoised(noisy, params::preserve_volume(false))));

  for(const double share : {1., 0.1})
  {
    double change = 0, change_by_noise = 0;
    for(const Model_generator model : {models::cube, models::cad_part, models::cut_sphere})
    {
      const Mesh truth = irregular_mesh(model, 1500);
      for(unsigned int seed=0; seed<4; ++seed)
      {
        Mesh mesh = truth;
        SMD::add_noise(mesh, params::noise_level(0.5).noise_share(share).random_seed(seed));
        change_by_noise += std::abs(SMD::relative_volume_change(mesh, truth));
        change += std::abs(SMD::relative_volume_change(denoised(mesh), truth));
      }
    }
    EXPECT_LT(change, 0.8 * change_by_noise) << "with noise at a share of " << share;
  }
}

TEST(Adaptive_fitting, Planes_and_edges_come_out_exactly)
{
  const Mesh truth = irregular_mesh(models::cube, 8000);
  const Mesh result = denoised(with_noise(truth, 0.3));
  EXPECT_LT(error(result, truth), 1);
  EXPECT_EQ(number_of_flips(result, truth), 0u);
}

TEST(Adaptive_fitting, Patches_are_better_where_they_are_fitted_twice)
{
  double sum_of_ratios = 0;
  for(const Model_generator model : {models::cube, models::pyramid_5, models::obtuse_prism, models::cylinder})
    for(const double level : {0.3, 0.6})
    {
      const Mesh truth = irregular_mesh(model, 6000), noisy = with_noise(truth, level);
      sum_of_ratios += error(denoised(noisy), truth) / error(denoised(noisy, params::refit_patches(false)), truth);
    }
  EXPECT_LT(sum_of_ratios, 8 * 0.9);
}

TEST(Adaptive_fitting, Impulses_go)
{
  const Mesh truth = irregular_mesh(models::cad_part, 8000);
  Mesh noisy = truth;
  SMD::add_noise(noisy, params::noise_level(0.5).noise_share(0.2).random_seed(1));
  const Mesh result = denoised(noisy);
  EXPECT_LT(error(result, truth), 0.05 * error(noisy, truth));
  EXPECT_LT(error(result, truth), 0.6 * error(denoised(noisy, params::remove_impulses(false)), truth));
  EXPECT_EQ(points_of(denoised(noisy, params::noise_level(0.3))),
            points_of(denoised(noisy, params::noise_level(0.3).remove_impulses(false))));

  // noise that all vertices have is none
  const Mesh other = with_noise(truth, 0.3);
  EXPECT_EQ(points_of(denoised(other)), points_of(denoised(other, params::remove_impulses(false))));
}

// ---- noise that is stronger in some places

// white noise of the given deviations, as residuals
std::vector<double> white_noise(const std::vector<double>& deviations)
{
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::vector<double> noise;
  for(const double d : deviations)
    noise.push_back(d * normal(random));
  return noise;
}

TEST(Local_levels, Are_those_of_white_noise)
{
  const Mesh mesh = plane();
  const SMD::internal::Vertex_neighbors neighbors(indexed_mesh(mesh));
  const std::vector<bool> counts(num_vertices(mesh), true);
  const double deviation_of_differences = std::sqrt(1 + 1. / 6);
  const auto levels = [&](const std::vector<double>& residuals)
  {
    return SMD::internal::local_levels<CGAL::Sequential_tag>(neighbors, counts, residuals, 1, deviation_of_differences);
  };

  std::vector<double> deviations(counts.size(), 0.3);
  const SMD::internal::Local_levels even = levels(white_noise(deviations));
  EXPECT_NEAR(even.strong, 0.3, 0.06);
  EXPECT_NEAR(even.weak, 0.3, 0.06);
  EXPECT_NEAR(even.normality, 1, 0.1);

  // half of the plane, and far from its border
  for(const Vertex v : mesh.vertices())
    if(mesh.point(v).x() < 30)
      deviations[std::size_t(v)] = 0.05;
  const SMD::internal::Local_levels uneven = levels(white_noise(deviations));
  EXPECT_NEAR(uneven.strong, 0.3, 0.06);
  EXPECT_NEAR(uneven.weak, 0.05, 0.01);
  EXPECT_NEAR(uneven.normality, 1, 0.1);
  EXPECT_NEAR(uneven.correlations[0], -0.25, 0.06);
  for(const Vertex v : mesh.vertices())
    if(std::abs(mesh.point(v).x() - 30) > 15)
    {
      EXPECT_NEAR(uneven.levels[std::size_t(v)] / deviations[std::size_t(v)], 1, 0.35);
    }

  // what neighbors have in common is not white, and impulses are not normally distributed
  std::vector<double> waves, impulses(counts.size(), 0);
  for(const Vertex v : mesh.vertices())
    waves.push_back(std::sin(0.9 * mesh.point(v).x()) * std::sin(1.1 * mesh.point(v).y()));
  EXPECT_GT(levels(waves).correlations[0], 0);
  for(std::size_t v=0; v<impulses.size(); v+=17)
    impulses[v] = 1;
  EXPECT_LT(levels(impulses).normality, 0.6);
}

// the mean angle of the faces on the side without noise, away from the other one, and on that
std::array<double, 2> errors_of_sides(const Mesh& mesh, const Mesh& truth)
{
  std::vector<bool> is_noisy(num_vertices(truth), false);
  for(const Vertex v : generated_models::vertices_on_one_side(truth))
    is_noisy[std::size_t(v)] = true;
  // noise is known by a window of some rings
  std::vector<bool> is_near = is_noisy;
  for(int k=0; k<5; ++k)
  {
    std::vector<bool> wider = is_near;
    for(const Mesh::Edge_index e : truth.edges())
      for(const int end : {0, 1})
        if(is_near[std::size_t(truth.vertex(e, end))])
          wider[std::size_t(truth.vertex(e, 1 - end))] = true;
    is_near.swap(wider);
  }
  std::array<double, 2> sums = {{ 0, 0 }}, numbers = {{ 0, 0 }};
  for(const Face f : truth.faces())
  {
    int number_of_noisy = 0, number_of_near = 0;
    for(const Vertex v : truth.vertices_around_face(truth.halfedge(f)))
    {
      number_of_noisy += is_noisy[std::size_t(v)];
      number_of_near += is_near[std::size_t(v)];
    }
    if(number_of_noisy < 3 && number_of_near > 0)
      continue;
    const int side = (number_of_noisy == 3);
    sums[side] += CGAL::approximate_angle(PMP::compute_face_normal(f, mesh), PMP::compute_face_normal(f, truth));
    ++numbers[side];
  }
  return {{ sums[0] / numbers[0], sums[1] / numbers[1] }};
}

TEST(Located_noise, Goes_and_the_other_side_stays)
{
  for(const Model_generator model : {models::cube, models::cad_part, models::cut_sphere, models::torus})
    for(const double level : {0.1, 0.3})
    {
      const Mesh truth = irregular_mesh(model, 4000), noisy = with_noise_on_one_side(truth, level);
      const std::array<double, 2> before = errors_of_sides(noisy, truth), after = errors_of_sides(denoised(noisy), truth);
      EXPECT_EQ(before[0], 0);
      EXPECT_LT(after[0], 0.25);
      EXPECT_LT(after[1], 0.1 * before[1]);
      EXPECT_LT(error(denoised(noisy), truth), 0.15 * error(denoised(noisy, params::locate_noise(false)), truth));
    }
}

// which would seem to be detail
TEST(Located_noise, May_be_weak)
{
  for(const Model_generator model : {models::saddle, models::torus, models::sphere})
    for(const double level : {0.05, 0.1})
    {
      const Mesh truth = irregular_mesh(model, 4000);
      const Mesh noisy = with_noise_on_one_side(with_noise(truth, level / 4, 2), level);
      EXPECT_LT(error(denoised(noisy), truth), 0.2 * error(noisy, truth));
      EXPECT_LT(error(denoised(noisy), truth), 0.5 * error(denoised(noisy, params::locate_noise(false)), truth));
    }
}

// as that of a depth camera, which moves points along its line of sight
TEST(Located_noise, May_have_one_direction)
{
  for(const Model_generator model : {models::cube, models::cylinder, models::sphere, models::cad_part})
  {
    const Mesh truth = irregular_mesh(model, 4000);
    const Vector sight(0.2, 0.3, 0.93);
    std::mt19937 random(5);
    std::normal_distribution<double> length(0, 0.3 * mean_edge_length(truth));
    Mesh noisy = truth;
    for(const Vertex v : noisy.vertices())
      noisy.point(v) = noisy.point(v) + length(random) * sight;
    EXPECT_LT(error(denoised(noisy), truth), 0.1 * error(noisy, truth));
  }
}

// else the stage does nothing
TEST(Located_noise, Differs_from_place_to_place)
{
  for(const Model_generator model : {models::cad_part, models::sphere, models::organic_shape})
    for(const double level : {0., 0.05, 0.3})
    {
      const Mesh noisy = noisy_mesh(model, 3000, level);
      EXPECT_EQ(points_of(denoised(noisy)), points_of(denoised(noisy, params::locate_noise(false))));
    }
  Mesh impulses = irregular_mesh(models::cad_part, 3000);
  SMD::add_noise(impulses, params::noise_level(0.4).noise_share(0.2).random_seed(1));
  EXPECT_EQ(points_of(denoised(impulses)), points_of(denoised(impulses, params::locate_noise(false))));
  const Mesh known = with_noise_on_one_side(irregular_mesh(models::cube, 3000), 0.3);
  EXPECT_EQ(points_of(denoised(known, params::noise_level(0.3))),
            points_of(denoised(known, params::noise_level(0.3).locate_noise(false))));
}

// waves of a few edge lengths on one side of a sphere
TEST(Located_noise, Is_no_detail_of_one_side)
{
  Mesh mesh = irregular_mesh(models::sphere, 4000);
  for(const Vertex v : mesh.vertices())
  {
    const Vector p = mesh.point(v) - CGAL::ORIGIN;
    const double frequency = 30, height = 0.015 * (std::max)(0., p.x());
    mesh.point(v) = CGAL::ORIGIN + (1 + height * std::sin(frequency * p.y()) * std::sin(frequency * p.z())) * p;
  }
  EXPECT_LT(error(denoised(mesh), mesh), 0.5);

  SMD::internal::Adaptive_parameters parameters;
  parameters.largest_located_correlation = 1;
  parameters.located_spread_by_correlation = 0;
  parameters.least_located_noise = 0;
  EXPECT_GT(error(denoised_by(parameters, mesh), mesh), 0.5);
}

// with triangles so large beside the shape that quadrics of two rings hardly find a smooth place
TEST(Adaptive_fitting, Weak_noise_is_told_from_edges)
{
  double sum_of_ratios = 0;
  for(const Model_generator model : {models::cad_part, models::cut_sphere})
    for(const std::size_t size : {500, 1000, 1500})
      for(const double level : {0.05, 0.1})
      {
        const Mesh truth = irregular_mesh(model, size), noisy = with_noise(truth, level);
        const double ratio = error(denoised(noisy), truth) / error(denoised(noisy, params::refine_noise_level(false)), truth);
        EXPECT_LT(ratio, 1.15);
        sum_of_ratios += ratio;
        EXPECT_EQ(points_of(denoised(noisy, params::noise_level(level))),
                  points_of(denoised(noisy, params::noise_level(level).refine_noise_level(false))));
      }
  EXPECT_LT(sum_of_ratios, 12 * 0.9);
}

// detail as fine as this stands out of all patches, and neighbors have it in common
TEST(Adaptive_fitting, Weak_noise_is_told_from_detail)
{
  double sum_of_ratios = 0;
  for(const unsigned int seed : {1, 2, 3})
  {
    const Mesh truth = irregular_mesh(models::organic_shape, 1500), noisy = with_noise(truth, 0.02, seed);
    sum_of_ratios += error(denoised(noisy), truth) / error(denoised(noisy, params::refine_noise_level(false)), truth);
  }
  EXPECT_LT(sum_of_ratios, 3 * 0.95);
}

// quadrics of two rings see nothing but edges here
TEST(Adaptive_fitting, Edges_on_coarse_meshes_hide_no_noise)
{
  for(const Model_generator model : {models::obtuse_prism, models::cad_part, models::pyramid_3})
    for(const unsigned int seed : {1, 2, 3})
      for(const double level : {0.01, 0.02})
      {
        const Mesh truth = irregular_mesh(model, 600), noisy = with_noise(truth, level, seed);
        EXPECT_LT(error(denoised(noisy), truth), 0.5 * error(noisy, truth)) << level << ", seed " << seed;
      }
}

// small patches follow the bends of large triangles, and leave little of them
TEST(Adaptive_fitting, Smooth_coarse_meshes_have_no_hidden_noise)
{
  for(const std::size_t size : {200, 250, 300, 350, 400})
  {
    const Mesh mesh = irregular_mesh(models::torus, size);
    EXPECT_EQ(points_of(denoised(mesh)), points_of(mesh)) << size;
  }
}

// which is small beside what triangles leave of the bends, and moves vertices along the surface as well
TEST(Adaptive_fitting, Smooth_coarse_meshes_hide_no_noise)
{
  for(const std::size_t size : {500, 1000, 2000})
    for(const unsigned int seed : {1, 2, 3})
    {
      const Mesh truth = irregular_mesh(models::torus, size);
      Mesh noisy = truth;
      SMD::add_noise(noisy, params::noise_level(0.05).noise_direction(SMD::Noise_direction::RANDOM).random_seed(seed));
      EXPECT_LT(error(denoised(noisy), truth), 0.5 * error(noisy, truth)) << size << ", seed " << seed;
    }
}

TEST(Adaptive_fitting, Large_residuals_that_lie_together_are_no_impulses)
{
  for(const std::size_t size : {300, 3000})
  {
    const Mesh mesh = irregular_mesh(models::sphere, size);
    const std::size_t n = mesh.number_of_vertices();
    const SMD::internal::Vertex_neighbors neighbors(indexed_mesh(mesh));
    const std::vector<bool> counts(n, true);
    const auto are_of_shape = [&](const std::vector<double>& residuals)
    { return SMD::internal::are_of_shape<CGAL::Sequential_tag>(neighbors, residuals, counts, 4.); };
    const auto are_mostly_of_shape = [&](const std::vector<double>& residuals)
    {
      return SMD::internal::are_mostly_of_shape<CGAL::Sequential_tag>(
        neighbors, residuals, counts, SMD::internal::quiet_places<CGAL::Sequential_tag>(neighbors, residuals, counts));
    };

    for(unsigned int seed=0; seed<20; ++seed)
    {
      std::mt19937 generator(seed);
      std::normal_distribution<double> normal;
      std::uniform_real_distribution<double> uniform(0, 1);
      std::vector<double> along_normals(n), in_all_directions(n), with_impulses(n), at_edges(n), of_one_half(n);
      for(const Vertex v : mesh.vertices())
      {
        const double r = normal(generator);
        along_normals[v] = r;
        in_all_directions[v] = (2 * uniform(generator) - 1) * r;
        with_impulses[v] = (uniform(generator) < 0.05) ? 20 * r : r;
        at_edges[v] = (std::abs(mesh.point(v).z()) < 0.15) ? 4 * r : r;
        of_one_half[v] = (mesh.point(v).z() < 0) ? r : r / 20;
      }
      EXPECT_FALSE(are_of_shape(along_normals));
      EXPECT_FALSE(are_of_shape(in_all_directions));
      EXPECT_FALSE(are_of_shape(with_impulses));
      EXPECT_FALSE(are_mostly_of_shape(along_normals));
      EXPECT_FALSE(are_mostly_of_shape(in_all_directions));
      EXPECT_TRUE(are_mostly_of_shape(of_one_half));
      if(size > 1000) // with few vertices it may be chance
      {
        EXPECT_TRUE(are_of_shape(at_edges));
        EXPECT_FALSE(are_mostly_of_shape(at_edges)); // there is noise away from them
      }
    }
  }
}

// edges of 150 degrees between sides a few triangles wide: with a noise level that is too high they merge
TEST(Adaptive_fitting, Impulses_leave_obtuse_edges_of_coarse_meshes)
{
  const Mesh truth = irregular_mesh(models::obtuse_prism, 1500);
  for(const unsigned int seed : { 1, 2, 3 })
  {
    Mesh noisy = truth;
    SMD::add_noise(noisy, params::noise_level(0.5).noise_share(0.1).random_seed(seed));
    EXPECT_LT(error(denoised(noisy), truth), 0.5);
  }
}

// with so much of it, turned faces lie side by side
TEST(Adaptive_fitting, Clusters_of_turned_faces_face_outwards_again)
{
  for(const Model_generator model : {models::sphere, models::organic_shape, models::saddle, models::obtuse_prism})
  {
    const Mesh truth = irregular_mesh(model, 6000);
    const Mesh noisy = with_noise_in_all_directions(truth, 0.6);
    EXPECT_GT(number_of_flips(denoised(noisy, params::unfold_faces(false).remove_tangential_noise(false)), truth), 10u);
    EXPECT_LE(number_of_flips(denoised(noisy), truth), 1u);
  }
}

TEST(Adaptive_fitting, Faces_that_noise_turned_face_outwards_again)
{
  double sum_of_distances = 0, sum_of_distances_of_folded = 0;
  for(const Model_generator model : {models::cube, models::sphere, models::cad_part, models::organic_shape})
  {
    const Mesh truth = irregular_mesh(model, 6000);
    const Mesh noisy = with_noise_in_all_directions(truth, 0.3);
    const Mesh result = denoised(noisy), folded = denoised(noisy, params::unfold_faces(false).remove_tangential_noise(false));
    EXPECT_GT(number_of_flips(folded, truth), 50u);
    EXPECT_LT(number_of_flips(result, truth), 0.1 * number_of_flips(folded, truth));
    EXPECT_LT(error(result, truth), 0.75 * error(folded, truth));
    // vertices slide on the surface
    const auto distance_to_truth = [&](const Mesh& mesh)
    { return SMD::vertex_distance_error(mesh, truth).area_weighted_l2; };
    EXPECT_LT(distance_to_truth(denoised(noisy, params::remove_tangential_noise(false))), 1.02 * distance_to_truth(folded));
    EXPECT_LT(distance_to_truth(result), 1.15 * distance_to_truth(folded));
    sum_of_distances += distance_to_truth(result) / distance_to_truth(noisy);
    sum_of_distances_of_folded += distance_to_truth(folded) / distance_to_truth(noisy);
  }
  EXPECT_LT(sum_of_distances, 1.01 * sum_of_distances_of_folded);
}

// some vertices close to a neighbor, as level sets of functions on grids have them
TEST(Adaptive_fitting, Low_faces_that_weak_noise_turned_face_outwards_again)
{
  std::size_t number_of_turned = 0, number_of_folded = 0;
  for(const Model_generator model : {models::sphere, models::saddle})
    for(const double level : { 0.1, 0.2 })
    {
      Mesh truth = irregular_mesh(model, 1500);
      for(std::uint32_t v=0; v<num_vertices(truth); v+=10)
      {
        const Point& p = truth.point(truth.source(truth.halfedge(Vertex(v))));
        truth.point(Vertex(v)) = truth.point(Vertex(v)) + 0.8 * (p - truth.point(Vertex(v)));
      }
      const Mesh noisy = with_noise_in_all_directions(truth, level);
      number_of_turned += number_of_flips(denoised(noisy), truth);
      number_of_folded += number_of_flips(denoised(noisy, params::unfold_faces(false)), truth);
    }
  EXPECT_GT(number_of_folded, 5u);
  EXPECT_LT(number_of_turned, 0.5 * number_of_folded);
}

std::size_t number_of_faces_turned_down(const SMD::Indexed_triangle_mesh& mesh)
{
  std::size_t n = 0;
  for(std::size_t f=0; f<mesh.number_of_faces(); ++f)
    n += mesh.area_vector(f).z() <= 0;
  return n;
}

void unfold(SMD::Indexed_triangle_mesh& mesh, const bool noise_turns_faces, const double noise = 0.4)
{
  const std::vector<bool> is_movable(mesh.number_of_vertices(), true);
  const SMD::internal::Vertex_neighbors neighbors(mesh);
  const std::vector<SMD::Indexed_triangle_mesh::Point_3> observed = mesh.points();
  SMD::internal::Adaptive_parameters parameters;
  parameters.unfolding_share_by_shape = 0.1;
  const SMD::internal::Unfolding_limits limits = { 4, 2 };
  SMD::internal::Face_unfolding<CGAL::Sequential_tag>(mesh, observed, is_movable, neighbors,
                                                      noise * mesh.mean_edge_length(), noise_turns_faces, limits,
                                                      parameters).run();
}

TEST(Face_unfolding, Slides_vertices_of_a_plane_within_the_plane)
{
  Mesh mesh = plane();
  for(const std::size_t v : {500, 1234, 1235, 2600})
    mesh.point(Vertex(std::uint32_t(v))) = mesh.point(Vertex(std::uint32_t(v))) + Vector(1.3, 0.4, 0);
  SMD::Indexed_triangle_mesh indexed = indexed_mesh(mesh);
  const std::vector<SMD::Indexed_triangle_mesh::Point_3> observed = indexed.points();
  EXPECT_GE(number_of_faces_turned_down(indexed), 4u);

  // without such noise, a few faces that were turned from the beginning are the shape's
  unfold(indexed, false);
  EXPECT_EQ(indexed.points(), observed);
  unfold(indexed, true);
  EXPECT_EQ(number_of_faces_turned_down(indexed), 0u);
  for(const SMD::Indexed_triangle_mesh::Point_3& p : indexed.points())
    EXPECT_NEAR(p.z(), 0, 1e-12);
}

// among faces that are large beside the noise, only low ones are turned by it
TEST(Face_unfolding, Takes_low_faces_for_folded_by_weak_noise)
{
  for(const double noise : { 0.01, 0.06 })
  {
    Mesh mesh = plane();
    const Vertex v(1234);
    const auto opposite = mesh.next(mesh.next(mesh.halfedge(v)));
    const Point center = CGAL::midpoint(mesh.point(mesh.source(opposite)), mesh.point(mesh.target(opposite)));
    const Vector way = center - mesh.point(v);
    const double beyond = 0.05 * mean_edge_length(mesh);
    mesh.point(v) = center + (beyond / std::sqrt(way.squared_length())) * way;
    SMD::Indexed_triangle_mesh indexed = indexed_mesh(mesh);
    EXPECT_GT(number_of_faces_turned_down(indexed), 0u);
    unfold(indexed, true, noise);
    EXPECT_EQ(number_of_faces_turned_down(indexed) == 0, noise == 0.06);
  }
}

TEST(Face_unfolding, Unfolds_the_border)
{
  Mesh mesh = plane();
  const Vertex v = *std::find_if(mesh.vertices().begin(), mesh.vertices().end(),
                                 [&](const Vertex w) { return mesh.is_border(w) && mesh.degree(w) == 4; });
  const Vertex next = mesh.target(mesh.next(mesh.halfedge(v)));
  EXPECT_TRUE(mesh.is_border(next));
  mesh.point(v) = mesh.point(v) + 1.4 * (mesh.point(next) - mesh.point(v));
  SMD::Indexed_triangle_mesh indexed = indexed_mesh(mesh);
  EXPECT_GT(number_of_faces_turned_down(indexed), 0u);
  unfold(indexed, true);
  EXPECT_EQ(number_of_faces_turned_down(indexed), 0u);
}

TEST(Tangential_noise, Shows_in_turned_faces)
{
  for(const Model_generator model : {models::cube, models::sphere, models::cad_part, models::organic_shape, models::saddle})
  {
    const Mesh truth = irregular_mesh(model, 6000);
    const SMD::Indexed_triangle_mesh surface = indexed_mesh(truth);
    // the level is that along the normals
    const auto ratio = [&](const Mesh& noisy, const double level)
    {
      return SMD::internal::tangential_noise_ratio<CGAL::Sequential_tag>(
        surface, indexed_mesh(noisy).points(), SMD::internal::Noise_map(level * mean_edge_length(truth)),
        SMD::internal::Adaptive_parameters());
    };
    EXPECT_EQ(ratio(truth, 0.3).value, 0);
    EXPECT_LT(ratio(with_noise(truth, 0.3), 0.3).upper_bound, 0.05);
    EXPECT_GT(ratio(with_noise_in_all_directions(truth, 0.3), 0.3 / std::sqrt(3.)).value, 0.5);
    // where noise turns no face in either direction, it may have any
    EXPECT_EQ(ratio(with_noise(truth, 0.05), 0.05).value, 0);
    EXPECT_GT(ratio(with_noise(truth, 0.05), 0.05).upper_bound, 0.5);
  }
}

TEST(Tangential_noise, Goes)
{
  for(const Model_generator model : {models::sphere, models::organic_shape})
  {
    const Mesh truth = irregular_mesh(model, 6000), noisy = with_noise_in_all_directions(truth, 0.3);
    EXPECT_LT(error(denoised(noisy), truth),
              0.9 * error(denoised(noisy, params::remove_tangential_noise(false)), truth));
    // without it, the stage does nothing
    const Mesh other = with_noise(truth, 0.3);
    EXPECT_EQ(points_of(denoised(other)), points_of(denoised(other, params::remove_tangential_noise(false))));
  }
  for(const Model_generator model : {models::sphere, models::cylinder, models::torus})
    for(const double level : {0.1, 0.2})
    {
      const Mesh truth = regular_mesh(model, 1500), noisy = with_noise_in_all_directions(truth, level);
      EXPECT_LT(error(denoised(noisy), truth),
                0.8 * error(denoised(noisy, params::remove_tangential_noise(false)), truth));
      const Mesh other = with_noise(truth, level);
      EXPECT_EQ(points_of(denoised(other)), points_of(denoised(other, params::remove_tangential_noise(false))));
    }
}

// weak noise turns none of even triangles
TEST(Tangential_noise, Shows_in_ways_to_centers)
{
  // the level is that along the normals
  const auto are_of_noise = [](const Mesh& truth, const Mesh& noisy, const double level)
  {
    std::vector<SMD::Indexed_triangle_mesh::Vector_3> normals, ways;
    SMD::internal::compute_vertex_normals<CGAL::Sequential_tag>(indexed_mesh(truth), normals);
    const SMD::Indexed_triangle_mesh indexed = indexed_mesh(noisy);
    const SMD::internal::Vertex_neighbors neighbors(indexed);
    SMD::internal::compute_ways_to_centers<CGAL::Sequential_tag>(indexed, neighbors, normals, ways);
    return SMD::internal::are_ways_of_noise<CGAL::Sequential_tag>(
      ways, neighbors, SMD::internal::Noise_map(level * mean_edge_length(truth)), SMD::internal::Adaptive_parameters());
  };
  for(const Model_generator model : {models::sphere, models::cylinder, models::torus})
  {
    const Mesh even = regular_mesh(model, 1500), uneven = irregular_mesh(model, 1500);
    for(const double level : {0.1, 0.2})
    {
      EXPECT_TRUE(are_of_noise(even, with_noise_in_all_directions(even, level), level / std::sqrt(3.)));
      EXPECT_FALSE(are_of_noise(even, with_noise(even, level), level));
      EXPECT_FALSE(are_of_noise(uneven, with_noise(uneven, level), level));
    }
  }
}

// `noise` is in mean edge lengths
Mesh relaxed_along_surface(const Mesh& mesh, const double noise)
{
  SMD::Indexed_triangle_mesh indexed = indexed_mesh(mesh);
  const std::vector<bool> is_movable(indexed.number_of_vertices(), true);
  SMD::internal::relax_along_surface<CGAL::Sequential_tag>(indexed, is_movable, SMD::internal::Vertex_neighbors(indexed),
                                                           0.5, SMD::internal::Noise_map(noise * indexed.mean_edge_length()),
                                                           SMD::internal::Adaptive_parameters());
  return with_points_of(indexed, mesh);
}

TEST(Tangential_noise, Relaxation_keeps_planes_and_edges)
{
  const Mesh truth = irregular_mesh(models::cube, 6000), mesh = relaxed_along_surface(truth, 1);
  std::size_t number_of_moved = 0;
  for(const Vertex v : mesh.vertices())
    number_of_moved += squared_distance(mesh.point(v), truth.point(v)) > 1e-6;
  EXPECT_GT(number_of_moved, 1000u);
  EXPECT_LT(SMD::vertex_distance_error(mesh, truth).in_mean_edge_lengths().area_weighted_l2, 0.005);
}

TEST(Tangential_noise, Relaxation_spares_triangles_that_are_uneven_without_noise)
{
  for(const Model_generator model : {models::cube, models::sphere})
  {
    const Mesh truth = irregular_mesh(model, 6000);
    const auto squared_move = [&](const Mesh& mesh)
    {
      double sum = 0;
      for(const Vertex v : mesh.vertices())
        sum += squared_distance(mesh.point(v), truth.point(v));
      return sum;
    };
    EXPECT_EQ(squared_move(relaxed_along_surface(truth, 0)), 0);
    EXPECT_LT(squared_move(relaxed_along_surface(truth, 0.05)), 0.05 * squared_move(relaxed_along_surface(truth, 1)));
  }
}

TEST(Replace_turned_normals, Finds_the_face_that_is_turned)
{
  Mesh mesh = plane();
  mesh.point(Vertex(500)) = mesh.point(Vertex(500)) + Vector(1.3, 0.4, 0);
  const SMD::Indexed_triangle_mesh indexed = indexed_mesh(mesh);
  std::vector<SMD::Indexed_triangle_mesh::Vector_3> normals;
  std::vector<double> areas;
  SMD::internal::compute_face_normals<CGAL::Sequential_tag>(indexed, normals, areas);
  const auto is_down = [](const SMD::Indexed_triangle_mesh::Vector_3& n) { return n.z() < 0; };
  EXPECT_GE(std::count_if(normals.begin(), normals.end(), is_down), 1);
  SMD::internal::replace_turned_normals<CGAL::Sequential_tag>(indexed, areas, 0.5, normals);
  EXPECT_EQ(std::count_if(normals.begin(), normals.end(), is_down), 0);
}

// noise that hardly turns the other faces
TEST(Steady_normals_of_low_faces, Low_faces_take_the_normals_around_them)
{
  Mesh mesh = plane();
  const double noise = 0.01, low = 0.01;
  std::mt19937 random(1);
  for(const Vertex v : mesh.vertices())
  {
    const Point& p = mesh.point(v);
    const double height = std::normal_distribution<double>(0, noise)(random);
    mesh.point(v) = (p.x() == 30) ? Point(29 + low, p.y(), height) : Point(p.x(), p.y(), height);
  }
  const SMD::Indexed_triangle_mesh indexed = indexed_mesh(mesh);
  std::vector<SMD::Indexed_triangle_mesh::Vector_3> normals;
  std::vector<double> areas;
  SMD::internal::compute_face_normals<CGAL::Sequential_tag>(indexed, normals, areas);
  const auto mean_angle = [&](const bool of_low_faces)
  {
    double sum = 0;
    std::size_t number = 0;
    for(std::size_t f=0; f<normals.size(); ++f)
      if((areas[f] < 0.1) == of_low_faces)
      {
        sum += angle_between(normals[f], Vector(0, 0, 1));
        ++number;
      }
    return sum / double(number);
  };
  const double angle_of_low_faces = mean_angle(true), angle_of_others = mean_angle(false);
  EXPECT_GT(angle_of_low_faces, 30);

  const auto before = normals;
  SMD::internal::steady_normals_of_low_faces<CGAL::Sequential_tag>(indexed, areas, 0, 3, normals);
  for(std::size_t f=0; f<normals.size(); ++f)
    EXPECT_GT(normals[f] * before[f], 1 - 1e-12);

  SMD::internal::steady_normals_of_low_faces<CGAL::Sequential_tag>(indexed, areas, 3 * noise, 3, normals);
  EXPECT_LT(mean_angle(true), 0.35 * angle_of_low_faces);
  EXPECT_LT(mean_angle(false), angle_of_others);
}

// what a linear path starts from, and refers to
struct Linear_path_input
{
  typedef SMD::internal::Linear_path<CGAL::Sequential_tag> Path;
  typedef SMD::Indexed_triangle_mesh::Point_3              Point_3;

  SMD::Indexed_triangle_mesh mesh;
  const std::vector<Point_3> observed;
  const std::vector<bool> is_movable;
  std::vector<double> disturbances;
  const SMD::internal::Vertex_neighbors neighbors;
  const SMD::internal::Adaptive_parameters parameters;
  SMD::internal::Noise_map noise_map;

  explicit Linear_path_input(const Mesh& input, const double disturbance = 0)
    : mesh(indexed_mesh(input)), observed(mesh.points()), is_movable(observed.size(), true),
      disturbances(observed.size(), disturbance), neighbors(mesh)
  {}

  Path path(const std::vector<Point_3>& points, const double noise)
  {
    noise_map.level = noise;
    return Path(mesh, points, is_movable, neighbors, disturbances, noise_map, parameters);
  }
};

// the path is the public smoothing, and what a disturbance changes is what two runs differ by
TEST(Linear_path, Is_lambda_mu_smoothing)
{
  Mesh mesh = noisy_mesh(models::organic_shape, 2000, 0.3);
  Linear_path_input input(mesh);
  const double noise = 1; // does not matter

  std::mt19937 random(3);
  for(double& d : input.disturbances)
    d = std::uniform_real_distribution<double>(-1, 1)(random);
  // along one axis a disturbance goes the way of a coordinate
  const SMD::Indexed_triangle_mesh::Vector_3 axis(0, 0, 1);
  std::vector<SMD::Indexed_triangle_mesh::Point_3> disturbed = input.observed;
  for(std::size_t v=0; v<disturbed.size(); ++v)
    disturbed[v] = disturbed[v] + input.disturbances[v] * axis;
  auto path = input.path(input.observed, noise), other = input.path(disturbed, noise);
  for(const std::size_t end : {4, 10})
  {
    path.go_to(end);
    other.go_to(end);
  }
  SMD::denoise_taubin(mesh, params::number_of_iterations(10));
  std::size_t i = 0;
  for(const Vertex v : mesh.vertices())
  {
    const SMD::Indexed_triangle_mesh::Point_3 p = path.point(i);
    EXPECT_LT(distance(mesh.point(v), Point(p.x(), p.y(), p.z())), 1e-12);
    EXPECT_NEAR(path.noise_share(i), input.disturbances[i] * (axis * (other.point(i) - p)), 1e-12);
    ++i;
  }
}

// by matrices: x = S^k y + n (S^2k n.(y - S^k y)), where n are the normals of S^k y
TEST(Linear_path, Gives_back_heights_over_Laplacian_smoothing)
{
  const double disturbance = 0.25;
  Linear_path_input input(noisy_mesh(models::organic_shape, 400, 0.5), disturbance);
  const std::size_t n = input.observed.size();

  Eigen::MatrixXd step = Eigen::MatrixXd::Identity(n, n) / 3, points(n, 3);
  for(std::size_t v=0; v<n; ++v)
  {
    for(const auto w : input.neighbors(v))
      step(v, w) += 2. / 3 / double(input.neighbors(v).size());
    points.row(v) << input.observed[v].x(), input.observed[v].y(), input.observed[v].z();
  }
  auto path = input.path(input.observed, 1);
  Eigen::MatrixXd power = Eigen::MatrixXd::Identity(n, n);
  for(const std::size_t k : {3, 6})
  {
    path.go_to(input.parameters.linear_number_of_lambda_mu_steps + k);
    power = power * step * step * step;
    const Eigen::MatrixXd smoothed = power * points;
    std::vector<SMD::Indexed_triangle_mesh::Point_3> smoothed_points;
    for(std::size_t v=0; v<n; ++v)
      smoothed_points.emplace_back(smoothed(v, 0), smoothed(v, 1), smoothed(v, 2));
    SMD::Indexed_triangle_mesh smoothed_mesh = input.mesh;
    smoothed_mesh.swap_points(smoothed_points);
    std::vector<SMD::Indexed_triangle_mesh::Vector_3> normals;
    SMD::internal::compute_vertex_normals<CGAL::Sequential_tag>(smoothed_mesh, normals);
    Eigen::VectorXd heights(n);
    for(std::size_t v=0; v<n; ++v)
      heights[v] = (input.observed[v] - smoothed_mesh.point(v)) * normals[v];
    heights = power * (power * heights);
    for(std::size_t v=0; v<n; ++v)
    {
      EXPECT_LT(squared_distance(path.point(v), smoothed_mesh.point(v) + heights[v] * normals[v]), 1e-12);
      EXPECT_NEAR(path.noise_share(v), disturbance * disturbance, 1e-6); // smoothing leaves what is the same everywhere
    }
  }
  EXPECT_EQ(input.mesh.points(), input.observed);
}

// of a sphere around the origin, beside that of the observed points
template <typename Path>
double relative_radius(const Path& path, const std::vector<SMD::Indexed_triangle_mesh::Point_3>& observed)
{
  double sum = 0, before = 0;
  for(std::size_t v=0; v<observed.size(); ++v)
  {
    sum += std::sqrt((path.point(v) - CGAL::ORIGIN).squared_length());
    before += std::sqrt((observed[v] - CGAL::ORIGIN).squared_length());
  }
  return sum / before;
}

TEST(Linear_path, Keeps_the_radius_of_a_sphere)
{
  Linear_path_input input(irregular_mesh(models::sphere, 3000));
  auto path = input.path(input.observed, 1);
  path.go_to(input.parameters.linear_local_band_ends.back());
  EXPECT_NEAR(relative_radius(path, input.observed), 1, 1e-3);
}

// many steps of it alone inflate
TEST(Linear_path, Gives_back_heights_over_lambda_mu_smoothing)
{
  Mesh mesh = irregular_mesh(models::sphere, 400);
  Linear_path_input input(mesh);
  auto path = input.path(input.observed, 1);
  path.go_to(input.parameters.linear_number_of_lambda_mu_steps);
  EXPECT_NEAR(relative_radius(path, input.observed), 1, 2e-3);

  SMD::denoise_taubin(mesh, params::number_of_iterations(input.parameters.linear_number_of_lambda_mu_steps));
  EXPECT_GT(relative_radius(indexed_mesh(mesh), input.observed), 1.01);
}

// only where it is small beside triangles
TEST(Linear_path, Small_noise_is_not_for_Laplacian_smoothing)
{
  Linear_path_input input(irregular_mesh(models::sphere, 1000));
  const std::size_t last = input.parameters.linear_number_of_lambda_mu_steps,
                    end = input.parameters.linear_local_band_ends.back();
  for(const double noise : {0.05, 2.})
  {
    auto path = input.path(input.observed, noise * input.mesh.mean_edge_length<CGAL::Sequential_tag>());
    path.go_to(end);
    for(std::size_t v=0; v<input.observed.size(); ++v)
    {
      EXPECT_EQ(path.least_weight(v, end), (noise < 1) ? 1 : 0);
      EXPECT_EQ(path.least_weight(v, last), 0);
    }
  }
}

// what a quadric or gentle path starts from, and refers to
struct Path_input
{
  typedef SMD::internal::Quadric_path<CGAL::Sequential_tag> Quadric_path;
  typedef SMD::internal::Gentle_path<CGAL::Sequential_tag>  Gentle_path;
  typedef SMD::Indexed_triangle_mesh::Point_3               Point_3;
  typedef SMD::Indexed_triangle_mesh::Vector_3              Vector_3;

  SMD::Indexed_triangle_mesh mesh;
  const std::vector<Point_3> observed;
  std::vector<bool> is_movable;
  std::vector<double> disturbances;
  std::vector<Vector_3> normals;
  const std::vector<Vector_3> normal_deviations;
  const SMD::internal::Vertex_neighbors neighbors;
  SMD::internal::Adaptive_parameters parameters;
  SMD::internal::Noise_map noise_map;

  explicit Path_input(const Mesh& input)
    : mesh(indexed_mesh(input)), observed(mesh.points()), is_movable(observed.size(), true),
      disturbances(observed.size()), normal_deviations(mesh.number_of_faces(), Vector_3(0, 0, 0)), neighbors(mesh)
  {
    SMD::internal::compute_vertex_normals<CGAL::Sequential_tag>(mesh, normals);
    std::mt19937 random(5);
    for(double& d : disturbances)
      d = std::uniform_real_distribution<double>(-0.1, 0.1)(random) * mean_edge_length();
  }

  double mean_edge_length() const { return mesh.mean_edge_length<CGAL::Sequential_tag>(); }

  Quadric_path quadric_path()
  {
    return Quadric_path(mesh, observed, is_movable, neighbors, normals, disturbances, mean_edge_length(), parameters);
  }

  // the noise in mean edge lengths
  Gentle_path gentle_path(const double noise, const bool has_last_steps = true)
  {
    noise_map.level = noise * mean_edge_length();
    return Gentle_path(mesh, observed, is_movable, neighbors, normals, disturbances, normal_deviations, noise_map,
                       mean_edge_length(), has_last_steps, parameters);
  }
};

// one sum over all vertices for each vertex, and for each vertex of that sum where quadrics are averaged twice
TEST(Quadric_path, Goes_mean_ways_to_planes)
{
  typedef Path_input::Point_3   Point_3;
  typedef Path_input::Vector_3  Vector_3;

  Path_input input(noisy_mesh(models::sphere, 500, 0.1));
  const std::size_t n = input.observed.size();
  const double unit = input.mean_edge_length(),
               sigma = input.parameters.quadric_sigma * unit, radius = input.parameters.quadric_reach * sigma;
  std::vector<Vector_3> ignored;
  std::vector<double> areas, vertex_areas(n, 0);
  SMD::internal::compute_face_normals<CGAL::Sequential_tag>(input.mesh, ignored, areas);
  for(std::size_t v=0; v<n; ++v)
    for(const auto f : input.mesh.faces_around_vertex(v))
      vertex_areas[v] += areas[f];
  std::vector<std::vector<std::pair<std::size_t, double> > > neighborhoods(n);
  for(std::size_t v=0; v<n; ++v)
  {
    double sum = 0;
    for(std::size_t w=0; w<n; ++w)
    {
      const double d = squared_distance(input.observed[v], input.observed[w]);
      if(d > radius * radius)
        continue;
      neighborhoods[v].emplace_back(w, vertex_areas[w] * std::exp(-d / (2 * sigma * sigma)));
      sum += neighborhoods[v].back().second;
    }
    for(auto& w : neighborhoods[v])
      w.second /= sum;
  }

  const auto mean_ways = [&](std::vector<Point_3> points, const std::size_t number_of_normal_averages,
                             const std::size_t number_of_averages)
  {
    std::vector<Vector_3> normals, vertex_normals;
    std::vector<double> disturbed_areas;
    const std::vector<Point_3> p = points;
    input.mesh.swap_points(points);
    SMD::internal::compute_face_normals<CGAL::Sequential_tag>(input.mesh, normals, disturbed_areas);
    input.mesh.swap_points(points);
    for(std::size_t k=0; k<number_of_normal_averages; ++k)
    {
      vertex_normals.assign(n, Vector_3(0, 0, 0));
      for(std::size_t f=0; f<normals.size(); ++f)
        for(const auto v : input.mesh.vertices(f))
          vertex_normals[v] += areas[f] * normals[f];
      for(std::size_t f=0; f<normals.size(); ++f)
      {
        Vector_3 sum(0, 0, 0);
        for(const auto v : input.mesh.vertices(f))
          sum += vertex_normals[v] / std::sqrt(vertex_normals[v].squared_length());
        normals[f] = sum / std::sqrt(sum.squared_length());
      }
    }
    // from a point to the planes around vertex `w`
    const std::function<Vector_3(const Point_3&, std::size_t, std::size_t)> mean_way
      = [&](const Point_3& from, const std::size_t w, const std::size_t depth)
    {
      Vector_3 sum(0, 0, 0);
      if(depth > 0)
        for(const auto& u : neighborhoods[w])
          sum += u.second * mean_way(from, u.first, depth - 1);
      else
        for(const auto f : input.mesh.faces_around_vertex(w))
        {
          const auto& t = input.mesh.vertices(f);
          const double height = normals[f] * (CGAL::centroid(p[t[0]], p[t[1]], p[t[2]]) - from);
          sum += areas[f] / vertex_areas[w] * height * normals[f];
        }
      return sum;
    };
    std::vector<Vector_3> ways;
    for(std::size_t v=0; v<n; ++v)
      ways.push_back(mean_way(p[v], v, number_of_averages));
    return ways;
  };
  const auto smoothed = [&](std::vector<double> heights, const std::size_t number_of_steps)
  {
    for(std::size_t k=0; k<number_of_steps; ++k)
    {
      const std::vector<double> before = heights;
      for(std::size_t v=0; v<n; ++v)
      {
        double sum = 0;
        for(const auto w : input.neighbors(v))
          sum += before[w];
        heights[v] = before[v] / 3 + 2. / 3 * sum / double(input.neighbors(v).size());
      }
    }
    return heights;
  };

  std::vector<Point_3> disturbed = input.observed;
  for(std::size_t v=0; v<n; ++v)
    disturbed[v] = disturbed[v] + input.disturbances[v] * input.normals[v];
  struct Step { std::size_t end, number_of_normal_averages, number_of_averages; };
  auto path = input.quadric_path();
  for(const Step& step : { Step{1, 1, 1}, Step{3, 1, 1}, Step{7, 5, 1}, Step{10, 8, 2} })
  {
    path.go_to(step.end);
    const std::vector<Vector_3> ways = mean_ways(input.observed, step.number_of_normal_averages, step.number_of_averages),
      disturbed_ways = mean_ways(disturbed, step.number_of_normal_averages, step.number_of_averages);
    std::vector<double> heights(n), differences(n);
    for(std::size_t v=0; v<n; ++v)
    {
      heights[v] = -(input.normals[v] * ways[v]);
      differences[v] = input.normals[v] * (disturbed_ways[v] - ways[v]);
    }
    const std::vector<double> smoothed_heights = smoothed(heights, step.end),
                              smoothed_differences = smoothed(differences, step.end);
    for(std::size_t v=0; v<n; ++v)
    {
      const Point_3 expected = input.observed[v] + ways[v] + smoothed_heights[v] * input.normals[v];
      EXPECT_LT(std::sqrt(squared_distance(path.point(v), expected)), 1e-5 * unit);
      const double left = input.disturbances[v] + differences[v] - smoothed_differences[v];
      EXPECT_NEAR(path.noise_share(v), input.disturbances[v] * left, 1e-5 * unit * unit);
    }
  }
}

// a grid of uneven triangles in a plane; its border stays, and so do fixed vertices
TEST(Quadric_path, A_plane_and_fixed_vertices_stay)
{
  const std::size_t side = 20;
  for(const double noise : {0., 0.1})
  {
    std::mt19937 random(7);
    Mesh plane;
    std::vector<Vertex> vertices;
    std::uniform_real_distribution<double> uniform(-0.3, 0.3);
    for(std::size_t i=0; i<side*side; ++i)
    {
      const double x = double(i % side) + uniform(random), y = double(i / side) + uniform(random);
      vertices.push_back(plane.add_vertex(Point(x, y, 0.5 * x - y + noise * uniform(random))));
    }
    for(std::size_t i=0; i+side<side*side; ++i)
      if(i % side != side - 1)
      {
        plane.add_face(vertices[i], vertices[i+1], vertices[i+side]);
        plane.add_face(vertices[i+1], vertices[i+side+1], vertices[i+side]);
      }
    Path_input input(plane);
    for(std::size_t v=0; v<input.is_movable.size(); ++v)
      input.is_movable[v] = (v % 7 != 0);
    auto path = input.quadric_path();
    path.go_to(input.parameters.quadric_local_band_ends.back());
    for(std::size_t v=0; v<input.observed.size(); ++v)
    {
      const double way = std::sqrt(squared_distance(path.point(v), input.observed[v]));
      if(!input.is_movable[v] || !input.neighbors.is_inside(v))
        EXPECT_EQ(way, 0);
      else if(noise == 0)
        EXPECT_LT(way, 1e-5);
      else
        EXPECT_GT(way, 0);
    }
  }
}

TEST(Quadric_path, Keeps_the_radius_of_a_sphere)
{
  Path_input input(irregular_mesh(models::sphere, 3000));
  auto path = input.quadric_path();
  for(const std::size_t end : input.parameters.quadric_local_band_ends)
  {
    path.go_to(end);
    EXPECT_NEAR(relative_radius(path, input.observed), 1, 1e-4);
  }
}

// Two iterations of the filter and one move by their formulas, all faces beside all faces
TEST(Normal_evolution, Follows_its_formulas)
{
  typedef SMD::Indexed_triangle_mesh                        Indexed_mesh;
  typedef Indexed_mesh::Point_3                             Point_3;
  typedef Indexed_mesh::Vector_3                            Vector_3;
  typedef SMD::internal::Normal_evolution<CGAL::Sequential_tag> Evolution;

  const Indexed_mesh mesh = indexed_mesh(noisy_mesh(models::cut_sphere, 300, 0.2)),
                     other = indexed_mesh(noisy_mesh(models::cut_sphere, 300, 0.3));
  const std::size_t number_of_faces = mesh.number_of_faces(), number_of_vertices = mesh.number_of_vertices();
  const std::vector<bool> is_movable(number_of_vertices, true);
  const double range = 0.4;
  const auto bell = [](const double x) { return std::pow((std::max)(0., 1 - x / 64), 64); };
  const auto share_a_vertex = [&](const std::size_t f, const std::size_t g)
  {
    const auto &s = mesh.vertices(f), &t = mesh.vertices(g);
    return std::find_first_of(s.begin(), s.end(), t.begin(), t.end()) != s.end();
  };
  // weights are those of `mesh`, the normals and points those of `start`
  const auto evolved = [&](const Indexed_mesh& start, const bool counts_own_normal)
  {
    const double width = SMD::internal::Face_geometry(mesh, CGAL::Sequential_tag()).mean_centroid_distance();
    std::vector<Vector_3> normals, filtered(number_of_faces);
    std::vector<double> areas;
    SMD::internal::compute_face_normals<CGAL::Sequential_tag>(start, normals, areas);
    for(int k=0; k<2; ++k)
    {
      for(std::size_t f=0; f<number_of_faces; ++f)
      {
        Vector_3 sum(0, 0, 0);
        for(std::size_t g=0; g<number_of_faces; ++g)
          if(share_a_vertex(f, g) && (f != g || counts_own_normal))
            sum += mesh.area(g)
                 * bell(squared_distance(mesh.centroid(f), mesh.centroid(g)) / (2 * width * width))
                 * bell((normals[f] - normals[g]).squared_length() / (2 * range * range)) * normals[g];
        filtered[f] = sum / std::sqrt(sum.squared_length());
      }
      normals.swap(filtered);
    }
    std::vector<Point_3> points;
    for(std::size_t v=0; v<number_of_vertices; ++v)
    {
      Vector_3 sum(0, 0, 0);
      for(const auto f : mesh.faces_around_vertex(v))
        sum += ((start.centroid(f) - start.point(v)) * normals[f]) * normals[f];
      points.push_back(start.point(v) + sum / double(mesh.faces_around_vertex(v).size()));
    }
    return points;
  };
  const auto expect_equal = [&](const std::vector<Point_3>& points, const std::vector<Point_3>& expected)
  {
    const double unit = mesh.mean_edge_length<CGAL::Sequential_tag>();
    ASSERT_EQ(points.size(), expected.size());
    for(std::size_t v=0; v<points.size(); ++v)
      EXPECT_LT(squared_distance(points[v], expected[v]), 1e-12 * unit * unit) << v; // weights are numbers of type float
  };

  Evolution evolve;
  evolve.update_weights(mesh, SMD::internal::Noise_map());
  Indexed_mesh single = mesh;
  evolve(single, is_movable, SMD::internal::Evolution_step{ range, true, 2, 1 });
  expect_equal(single.points(), evolved(mesh, true));

  Indexed_mesh first = mesh;
  std::vector<Point_3> second = other.points();
  evolve(first, second, is_movable, std::vector<Vector_3>(number_of_faces, Vector_3(0, 0, 0)),
         SMD::internal::Evolution_step{ range, false, 2, 1 });
  expect_equal(first.points(), evolved(mesh, false));
  expect_equal(second, evolved(other, false));
}

// With S one step of smoothing, what is not given back of heights h is h - S^k h, so that two steps leave (1 + S) times what one
// leaves. Without any, points are as far along the normals as they were observed
TEST(Gentle_path, Gives_back_heights_in_the_end)
{
  Path_input input(noisy_mesh(models::torus, 1000, 0.2));
  const std::size_t n = input.observed.size();
  const auto rests_of_heights = [&](const std::size_t number_of_steps)
  {
    input.parameters.gentle_number_of_height_steps = number_of_steps;
    auto path = input.gentle_path(0.2);
    path.go_to(input.parameters.gentle_local_band_ends.back());
    std::vector<std::array<double, 2> > rests;
    for(std::size_t v=0; v<n; ++v)
    {
      const double d = input.disturbances[v];
      rests.push_back({{ (input.observed[v] - path.point(v)) * input.normals[v], d - path.noise_share(v) / d }});
    }
    return rests;
  };

  const double rounding = 1e-6 * input.mean_edge_length();
  const auto none = rests_of_heights(0), one = rests_of_heights(1), two = rests_of_heights(2);
  double largest = 0;
  for(std::size_t v=0; v<n; ++v)
    for(const int i : {0, 1})
    {
      EXPECT_NEAR(none[v][i], 0, rounding);
      double mean = 0;
      for(const auto w : input.neighbors(v))
        mean += one[w][i] / double(input.neighbors(v).size());
      const double share = input.parameters.laplacian_shares[0];
      EXPECT_NEAR(two[v][i], (2 - share) * one[v][i] + share * mean, rounding);
      largest = (std::max)(largest, std::abs(one[v][i]));
    }
  EXPECT_GT(largest, 1000 * rounding);
}

// No edge and no plane speaks for patches there, and the gentle path has better normals
TEST(Gentle_path, Is_for_smooth_surfaces)
{
  Mesh sphere;
  CGAL::make_icosahedron(sphere, Point(0, 0, 0), 1);
  CGAL::Subdivision_method_3::Loop_subdivision(sphere, CGAL::parameters::number_of_iterations(3));
  for(const Vertex v : sphere.vertices())
  {
    const Vector d = sphere.point(v) - CGAL::ORIGIN;
    sphere.point(v) = CGAL::ORIGIN + d / std::sqrt(d * d);
  }
  for(const unsigned int seed : {1, 2, 3})
    EXPECT_LT(error(denoised(with_noise(sphere, 0.3, seed)), sphere), 1.1) << seed;
}

TEST(Gentle_path, The_relaxation_is_beside_the_last_steps)
{
  Path_input input(noisy_mesh(models::sphere, 1000, 0.2));
  const auto points_at = [&](const std::size_t end, const std::size_t number_of_relaxations, const bool has_last_steps)
  {
    input.parameters.number_of_relaxations = number_of_relaxations;
    auto path = input.gentle_path(0.2, has_last_steps);
    path.go_to(end);
    std::vector<SMD::Indexed_triangle_mesh::Point_3> points;
    for(std::size_t v=0; v<input.observed.size(); ++v)
      points.push_back(path.point(v));
    return points;
  };
  const std::size_t relaxed = input.parameters.gentle_number_of_steps + 1,
                    last = input.parameters.gentle_local_band_ends.back();
  EXPECT_NE(points_at(relaxed, 3, true), points_at(relaxed, 0, true));
  EXPECT_NE(points_at(relaxed, 3, true), points_at(last, 3, true));
  EXPECT_EQ(points_at(last, 3, true), points_at(last, 0, true));
  EXPECT_EQ(points_at(last, 3, false), points_at(relaxed, 3, false));
  EXPECT_EQ(input.mesh.points(), input.observed);
}

TEST(Linear_path, Helps_where_triangles_are_smaller_than_the_noise)
{
  double sum_of_ratios = 0, sum_of_distance_ratios = 0;
  for(const Model_generator model : {models::organic_shape, models::cut_sphere})
  {
    const Mesh truth = uneven_mesh(model);
    for(const unsigned int seed : {1, 2, 3})
    {
      const Mesh noisy = with_noise(truth, 0.6, seed);
      const Mesh result = denoised(noisy), without = denoised(noisy, params::use_linear_path(false));
      sum_of_ratios += error(result, truth) / error(without, truth);
      sum_of_distance_ratios += SMD::vertex_distance_error(result, truth).area_weighted_l2
                              / SMD::vertex_distance_error(without, truth).area_weighted_l2;
    }
  }
  EXPECT_LT(sum_of_ratios, 6 * 0.85);
  EXPECT_LT(sum_of_distance_ratios, 6 * 0.98);
}

// ---- faces at edges

struct Assigned_faces
{
  SMD::Indexed_triangle_mesh mesh;
  std::vector<SMD::Indexed_triangle_mesh::Vector_3> normals;

  // noise is a third of the mean edge length
  void reassign(const std::vector<SMD::Indexed_triangle_mesh::Point_3>& observed, const float share,
                const SMD::internal::Adaptive_parameters& parameters = SMD::internal::Adaptive_parameters())
  {
    const std::vector<bool> is_movable(mesh.number_of_vertices(), true);
    const std::vector<float> shares(normals.size(), share);
    const SMD::internal::Noise_map noise(mesh.mean_edge_length() / 3);
    SMD::internal::Face_reassignment<CGAL::Sequential_tag>(mesh, observed, is_movable, SMD::internal::Vertex_neighbors(mesh),
                                                           noise, 1, shares, parameters, normals).run();
  }
};

Assigned_faces faces_of_cube()
{
  Assigned_faces faces = { indexed_mesh(irregular_mesh(models::cube, 3000)), {} };
  std::vector<double> areas;
  SMD::internal::compute_face_normals<CGAL::Sequential_tag>(faces.mesh, faces.normals, areas);
  return faces;
}

// gives faces at edges, no two of which are neighbors, the normal of the other side. Returns how many
std::size_t assign_wrongly(Assigned_faces& faces)
{
  std::size_t n = 0;
  std::vector<bool> is_near(faces.normals.size());
  for(std::size_t f=0; f<faces.normals.size(); ++f)
    for(const SMD::Indexed_triangle_mesh::Index g : faces.mesh.neighbors(f))
      if(!is_near[f] && faces.normals[f] * faces.normals[g] < 0.5)
      {
        for(const SMD::Indexed_triangle_mesh::Index h : faces.mesh.faces_around_face(f))
          for(const SMD::Indexed_triangle_mesh::Index i : faces.mesh.faces_around_face(h))
            is_near[i] = true;
        faces.normals[f] = faces.normals[g];
        ++n;
      }
  return n;
}

double largest_difference(const Assigned_faces& a, const Assigned_faces& b)
{
  double squared_maximum = 0;
  for(std::size_t f=0; f<a.normals.size(); ++f)
    squared_maximum = (std::max)(squared_maximum, (a.normals[f] - b.normals[f]).squared_length());
  return std::sqrt(squared_maximum);
}

TEST(Face_reassignment, Leaves_faces_on_their_sides)
{
  const Assigned_faces cube = faces_of_cube();
  Assigned_faces faces = cube;
  faces.reassign(cube.mesh.points(), 1);
  EXPECT_LT(largest_difference(faces, cube), 1e-6);
  EXPECT_EQ(faces.mesh.points(), cube.mesh.points());
}

TEST(Face_reassignment, Brings_faces_back_to_their_sides)
{
  const Assigned_faces cube = faces_of_cube();
  Assigned_faces faces = cube;
  EXPECT_GT(assign_wrongly(faces), 20u);
  EXPECT_GT(largest_difference(faces, cube), 1.4);
  faces.reassign(cube.mesh.points(), 1);
  EXPECT_LT(largest_difference(faces, cube), 1e-6);
}

// A wrong side takes ways along the surface
TEST(Face_reassignment, Knows_more_where_noise_is_along_normals)
{
  SMD::internal::Adaptive_parameters parameters;
  parameters.reassignment_tangential_weight = 0;
  std::size_t flips = 0, flips_without = 0;
  double sum_of_ratios = 0;
  for(const Model_generator model : {models::cone, models::pyramid_3, models::pyramid_4, models::cut_sphere, models::cad_part})
    for(const unsigned int seed : {1, 2})
    {
      const Mesh truth = irregular_mesh(model, 6000), noisy = with_noise(truth, 0.8, seed);
      const Mesh result = denoised(noisy), without = denoised_by(parameters, noisy);
      flips += number_of_flips(result, truth);
      flips_without += number_of_flips(without, truth);
      sum_of_ratios += error(result, truth) / error(without, truth);
    }
  EXPECT_GT(flips_without, 20u);
  EXPECT_LT(flips, 0.75 * flips_without);
  EXPECT_LT(sum_of_ratios, 10);
}

void expect_that_wrong_faces_stay(const float share, const SMD::internal::Adaptive_parameters& parameters)
{
  Assigned_faces faces = faces_of_cube();
  assign_wrongly(faces);
  const Assigned_faces wrong = faces;
  faces.reassign(wrong.mesh.points(), share, parameters);
  EXPECT_EQ(faces.normals, wrong.normals);
  EXPECT_EQ(faces.mesh.points(), wrong.mesh.points());
}

TEST(Face_reassignment, Leaves_faces_that_have_little_of_patches)
{
  expect_that_wrong_faces_stay(0.4f, SMD::internal::Adaptive_parameters());
}

TEST(Face_reassignment, Leaves_faces_that_are_smaller_than_the_noise)
{
  SMD::internal::Adaptive_parameters parameters;
  parameters.reassignment_least_height *= 10;
  expect_that_wrong_faces_stay(1, parameters);
}

TEST(Face_reassignment, Helps_where_noise_is_strong)
{
  std::size_t flips = 0, flips_without = 0;
  double sum_of_ratios = 0;
  for(const Model_generator model : {models::cone, models::pyramid_5, models::cut_sphere, models::thin_plate})
  {
    const Mesh truth = irregular_mesh(model, 6000);
    for(const Mesh& noisy : { with_noise(truth, 0.6), with_noise_in_all_directions(truth, 0.6) })
    {
      const Mesh result = denoised(noisy), without = denoised(noisy, params::reassign_faces(false));
      flips += number_of_flips(result, truth);
      flips_without += number_of_flips(without, truth);
      sum_of_ratios += error(result, truth) / error(without, truth);
    }
  }
  EXPECT_LT(flips, 0.7 * flips_without);
  EXPECT_LT(sum_of_ratios, 8 * 0.9);
}

// ---- what may not matter

TEST(Adaptive_fitting, Numbers_do_not_matter)
{
  const Mesh mesh = noisy_mesh(models::cad_part, 4000, 0.3);
  std::vector<std::size_t> vertex;
  const Mesh result = denoised(mesh), other = denoised(renumbered(mesh, vertex));
  double largest = 0;
  for(const Vertex v : mesh.vertices())
    largest = (std::max)(largest, distance(result.point(v), other.point(Vertex(std::uint32_t(vertex[std::size_t(v)])))));
  EXPECT_LT(largest, 1e-4 * mean_edge_length(mesh));
}

TEST(Adaptive_fitting, Position_and_unit_do_not_matter)
{
  const Mesh mesh = noisy_mesh(models::cut_sphere, 4000, 0.3);
  const Mesh result = denoised(mesh);
  for(const auto& map : { rotation_and_shift(), CGAL::Aff_transformation_3<Kernel>(CGAL::SCALING, 3e7) })
  {
    Mesh moved_first = mesh, moved_last = result;
    PMP::transform(map, moved_first);
    PMP::transform(map, moved_last);
    EXPECT_LT(largest_distance(denoised(moved_first), moved_last), 1e-4 * mean_edge_length(moved_last));
  }
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(Adaptive_fitting, Threads_do_not_matter)
{
  for(const Model_generator model : {models::cad_part, models::saddle})
  {
    const Mesh mesh = noisy_mesh(model, 8000, 0.3), small = irregular_mesh(model, 4000);
    Mesh with_impulses = small;
    SMD::add_noise(with_impulses, params::noise_level(0.5).noise_share(0.1).random_seed(1));
    for(const Mesh& noisy : { mesh, with_noise_in_all_directions(small, 0.3), with_impulses })
    {
      Mesh sequential = noisy, parallel = noisy;
      SMD::denoise_anisotropic_fitting<CGAL::Sequential_tag>(sequential);
      SMD::denoise_anisotropic_fitting<CGAL::Parallel_tag>(parallel);
      EXPECT_EQ(points_of(sequential), points_of(parallel));
    }
    EXPECT_EQ(SMD::estimate_noise_level<CGAL::Sequential_tag>(mesh),
              SMD::estimate_noise_level<CGAL::Parallel_tag>(mesh));
  }
}
#endif

// ---- fits of patches

// heights over random places of a disc, noisy ones and those of the surface, as a pilot without error has them
struct Sampled_heights
{
  Eigen::MatrixXd monomials;
  Eigen::VectorXd heights, true_heights;
  double noise;

  // with `has_three_rows`, over three lines of the disc
  template <typename True_height>
  Sampled_heights(const True_height& true_height, const std::size_t n, const double noise, const unsigned int seed,
                  const bool has_three_rows = false)
    : monomials(n, 10), heights(n), true_heights(n), noise(noise)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::normal_distribution<double> normal(0, noise);
    for(std::size_t i=0; i<n; ++i)
    {
      double u, v;
      do { u = uniform(random); v = uniform(random); } while(u*u + v*v > 1);
      if(has_three_rows)
        v = 0.1 * double(i % 3);
      monomials.row(i) << 1, u, v, u*u, u*v, v*v, u*u*u, u*u*v, u*v*v, v*v*v;
      true_heights[i] = true_height(u, v);
      heights[i] = true_heights[i] + normal(random);
    }
  }

  SMD::internal::Patch_surface fit(const SMD::internal::Adaptive_parameters& parameters
                                     = SMD::internal::Adaptive_parameters(), const bool is_pilot_fine = true,
                                   const double extent = 1) const
  {
    SMD::internal::Pilot_error pilot_error = parameters.first_patches_error;
    pilot_error.is_fine = is_pilot_fine;
    SMD::internal::Patch_fit fit(parameters, pilot_error, parameters.last_patches_effort, extent);
    fit.clear(noise * noise);
    for(Eigen::Index i=0; i<heights.size(); ++i)
      fit.insert(monomials(i, 1) / extent, monomials(i, 2) / extent, heights[i], true_heights[i]);
    fit.update(2 * std::size_t(heights.size()));
    return fit.best();
  }

  // the leverages sum up to the number of coefficients
  double sum_of_leverages(const SMD::internal::Patch_surface& surface) const
  {
    double sum = 0;
    for(Eigen::Index i=0; i<heights.size(); ++i)
      sum += surface.variance_of_height(monomials(i, 1), monomials(i, 2));
    return sum;
  }
};

// c (u cos(angle) + v sin(angle))^2 over a tilted plane
struct Parabolic_cylinder
{
  double c, angle;

  double operator()(const double u, const double v) const
  {
    return 0.3 + 0.2*u - 0.1*v + c * std::pow(u * std::cos(angle) + v * std::sin(angle), 2);
  }
};

double bowl(const double u, const double v) { return 0.5*u*u + 0.1*u*v + 0.4*v*v; }
double saddle(const double u, const double v) { return 0.4*u*u + 0.1*u*v - 0.5*v*v; }
double monkey_saddle(const double u, const double v) { return u*u*u - 3*u*v*v; }

TEST(Patch_fit, Takes_no_more_coefficients_than_the_surface_has)
{
  const std::vector<std::pair<std::function<double(double, double)>, std::size_t> > surfaces
    = { { Parabolic_cylinder{0, 0}, 3 }, { Parabolic_cylinder{0.5, 0.4}, 4 }, { Parabolic_cylinder{-0.5, 1.9}, 4 },
        { bowl, 6 }, { saddle, 6 }, { monkey_saddle, 10 } };
  for(const auto& surface : surfaces)
  {
    std::size_t number_as_expected = 0;
    for(unsigned int seed=1; seed<=100; ++seed)
    {
      const Sampled_heights sample(surface.first, 60, 0.03, seed);
      const SMD::internal::Patch_surface fit = sample.fit();
      const double n = sample.sum_of_leverages(fit);
      EXPECT_LT(std::abs(n - std::round(n)), 1e-9);
      EXPECT_NEAR(fit.risk - fit.squared_bias, n * 0.03 * 0.03 / 60, 1e-12);
      number_as_expected += (std::lround(n) == long(surface.second));
    }
    EXPECT_GE(number_as_expected, 80u) << surface.second;
  }
}

TEST(Patch_fit, Cubic_is_that_of_least_squares)
{
  typedef SMD::Indexed_triangle_mesh Indexed;
  const Sampled_heights sample(monkey_saddle, 60, 0.03, 1);
  const SMD::internal::Patch_surface fit = sample.fit();
  const Eigen::VectorXd c = sample.monomials.colPivHouseholderQr().solve(sample.heights);
  EXPECT_LT((fit.coefficients - c).norm(), 1e-9);

  const Eigen::MatrixXd covariance = (sample.monomials.transpose() * sample.monomials).inverse();
  const SMD::internal::Patch_frame frame(Indexed::Point_3(0, 0, 0),
                                         Indexed::Vector_3(0, 0, 1), 1);
  const double step = 1e-5;
  for(Eigen::Index i=0; i<60; ++i)
  {
    const Eigen::VectorXd m = sample.monomials.row(i);
    const double u = m[1], v = m[2];
    EXPECT_NEAR(fit.height(u, v), m.dot(c), 1e-9);
    EXPECT_NEAR(fit.variance_of_height(u, v), m.dot(covariance * m), 1e-9);

    const Indexed::Vector_3 normal = fit.normal(frame, u, v);
    const double slope_u = (fit.height(u + step, v) - fit.height(u - step, v)) / (2 * step),
                 slope_v = (fit.height(u, v + step) - fit.height(u, v - step)) / (2 * step);
    EXPECT_LT((normal - (frame.axis - slope_u * frame.tangents[0] - slope_v * frame.tangents[1])).squared_length(), 1e-16);

    Eigen::MatrixXd slopes(10, 2);
    slopes << 0, 0, 1, 0, 0, 1, 2*u, 0, v, u, 0, 2*v, 3*u*u, 0, 2*u*v, u*u, v*v, 2*u*v, 0, 3*v*v;
    EXPECT_NEAR(fit.variance_of_slopes(u, v), (slopes.transpose() * covariance * slopes).trace(), 1e-9);
  }
}

TEST(Patch_fit, Cubics_are_for_smooth_shapes_that_a_fine_pilot_shows_on_all_sides)
{
  const auto is_cubic = [](const Sampled_heights& sample, const bool is_pilot_fine = true)
  {
    return sample.fit(SMD::internal::Adaptive_parameters(), is_pilot_fine).is_cubic();
  };
  for(unsigned int seed=1; seed<=20; ++seed)
  {
    EXPECT_TRUE(is_cubic(Sampled_heights(monkey_saddle, 60, 0.03, seed)));
    EXPECT_FALSE(is_cubic(Sampled_heights(monkey_saddle, 60, 0.03, seed), false));
    EXPECT_FALSE(is_cubic(Sampled_heights(monkey_saddle, 60, 0.001, seed, true)));
    for(const double place : {0., 0.2, 0.4, 0.6})
    {
      const auto roof = [&](const double u, double) { return -0.3 * std::abs(u - place); };
      EXPECT_FALSE(is_cubic(Sampled_heights(roof, 60, 0.03, seed))) << place;
    }
  }
}

TEST(Patch_fit, Cylinder_is_that_of_least_squares_about_the_axis_of_the_pilot)
{
  const double angle = 0.7;
  const Sampled_heights sample(Parabolic_cylinder{0.5, angle}, 60, 0.03, 1);
  SMD::internal::Adaptive_parameters parameters;
  parameters.quadric_threshold = std::numeric_limits<double>::infinity();
  const SMD::internal::Patch_surface fit = sample.fit(parameters);

  Eigen::MatrixXd design(60, 4);
  for(Eigen::Index i=0; i<60; ++i)
  {
    const double u = sample.monomials(i, 1), v = sample.monomials(i, 2);
    design.row(i) << 1, u, v, std::pow(u * std::cos(angle) + v * std::sin(angle), 2);
  }
  const Eigen::VectorXd c = design.colPivHouseholderQr().solve(sample.heights);
  EXPECT_LT((fit.coefficients.head<3>() - c.head<3>()).norm(), 1e-9);
  const double cosine = std::cos(angle), sine = std::sin(angle);
  EXPECT_LT((fit.coefficients.segment<3>(3) - c[3] * Eigen::Vector3d(cosine*cosine, 2*cosine*sine, sine*sine)).norm(), 1e-9);

  const Eigen::MatrixXd leverages = design * (design.transpose() * design).inverse() * design.transpose();
  for(Eigen::Index i=0; i<60; ++i)
    EXPECT_NEAR(fit.variance_of_height(sample.monomials(i, 1), sample.monomials(i, 2)), leverages(i, i), 1e-9);
}

// of radius r; touches the plane at the origin
struct Sphere
{
  double r;

  double operator()(const double u, const double v) const { return r - std::sqrt(r*r - u*u - v*v); }
};

struct Circular_cylinder
{
  double r, angle;

  double operator()(const double u, const double v) const
  {
    return 0.3 + Sphere{r}(u * std::cos(angle) + v * std::sin(angle), 0);
  }
};

TEST(Patch_fit, Round_surfaces_are_spheres_and_cylinders)
{
  typedef SMD::Indexed_triangle_mesh Indexed;
  const double noise = 1e-6, step = 1e-5;
  SMD::internal::Adaptive_parameters parameters, without;
  parameters.cubic_threshold = without.cubic_threshold = std::numeric_limits<double>::infinity();
  without.use_round_patches = false;
  const std::vector<std::function<double(double, double)> > surfaces
    = { Sphere{1.2}, Circular_cylinder{1.2, 0}, Circular_cylinder{1.2, 0.7} };
  for(const auto& surface : surfaces)
    for(const double extent : {1., 3.})
    {
      const Sampled_heights sample(surface, 200, noise, 1);
      const SMD::internal::Patch_surface fit = sample.fit(parameters, true, extent);
      const SMD::internal::Patch_surface parabolic = sample.fit(without, true, extent);
      EXPECT_EQ(parabolic.roundness, 0);
      EXPECT_FALSE(fit.is_cubic());
      EXPECT_NEAR(fit.risk - fit.squared_bias, parabolic.risk - parabolic.squared_bias, 1e-18); // as many coefficients
      const SMD::internal::Patch_frame frame(Indexed::Point_3(0, 0, 0), Indexed::Vector_3(0, 0, 1), extent);
      double largest_error_of_parabolas = 0;
      for(Eigen::Index i=0; i<200; ++i)
      {
        const double x = sample.monomials(i, 1), y = sample.monomials(i, 2);
        const double u = x / extent, v = y / extent;
        EXPECT_NEAR(fit.height(u, v), surface(x, y), 20 * noise);
        largest_error_of_parabolas = (std::max)(largest_error_of_parabolas,
                                                std::abs(parabolic.height(u, v) - surface(x, y)));
        const double slope_x = (surface(x + step, y) - surface(x - step, y)) / (2 * step),
                     slope_y = (surface(x, y + step) - surface(x, y - step)) / (2 * step);
        const Indexed::Vector_3 slopes = slope_x * extent * frame.tangents[0] + slope_y * extent * frame.tangents[1];
        EXPECT_LT((fit.normal(frame, u, v) - (frame.axis - slopes)).squared_length(), 1e-7);
      }
      EXPECT_GT(largest_error_of_parabolas, 1e4 * noise);
    }
}

TEST(Patch_fit, Round_surfaces_are_only_for_what_is_rounder_than_parabolas)
{
  // the fourth derivatives of cosines have the other sign
  const auto wave = [](const double u, const double v) { return 0.4 * std::cos(1.2 * u) * std::cos(0.8 * v); };
  for(unsigned int seed=1; seed<=20; ++seed)
  {
    EXPECT_EQ(Sampled_heights(wave, 200, 0.001, seed).fit().roundness, 0);
    EXPECT_EQ(Sampled_heights(Parabolic_cylinder{0.5, 0.4}, 200, 0.001, seed).fit().roundness, 0);
    EXPECT_NE(Sampled_heights(Circular_cylinder{1.2, 0.4}, 200, 0.001, seed).fit().roundness, 0);
  }
}

TEST(Patch_fit, Round_surfaces_end_before_they_go_upright)
{
  EXPECT_EQ(Sampled_heights(Sphere{1.01}, 200, 0.001, 1).fit().roundness, 0);
  EXPECT_NEAR(Sampled_heights(Sphere{1.1}, 200, 0.001, 1).fit().roundness, 1 / 2.2, 0.005);
}

TEST(Patch_fit, Round_surfaces_help_on_spheres_and_cylinders)
{
  for(const Model_generator model : {models::sphere, models::cylinder})
  {
    double sum_of_logarithms = 0;
    for(const double level : {0.05, 0.1, 0.2})
    {
      const Mesh truth = irregular_mesh(model, 3000), noisy = with_noise(truth, level);
      sum_of_logarithms += std::log(error(denoised(noisy), truth)
                                    / error(denoised(noisy, params::use_round_patches(false)), truth));
    }
    EXPECT_LT(sum_of_logarithms, 3 * -0.15);
  }
}

TEST(Patch_fit, Without_adaptive_degree_all_are_quadrics)
{
  SMD::internal::Adaptive_parameters parameters;
  parameters.use_adaptive_degree = false;
  const Sampled_heights sample(monkey_saddle, 60, 0.03, 1);
  EXPECT_NEAR(sample.sum_of_leverages(sample.fit(parameters)), 6, 1e-9);
}

TEST(Patch_fit, Cylinders_help_where_surfaces_bend_one_way)
{
  SMD::internal::Adaptive_parameters parameters;
  parameters.cylinder_threshold = std::numeric_limits<double>::infinity();
  double sum_of_logarithms = 0;
  for(const Model_generator model : {models::cylinder, models::cad_part, models::drilled_block, models::cone})
    for(const double level : {0.1, 0.3, 0.5})
    {
      const Mesh truth = irregular_mesh(model, 3000), noisy = with_noise(truth, level);
      sum_of_logarithms += std::log(error(denoised(noisy), truth) / error(denoised_by(parameters, noisy), truth));
    }
  EXPECT_LT(sum_of_logarithms, 12 * -0.03);
}

TEST(Patch_fit, Cubics_help_on_smooth_shapes_in_weak_noise)
{
  SMD::internal::Adaptive_parameters parameters;
  parameters.cubic_threshold = std::numeric_limits<double>::infinity();
  for(const double level : {0.05, 0.1})
  {
    const Mesh truth = irregular_mesh(models::saddle, 3000), noisy = with_noise(truth, level);
    EXPECT_LT(error(denoised(noisy), truth), 0.85 * error(denoised_by(parameters, noisy), truth));
  }
}

// ---- blend of patches

typedef SMD::internal::Patch_blend<CGAL::Sequential_tag> Patch_blend;

// blends patches over the mesh itself, where noise is weak
template <typename Get>
auto of_patches(const SMD::Indexed_triangle_mesh& mesh, const bool is_mesh_fine, const Get& get)
{
  const SMD::internal::Adaptive_parameters parameters;
  const double edge_length = mesh.mean_edge_length<CGAL::Sequential_tag>();
  SMD::internal::Pilot_error error = parameters.first_patches_error;
  error.is_fine = is_mesh_fine;
  const SMD::internal::Noise_map noise(0.01 * edge_length);
  return get(Patch_blend(mesh, mesh.points(), std::vector<bool>(mesh.number_of_vertices(), true), noise, edge_length,
                         parameters, error, parameters.last_patches_effort));
}

std::vector<SMD::Indexed_triangle_mesh::Vector_3> normal_deviations(const Patch_blend& blend)
{
  return blend.normal_deviations(blend.leverages());
}

// in degrees
double mean_angle(const std::vector<SMD::Indexed_triangle_mesh::Vector_3>& a,
                  const std::vector<SMD::Indexed_triangle_mesh::Vector_3>& b)
{
  double sum = 0;
  for(std::size_t i=0; i<a.size(); ++i)
    sum += CGAL::approximate_angle(a[i], b[i]);
  return sum / double(a.size());
}

// a level and what it is multiplied by, at each vertex
TEST(Patch_blend, Goes_by_the_noise_of_each_place)
{
  const Mesh truth = irregular_mesh(models::cad_part, 1500);
  const SMD::Indexed_triangle_mesh mesh = indexed_mesh(truth), observed = indexed_mesh(with_noise(truth, 0.1));
  const std::vector<bool> is_movable(mesh.number_of_vertices(), true);
  const SMD::internal::Adaptive_parameters parameters;
  const double edge_length = mesh.mean_edge_length<CGAL::Sequential_tag>();
  const auto points = [&](const SMD::internal::Noise_map& noise)
  {
    return Patch_blend(mesh, observed.points(), is_movable, noise, edge_length, parameters, parameters.first_patches_error,
                       parameters.last_patches_effort).points();
  };
  const SMD::internal::Noise_map uniform(0.1 * edge_length), strong(0.2 * edge_length);
  SMD::internal::Noise_map halves = strong;
  halves.ratios.assign(mesh.number_of_vertices(), 0.5f);
  const auto expected = points(uniform);
  const auto mean_distance = [&](const SMD::internal::Noise_map& noise)
  {
    const auto found = points(noise);
    double sum = 0;
    for(std::size_t v=0; v<found.size(); ++v)
      sum += std::sqrt(CGAL::squared_distance(found[v], expected[v]));
    return sum / double(found.size());
  };
  // but for the normals of low faces
  EXPECT_LT(mean_distance(halves), 2e-4 * edge_length);
  EXPECT_GT(mean_distance(strong), 2e-3 * edge_length);
}

TEST(Patch_blend, Faces_have_the_normals_that_triangles_have_where_the_surface_bends)
{
  typedef std::vector<SMD::Indexed_triangle_mesh::Vector_3> Normals;
  const auto normals = [](const Patch_blend& blend) { return blend.face_normals(); };
  for(const Model_generator model : {models::sphere, models::saddle})
  {
    const SMD::Indexed_triangle_mesh mesh = indexed_mesh(irregular_mesh(model, 1500));
    Normals normals_of_mesh;
    std::vector<double> areas;
    SMD::internal::compute_face_normals<CGAL::Sequential_tag>(mesh, normals_of_mesh, areas);

    const Normals fine = of_patches(mesh, true, normals), coarse = of_patches(mesh, false, normals);
    EXPECT_LT(mean_angle(fine, normals_of_mesh), 0.1);
    EXPECT_GT(mean_angle(coarse, normals_of_mesh), 0.5);

    Normals without_deviations = fine;
    const Normals fine_deviations = of_patches(mesh, true, normal_deviations);
    for(std::size_t f=0; f<fine.size(); ++f)
      without_deviations[f] = without_deviations[f] - fine_deviations[f];
    EXPECT_LT(mean_angle(without_deviations, coarse), 0.1);
    for(const SMD::Indexed_triangle_mesh::Vector_3& d : of_patches(mesh, false, normal_deviations))
      EXPECT_LT(d.squared_length(), 1e-24);
  }
}

TEST(Patch_blend, Planes_have_no_deviations_and_stay)
{
  const SMD::Indexed_triangle_mesh mesh = indexed_mesh(plane());
  for(const auto& d : of_patches(mesh, true, normal_deviations))
    EXPECT_LT(d.squared_length(), 1e-20);
  const auto points = of_patches(mesh, true, [](const Patch_blend& blend) { return blend.points(); });
  for(std::size_t v=0; v<points.size(); ++v)
    EXPECT_LT(CGAL::squared_distance(points[v], mesh.point(v)), 1e-20);
}

// what the points of patches over a patched mesh follow of the noise along the normals, and their noise shares, in the mean and
// in the squared noise
std::array<double, 2> followed_noise(const Mesh& truth, const double level)
{
  SMD::internal::Adaptive_parameters parameters;
  parameters.use_gentle_path = parameters.use_linear_path = parameters.use_quadric_path = false;
  const Mesh noisy = with_noise(truth, level);
  const SMD::Indexed_triangle_mesh pilot = indexed_mesh(denoised_by(parameters, noisy)), observed = indexed_mesh(noisy),
                                   mesh = indexed_mesh(truth);
  const double edge_length = mesh.mean_edge_length<CGAL::Sequential_tag>(), noise = level * edge_length;
  const std::vector<bool> is_movable(mesh.number_of_vertices(), true);
  const SMD::internal::Noise_map noise_map(noise);
  const Patch_blend blend(pilot, observed.points(), is_movable, noise_map,
                          pilot.mean_edge_length<CGAL::Sequential_tag>(), parameters, parameters.first_patches_error,
                          parameters.last_patches_effort);
  std::vector<SMD::Indexed_triangle_mesh::Vector_3> normals;
  SMD::internal::compute_vertex_normals<CGAL::Sequential_tag>(mesh, normals);
  const auto points = blend.points();
  const std::vector<double> shares = blend.noise_shares(SMD::internal::Vertex_neighbors(pilot));
  std::array<double, 2> sums = {{ 0, 0 }};
  double squares = 0;
  for(std::size_t v=0; v<points.size(); ++v)
  {
    const double n = (observed.point(v) - mesh.point(v)) * normals[v];
    sums[0] += n * ((points[v] - mesh.point(v)) * normals[v]);
    sums[1] += shares[v];
    squares += n * n;
  }
  return {{ sums[0] / squares, sums[1] / (double(points.size()) * noise * noise) }};
}

TEST(Patch_blend, Noise_shares_are_what_points_follow_of_the_noise)
{
  for(const Model_generator model : {models::sphere, models::torus, models::cylinder, models::organic_shape, models::cube})
    for(const double level : {0.1, 0.3})
    {
      const std::array<double, 2> followed = followed_noise(irregular_mesh(model, 3000), level);
      EXPECT_LT(followed[1], 1.35 * followed[0]);
      EXPECT_GT(followed[1], 0.75 * followed[0]);
    }
}

// ---- moves that turn faces

typedef std::vector<SMD::Indexed_triangle_mesh::Vector_3> Vectors;

// the normals of the mesh, turned by some degrees each
Vectors turned_normals(const SMD::Indexed_triangle_mesh& mesh, const double degrees)
{
  Vectors normals;
  std::vector<double> areas;
  SMD::internal::compute_face_normals<CGAL::Sequential_tag>(mesh, normals, areas);
  std::mt19937 random(3);
  std::normal_distribution<double> slope(0, degrees * models::pi / 180);
  for(auto& n : normals)
  {
    const double x = slope(random), y = slope(random), z = slope(random);
    n = SMD::internal::normalized_or_null(n + SMD::Indexed_triangle_mesh::Vector_3(x, y, z));
  }
  return normals;
}

void turn_faces(SMD::Indexed_triangle_mesh& mesh, const Vectors& normals, const std::size_t number_of_moves,
                const std::size_t moves_between_weights, const double relaxation)
{
  SMD::internal::turn_faces<CGAL::Sequential_tag>(mesh, std::vector<bool>(mesh.number_of_vertices(), true), normals,
                                                  number_of_moves, moves_between_weights, relaxation);
}

TEST(Turn_faces, Faces_that_have_their_normals_stay)
{
  const SMD::Indexed_triangle_mesh mesh = indexed_mesh(irregular_mesh(models::torus, 500));
  SMD::Indexed_triangle_mesh moved = mesh;
  turn_faces(moved, turned_normals(mesh, 0), 10, 3, 0.4);
  for(std::size_t v=0; v<mesh.number_of_vertices(); ++v)
    EXPECT_LT(CGAL::squared_distance(moved.point(v), mesh.point(v)), 1e-24);
}

// the slopes of the heights along the normals, by the metric that the edges of `original` make
TEST(Turn_faces, The_sum_of_squared_slopes_never_grows)
{
  const SMD::Indexed_triangle_mesh original = indexed_mesh(irregular_mesh(models::cad_part, 1500));
  const Vectors normals = turned_normals(original, 5);
  const auto sum_of_slopes = [&](const SMD::Indexed_triangle_mesh& mesh)
  {
    double sum = 0;
    for(std::size_t f=0; f<mesh.number_of_faces(); ++f)
    {
      const auto& t = mesh.vertices(f);
      const auto e = original.point(t[1]) - original.point(t[0]), g = original.point(t[2]) - original.point(t[0]);
      Eigen::Matrix2d metric;
      metric << e * e, e * g, e * g, g * g;
      const Eigen::Vector2d rises(normals[f] * (mesh.point(t[1]) - mesh.point(t[0])),
                                  normals[f] * (mesh.point(t[2]) - mesh.point(t[0])));
      const double squared_longest = (std::max)({e.squared_length(), g.squared_length(), (g - e).squared_length()});
      sum += metric.determinant() / squared_longest * rises.dot(metric.inverse() * rises);
    }
    return sum;
  };
  for(const double relaxation : {0.4, 0.66})
  {
    double last = sum_of_slopes(original);
    for(const std::size_t number_of_moves : {1, 2, 3, 5, 10, 20, 50, 100})
    {
      SMD::Indexed_triangle_mesh mesh = original;
      turn_faces(mesh, normals, number_of_moves, number_of_moves, relaxation);
      const double now = sum_of_slopes(mesh);
      EXPECT_LT(now, last);
      last = now;
    }
    EXPECT_LT(last, 0.6 * sum_of_slopes(original)); // there are more faces than vertices, so much remains
  }
}

TEST(Turn_faces, Weights_are_computed_anew)
{
  const SMD::Indexed_triangle_mesh original = indexed_mesh(irregular_mesh(models::cad_part, 1500));
  const Vectors normals = turned_normals(original, 5);
  SMD::Indexed_triangle_mesh together = original, apart = original, frozen = original;
  turn_faces(together, normals, 6, 2, 0.5);
  for(int i=0; i<3; ++i)
    turn_faces(apart, normals, 2, 2, 0.5);
  turn_faces(frozen, normals, 6, 6, 0.5);
  EXPECT_EQ(together.points(), apart.points());
  EXPECT_NE(together.points(), frozen.points());
}

// the normals of slivers tell little, and must not keep neighborhoods from growing over them
TEST(Adaptive_fitting, Uneven_triangles_keep_edges)
{
  double sum = 0;
  for(const Model_generator model : {models::cut_sphere, models::cylinder})
  {
    const Mesh truth = uneven_mesh(model);
    for(const unsigned int seed : {1, 2})
      sum += error(denoised(with_noise(truth, 0.3, seed)), truth);
  }
  EXPECT_LT(sum / 4, 7);
}

// where results are mixed, low triangles must not pay for what the others gain
TEST(Adaptive_fitting, Uneven_triangles_stay_smooth)
{
  const Mesh truth = uneven_mesh(models::sphere);
  double sum = 0;
  for(const unsigned int seed : {1, 2, 3})
    sum += error(denoised(with_noise(truth, 0.1, seed)), truth);
  EXPECT_LT(sum / 3, 1.5);
}

// where what patches tell of the bends in single triangles is noise, and cancels without it
TEST(Adaptive_fitting, Regular_triangles_of_bent_surfaces_come_out_smooth)
{
  const Mesh truth = regular_mesh(models::torus, 1500);
  EXPECT_LT(error(denoised(with_noise(truth, 0.05)), truth), 0.58);
  EXPECT_LT(error(denoised(with_noise(truth, 0.1)), truth), 0.91);
}

// where noise is averaged over more than patches hold
TEST(Adaptive_fitting, Large_smooth_surfaces_come_out_smoother)
{
  const Mesh truth = regular_mesh(models::torus, 6000);
  EXPECT_LT(error(denoised(with_noise(truth, 0.05)), truth), 0.28);
  EXPECT_LT(error(denoised(with_noise(truth, 0.1)), truth), 0.46);
}

TEST(Adaptive_fitting, Uneven_triangles_cost_little_on_smooth_shapes)
{
  const auto error_on = [](const Mesh& truth) { return error(denoised(with_noise(truth, 0.05)), truth); };
  struct Case { Model_generator model; double largest_ratio, largest_error; };
  for(const Case& c : {Case{models::sphere, 1.5, 0.42}, Case{models::torus, 2.2, 1}})
  {
    const double irregular = error_on(irregular_mesh(c.model, 1500));
    EXPECT_LT(irregular, c.largest_ratio * error_on(regular_mesh(c.model, 1500)));
    EXPECT_LT(irregular, c.largest_error);
  }
}

TEST(Adaptive_fitting, Noise_along_the_normals_moves_vertices_along_the_normals_only)
{
  for(const Model_generator model : {models::sphere, models::saddle, models::torus})
  {
    const Mesh truth = irregular_mesh(model, 1500), result = denoised(with_noise(truth, 0.05));
    const SMD::Indexed_triangle_mesh indexed_truth = indexed_mesh(truth), indexed_result = indexed_mesh(result);
    std::vector<SMD::Indexed_triangle_mesh::Vector_3> normals;
    SMD::internal::compute_vertex_normals<CGAL::Sequential_tag>(indexed_truth, normals);
    double sum = 0;
    for(std::size_t v=0; v<normals.size(); ++v)
      sum += SMD::internal::along_surface(indexed_result.point(v) - indexed_truth.point(v), normals[v]).squared_length();
    EXPECT_LT(std::sqrt(sum / double(normals.size())), 0.02 * indexed_truth.mean_edge_length<CGAL::Sequential_tag>());
  }
}

// ---- parameters

TEST(Adaptive_fitting, Any_parameter_of_the_iterative_method_chooses_it)
{
  const Mesh mesh = noisy_mesh(models::cad_part, 1500, 0.2);
  const Mesh iterative = denoised(mesh, Anisotropic_parameters().named());
  EXPECT_EQ(points_of(denoised(mesh, params::number_of_iterations(30))), points_of(iterative));
  EXPECT_EQ(points_of(denoised(mesh, params::convergence_threshold(0.05))), points_of(iterative));
  EXPECT_EQ(points_of(denoised(mesh, params::neighborhood_size(40))), points_of(iterative));
  EXPECT_EQ(points_of(denoised(mesh, params::normal_weight(200))), points_of(iterative));
  EXPECT_EQ(points_of(denoised(mesh, params::angle_threshold(0.5))), points_of(iterative));
  EXPECT_EQ(points_of(denoised(mesh, params::normal_exponent(4))), points_of(iterative));
  EXPECT_EQ(points_of(denoised(mesh, params::number_of_normal_iterations(5))), points_of(iterative));
  EXPECT_EQ(points_of(denoised(mesh, params::relaxation_factor(0.5))), points_of(iterative));
  EXPECT_EQ(points_of(denoised(mesh, params::face_normal_filter(SMD::Thresholded_normal_filter(0.5, 4)))),
            points_of(iterative));
  EXPECT_NE(points_of(denoised(mesh)), points_of(iterative));
}

TEST(Adaptive_fitting, Each_switch_has_an_effect)
{
  const Mesh truth = irregular_mesh(models::cad_part, 6000), noisy = with_noise(truth, 0.4);
  const double best = error(denoised(noisy), truth);
  EXPECT_GT(error(denoised(noisy, params::use_adaptive_neighborhoods(false)), truth), 1.1 * best);

  // planes are fitted best by planes
  const Mesh cube = irregular_mesh(models::cube, 6000), noisy_cube = with_noise(cube, 0.4);
  EXPECT_GT(error(denoised(noisy_cube, params::use_adaptive_degree(false)), cube),
            1.1 * error(denoised(noisy_cube), cube));

  for(const std::size_t size : {1500, 6000})
  {
    const Mesh bent = irregular_mesh(models::organic_shape, size), noisy_bent = with_noise(bent, 0.05);
    EXPECT_LT(error(denoised(noisy_bent), bent),
              0.92 * error(denoised(noisy_bent, params::use_quadric_path(false)), bent));
  }

  const Mesh detail = irregular_mesh(models::organic_shape, 6000), noisy_detail = with_noise(detail, 0.3);
  EXPECT_LT(error(denoised(noisy_detail), detail),
            0.97 * error(denoised(noisy_detail, params::use_gentle_path(false)), detail));
}

TEST(Adaptive_fitting, The_noise_level_can_be_given)
{
  const Mesh truth = irregular_mesh(models::organic_shape, 4000), noisy = with_noise(truth, 0.2);
  EXPECT_EQ(points_of(denoised(noisy, params::noise_level(0.))), points_of(noisy));
  const auto moved = [&](const double level)
  { return largest_distance(denoised(noisy, params::noise_level(level)), noisy); };
  EXPECT_LT(moved(0.02), 0.5 * moved(0.2));
  for(const double level : {-0.1, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(denoised(noisy, params::noise_level(level)), std::invalid_argument);
}

TEST(Adaptive_fitting, Constrained_vertices_stay)
{
  Mesh mesh = noisy_mesh(models::cad_part, 4000, 0.3);
  auto constrained = mesh.add_property_map<Vertex, bool>("v:constrained", false).first;
  for(const Vertex v : mesh.vertices())
    constrained[v] = mesh.point(v).x() < 2;
  const Mesh result = denoised(mesh, params::vertex_is_constrained_map(constrained));
  std::size_t number_of_moved = 0, number_of_movable = 0;
  for(const Vertex v : mesh.vertices())
  {
    if(constrained[v])
    {
      EXPECT_EQ(result.point(v), mesh.point(v));
    }
    number_of_movable += !constrained[v];
    number_of_moved += (result.point(v) != mesh.point(v));
  }
  EXPECT_EQ(number_of_moved, number_of_movable);
}

TEST(Adaptive_fitting, The_range_moves_alone)
{
  Mesh mesh = noisy_mesh(models::sphere, 4000, 0.3);
  const Mesh noisy = mesh;
  std::vector<Vertex> range;
  for(const Vertex v : mesh.vertices())
    if(mesh.point(v).z() > 0.5)
      range.push_back(v);
  SMD::denoise_anisotropic_fitting(range, mesh);
  std::size_t number_of_moved = 0;
  for(const Vertex v : mesh.vertices())
    number_of_moved += (noisy.point(v) != mesh.point(v));
  EXPECT_EQ(number_of_moved, range.size());
}

TEST(Adaptive_fitting, Neighborhoods_do_not_cross_constrained_edges)
{
  // a crease that noise hides: without the constraint it is rounded
  Mesh truth = plane();
  for(const Vertex v : truth.vertices())
    truth.point(v) = Point(truth.point(v).x(), truth.point(v).y(), 0.22 * std::abs(truth.point(v).x() - 30));
  double sum = 0, sum_without = 0; // by chance, noise may look like a shape
  for(const unsigned int seed : {1, 2, 3, 4})
  {
    Mesh noisy = with_noise(truth, 0.4, seed);
    auto constrained = noisy.add_property_map<Edge, bool>("e:constrained", false).first;
    for(const Edge e : noisy.edges())
      constrained[e] = truth.point(noisy.vertex(e, 0)).x() == 30 && truth.point(noisy.vertex(e, 1)).x() == 30;
    sum += error(denoised(noisy, params::edge_is_constrained_map(constrained)), truth);
    sum_without += error(denoised(noisy), truth);
  }
  EXPECT_LT(sum, 0.75 * sum_without);
}

TEST(Adaptive_fitting, The_visitor_sees_each_iteration)
{
  const Mesh noisy = noisy_mesh(models::cad_part, 2000, 0.3);
  Mesh mesh = noisy;
  Counting_visitor visitor;
  const SMD::Denoising_result result = SMD::denoise_anisotropic_fitting(mesh, params::visitor(std::ref(visitor)));
  EXPECT_GT(visitor.number_of_calls, 2u);
  EXPECT_EQ(visitor.number_of_calls, result.number_of_iterations);
  EXPECT_EQ(visitor.number_of_converged, 1u);
  EXPECT_TRUE(visitor.displacements_are_positive);
  EXPECT_TRUE(result.has_converged);

  // the pilot grows better from step to step
  double last_error = std::numeric_limits<double>::infinity();
  const Mesh truth = irregular_mesh(models::cad_part, 2000);
  for(const std::size_t last : {1, 3, 6})
  {
    Mesh early = noisy;
    Counting_visitor ending;
    ending.last = last;
    const SMD::Denoising_result ended = SMD::denoise_anisotropic_fitting(early, params::visitor(std::ref(ending)));
    EXPECT_EQ(ended.number_of_iterations, last);
    EXPECT_FALSE(ended.has_converged);
    EXPECT_LT(error(early, truth), last_error);
    last_error = error(early, truth);
  }
}

TEST(Adaptive_fitting, An_exception_leaves_the_mesh_as_it_was)
{
  const Mesh noisy = noisy_mesh(models::cad_part, 1000, 0.3);
  Mesh mesh = noisy;
  const std::size_t last = SMD::denoise_anisotropic_fitting(mesh).number_of_iterations;
  for(const std::size_t iteration : {std::size_t(1), last})
  {
    mesh = noisy;
    Counting_visitor visitor;
    visitor.see = [&](const std::size_t i) { if(i == iteration) throw std::runtime_error("enough"); };
    EXPECT_THROW(SMD::denoise_anisotropic_fitting(mesh, params::visitor(std::ref(visitor))), std::runtime_error);
    EXPECT_EQ(points_of(mesh), points_of(noisy));
  }
}

TEST(Adaptive_fitting, Normals_are_those_of_the_result)
{
  for(const Model_generator model : {models::cad_part, models::organic_shape})
  {
    Mesh mesh = noisy_mesh(model, 5000, 0.2);
    auto face_normals = mesh.add_property_map<Face, Vector>("f:normal", Vector(0, 0, 0)).first;
    auto vertex_normals = mesh.add_property_map<Vertex, Vector>("v:normal", Vector(0, 0, 0)).first;
    SMD::denoise_anisotropic_fitting(mesh, params::face_normal_map(face_normals).vertex_normal_map(vertex_normals));
    double sum = 0;
    for(const Face f : mesh.faces())
    {
      EXPECT_NEAR(face_normals[f].squared_length(), 1, 1e-12);
      sum += angle_between(face_normals[f], normal_of(mesh, f));
    }
    EXPECT_LT(sum / double(num_faces(mesh)), 2);
    for(const Vertex v : mesh.vertices())
      EXPECT_NEAR(vertex_normals[v].squared_length(), 1, 1e-12);
  }
}

// ---- bad and small meshes

// a rough letter C with plane walls, of four vertices for each of `n` + 1 radii
Mesh rough_letter(const int n)
{
  Mesh mesh;
  for(int i=0; i<=n; ++i)
    for(const double radius : {1 - 0.1 * (i % 3), 1.4 + 0.15 * (i % 2)})
      for(const double z : {0., 0.3})
      {
        const double angle = 5. * i / n;
        mesh.add_vertex(Point(radius * std::cos(angle), radius * std::sin(angle), z));
      }
  const auto add_quad = [&](const int a, const int b, const int c, const int d)
  {
    mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
    mesh.add_face(Vertex(a), Vertex(c), Vertex(d));
  };
  for(int i=0; i<4*n; i+=4)
  {
    add_quad(i, i+4, i+6, i+2);     // bottom
    add_quad(i+3, i+7, i+5, i+1);   // top
    add_quad(i, i+1, i+5, i+4);     // inside
    add_quad(i+2, i+6, i+7, i+3);   // outside
  }
  add_quad(0, 2, 3, 1);
  add_quad(4*n, 4*n+1, 4*n+3, 4*n+2);
  return mesh;
}

TEST(Adaptive_fitting, Meshes_of_few_vertices_come_back)
{
  Mesh icosahedron;
  CGAL::make_icosahedron(icosahedron, Point(0, 0, 0), 1.);
  for(const Mesh& model : {icosahedron, rough_letter(10)})
    for(const double noise : {0., 0.2})
    {
      const Mesh mesh = (noise > 0) ? with_noise(model, noise) : model;
      ASSERT_LT(num_vertices(mesh), 50);
      EXPECT_EQ(points_of(denoised(mesh)), points_of(mesh));
      EXPECT_EQ(SMD::estimate_noise_level(mesh), 0);
      // but not if the level is known
      EXPECT_NE(points_of(denoised(mesh, params::noise_level(0.2))), points_of(mesh));
    }
}

// however coarse it is: noise leaves no planes
TEST(Adaptive_fitting, Small_meshes_of_planes_come_back)
{
  for(const int n : {12, 20, 40})
  {
    Mesh mesh = rough_letter(n);
    ASSERT_TRUE(CGAL::is_closed(mesh));
    EXPECT_GT(SMD::estimate_noise_level(with_noise(mesh, 0.2)), 0.1);
    for(const bool is_moved : {false, true})
    {
      if(is_moved)
        PMP::transform(rotation_and_shift(), mesh);
      EXPECT_EQ(points_of(denoised(mesh)), points_of(mesh));
      EXPECT_EQ(SMD::estimate_noise_level(mesh), 0);
    }
  }
}

TEST(Adaptive_fitting, Tiny_meshes_stay_finite)
{
  Mesh empty;
  SMD::denoise_anisotropic_fitting(empty);

  Mesh mesh;
  const Vertex a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(1, 0, 0)),
               c = mesh.add_vertex(Point(0, 1, 0.1)), d = mesh.add_vertex(Point(0.1, 0, 1));
  mesh.add_vertex(Point(5, 5, 5)); // isolated
  mesh.add_face(a, c, b);
  for(int i=0; i<2; ++i)
  {
    for(const double level : {0.01, 0.3, 100.})
    {
      const Mesh result = denoised(mesh, params::noise_level(level));
      EXPECT_TRUE(has_finite_points(result));
      EXPECT_EQ(result.point(Vertex(4)), mesh.point(Vertex(4)));
    }
    mesh.add_face(a, b, d); // a tetrahedron the second time
    mesh.add_face(b, c, d);
    mesh.add_face(c, a, d);
  }
}

TEST(Adaptive_fitting, Degenerate_faces_and_duplicate_points_stay_finite)
{
  const Mesh noisy = noisy_mesh(models::cad_part, 2000, 0.3);
  std::mt19937 random(3);
  Mesh mesh = noisy;
  for(const Face f : mesh.faces())
    if(random() % 20 == 0)
    {
      const auto t = vertices_of(mesh, f);
      mesh.point(t[1]) = mesh.point(t[0]);
      if(random() % 2 == 0)
        mesh.point(t[2]) = mesh.point(t[0]);
    }
  EXPECT_TRUE(has_finite_points(denoised(mesh)));

  Mesh flat = noisy; // on a line, and on a point
  for(const Vertex v : flat.vertices())
    flat.point(v) = Point(flat.point(v).x(), 0, 0);
  EXPECT_TRUE(has_finite_points(denoised(flat, params::noise_level(0.3))));
  for(const Vertex v : flat.vertices())
    flat.point(v) = Point(1, 2, 3);
  EXPECT_EQ(points_of(denoised(flat, params::noise_level(0.3))), points_of(flat));
}

TEST(Adaptive_fitting, Noise_alone_stays_finite)
{
  std::mt19937 random(4);
  Mesh mesh = irregular_mesh(models::sphere, 2000);
  const auto coordinate = [&]() { return double(random()) / double(random.max()); };
  for(const Vertex v : mesh.vertices())
    mesh.point(v) = Point(coordinate(), coordinate(), coordinate());
  EXPECT_TRUE(has_finite_points(denoised(mesh)));
}

TEST(Adaptive_fitting, A_vertex_with_very_many_faces_stays_finite)
{
  const std::uint32_t n = 20000;
  Mesh mesh;
  const Vertex hub = mesh.add_vertex(Point(0, 0, 1));
  std::mt19937 random(6);
  for(std::uint32_t i=0; i<n; ++i)
  {
    const double angle = 2 * models::pi * i / n, radius = 1 + 1e-4 * (double(random()) / double(random.max()));
    mesh.add_vertex(Point(radius * std::cos(angle), radius * std::sin(angle), 0));
  }
  for(std::uint32_t i=0; i<n; ++i)
    mesh.add_face(hub, Vertex(1 + i), Vertex(1 + (i+1) % n));
  EXPECT_TRUE(has_finite_points(denoised(mesh, params::noise_level(0.1))));
}

} // namespace
