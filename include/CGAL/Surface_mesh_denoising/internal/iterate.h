// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_ITERATE_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_ITERATE_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Denoising_result.h>
#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Hausdorff_test.h>
#include <CGAL/Surface_mesh_denoising/internal/move.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

struct Iteration_parameters
{
  std::size_t number_of_iterations;
  double convergence_threshold; // in mean edge lengths
  double relaxation_factor;
};

// The loop around a fit: fits -> moves -> convergence test. `fit(mesh, is_movable, displacements)` says where the
// vertices are to go, `report(iteration, largest displacement, has converged)` whether to go on.
template <typename ConcurrencyTag, typename Fit, typename Report>
Denoising_result iterate(Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                         const Iteration_parameters& parameters, Fit& fit, const Report& report)
{
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  const double mean_edge_length = mesh.mean_edge_length<ConcurrencyTag>();
  const double bound = parameters.convergence_threshold * mean_edge_length;
  const std::size_t number_of_movable_vertices = std::count(is_movable.begin(), is_movable.end(), true);
  Damping damp(mesh.number_of_vertices(), parameters.relaxation_factor, 0.05 * mean_edge_length);
  std::vector<Vector_3> displacements, outwards;
  std::vector<Point_3> points;

  Denoising_result result;
  while(result.number_of_iterations < parameters.number_of_iterations && !result.has_converged)
  {
    fit(mesh, is_movable, displacements);
    damp(displacements, ConcurrencyTag());
    average_vertex_normals<ConcurrencyTag>(mesh, fit.vertex_normals(), outwards);
    prevent_flips<ConcurrencyTag>(mesh, outwards, displacements);

    const double squared_maximum = move_vertices<ConcurrencyTag>(mesh, displacements, points);
    const double mean_square = sum<ConcurrencyTag>(displacements.size(), [&](const std::size_t v)
    {
      return displacements[v].squared_length();
    }) / (std::max)(number_of_movable_vertices, std::size_t(1));

    // The Hausdorff distance is a maximum. It may fall below the bound while the bulk of the vertices still creeps
    // on, by less each, in one direction: a fifteenth is where the error of the normals was seen to end its fall.
    ++result.number_of_iterations;
    result.has_converged = std::sqrt(mean_square) <= bound / 15
      && (squared_maximum <= bound * bound
          || !Hausdorff_test<ConcurrencyTag>::is_distance_larger(mesh, points, mesh.points(), bound));
    if(!report(result.number_of_iterations, std::sqrt(squared_maximum), result.has_converged))
      break;
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_ITERATE_H
