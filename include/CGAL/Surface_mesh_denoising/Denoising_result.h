// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_DENOISING_RESULT_H
#define CGAL_SURFACE_MESH_DENOISING_DENOISING_RESULT_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingRef
*
* The struct `Denoising_result` tells how an iterative denoising function came to its end.
*/
struct Denoising_result
{
  /// the number of iterations that were completed
  std::size_t number_of_iterations = 0;
  /// whether the last iteration changed the mesh by no more than the convergence threshold; if not, the maximal number
  /// of iterations was reached or the visitor ended the run
  bool has_converged = false;
};

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_DENOISING_RESULT_H
