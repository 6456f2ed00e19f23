// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_GAUSSIAN_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_GAUSSIAN_H

#include <CGAL/license/Surface_mesh_denoising.h>


#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// exp(-d^2 / (2 sigma^2)), or its exponent. Defined for a sigma of zero as well
class Gaussian
{
public:
  explicit Gaussian(const double sigma)
    : m_factor(-(std::min)(0.5 / (sigma * sigma), (std::numeric_limits<double>::max)()))
  {}

  double exponent(const double squared_distance) const { return m_factor * squared_distance; }
  double operator()(const double squared_distance) const { return std::exp(exponent(squared_distance)); }

private:
  double m_factor;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_GAUSSIAN_H
