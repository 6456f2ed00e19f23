// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Each face normal filter is held against its formula, written down a second time without a thought of cost, and
// against what is known of it.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_denoising/Adaptive_gaussian_normal_filter.h>
#include <CGAL/Surface_mesh_denoising/Alpha_trimmed_normal_filter.h>
#include <CGAL/Surface_mesh_denoising/anisotropic_neighborhood.h>
#include <CGAL/Surface_mesh_denoising/Bilateral_normal_filter.h>
#include <CGAL/Surface_mesh_denoising/denoise_with_normals.h>
#include <CGAL/Surface_mesh_denoising/Guided_normal_filter.h>
#include <CGAL/Surface_mesh_denoising/internal/Ball_search.h>
#include <CGAL/Surface_mesh_denoising/Mean_normal_filter.h>
#include <CGAL/Surface_mesh_denoising/measure_error.h>
#include <CGAL/Surface_mesh_denoising/Median_normal_filter.h>

#include <boost/property_map/vector_property_map.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <type_traits>

using generated_models::cube;
using generated_models::saddle;
using generated_models::sphere;

typedef std::vector<Vector> Normals; // of the faces, in their order

// any filter, behind one type
struct Filter
{
  typedef std::function<void(const SMD::Indexed_triangle_mesh&, Normals&, std::size_t)> Function;
  Function sequential, parallel;

  template <typename FaceNormalFilter>
  Filter(const FaceNormalFilter& filter)
    : sequential([filter](const SMD::Indexed_triangle_mesh& mesh, Normals& normals, const std::size_t n)
                 { filter(mesh, normals, n, CGAL::Sequential_tag()); }),
      parallel([filter](const SMD::Indexed_triangle_mesh& mesh, Normals& normals, const std::size_t n)
               { filter(mesh, normals, n, CGAL::Parallel_if_available_tag()); })
  {}

  template <typename ConcurrencyTag>
  void operator()(const SMD::Indexed_triangle_mesh& mesh, Normals& normals, const std::size_t n, ConcurrencyTag) const
  {
    (std::is_same<ConcurrencyTag, CGAL::Sequential_tag>::value ? sequential : parallel)(mesh, normals, n);
  }
};

struct Named_filter
{
  std::string name;
  Filter filter;
};

std::vector<Named_filter> all_filters()
{
  return { { "thresholded", SMD::Thresholded_normal_filter() },
           { "bilateral", SMD::Bilateral_normal_filter() },
           { "guided", SMD::Guided_normal_filter() },
           { "mean", SMD::Mean_normal_filter() },
           { "median", SMD::Median_normal_filter() },
           { "alpha-trimmed", SMD::Alpha_trimmed_normal_filter() },
           { "adaptive Gaussian", SMD::Adaptive_gaussian_normal_filter() } };
}

template <typename ConcurrencyTag = CGAL::Sequential_tag>
Normals filtered(Mesh mesh, const Filter& filter, const std::size_t number_of_iterations)
{
  auto normals = mesh.add_property_map<Face, Vector>("f:filtered").first;
  SMD::denoise_with_normals<ConcurrencyTag>(
    mesh, params::face_normal_filter(filter).number_of_normal_iterations(number_of_iterations)
                 .number_of_iterations(0).face_normal_map(normals));
  return Normals(normals.begin(), normals.end());
}

Normals normals_of(const Mesh& mesh)
{
  Normals normals;
  for(const Face f : faces(mesh))
    normals.push_back(normal_of(mesh, f));
  return normals;
}

double largest_difference(const Normals& a, const Normals& b) { return largest_distance(a, b); }

// ---- the formulas

struct Naive_mesh
{
  Normals normals;
  std::vector<double> areas;
  std::vector<Point> centroids;
  std::vector<std::array<Vertex, 3> > triangles;
  double mean_centroid_distance;

  explicit Naive_mesh(const Mesh& mesh) : normals(normals_of(mesh))
  {
    for(const Face f : faces(mesh))
    {
      const std::array<Vertex, 3> t = vertices_of(mesh, f);
      const Point p = mesh.point(t[0]), q = mesh.point(t[1]), r = mesh.point(t[2]);
      triangles.push_back(t);
      areas.push_back(0.5 * std::sqrt(cross_product(q - p, r - p).squared_length()));
      centroids.push_back(centroid(p, q, r));
    }
    double sum = 0;
    int number = 0;
    for(std::size_t f=0; f<normals.size(); ++f)
      for(std::size_t g=0; g<f; ++g)
        if(number_of_common_vertices(f, g) == 2)
        {
          sum += distance(centroids[f], centroids[g]);
          ++number;
        }
    mean_centroid_distance = sum / number;
  }

  int number_of_common_vertices(const std::size_t f, const std::size_t g) const
  {
    int number = 0;
    for(const Vertex v : triangles[f])
      for(const Vertex w : triangles[g])
        number += (v == w);
    return number;
  }

  // the faces that share a vertex with face `f`, but for `f`
  std::vector<std::size_t> around(const std::size_t f) const
  {
    std::vector<std::size_t> result;
    for(std::size_t g=0; g<normals.size(); ++g)
      if(g != f && number_of_common_vertices(f, g) > 0)
        result.push_back(g);
    return result;
  }
};

Vector unit(const Vector& v) { return v / std::sqrt(v.squared_length()); }

double gaussian(const double x, const double sigma) { return std::exp(-x*x / (2 * sigma*sigma)); }

Normals naive_bilateral(const Naive_mesh& mesh, const double normal_sigma, const double spatial_sigma)
{
  Normals result;
  for(std::size_t f=0; f<mesh.normals.size(); ++f)
  {
    Vector sum(0, 0, 0);
    for(const std::size_t g : mesh.around(f))
      sum += mesh.areas[g]
           * gaussian(distance(mesh.centroids[f], mesh.centroids[g]), spatial_sigma * mesh.mean_centroid_distance)
           * gaussian(distance(mesh.normals[f], mesh.normals[g]), normal_sigma) * mesh.normals[g];
    result.push_back(unit(sum));
  }
  return result;
}

Normals naive_alpha_trimmed(const Naive_mesh& mesh, const double alpha)
{
  Normals result;
  for(std::size_t f=0; f<mesh.normals.size(); ++f)
  {
    std::vector<std::size_t> around = mesh.around(f);
    std::sort(around.begin(), around.end(), [&](const std::size_t g, const std::size_t h)
    { return mesh.normals[f] * mesh.normals[g] > mesh.normals[f] * mesh.normals[h]; });
    const std::size_t trimmed = std::size_t(std::floor(alpha * double(around.size() - 1)));
    Vector sum(0, 0, 0);
    for(std::size_t i=trimmed; i<around.size()-trimmed; ++i)
      sum += mesh.areas[around[i]] * mesh.normals[around[i]];
    result.push_back(unit(sum));
  }
  return result;
}

Normals naive_guided(const Naive_mesh& mesh, const double normal_sigma, const double spatial_sigma, const double radius)
{
  const std::size_t n = mesh.normals.size();
  std::vector<std::vector<std::size_t> > patches;
  Normals mean_normals;
  std::vector<double> inconsistencies;
  for(std::size_t f=0; f<n; ++f)
  {
    patches.push_back(mesh.around(f));
    patches.back().push_back(f);
    Vector sum(0, 0, 0);
    double largest = 0, most_salient = 0, saliencies = 1e-9;
    for(const std::size_t g : patches[f])
    {
      sum += mesh.areas[g] * mesh.normals[g];
      for(const std::size_t h : patches[f])
      {
        const double difference = distance(mesh.normals[g], mesh.normals[h]);
        largest = (std::max)(largest, difference);
        if(g < h && mesh.number_of_common_vertices(g, h) == 2)
        {
          most_salient = (std::max)(most_salient, difference);
          saliencies += difference;
        }
      }
    }
    mean_normals.push_back(unit(sum));
    inconsistencies.push_back(largest * most_salient / saliencies);
  }

  Normals guidance, result;
  for(std::size_t f=0; f<n; ++f)
    guidance.push_back(mean_normals[*std::min_element(
      patches[f].begin(), patches[f].end(),
      [&](const std::size_t g, const std::size_t h) { return inconsistencies[g] < inconsistencies[h]; })]);
  for(std::size_t f=0; f<n; ++f)
  {
    Vector sum(0, 0, 0);
    for(std::size_t g=0; g<n; ++g)
    {
      const double d = distance(mesh.centroids[f], mesh.centroids[g]);
      if(d <= radius * mesh.mean_centroid_distance)
        sum += mesh.areas[g] * gaussian(d, spatial_sigma * mesh.mean_centroid_distance)
             * gaussian(distance(guidance[f], guidance[g]), normal_sigma) * mesh.normals[g];
    }
    result.push_back(unit(sum));
  }
  return result;
}

Normals naive_adaptive(const Mesh& mesh, const double c, const double omega, const std::size_t neighborhood_size)
{
  const Naive_mesh naive(mesh);
  const double unit_length = mean_edge_length(mesh);
  Normals result;
  for(const Face f : faces(mesh))
  {
    std::vector<Face> neighborhood;
    boost::vector_property_map<double, boost::property_map<Mesh, boost::face_index_t>::const_type>
      distances(get(boost::face_index, mesh));
    SMD::anisotropic_neighborhood(f, mesh, std::back_inserter(neighborhood),
                                  params::neighborhood_size(neighborhood_size).normal_weight(omega)
                                         .distance_map(distances));
    double least = std::numeric_limits<double>::infinity();
    Vector best(0, 0, 0);
    for(const double sigma : { 0.5, std::sqrt(0.5), 1., std::sqrt(2.), 2., std::sqrt(8.), 4. })
    {
      Vector sum(0, 0, 0);
      double weights = 0, deviations = 0;
      const auto weight = [&](const Face g)
      { return naive.areas[g] * gaussian(get(distances, g) / unit_length, sigma); };
      for(const Face g : neighborhood)
        sum += weight(g) * naive.normals[g];
      for(const Face g : neighborhood)
      {
        weights += weight(g);
        deviations += weight(g) * std::pow(distance(naive.normals[g], unit(sum)), 2);
      }
      const double error = c / (sigma * sigma) + deviations / weights;
      if(error < least)
      {
        least = error;
        best = unit(sum);
      }
    }
    result.push_back(best);
  }
  return result;
}

TEST(Normal_filters, Formulas)
{
  for(const Model_generator generate : { sphere, saddle })
  {
    const Mesh mesh = noisy_mesh(generate, 120, 0.2);
    const Naive_mesh naive(mesh);
    EXPECT_LT(largest_difference(filtered(mesh, SMD::Bilateral_normal_filter(0.4, 1.5), 1),
                                 naive_bilateral(naive, 0.4, 1.5)), 1e-9);
    EXPECT_LT(largest_difference(filtered(mesh, SMD::Guided_normal_filter(0.3, 1.5, 1.8), 1),
                                 naive_guided(naive, 0.3, 1.5, 1.8)), 1e-9);
    EXPECT_LT(largest_difference(filtered(mesh, SMD::Mean_normal_filter(), 1), naive_alpha_trimmed(naive, 0)), 1e-9);
    EXPECT_LT(largest_difference(filtered(mesh, SMD::Median_normal_filter(), 1),
                                 naive_alpha_trimmed(naive, 0.5)), 1e-9);
    EXPECT_LT(largest_difference(filtered(mesh, SMD::Alpha_trimmed_normal_filter(0.3), 1),
                                 naive_alpha_trimmed(naive, 0.3)), 1e-9);
    EXPECT_LT(largest_difference(filtered(mesh, SMD::Adaptive_gaussian_normal_filter(0.1, 7, 20), 1),
                                 naive_adaptive(mesh, 0.1, 7, 20)), 1e-9);
  }
}

// ---- what is known of them

TEST(Normal_filters, Iterations_follow_each_other)
{
  const Mesh mesh = noisy_mesh(sphere, 120, 0.2);
  for(const Named_filter& f : all_filters())
  {
    // no filter stands still, and none takes the geometry for filtered
    EXPECT_GT(largest_difference(filtered(mesh, f.filter, 1), normals_of(mesh)), 0.01) << f.name;
    EXPECT_GT(largest_difference(filtered(mesh, f.filter, 2), filtered(mesh, f.filter, 1)), 0.01) << f.name;
    EXPECT_LT(largest_difference(filtered(mesh, f.filter, 0), normals_of(mesh)), 1e-12) << f.name;
  }
}

TEST(Normal_filters, Normals_have_unit_length)
{
  for(const Model_generator generate : { cube, saddle })
  {
    const Mesh mesh = noisy_mesh(generate, 300, 0.4);
    for(const Named_filter& f : all_filters())
      for(const Vector& n : filtered(mesh, f.filter, 3))
        ASSERT_NEAR(n.squared_length(), 1, 1e-12) << f.name;
  }
}

TEST(Normal_filters, Flat_parts_keep_their_normals)
{
  // the sides of a pyramid lie in planes: normals may change only around its edges
  const Mesh mesh = irregular_mesh(generated_models::pyramid_4, 1200);
  const Naive_mesh naive(mesh);
  for(const Named_filter& f : all_filters())
  {
    const Normals normals = filtered(mesh, f.filter, 1);
    int number_of_inner_faces = 0;
    for(std::size_t i=0; i<normals.size(); ++i)
    {
      bool is_inner = true;
      for(std::size_t j=0; j<normals.size(); ++j)
        if(distance(naive.centroids[i], naive.centroids[j]) < 6 * naive.mean_centroid_distance)
          is_inner = is_inner && distance(naive.normals[i], naive.normals[j]) < 1e-9;
      if(is_inner)
      {
        ++number_of_inner_faces;
        ASSERT_LT(distance(normals[i], naive.normals[i]), 1e-12) << f.name;
      }
    }
    EXPECT_GT(number_of_inner_faces, 50);
  }
}

TEST(Normal_filters, The_median_keeps_the_normals_of_a_cube)
{
  const Mesh mesh = irregular_mesh(cube, 600);
  const Naive_mesh naive(mesh);
  const Normals median = filtered(mesh, SMD::Median_normal_filter(), 1);
  const Normals mean = filtered(mesh, SMD::Mean_normal_filter(), 1);
  double largest_change_of_mean = 0;
  for(std::size_t f=0; f<median.size(); ++f)
  {
    std::size_t number_on_this_side = 0;
    const std::vector<std::size_t> around = naive.around(f);
    for(const std::size_t g : around)
      number_on_this_side += (naive.normals[f] * naive.normals[g] > 0.5);
    if(2 * number_on_this_side > around.size() + 1)
    {
      EXPECT_LT(distance(median[f], naive.normals[f]), 1e-12);
    }
    largest_change_of_mean = (std::max)(largest_change_of_mean, distance(mean[f], naive.normals[f]));
  }
  EXPECT_GT(largest_change_of_mean, 0.3);
}

TEST(Normal_filters, The_thresholded_filter_keeps_a_cube)
{
  const Mesh mesh = irregular_mesh(cube, 600);
  Mesh result = mesh;
  SMD::denoise_with_normals(result);
  EXPECT_LT(largest_distance(result, mesh), 1e-13);
}

TEST(Normal_filters, Noise_falls)
{
  for(const Model_generator generate : { sphere, cube, saddle })
  {
    const Mesh truth = irregular_mesh(generate, 1500), noisy = with_noise(truth, 0.2);
    for(const Named_filter& f : all_filters())
    {
      Mesh result = noisy;
      SMD::denoise_with_normals(result, params::face_normal_filter(f.filter).number_of_normal_iterations(4));
      EXPECT_LT(SMD::angular_error(result, truth).mean, 0.6 * SMD::angular_error(noisy, truth).mean) << f.name;
      EXPECT_LT(SMD::vertex_distance_error(result, truth).root_mean_square,
                0.8 * SMD::vertex_distance_error(noisy, truth).root_mean_square) << f.name;
    }
  }
}

TEST(Normal_filters, Rounds_of_guided_filtering_sharpen_the_edges_of_a_cube)
{
  const Mesh truth = irregular_mesh(cube, 1500);
  Mesh once = with_noise(truth, 0.2), rounds = once;
  SMD::denoise_with_normals(once, params::face_normal_filter(Filter(SMD::Guided_normal_filter()))
                                         .number_of_normal_iterations(1).number_of_rounds(1));
  SMD::denoise_with_normals(rounds, params::face_normal_filter(Filter(SMD::Guided_normal_filter()))
                                           .number_of_normal_iterations(1).number_of_rounds(20));
  EXPECT_LT(SMD::angular_error(rounds, truth).mean, 0.5 * SMD::angular_error(once, truth).mean);
}

TEST(Normal_filters, Parallel_runs_give_the_same_bits)
{
  const Mesh mesh = noisy_mesh(cube, 2000, 0.3);
  for(const Named_filter& f : all_filters())
    EXPECT_EQ(filtered<CGAL::Parallel_if_available_tag>(mesh, f.filter, 2), filtered(mesh, f.filter, 2)) << f.name;
}

TEST(Normal_filters, Filters_do_not_look_across_constrained_edges)
{
  // the noise of one half must not reach the other one
  const Mesh noisy = noisy_mesh(saddle, 400, 0.2);
  Mesh other = noisy;
  std::vector<bool> is_left(num_faces(noisy));
  for(const Face f : faces(noisy))
    is_left[f] = noisy.point(vertices_of(noisy, f)[0]).x() < 0;
  std::vector<bool> is_crease(num_edges(noisy), false);
  for(const Edge e : edges(noisy))
    if(!noisy.is_border(e))
      is_crease[e] = is_left[noisy.face(noisy.halfedge(e, 0))] != is_left[noisy.face(noisy.halfedge(e, 1))];
  for(const Vertex v : vertices(other))
  {
    bool has_left_face = false;
    for(const Face f : CGAL::faces_around_target(other.halfedge(v), other))
      has_left_face = has_left_face || (f != Mesh::null_face() && is_left[f]);
    if(!has_left_face)
      other.point(v) = other.point(v) + Vector(0, 0, 0.001 * (int(v) % 5));
  }

  for(const Named_filter& f : all_filters())
  {
    const auto filtered_apart = [&](Mesh mesh)
    {
      auto normals = mesh.add_property_map<Face, Vector>("f:filtered").first;
      auto creases = mesh.add_property_map<Edge, bool>("e:crease").first;
      for(const Edge e : edges(mesh))
        creases[e] = is_crease[e];
      SMD::denoise_with_normals(mesh, params::face_normal_filter(f.filter).number_of_normal_iterations(1)
                                             .number_of_iterations(0).face_normal_map(normals)
                                             .edge_is_constrained_map(creases));
      return Normals(normals.begin(), normals.end());
    };
    const Normals a = filtered_apart(noisy), b = filtered_apart(other);
    double on_the_left = 0, on_the_right = 0; // largest differences
    for(std::size_t i=0; i<a.size(); ++i)
    {
      double& largest = is_left[i] ? on_the_left : on_the_right;
      largest = (std::max)(largest, distance(a[i], b[i]));
    }
    // but for the mean lengths, which are those of the whole mesh
    EXPECT_LT(on_the_left, 1e-3) << f.name;
    EXPECT_GT(on_the_right, 1e-2) << f.name;
  }
}

// ---- bad input

template <typename Construct>
void expect_refused(const Construct& construct, const std::string& name)
{
  try
  {
    construct();
    ADD_FAILURE() << "nothing thrown, expected: " << name;
  }
  catch(const std::invalid_argument& e)
  {
    EXPECT_NE(std::string(e.what()).find("the parameter " + name + " is "), std::string::npos) << e.what();
  }
}

TEST(Normal_filters, Parameters_out_of_range)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for(const double x : { 0., -1., infinity, std::nan("") })
  {
    expect_refused([x]() { SMD::Bilateral_normal_filter filter(x); }, "normal_sigma");
    expect_refused([x]() { SMD::Bilateral_normal_filter filter(1, x); }, "spatial_sigma");
    expect_refused([x]() { SMD::Guided_normal_filter filter(x); }, "normal_sigma");
    expect_refused([x]() { SMD::Guided_normal_filter filter(1, x); }, "spatial_sigma");
    expect_refused([x]() { SMD::Guided_normal_filter filter(1, 1, x); }, "radius");
    expect_refused([x]() { SMD::Adaptive_gaussian_normal_filter filter(x); }, "scale_weight");
  }
  for(const double x : { -1e-9, 0.5000001, std::nan("") })
    expect_refused([x]() { SMD::Alpha_trimmed_normal_filter filter(x); }, "trimmed_share");
  for(const double x : { -1e-9, infinity, std::nan("") })
    expect_refused([x]() { SMD::Adaptive_gaussian_normal_filter filter(1, x); }, "normal_weight");
  expect_refused([]() { SMD::Adaptive_gaussian_normal_filter filter(1, 1, 0); }, "neighborhood_size");
}

TEST(Normal_filters, Extreme_widths_give_unit_normals)
{
  const Mesh mesh = noisy_mesh(cube, 200, 0.3);
  for(const double sigma : { 1e-200, 1e200 })
    for(const Filter& filter : { Filter(SMD::Bilateral_normal_filter(sigma, sigma)),
                                 Filter(SMD::Guided_normal_filter(sigma, sigma, 1 / sigma)),
                                 Filter(SMD::Adaptive_gaussian_normal_filter(sigma, sigma)) })
      for(const Vector& n : filtered(mesh, filter, 2))
        ASSERT_NEAR(n.squared_length(), 1, 1e-12);
}

TEST(Normal_filters, Degenerate_faces)
{
  Mesh mesh = noisy_mesh(sphere, 200, 0.1);
  const Edge e = *edges(mesh).begin();
  mesh.point(mesh.vertex(e, 0)) = mesh.point(mesh.vertex(e, 1));
  Mesh point;
  const Vertex a = point.add_vertex(Point(1, 2, 3)), b = point.add_vertex(Point(1, 2, 3)),
               c = point.add_vertex(Point(1, 2, 3));
  point.add_face(a, b, c);
  for(const Named_filter& f : all_filters())
  {
    for(const Vector& n : filtered(mesh, f.filter, 3))
      ASSERT_NEAR(n.squared_length(), 1, 1e-12) << f.name;
    EXPECT_EQ(filtered(point, f.filter, 3).front(), Vector(0, 0, 0)) << f.name;
    EXPECT_TRUE(filtered(Mesh(), f.filter, 3).empty()) << f.name;
  }
}

// a ball that holds the whole mesh, and a vertex with thousands of faces
TEST(Normal_filters, Searches_are_bounded)
{
  const std::size_t n = 4000;
  std::vector<Point> points(1, Point(0, 0, 1));
  std::vector<std::array<std::uint32_t, 3> > triangles, neighbors;
  for(std::uint32_t i=0; i<n; ++i)
  {
    const double angle = 2 * generated_models::pi * i / double(n);
    points.push_back(Point(std::cos(angle), std::sin(angle), 0));
    triangles.push_back({{ 0, i + 1, std::uint32_t((i + 1) % n + 1) }});
    neighbors.push_back({{ std::uint32_t((i + n - 1) % n), SMD::Indexed_triangle_mesh::null_index(),
                           std::uint32_t((i + 1) % n) }});
  }
  const SMD::Indexed_triangle_mesh mesh(points, triangles, neighbors);
  SMD::internal::Ball_search search(mesh);
  const std::size_t found
    = search.faces_around_face(0, [&](const std::size_t f) { return mesh.centroid(f); }, 100).size();
  EXPECT_GE(found, SMD::internal::Ball_search::max_number_of_faces);
  EXPECT_LT(found, 2 * SMD::internal::Ball_search::max_number_of_faces);
  // its own faces, all of them
  EXPECT_EQ(search.faces_around_vertex(0, 100).size(), n);
}
