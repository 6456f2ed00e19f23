// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_TANGENTIAL_NOISE_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_TANGENTIAL_NOISE_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Adaptive_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Noise_map.h>
#include <CGAL/Surface_mesh_denoising/internal/Normal_evolution.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/mixing.h>
#include <CGAL/Surface_mesh_denoising/internal/noise_level.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>
#include <CGAL/Surface_mesh_denoising/internal/surface_fit.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

struct Tangential_noise_ratio
{
  double value = 0;
  double upper_bound = 0;    // it may be as large as this: a few turned faces, out of thousands, tell nothing
  double expected_share = 0; // of the faces: where it is small, the ratio hardly tells
};

// How many faces the observed points turn over, as seen from outside the smoother surface `mesh`, beside how many they
// would if the noise were as strong along the surface as across it. About one half to one if it is, while noise
// along the normals turns none where the normals are known.
template <typename ConcurrencyTag>
Tangential_noise_ratio tangential_noise_ratio(const Indexed_triangle_mesh& mesh,
                                              const std::vector<Indexed_triangle_mesh::Point_3>& observed,
                                              const Noise_map& noise, const Adaptive_parameters& parameters)
{
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;

  std::vector<Vector_3> normals;
  std::vector<double> areas;
  compute_face_normals<ConcurrencyTag>(mesh, normals, areas);
  struct Counts
  {
    bool is_known, is_turned;
    double expected;
  };
  std::vector<Counts> counts(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(counts.size(), [&](const std::size_t f)
  {
    const Surroundings around = surroundings(mesh, f, normals, areas);
    counts[f] = Counts{ false, false, 0 };
    if(!around.agree(parameters.agreement))
      return;
    // A face turns when a vertex passes the opposite edge: their distance changes by a vertex's own noise and
    // about half of that of the edge's
    const double height = height_of_face(mesh, f, areas);
    counts[f].is_known = true;
    counts[f].is_turned = area_vector(mesh, f, observed) * around.area_vector < 0;
    counts[f].expected = 0.5 * std::erfc(height / (std::sqrt(2 * 1.5) * noise.level * noise.ratio_of_face(mesh, f)));
  });
  const auto total = [&](const auto& value)
  { return sum<ConcurrencyTag>(counts.size(), [&](const std::size_t f) { return double(value(counts[f])); }); };
  const double whole = total([](const Counts& c) { return c.is_known; });
  if(!(whole > 0))
    return Tangential_noise_ratio();
  const double turned = total([](const Counts& c) { return c.is_turned; });
  const double untold = parameters.least_share_of_turned_faces * whole;
  const double expected = total([](const Counts& c) { return c.expected; }) + untold;
  return Tangential_noise_ratio{ turned / expected, (turned + untold) / expected, expected / whole };
}

// From each vertex inside to the center of its neighbors, along the surface
template <typename ConcurrencyTag>
void compute_ways_to_centers(const Indexed_triangle_mesh& mesh, const Vertex_neighbors& neighbors,
                             const std::vector<Indexed_triangle_mesh::Vector_3>& vertex_normals,
                             std::vector<Indexed_triangle_mesh::Vector_3>& ways)
{
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;

  ways.assign(vertex_normals.size(), Vector_3(0, 0, 0));
  for_each_index<ConcurrencyTag>(ways.size(), [&](const std::size_t v)
  {
    if(!neighbors.is_inside(v))
      return;
    ways[v] = along_surface(to_center(mesh, neighbors, v), vertex_normals[v]);
  });
}

// The square of such a way if nothing but noise in all directions made it
inline double expected_square_of_way(const Vertex_neighbors& neighbors, const Noise_map& noise, const std::size_t v)
{
  return 2 * noise.at(v) * noise.at(v) * (1 + 1 / double(neighbors(v).size()));
}

// Whether noise along the surface made these ways: then their squares are as large as expected, spread as those of a normal
// distribution, and ways do not point the way of those of their neighbors. Those of uneven triangles are larger or, as the shape's
// fineness changes from place to place, go along with each other; of even triangles noise along the normals leaves but small ones
template <typename ConcurrencyTag>
bool are_ways_of_noise(const std::vector<Indexed_triangle_mesh::Vector_3>& ways, const Vertex_neighbors& neighbors,
                       const Noise_map& noise, const Adaptive_parameters& parameters)
{
  std::vector<double> ratios(ways.size(), std::numeric_limits<double>::quiet_NaN()); // known inside only
  for_each_index<ConcurrencyTag>(ratios.size(), [&](const std::size_t v)
  {
    if(neighbors.is_inside(v))
      ratios[v] = ways[v].squared_length() / expected_square_of_way(neighbors, noise, v);
  });
  const std::vector<bool> all(ratios.size(), true);
  const double median = median_of_absolutes(ratios, all);
  if(!(parameters.medians_of_noisy_ways[0] < median && median < parameters.medians_of_noisy_ways[1]
       && quantile_of_absolutes(ratios, all, 0.25) > parameters.quartiles_of_noisy_ways[0] * median
       && quantile_of_absolutes(ratios, all, 0.75) > parameters.quartiles_of_noisy_ways[1] * median))
    return false;

  const auto cosines_above_limit = [&](const std::size_t v)
  {
    double result = 0;
    if(neighbors.is_inside(v))
      for(const auto w : neighbors(v))
      {
        const double squares = ways[v].squared_length() * ways[w].squared_length(); // none at borders
        if(squares > 0)
          result += ways[v] * ways[w] / std::sqrt(squares) - parameters.mean_cosine_of_noisy_ways;
      }
    return result;
  };
  return sum<ConcurrencyTag>(ways.size(), cosines_above_limit) < 0;
}

// What of these ways is noise, which is as strong along the surface as across it: the rest is how uneven the triangles of the
// surface itself are. For each vertex the share of the squares, in the mean around it (Wiener's filter)
template <typename ConcurrencyTag>
std::vector<double> noise_shares_of_ways(const std::vector<Indexed_triangle_mesh::Vector_3>& ways,
                                         const Vertex_neighbors& neighbors, const Noise_map& noise,
                                         const Adaptive_parameters& parameters)
{
  std::vector<Mixing_moments<1> > moments(ways.size());
  for_each_index<ConcurrencyTag>(ways.size(), [&](const std::size_t v)
  {
    moments[v].products[0] = moments[v].squares[0] = 0;
    if(!neighbors.is_inside(v))
      return;
    moments[v].products[0] = float(expected_square_of_way(neighbors, noise, v));
    moments[v].squares[0] = float(ways[v].squared_length());
  });
  average_over_neighbors<ConcurrencyTag>(neighbors, parameters.sliding_number_of_averages, moments);
  std::vector<double> shares(ways.size(), 1);
  for_each_index<ConcurrencyTag>(shares.size(), [&](const std::size_t v)
  {
    if(moments[v].products[0] < moments[v].squares[0])
      shares[v] = moments[v].products[0] / moments[v].squares[0];
  });
  return shares;
}

// Vertices slide towards the centers of their neighbors as far as noise took them away from there, in the directions in which
// normals do not change: on an edge, along the edge
template <typename ConcurrencyTag>
void relax_along_surface(Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                         const Vertex_neighbors& neighbors, const double share, const Noise_map& noise,
                         const Adaptive_parameters& parameters)
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  const double factor = 0.5 / (parameters.sliding_range * parameters.sliding_range);
  std::vector<Vector_3> normals, vertex_normals, ways;
  std::vector<double> areas, noise_shares;
  std::vector<Point_3> points(mesh.number_of_vertices());
  for(std::size_t k=0; k<parameters.sliding_number_of_steps; ++k)
  {
    compute_face_normals<ConcurrencyTag>(mesh, normals, areas);
    compute_vertex_normals<ConcurrencyTag>(mesh, normals, areas, vertex_normals);
    compute_ways_to_centers<ConcurrencyTag>(mesh, neighbors, vertex_normals, ways);
    if(k == 0)
      noise_shares = noise_shares_of_ways<ConcurrencyTag>(ways, neighbors, noise, parameters);
    for_each_index<ConcurrencyTag>(points.size(), [&](const std::size_t v)
    {
      points[v] = mesh.point(v);
      if(!is_movable[v] || is_null(ways[v]))
        return;
      const std::array<Vector_3, 2> tangents = tangent_frame(vertex_normals[v]);
      Eigen::Matrix2d deviations = Eigen::Matrix2d::Zero();
      double area = 0;
      for(const Index f : mesh.faces_around_vertex(v))
      {
        // along the deviation, with the square of its length
        const Eigen::Vector2d direction(normals[f] * tangents[0], normals[f] * tangents[1]);
        const double scale = 2 / (std::max)(0.1, 1 + normals[f] * vertex_normals[v]);
        deviations += (areas[f] * scale) * direction * direction.transpose();
        area += areas[f];
      }
      if(!(area > 0))
        return;
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
      solver.computeDirect(deviations / area);
      const auto axes = solver.eigenvectors();
      Eigen::Vector2d way = axes.transpose() * Eigen::Vector2d(ways[v] * tangents[0], ways[v] * tangents[1]);
      for(int i=0; i<2; ++i)
        way[i] *= share * noise_shares[v] * bell(factor * solver.eigenvalues()[i]);
      way = axes * way;
      points[v] = points[v] + (way[0] * tangents[0] + way[1] * tangents[1]);
    });
    mesh.swap_points(points);
  }
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_TANGENTIAL_NOISE_H
