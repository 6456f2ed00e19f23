// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_BILATERAL_VERTEX_NORMALS_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_BILATERAL_VERTEX_NORMALS_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// calls `visit(w)` for each vertex `w` that shares an edge with `v`
template <typename Visit>
void for_each_adjacent_vertex(const Indexed_triangle_mesh& mesh, const std::size_t v, const Visit& visit)
{
  for(const Indexed_triangle_mesh::Index f : mesh.faces_around_vertex(v))
  {
    const std::array<Indexed_triangle_mesh::Index, 3>& t = mesh.vertices(f);
    const int i = (t[0] == v) ? 0 : (t[1] == v) ? 1 : 2;
    visit(t[(i+1)%3]);
    if(mesh.is_border(f, (i+2)%3)) // else the next face around `v` visits that vertex
      visit(t[(i+2)%3]);
  }
}

// Bilateral filtering of vertex normals. `sigma_c` is a length, `sigma_s` a distance of unit vectors
template <typename ConcurrencyTag>
void filter_vertex_normals(const Indexed_triangle_mesh& mesh, const std::vector<bool>& is_filtered,
                           const double sigma_c, const double sigma_s, const std::size_t number_of_iterations,
                           std::vector<Indexed_triangle_mesh::Vector_3>& normals)
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  if(!(sigma_c > 0)) // all vertices in one place
    return;

  const double spatial_factor = 0.5 / (sigma_c * sigma_c), normal_factor = 0.5 / (sigma_s * sigma_s);
  std::vector<Vector_3> filtered(normals.size());
  for(std::size_t iteration=0; iteration<number_of_iterations; ++iteration)
  {
    for_each_index<ConcurrencyTag>(normals.size(), [&](const std::size_t v)
    {
      const Vector_3 n = normals[v];
      filtered[v] = n;
      if(!is_filtered[v])
        return;

      Vector_3 weighted_sum(0, 0, 0);
      double sum_of_weights = 0;
      for_each_adjacent_vertex(mesh, v, [&](const Index w)
      {
        const Vector_3 difference = normals[w] - n;
        const double weight = std::exp(-spatial_factor * squared_distance(mesh.point(v), mesh.point(w))
                                       - normal_factor * difference.squared_length());
        weighted_sum += weight * difference;
        sum_of_weights += weight;
      });
      if(sum_of_weights > 0)
        filtered[v] = normalized_or_null(n + weighted_sum / sum_of_weights);
    });
    normals.swap(filtered);
  }
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_BILATERAL_VERTEX_NORMALS_H
