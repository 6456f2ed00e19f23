// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_MIXING_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_MIXING_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Adaptive_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// An estimate of the surface, and for each vertex its noise share: the covariance, along the normal, of the noise and the
// estimate (Stein). That is what the estimate changes by when a known disturbance is added to the noise, times that
// disturbance, in the mean.
struct Estimate
{
  std::vector<Indexed_triangle_mesh::Point_3> points;
  std::vector<double> noise_shares;
};

// from 0 up to `low` to 1 from `high` on
inline double ramp(const double x, const double low, const double high)
{
  return !(x > low) ? 0 : (x < high) ? (x - low) / (high - low) : 1;
}

// from 0 to 1, as `t` goes, and level at both ends
inline double smooth_step(const double t) { return t * t * (3 - 2 * t); }

// What the choice between a coarse and a fine estimate rests on, at one vertex and summed over a window. With
// y the observed point, c and f the two estimates, the least squared error of c + t (f - c) to the true surface is at
//   t = [(y - c) (f - c) - (noise share of f - that of c)] / (f - c)^2,
// where all differences are along the normal: what vertices slide along the surface does not count.
template <std::size_t N>
struct Mixing_moments
{
  std::array<float, N> products;   // (y - c) (f - c) - noise share
  std::array<float, N> squares;    // (f - c)^2
};

// replaces the moments of each vertex by the mean of them and its neighbors' moments, again and again
template <typename ConcurrencyTag, std::size_t N>
void average_over_neighbors(const Vertex_neighbors& neighbors, const std::size_t number_of_times,
                            std::vector<Mixing_moments<N> >& moments)
{
  std::vector<Mixing_moments<N> > means(moments.size());
  for(std::size_t k=0; k<number_of_times; ++k)
  {
    for_each_index<ConcurrencyTag>(moments.size(), [&](const std::size_t v)
    {
      Mixing_moments<N> m = moments[v];
      for(const Indexed_triangle_mesh::Index w : neighbors(v))
      {
        const Mixing_moments<N>& other = moments[w];
        for(std::size_t i=0; i<N; ++i)
        {
          m.products[i] += other.products[i];
          m.squares[i] += other.squares[i];
        }
      }
      const float factor = 1.f / float(1 + neighbors(v).size());
      for(std::size_t i=0; i<N; ++i)
      {
        m.products[i] *= factor;
        m.squares[i] *= factor;
      }
      means[v] = m;
    });
    moments.swap(means);
  }
}

// `deviation`, of a weight or of an offset, less what chance explains (James and Stein). That has the variance
// `squared_noise` / `square`; an offset rests on as many vertices as `square` says
inline double shrunk(const double deviation, const double square, const double squared_noise, const double penalty)
{
  const double squared_deviation = deviation * deviation;
  const double by_chance = penalty * squared_noise / square;
  return (squared_deviation > by_chance) ? deviation * (1 - by_chance / squared_deviation) : 0;
}

// The weight t of the whole mesh, in [0, 1], which keeps to zero as far as it may be chance. `product(v)` and `square(v)`
// are the moments at vertex v
template <typename ConcurrencyTag, typename Product, typename Square>
double weight_of_mesh(const std::size_t number_of_vertices, const Product& product, const Square& square,
                      const double squared_noise, const double penalty)
{
  const double p = sum<ConcurrencyTag>(number_of_vertices, product), s = sum<ConcurrencyTag>(number_of_vertices, square);
  if(!(s > 0))
    return 0;
  return shrunk((std::min)(1., (std::max)(0., p / s)), s, squared_noise, penalty);
}

// How far weights keep to others
struct Mixing_penalties
{
  double mesh;  // that of the whole mesh to zero
  double local; // those of windows to that of the whole mesh
};

// The weight t, in [0, 1], of the fine estimate at each vertex. That of a window, where vertices count by `importance(v)`, keeps
// to that of the whole mesh as far as its deviation may be chance. Uses up the moments
template <typename ConcurrencyTag, typename Importance, std::size_t N>
std::vector<std::array<float, N> >
local_weights(const Vertex_neighbors& neighbors, const Adaptive_parameters& parameters, const double squared_noise,
              const Mixing_penalties& penalties, const Importance& importance, std::vector<Mixing_moments<N> >& moments)
{
  std::array<double, N> means;
  for(std::size_t i=0; i<N; ++i)
    means[i] = weight_of_mesh<ConcurrencyTag>(moments.size(),
                                              [&](const std::size_t v) { return double(moments[v].products[i]); },
                                              [&](const std::size_t v) { return double(moments[v].squares[i]); },
                                              squared_noise, penalties.mesh);

  // from here on, products are those of the deviation from the weight of the whole mesh
  for_each_index<ConcurrencyTag>(moments.size(), [&](const std::size_t v)
  {
    const float factor = float(importance(v));
    for(std::size_t i=0; i<N; ++i)
    {
      Mixing_moments<N>& m = moments[v];
      m.products[i] = factor * (m.products[i] - float(means[i]) * m.squares[i]);
      m.squares[i] *= factor;
    }
  });
  average_over_neighbors<ConcurrencyTag>(neighbors, parameters.window_number_of_averages, moments);

  const double points_in_window = parameters.window_points_per_average * double(parameters.window_number_of_averages);
  std::vector<std::array<float, N> > weights(moments.size());
  for_each_index<ConcurrencyTag>(moments.size(), [&](const std::size_t v)
  {
    for(std::size_t i=0; i<N; ++i)
    {
      const double square = moments[v].squares[i];
      double t = means[i];
      if(square > 0)
        t += shrunk(moments[v].products[i] / square, points_in_window * square, squared_noise, penalties.local);
      weights[v][i] = float((std::min)(1., (std::max)(0., t)));
    }
  });
  return weights;
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_MIXING_H
