// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_REPEAT_STEP_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_REPEAT_STEP_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Denoising_result.h>
#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/move.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// The loop of the methods that make a given number of steps. It ends early when no vertex moves any more.
// `step(mesh, is_movable, displacements)` says where the movable vertices are to go,
// `report(iteration, largest displacement, has converged)` whether to go on.
template <typename ConcurrencyTag, typename Step, typename Report>
Denoising_result repeat_step(Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                             const std::size_t number_of_iterations, Step& step, const Report& report)
{
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  std::vector<Vector_3> displacements;
  std::vector<Point_3> points;
  Denoising_result result;
  while(result.number_of_iterations < number_of_iterations && !result.has_converged)
  {
    displacements.assign(mesh.number_of_vertices(), Vector_3(0, 0, 0));
    step(mesh, is_movable, displacements);
    for_each_index<ConcurrencyTag>(displacements.size(), [&](const std::size_t v)
    {
      if(!std::isfinite(displacements[v].squared_length()))
        displacements[v] = Vector_3(0, 0, 0);
    });
    const double squared_maximum = move_vertices<ConcurrencyTag>(mesh, displacements, points);

    ++result.number_of_iterations;
    result.has_converged = (squared_maximum == 0);
    if(!report(result.number_of_iterations, std::sqrt(squared_maximum), result.has_converged))
      break;
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_REPEAT_STEP_H
