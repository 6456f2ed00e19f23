// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_NOISE_MAP_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_NOISE_MAP_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// The standard deviation of the noise at each vertex, in the unit of the coordinates
struct Noise_map
{
  double level = 0;          // where noise is strong, or everywhere
  std::vector<float> ratios; // to that level, for each vertex; empty if noise is as strong everywhere

  Noise_map() {}
  explicit Noise_map(const double level) : level(level) {}

  bool is_uniform() const { return ratios.empty(); }

  double ratio(const std::size_t v) const { return is_uniform() ? 1 : double(ratios[v]); }

  double squared_ratio(const std::size_t v) const { return ratio(v) * ratio(v); }

  double ratio_of_face(const Indexed_triangle_mesh& mesh, const std::size_t f) const
  {
    if(is_uniform())
      return 1;
    double sum = 0;
    for(const Indexed_triangle_mesh::Index v : mesh.vertices(f))
      sum += ratios[v];
    return sum / 3;
  }

  double at(const std::size_t v) const { return level * ratio(v); }
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_NOISE_MAP_H
