// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_SINE_KEY_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_SINE_KEY_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <cmath>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// A number in [-1, 1] that is as good as random where `x` holds noise of far more than a thousandth. Unlike a random
// number it belongs to the geometry: numbering, position and scale of the mesh do not matter.
inline double sine_key(const double x)
{
  return std::sin(1000 * x);
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_SINE_KEY_H
