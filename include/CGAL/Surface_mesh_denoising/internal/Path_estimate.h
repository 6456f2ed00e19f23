// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_PATH_ESTIMATE_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_PATH_ESTIMATE_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Adaptive_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Noise_map.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/mixing.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// The estimate that follows a path of smoother and smoother points, which starts from the observed ones. The path is cut
// into bands, and as much of each is given back as Stein's risk estimate says: the first bands, the finest, hold so much
// noise that only the whole mesh tells what else they hold; the others are given back locally.
//
// `Path` has `go_to(step)`, at each step `point(v)` and `noise_share(v)`, and in the end `least_weight(v, step)`: how much of
// the band that ended there is given back at least.
template <typename ConcurrencyTag, typename Path, std::size_t M, std::size_t N>
Estimate estimate_along(Path& path, const std::vector<Indexed_triangle_mesh::Point_3>& observed,
                        const std::vector<Indexed_triangle_mesh::Vector_3>& normals, const Vertex_neighbors& neighbors,
                        const Noise_map& noise, const std::array<std::size_t, M>& global_band_ends,
                        const std::array<std::size_t, N>& local_band_ends, const Adaptive_parameters& parameters)
{
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;

  struct Band
  {
    std::array<float, 3> difference; // between its fine and its coarse end
    float noise_share;
  };

  const std::size_t n = observed.size();
  // of the fine end of a band
  Estimate fine = { observed, std::vector<double>(n) };
  for_each_index<ConcurrencyTag>(n, [&](const std::size_t v) { fine.noise_shares[v] = path.noise_share(v); });

  const auto difference = [&](const std::size_t v) { return fine.points[v] - path.point(v); };
  const auto noise_share = [&](const std::size_t v) { return fine.noise_shares[v] - path.noise_share(v); };
  const auto product = [&](const std::size_t v)
  {
    return ((observed[v] - path.point(v)) * normals[v]) * (difference(v) * normals[v]) - noise_share(v);
  };
  const auto square = [&](const std::size_t v)
  {
    const double d = difference(v) * normals[v];
    return d * d;
  };
  const auto end_band = [&](const std::size_t v)
  {
    fine.points[v] = path.point(v);
    fine.noise_shares[v] = path.noise_share(v);
  };

  std::vector<Vector_3> given_back(n, Vector_3(0, 0, 0));
  Estimate estimate;
  estimate.noise_shares.assign(n, 0);
  for(const std::size_t end : global_band_ends)
  {
    path.go_to(end);
    const double t = weight_of_mesh<ConcurrencyTag>(n, product, square, noise.level * noise.level, parameters.mesh_penalty);
    for_each_index<ConcurrencyTag>(n, [&](const std::size_t v)
    {
      given_back[v] += t * difference(v);
      estimate.noise_shares[v] += t * noise_share(v);
      end_band(v);
    });
  }

  std::vector<std::array<Band, N> > bands(n);
  std::vector<Mixing_moments<N> > moments(n);
  for(std::size_t i=0; i<N; ++i)
  {
    path.go_to(local_band_ends[i]);
    for_each_index<ConcurrencyTag>(n, [&](const std::size_t v)
    {
      const Vector_3 d = difference(v);
      bands[v][i] = Band{ {{ float(d.x()), float(d.y()), float(d.z()) }}, float(noise_share(v)) };
      moments[v].products[i] = float(product(v));
      moments[v].squares[i] = float(square(v));
      end_band(v);
    });
  }

  const auto importance = [&](const std::size_t v) { return 1 / noise.squared_ratio(v); };
  const Mixing_penalties penalties = { parameters.mesh_penalty, parameters.band_penalty };
  const auto weights = local_weights<ConcurrencyTag>(neighbors, parameters, noise.level * noise.level, penalties, importance,
                                                     moments);
  for_each_index<ConcurrencyTag>(n, [&](const std::size_t v)
  {
    estimate.noise_shares[v] += fine.noise_shares[v];
    for(std::size_t i=0; i<N; ++i)
    {
      const Band& b = bands[v][i];
      const double w = (std::max)(double(weights[v][i]), path.least_weight(v, local_band_ends[i]));
      given_back[v] += w * Vector_3(b.difference[0], b.difference[1], b.difference[2]);
      estimate.noise_shares[v] += w * b.noise_share;
    }
    fine.points[v] = fine.points[v] + given_back[v];
  });
  estimate.points.swap(fine.points);
  return estimate;
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_PATH_ESTIMATE_H
