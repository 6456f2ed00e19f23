// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_DENOISE_BY_FITTING_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_DENOISE_BY_FITTING_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/internal/named_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/check_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/denoise_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/iterate.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// the part that all fitting methods share: the parameters of the iterations, and their loop
template <typename ConcurrencyTag, typename Range, typename TriangleMesh, typename NamedParameters, typename Fit>
Denoising_result denoise_by_fitting(const Range& range, TriangleMesh& tmesh, const NamedParameters& np,
                                    const std::size_t default_number_of_iterations, Fit& fit)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  Iteration_parameters iteration_parameters;
  iteration_parameters.number_of_iterations
    = checked_count("number_of_iterations",
                    choose_parameter(get_parameter(np, internal_np::number_of_iterations),
                                     default_number_of_iterations), 0);
  iteration_parameters.convergence_threshold
    = checked_positive("convergence_threshold",
                       choose_parameter(get_parameter(np, internal_np::convergence_threshold), 0.05));
  iteration_parameters.relaxation_factor
    = checked_share("relaxation_factor",
                    choose_parameter(get_parameter(np, internal_np::relaxation_factor), 0.5));

  return denoise_mesh(range, tmesh, np,
                      [&](Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable, const auto& report)
                      { return iterate<ConcurrencyTag>(mesh, is_movable, iteration_parameters, fit, report); },
                      fit);
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_DENOISE_BY_FITTING_H
