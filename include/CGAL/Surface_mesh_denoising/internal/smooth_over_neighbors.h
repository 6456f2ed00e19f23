// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_SMOOTH_OVER_NEIGHBORS_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_SMOOTH_OVER_NEIGHBORS_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// In each step the values at vertices go by these shares, one after the other, of the way to the mean of their neighbors'.
// Vertices that may not move, or are at borders, keep theirs. The values are arrays of Eigen
template <typename ConcurrencyTag, typename Shares, typename Value>
void smooth_over_neighbors(const Vertex_neighbors& neighbors, const std::vector<bool>& is_movable,
                           const std::size_t number_of_steps, const Shares& shares, std::vector<Value>& values)
{
  typedef typename Value::Scalar Number;

  std::vector<Value> next(values.size());
  for(std::size_t k=0; k<number_of_steps; ++k)
    for(const double share : shares)
    {
      for_each_index<ConcurrencyTag>(values.size(), [&](const std::size_t v)
      {
        next[v] = values[v];
        if(!is_movable[v] || !neighbors.is_inside(v))
          return;
        Value sum = Value::Zero();
        for(const Indexed_triangle_mesh::Index w : neighbors(v))
          sum += values[w];
        next[v] += Number(share) * (sum / Number(neighbors(v).size()) - values[v]);
      });
      values.swap(next);
    }
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_SMOOTH_OVER_NEIGHBORS_H
