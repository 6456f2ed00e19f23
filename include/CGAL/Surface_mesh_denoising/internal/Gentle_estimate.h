// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_GENTLE_ESTIMATE_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_GENTLE_ESTIMATE_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Adaptive_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Normal_evolution.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/mixing.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// An estimate that spares small detail: a path of many gentle steps, each of which takes more of the noise and more of
// the shape away, and a relaxation of what noise is left between neighbors. What changes between two points of the path
// is a band; the estimate is the end of the path, with each band given back as far as, by Stein's estimate, it is shape
// and not noise.
struct Gentle_estimate
{
  std::vector<Indexed_triangle_mesh::Point_3> points;
  // for each vertex its disturbance times what it changes the estimate by (see mixing.h)
  std::vector<double> noise_shares;
};

inline Evolution_step gentle_step(const std::size_t k, const double relative_noise, const Adaptive_parameters& parameters)
{
  const double range = (std::max)(parameters.gentle_last_range,
                                  parameters.gentle_first_range
                                  * std::pow(parameters.gentle_last_range / parameters.gentle_first_range,
                                             double(k) / parameters.gentle_range_steps));
  const auto growth = [&](const double g) { return std::size_t((std::min)(g, double(parameters.gentle_maximal_growth))); };
  const double progress = relative_noise * double(k);
  return { (std::min)(range * relative_noise, parameters.largest_range), false,
           1 + growth(parameters.gentle_normal_growth * progress * progress),
           2 + growth(parameters.gentle_move_growth * progress) };
}

// Lambda-mu smoothing (Taubin), of what noise may have left only: a vertex far from the center of its neighbors, beside
// the noise, stays, and moves along its normal and across it count each for itself.
template <typename ConcurrencyTag>
void relax(Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable, const Vertex_neighbors& neighbors,
           const std::vector<Indexed_triangle_mesh::Vector_3>& normals, const double noise,
           const Adaptive_parameters& parameters)
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  const auto factor_of_range = [&](const double range) { return 0.5 / (range * range * noise * noise); };
  const double factor_along = factor_of_range(parameters.relaxation_range_along_normals);
  const double factor_across = factor_of_range(parameters.relaxation_range_across_normals);
  std::vector<Point_3> points(mesh.number_of_vertices());
  for(std::size_t k=0; k<2*parameters.number_of_relaxations; ++k)
  {
    const double share = (k % 2 == 0) ? 0.5 : -0.53;
    for_each_index<ConcurrencyTag>(points.size(), [&](const std::size_t v)
    {
      points[v] = mesh.point(v);
      if(!is_movable[v] || neighbors.is_at_border(v) || neighbors(v).empty())
        return;
      Vector_3 sum(0, 0, 0);
      for(const Index w : neighbors(v))
        sum += mesh.point(w) - mesh.point(v);
      const Vector_3 to_center = sum / double(neighbors(v).size());
      const Vector_3 along = (to_center * normals[v]) * normals[v], across = to_center - along;
      points[v] = points[v] + (share * bell(factor_along * along.squared_length())) * along
                            + (share * bell(factor_across * across.squared_length())) * across;
    });
    mesh.swap_points(points);
  }
}

// `mesh` holds the best points that are known, which tell areas and distances better than the observed ones. It is
// as before afterwards. `noise` is in the unit of the coordinates, `disturbances` are lengths along `normals` of about that
// of the noise, independent of each other
template <typename ConcurrencyTag>
Gentle_estimate
estimate_gently(Indexed_triangle_mesh& mesh, const std::vector<Indexed_triangle_mesh::Point_3>& observed,
                const std::vector<bool>& is_movable, const Vertex_neighbors& neighbors,
                const std::vector<Indexed_triangle_mesh::Vector_3>& normals, const std::vector<double>& disturbances,
                const double noise,
                const double mean_edge_length, const Adaptive_parameters& parameters)
{
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  const std::size_t N = Adaptive_parameters::number_of_local_bands;
  struct Band
  {
    std::array<float, 3> difference; // between its fine and its coarse end
    float noise_share;
  };

  const std::size_t n = mesh.number_of_vertices();
  std::vector<Point_3> fine = observed, points = observed, disturbed(n);
  for_each_index<ConcurrencyTag>(n, [&](const std::size_t v) { disturbed[v] = observed[v] + disturbances[v] * normals[v]; });
  std::vector<Point_3> disturbed_fine = disturbed;

  // goes on to step `end` of the path, for the observed and for the disturbed points
  Normal_evolution<ConcurrencyTag> evolve;
  mesh.swap_points(points);
  std::size_t k = 0;
  const auto go_to = [&](const std::size_t end)
  {
    evolve.update_weights(mesh);
    for(; k<end; ++k)
    {
      const Evolution_step step = gentle_step(k, noise / mean_edge_length, parameters);
      evolve(mesh, is_movable, step);
      mesh.swap_points(disturbed);
      evolve(mesh, is_movable, step);
      mesh.swap_points(disturbed);
    }
  };
  const auto difference = [&](const std::size_t v) { return fine[v] - mesh.point(v); };
  const auto noise_share = [&](const std::size_t v)
  { return disturbances[v] * normals[v] * ((disturbed_fine[v] - fine[v]) - (disturbed[v] - mesh.point(v))); };
  const auto product = [&](const std::size_t v)
  { return (observed[v] - mesh.point(v)) * difference(v) - noise_share(v); };
  const auto end_band = [&]()
  {
    fine = mesh.points();
    disturbed_fine = disturbed;
  };

  std::vector<Vector_3> given_back(n, Vector_3(0, 0, 0));
  Gentle_estimate estimate;
  estimate.noise_shares.assign(n, 0);
  for(const std::size_t end : parameters.global_band_ends)
  {
    go_to(end);
    const Weight_of_mesh w = weight_of_mesh<ConcurrencyTag>(
      n, product, [&](const std::size_t v) { return difference(v).squared_length(); });
    const double t = (w.square > 0) ? shrunk(w.weight, w.square, noise * noise, parameters.gentle_penalty) : 0;
    for_each_index<ConcurrencyTag>(n, [&](const std::size_t v)
    {
      given_back[v] += t * difference(v);
      estimate.noise_shares[v] += t * noise_share(v);
    });
    end_band();
  }

  std::vector<std::array<Band, N> > bands(n);
  std::vector<Mixing_moments<N> > moments(n);
  for(std::size_t i=0; i<N; ++i)
  {
    if(i < parameters.local_band_ends.size())
      go_to(parameters.local_band_ends[i]);
    else
    {
      relax<ConcurrencyTag>(mesh, is_movable, neighbors, normals, noise, parameters);
      mesh.swap_points(disturbed);
      relax<ConcurrencyTag>(mesh, is_movable, neighbors, normals, noise, parameters);
      mesh.swap_points(disturbed);
    }
    for_each_index<ConcurrencyTag>(n, [&](const std::size_t v)
    {
      const Vector_3 d = difference(v);
      bands[v][i] = Band{ {{ float(d.x()), float(d.y()), float(d.z()) }}, float(noise_share(v)) };
      moments[v].products[i] = float(product(v));
      moments[v].squares[i] = float(d.squared_length());
    });
    end_band();
  }
  evolve = Normal_evolution<ConcurrencyTag>();
  disturbed_fine = std::vector<Point_3>();

  const auto weights
    = local_weights<ConcurrencyTag>(neighbors, parameters, noise * noise, parameters.gentle_penalty, moments);
  for_each_index<ConcurrencyTag>(n, [&](const std::size_t v)
  {
    estimate.noise_shares[v] += disturbances[v] * normals[v] * (disturbed[v] - mesh.point(v));
    for(std::size_t i=0; i<N; ++i)
    {
      const Band& b = bands[v][i];
      const double w = weights[v][i];
      given_back[v] += w * Vector_3(b.difference[0], b.difference[1], b.difference[2]);
      estimate.noise_shares[v] += w * b.noise_share;
    }
    fine[v] = mesh.point(v) + given_back[v];
  });
  estimate.points.swap(fine);
  mesh.swap_points(points);
  return estimate;
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_GENTLE_ESTIMATE_H
