// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes and measures that the test programs share.

#ifndef SURFACE_MESH_DENOISING_TEST_MESHES_H
#define SURFACE_MESH_DENOISING_TEST_MESHES_H

#include <CGAL/Surface_mesh_denoising/add_noise.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <generated_models.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace SMD = CGAL::Surface_mesh_denoising;
namespace params = CGAL::parameters;

typedef CGAL::Simple_cartesian<double>  Kernel;
typedef Kernel::Point_3                 Point;
typedef Kernel::Vector_3                Vector;
typedef CGAL::Surface_mesh<Point>       Mesh;
typedef Mesh::Vertex_index              Vertex;
typedef Mesh::Face_index                Face;
typedef Mesh::Edge_index                Edge;
typedef Mesh::Halfedge_index            Halfedge;

typedef generated_models::Model (*Model_generator)(const generated_models::Options&);

inline generated_models::Model irregular_model(const Model_generator generate, const std::size_t number_of_vertices)
{
  generated_models::Options options;
  options.number_of_vertices = number_of_vertices;
  options.triangles = generated_models::Triangles::IRREGULAR;
  options.seed = 1;
  return generate(options);
}

inline Mesh irregular_mesh(const Model_generator generate, const std::size_t number_of_vertices)
{
  return generated_models::to_mesh<Mesh>(irregular_model(generate, number_of_vertices));
}

inline Mesh regular_mesh(const Model_generator generate, const std::size_t number_of_vertices)
{
  generated_models::Options options;
  options.number_of_vertices = number_of_vertices;
  return generated_models::to_mesh<Mesh>(generate(options));
}

// for messages
inline std::string name_of(const Model_generator generate)
{
  for(const generated_models::Generator& g : generated_models::all())
    if(g.generate == generate)
      return g.name;
  return "";
}

// `level` in mean edge lengths
inline Mesh with_noise(Mesh mesh, const double level, const unsigned int seed = 1)
{
  SMD::add_noise(mesh, params::noise_level(level).random_seed(seed));
  return mesh;
}

inline Mesh noisy_mesh(const Model_generator generate, const std::size_t number_of_vertices, const double level)
{
  return with_noise(irregular_mesh(generate, number_of_vertices), level);
}

inline Mesh with_noise_on_one_side(Mesh mesh, const double level)
{
  SMD::add_noise(generated_models::vertices_on_one_side(mesh), mesh, params::noise_level(level).random_seed(1));
  return mesh;
}

// Every parameter of the fitting functions, with its default value. All calls that pass them have the same type.
struct Anisotropic_parameters
{
  int number_of_iterations = 30;
  double convergence_threshold = 0.05;
  int neighborhood_size = 40;
  double normal_weight = 200;
  double angle_threshold = 0.5;
  int normal_exponent = 4;
  int number_of_normal_iterations = 5;
  double relaxation_factor = 0.5;

  auto named() const
  {
    return params::number_of_iterations(number_of_iterations).convergence_threshold(convergence_threshold)
                  .neighborhood_size(neighborhood_size).normal_weight(normal_weight)
                  .angle_threshold(angle_threshold).normal_exponent(normal_exponent)
                  .number_of_normal_iterations(number_of_normal_iterations).relaxation_factor(relaxation_factor);
  }
};

struct Isotropic_parameters
{
  int number_of_iterations = 30;
  double convergence_threshold = 0.05;
  int neighborhood_ring_size = 2;
  int number_of_normal_iterations = 3;
  double spatial_sigma = 1;
  double normal_sigma = 0.6;
  double relaxation_factor = 0.5;

  auto named() const
  {
    return params::number_of_iterations(number_of_iterations).convergence_threshold(convergence_threshold)
                  .neighborhood_ring_size(neighborhood_ring_size)
                  .number_of_normal_iterations(number_of_normal_iterations).spatial_sigma(spatial_sigma)
                  .normal_sigma(normal_sigma).relaxation_factor(relaxation_factor);
  }
};

// the points in the order of the vertices, for comparison to the last bit
template <typename TriangleMesh>
auto points_of(const TriangleMesh& mesh)
{
  typedef typename CGAL::GetVertexPointMap<TriangleMesh>::const_type Point_map;
  std::vector<typename boost::property_traits<Point_map>::value_type> points;
  for(const auto v : vertices(mesh))
    points.push_back(get(get(CGAL::vertex_point, mesh), v));
  return points;
}

template <typename P, typename Q>
double distance(const P& p, const Q& q)
{
  return std::sqrt(std::pow(double(p[0]) - double(q[0]), 2) + std::pow(double(p[1]) - double(q[1]), 2)
                   + std::pow(double(p[2]) - double(q[2]), 2));
}

template <typename P, typename Q>
double largest_distance(const std::vector<P>& a, const std::vector<Q>& b)
{
  if(a.size() != b.size())
    return std::numeric_limits<double>::infinity();
  double largest = 0;
  for(std::size_t i=0; i<a.size(); ++i)
  {
    const double d = distance(a[i], b[i]);
    if(!(d <= largest)) // keeps what is not a number
      largest = d;
  }
  return largest;
}

inline double largest_distance(const Mesh& a, const Mesh& b) { return largest_distance(points_of(a), points_of(b)); }

inline double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(const Edge e : edges(mesh))
    sum += distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
  return sum / double(num_edges(mesh));
}

template <typename TriangleMesh>
bool has_finite_points(const TriangleMesh& mesh)
{
  for(const auto& p : points_of(mesh))
    if(!(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])))
      return false;
  return true;
}

inline std::array<Vertex, 3> vertices_of(const Mesh& mesh, const Face f)
{
  const Halfedge h = mesh.halfedge(f);
  return {{ mesh.source(h), mesh.target(h), mesh.target(mesh.next(h)) }};
}

// the unit normal of a face, null if it is degenerate
inline Vector normal_of(const Mesh& mesh, const Face f)
{
  const std::array<Vertex, 3> t = vertices_of(mesh, f);
  const Vector n = cross_product(mesh.point(t[1]) - mesh.point(t[0]), mesh.point(t[2]) - mesh.point(t[0]));
  const double length = std::sqrt(n.squared_length());
  return (length > 0) ? n / length : Vector(0, 0, 0);
}

// in degrees
inline double angle_between(const Vector& a, const Vector& b)
{
  return std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b) * 180 / generated_models::pi;
}

#endif // SURFACE_MESH_DENOISING_TEST_MESHES_H
