// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_BILATERAL_STEP_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_BILATERAL_STEP_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Ball_search.h>
#include <CGAL/Surface_mesh_denoising/internal/bilateral_vertex_normals.h>
#include <CGAL/Surface_mesh_denoising/internal/Gaussian.h>
#include <CGAL/Surface_mesh_denoising/internal/Mesh_normals.h>
#include <CGAL/Surface_mesh_denoising/internal/move.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Where bilateral mesh denoising moves the vertices in one iteration
template <typename ConcurrencyTag>
class Bilateral_step : public Mesh_normals<ConcurrencyTag>
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  // `spatial_sigma` in lengths of the shortest edge at a vertex
  explicit Bilateral_step(const double spatial_sigma) : m_spatial_sigma(spatial_sigma) {}

  void operator()(const Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                  std::vector<Vector_3>& displacements)
  {
    this->compute_normals(mesh);
    for_each_block<ConcurrencyTag>(mesh.number_of_vertices(), [&](const std::size_t first, const std::size_t last)
    {
      Ball_search search(mesh);
      std::vector<double> heights;
      for(std::size_t v=first; v<last; ++v)
        if(is_movable[v] && !mesh.faces_around_vertex(v).empty())
        {
          const Vector_3 n = mean_normal(mesh, v);
          displacements[v] = height(mesh, v, n, search, heights) * n;
        }
    });
    prevent_flips<ConcurrencyTag>(mesh, this->mean_normals(mesh), displacements);
  }

private:
  Vector_3 mean_normal(const Indexed_triangle_mesh& mesh, const std::size_t v) const
  {
    Vector_3 n(0, 0, 0);
    for(const Index f : mesh.faces_around_vertex(v))
      n += this->face_normals()[f];
    return normalized_or_null(n);
  }

  // the bilaterally filtered height of the surface above the plane through `v` with the normal `n`
  double height(const Indexed_triangle_mesh& mesh, const std::size_t v, const Vector_3& n, Ball_search& search,
                std::vector<double>& heights) const
  {
    const Point_3& p = mesh.point(v);
    double shortest = (std::numeric_limits<double>::max)(); // squared
    for_each_adjacent_vertex(mesh, v, [&](const Index w)
    { shortest = (std::min)(shortest, squared_distance(p, mesh.point(w))); });
    const double sigma_c = m_spatial_sigma * std::sqrt(shortest);
    const std::vector<Index>& neighbors = search.vertices_around_vertex(v, 4 * sigma_c * sigma_c);

    // `v` itself is a neighbor, at height zero
    heights.clear();
    double mean = 0;
    for(const Index w : neighbors)
    {
      heights.push_back((mesh.point(w) - p) * n);
      mean += std::abs(heights.back()) / double(neighbors.size() + 1);
    }
    double variance = mean * mean;
    for(const double h : heights)
      variance += (std::abs(h) - mean) * (std::abs(h) - mean);
    variance /= double(neighbors.size() + 1);

    const Gaussian spatial(sigma_c), range(std::sqrt(variance));
    double sum = 0, sum_of_weights = 1;
    for(std::size_t i=0; i<neighbors.size(); ++i)
    {
      const double weight = std::exp(spatial.exponent(squared_distance(p, mesh.point(neighbors[i])))
                                     + range.exponent(heights[i] * heights[i]));
      sum += weight * heights[i];
      sum_of_weights += weight;
    }
    return sum / sum_of_weights;
  }

  double m_spatial_sigma;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_BILATERAL_STEP_H
