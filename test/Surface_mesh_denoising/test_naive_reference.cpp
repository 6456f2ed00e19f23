// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A second implementation of each stage, straight from the formulas and without a thought of cost, against which
// one iteration of the package is held.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_denoising/anisotropic_neighborhood.h>
#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/denoise_isotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/filter_vertex_normals.h>

#include <CGAL/boost/graph/Dual.h>
#include <CGAL/boost/graph/iterator.h>

#include <Eigen/QR>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/filtered_graph.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <iterator>
#include <map>
#include <set>

namespace naive {

typedef std::map<Face, Vector>     Face_normals;
typedef std::map<Vertex, Vector>   Vertex_normals;

Vector unit(const Vector& v) { return v / std::sqrt(v.squared_length()); }

Vector area_vector(const Mesh& mesh, const Face f)
{
  const std::array<Vertex, 3> t = vertices_of(mesh, f);
  return 0.5 * cross_product(mesh.point(t[1]) - mesh.point(t[0]), mesh.point(t[2]) - mesh.point(t[0]));
}

Face_normals face_normals(const Mesh& mesh)
{
  Face_normals normals;
  for(const Face f : faces(mesh))
    normals[f] = unit(area_vector(mesh, f));
  return normals;
}

bool share_a_vertex(const Mesh& mesh, const Face f, const Face g)
{
  for(const Vertex v : vertices_of(mesh, f))
    for(const Vertex w : vertices_of(mesh, g))
      if(v == w)
        return true;
  return false;
}

// all pairs of faces
Face_normals filter_face_normals(const Mesh& mesh, Face_normals normals, const int number_of_iterations,
                                 const double threshold, const int exponent)
{
  std::map<Face, std::vector<Face> > neighbors;
  for(const Face f : faces(mesh))
    for(const Face g : faces(mesh))
      if(share_a_vertex(mesh, f, g)) // a face does with itself
        neighbors[f].push_back(g);

  for(int i=0; i<number_of_iterations; ++i)
  {
    Face_normals filtered;
    for(const Face f : faces(mesh))
    {
      Vector sum(0, 0, 0);
      for(const Face g : neighbors[f])
      {
        const double cosine = normals[f] * normals[g];
        if(cosine > threshold)
          sum += std::pow(cosine - threshold, exponent) * normals[g];
      }
      filtered[f] = unit(sum);
    }
    normals = filtered;
  }
  return normals;
}

// the mean of the normals of the faces, weighted with their areas
Vertex_normals vertex_normals(const Mesh& mesh, const Face_normals& normals)
{
  Vertex_normals sums;
  for(const Vertex v : vertices(mesh))
    sums[v] = Vector(0, 0, 0);
  for(const Face f : faces(mesh))
    for(const Vertex v : vertices_of(mesh, f))
      sums[v] += std::sqrt(area_vector(mesh, f).squared_length()) * normals.at(f);
  for(auto& entry : sums)
    entry.second = unit(entry.second);
  return sums;
}

Vertex_normals filter_vertex_normals(const Mesh& mesh, Vertex_normals normals, const int number_of_iterations,
                                     const double sigma_c, const double sigma_s)
{
  for(int i=0; i<number_of_iterations; ++i)
  {
    Vertex_normals filtered;
    for(const Vertex v : vertices(mesh))
    {
      Vector sum(0, 0, 0);
      double sum_of_weights = 0;
      for(const Vertex w : vertices_around_target(mesh.halfedge(v), mesh))
      {
        const double length = distance(mesh.point(v), mesh.point(w));
        const Vector difference = normals[w] - normals[v];
        const double weight = std::exp(-length * length / (2 * sigma_c * sigma_c))
                            * std::exp(-difference.squared_length() / (2 * sigma_s * sigma_s));
        sum += weight * difference;
        sum_of_weights += weight;
      }
      filtered[v] = unit(normals[v] + sum / sum_of_weights);
    }
    normals = filtered;
  }
  return normals;
}

struct Has_two_faces
{
  const Mesh* mesh;
  bool operator()(const Edge e) const { return !mesh->is_border(e); }
};

struct Neighborhood
{
  std::vector<Face> faces;         // all faces that a path leads to, the nearest first
  std::map<Face, double> distance;
};

// the whole dual graph, initialized and searched from end to end for one seed
Neighborhood neighborhood(const Mesh& mesh, const Face seed, const Face_normals& normals, const double omega)
{
  typedef CGAL::Dual<Mesh> Dual;
  const Dual dual(mesh);
  const boost::filtered_graph<Dual, Has_two_faces> graph(dual, Has_two_faces{&mesh});

  const auto centroid_of = [&](const Face f)
  {
    const std::array<Vertex, 3> t = vertices_of(mesh, f);
    return CGAL::centroid(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]));
  };
  const auto weight = [&](const Edge e)
  {
    const Face j = mesh.face(mesh.halfedge(e, 0)), k = mesh.face(mesh.halfedge(e, 1));
    const Point middle = CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
    const double delta = distance(centroid_of(j), middle) + distance(centroid_of(k), middle);
    const double a = (normals.at(j) - normals.at(k)).squared_length() / 6;
    const double b = (normals.at(seed) - normals.at(j)).squared_length() / 2;
    const double c = (normals.at(seed) - normals.at(k)).squared_length() / 2;
    return delta * (1 + omega * (a + b + c));
  };

  Neighborhood result;
  std::map<Face, Face> predecessor;
  std::map<Face, boost::default_color_type> color;
  boost::dijkstra_shortest_paths(graph, seed,
    boost::weight_map(boost::make_function_property_map<Edge>(weight))
      .vertex_index_map(get(boost::vertex_index, dual))
      .distance_map(boost::make_assoc_property_map(result.distance))
      .predecessor_map(boost::make_assoc_property_map(predecessor))
      .color_map(boost::make_assoc_property_map(color)));

  for(const Face f : faces(mesh))
    if(result.distance[f] < std::numeric_limits<double>::max())
      result.faces.push_back(f);
  std::sort(result.faces.begin(), result.faces.end(),
            [&](const Face f, const Face g) { return result.distance[f] < result.distance[g]; });
  return result;
}

// the height over `origin`, along `axis`, of the quadric fitted to the points
double height_of_fit(const Point& origin, const Vector& axis, const std::vector<Point>& data)
{
  const Vector other = (std::abs(axis.x()) < 0.6) ? Vector(1, 0, 0) : Vector(0, 1, 0);
  const Vector s = unit(cross_product(axis, other)), t = cross_product(axis, s);

  double radius = 0;
  for(const Point& p : data)
    radius = (std::max)(radius, distance(p, origin));
  Eigen::MatrixXd design(data.size(), 6);
  Eigen::VectorXd heights(data.size());
  for(std::size_t i=0; i<data.size(); ++i)
  {
    const Vector d = (data[i] - origin) / radius;
    const double root_of_weight = std::exp(-0.5 * std::sqrt(d.squared_length()));
    const double u = d * s, v = d * t;
    design.row(i) << u*u, u*v, v*v, u, v, 1;
    design.row(i) *= root_of_weight;
    heights[i] = root_of_weight * (d * axis);
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(design);
  // the meshes of these tests are such that each fit is well posed
  EXPECT_GT(std::abs(qr.matrixQR()(5, 5)), 1e-3 * qr.maxPivot());
  return radius * qr.solve(heights)[5];
}

Point projection(const Mesh& mesh, const Vertex v, const Vector& normal, const std::set<Vertex>& neighbors)
{
  std::vector<Point> data;
  for(const Vertex w : neighbors)
    data.push_back(mesh.point(w));
  return mesh.point(v) + height_of_fit(mesh.point(v), normal, data) * normal;
}

// the face at the vertex whose normal is closest to that of the vertex. Of those that differ by rounding, the largest
Face seed_of(const Mesh& mesh, const Vertex v, const Face_normals& face_normals, const Vector& vertex_normal)
{
  std::map<double, Face> by_cosine, by_area;
  for(const Face f : faces_around_target(mesh.halfedge(v), mesh))
    if(f != Mesh::null_face())
      by_cosine[face_normals.at(f) * vertex_normal] = f;
  for(const auto& entry : by_cosine)
    if(entry.first > by_cosine.rbegin()->first - 1e-6)
      by_area[area_vector(mesh, entry.second).squared_length()] = entry.second;
  return by_area.rbegin()->second;
}

std::vector<Point> anisotropic_iteration(const Mesh& mesh, const int number_of_normal_iterations,
                                         const double threshold, const int exponent,
                                         const std::size_t neighborhood_size, const double omega)
{
  const Face_normals face_normals = filter_face_normals(mesh, naive::face_normals(mesh), number_of_normal_iterations,
                                                        threshold, exponent);
  const Vertex_normals vertex_normals = naive::vertex_normals(mesh, face_normals);

  std::vector<Point> result;
  for(const Vertex v : vertices(mesh))
  {
    const Neighborhood n = neighborhood(mesh, seed_of(mesh, v, face_normals, vertex_normals.at(v)), face_normals, omega);
    std::set<Vertex> neighbors;
    for(std::size_t i=0; i < (std::min)(neighborhood_size, n.faces.size()); ++i)
      for(const Vertex w : vertices_of(mesh, n.faces[i]))
        neighbors.insert(w);
    result.push_back(projection(mesh, v, vertex_normals.at(v), neighbors));
  }
  return result;
}

std::vector<Point> isotropic_iteration(const Mesh& mesh, const int number_of_normal_iterations, const double sigma_c,
                                       const double sigma_s, const int ring_size)
{
  const Vertex_normals normals = filter_vertex_normals(mesh, vertex_normals(mesh, face_normals(mesh)),
                                                       number_of_normal_iterations, sigma_c, sigma_s);
  std::vector<Point> result;
  for(const Vertex v : vertices(mesh))
  {
    std::set<Vertex> neighbors = { v };
    for(int ring=0; ring<ring_size; ++ring)
      for(const Vertex w : std::set<Vertex>(neighbors))
        for(const Vertex x : vertices_around_target(mesh.halfedge(w), mesh))
          neighbors.insert(x);
    result.push_back(projection(mesh, v, normals.at(v), neighbors));
  }
  return result;
}

} // namespace naive

// in mean edge lengths
const double rounding = 1e-9;

// of the four, one has a border
std::vector<Mesh> noisy_meshes()
{
  return { noisy_mesh(generated_models::cube, 200, 0.15), noisy_mesh(generated_models::cylinder, 200, 0.1),
           noisy_mesh(generated_models::sphere, 200, 0.2), noisy_mesh(generated_models::saddle, 200, 0.2) };
}

TEST(Naive_reference, One_iteration_of_anisotropic_fitting)
{
  for(const Mesh& noisy : noisy_meshes())
  {
    Mesh mesh = noisy;
    const auto result = SMD::denoise_anisotropic_fitting(mesh, params::number_of_iterations(1).relaxation_factor(1.));
    EXPECT_EQ(result.number_of_iterations, 1u);
    EXPECT_GT(largest_distance(mesh, noisy), 0.1 * mean_edge_length(noisy));
    EXPECT_LT(largest_distance(points_of(mesh), naive::anisotropic_iteration(noisy, 5, 0.5, 4, 40, 200)),
              rounding * mean_edge_length(noisy));
  }
}

TEST(Naive_reference, One_iteration_of_anisotropic_fitting_with_other_parameters)
{
  const Mesh noisy = noisy_mesh(generated_models::cylinder, 200, 0.1);
  Mesh mesh = noisy;
  SMD::denoise_anisotropic_fitting(mesh, params::number_of_iterations(1).relaxation_factor(1.)
                                                .number_of_normal_iterations(9).angle_threshold(0.3)
                                                .normal_exponent(2).neighborhood_size(25).normal_weight(10.));
  EXPECT_LT(largest_distance(points_of(mesh), naive::anisotropic_iteration(noisy, 9, 0.3, 2, 25, 10)),
            rounding * mean_edge_length(noisy));
}

TEST(Naive_reference, Relaxation_factor_is_the_share_of_the_displacement)
{
  const Mesh noisy = noisy_mesh(generated_models::cube, 200, 0.15);
  const std::vector<Point> projections = naive::anisotropic_iteration(noisy, 5, 0.5, 4, 40, 200);
  for(const double share : { 0.5, 0.1 })
  {
    Mesh mesh = noisy;
    SMD::denoise_anisotropic_fitting(mesh, params::number_of_iterations(1).relaxation_factor(share));
    std::vector<Point> expected;
    for(const Vertex v : vertices(noisy))
      expected.push_back(noisy.point(v) + share * (projections[v] - noisy.point(v)));
    EXPECT_LT(largest_distance(points_of(mesh), expected), rounding * mean_edge_length(noisy));
  }
}

TEST(Naive_reference, One_iteration_of_isotropic_fitting)
{
  for(const Mesh& noisy : noisy_meshes())
  {
    const double length = mean_edge_length(noisy);
    Mesh mesh = noisy;
    SMD::denoise_isotropic_fitting(mesh, params::number_of_iterations(1).relaxation_factor(1.));
    EXPECT_GT(largest_distance(mesh, noisy), 0.1 * length);
    EXPECT_LT(largest_distance(points_of(mesh), naive::isotropic_iteration(noisy, 3, length, 0.6, 2)),
              rounding * length);
  }
}

TEST(Naive_reference, One_iteration_of_isotropic_fitting_with_other_parameters)
{
  const Mesh noisy = noisy_mesh(generated_models::sphere, 200, 0.2);
  const double length = mean_edge_length(noisy);
  Mesh mesh = noisy;
  SMD::denoise_isotropic_fitting(mesh, params::number_of_iterations(1).relaxation_factor(1.)
                                              .number_of_normal_iterations(7).spatial_sigma(0.8).normal_sigma(0.3)
                                              .neighborhood_ring_size(3));
  EXPECT_LT(largest_distance(points_of(mesh), naive::isotropic_iteration(noisy, 7, 0.8 * length, 0.3, 3)),
            rounding * length);
}

TEST(Naive_reference, Bilateral_filter_of_vertex_normals)
{
  for(Mesh& mesh : std::vector<Mesh>(noisy_meshes()))
  {
    auto normals = mesh.add_property_map<Vertex, Vector>("v:normal").first;
    const double length = mean_edge_length(mesh);
    const naive::Vertex_normals raw = naive::vertex_normals(mesh, naive::face_normals(mesh));

    const auto expect_equal = [&](const naive::Vertex_normals& expected)
    {
      for(const Vertex v : vertices(mesh))
        ASSERT_LT((normals[v] - expected.at(v)).squared_length(), 1e-24);
    };
    SMD::filter_vertex_normals(mesh, normals, params::number_of_iterations(0));
    expect_equal(raw);
    SMD::filter_vertex_normals(mesh, normals);
    expect_equal(naive::filter_vertex_normals(mesh, raw, 3, length, 0.6));
    SMD::filter_vertex_normals(mesh, normals,
                               params::number_of_iterations(10).spatial_sigma(1.5).normal_sigma(0.25));
    expect_equal(naive::filter_vertex_normals(mesh, raw, 10, 1.5 * length, 0.25));
  }
}

TEST(Naive_reference, Filtered_face_normals)
{
  for(Mesh& mesh : std::vector<Mesh>(noisy_meshes()))
  {
    // without a fit, what comes back are the filtered normals of the mesh as it is
    auto normals = mesh.add_property_map<Face, Vector>("f:normal").first;
    for(const int exponent : { 2, 4 })
    {
      SMD::denoise_anisotropic_fitting(mesh, params::number_of_iterations(0).number_of_normal_iterations(6)
                                                    .angle_threshold(0.4).normal_exponent(exponent)
                                                    .face_normal_map(normals));
      const naive::Face_normals expected
        = naive::filter_face_normals(mesh, naive::face_normals(mesh), 6, 0.4, exponent);
      for(const Face f : faces(mesh))
        ASSERT_LT((normals[f] - expected.at(f)).squared_length(), 1e-24);
    }
  }
}

// the faces in the same order, and their distances
template <typename NamedParameters>
void expect_same_neighborhood(Mesh& mesh, const Face seed, const std::size_t size,
                              const naive::Neighborhood& expected, const NamedParameters& np)
{
  const auto distances = mesh.add_property_map<Face, double>("f:distance").first;
  std::vector<Face> found;
  SMD::anisotropic_neighborhood(seed, mesh, std::back_inserter(found),
                                np.neighborhood_size(size).distance_map(distances));

  ASSERT_EQ(found.size(), (std::min)(size, expected.faces.size()));
  EXPECT_EQ(found, std::vector<Face>(expected.faces.begin(), expected.faces.begin() + found.size()));
  for(const Face f : found)
    ASSERT_NEAR(distances[f], expected.distance.at(f), 1e-12 * expected.distance.at(found.back()));
}

TEST(Naive_reference, Neighborhoods)
{
  for(Mesh& mesh : std::vector<Mesh>(noisy_meshes()))
  {
    const naive::Face_normals raw = naive::face_normals(mesh);
    const naive::Face_normals filtered = naive::filter_face_normals(mesh, raw, 5, 0.5, 4);
    for(std::size_t i=0; i<num_faces(mesh); i += 37)
    {
      const Face seed(static_cast<Mesh::size_type>(i));
      expect_same_neighborhood(mesh, seed, 40, naive::neighborhood(mesh, seed, raw, 200), params::default_values());
      expect_same_neighborhood(mesh, seed, 60, naive::neighborhood(mesh, seed, filtered, 15),
                               params::normal_weight(15.)
                                      .face_normal_map(boost::make_assoc_property_map(filtered)));
    }
    // the whole mesh, and no more
    expect_same_neighborhood(mesh, Face(0), num_faces(mesh) + 1, naive::neighborhood(mesh, Face(0), raw, 200),
                             params::default_values());
  }
}
