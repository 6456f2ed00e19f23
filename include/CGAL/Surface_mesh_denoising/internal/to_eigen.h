// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_TO_EIGEN_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_TO_EIGEN_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>

#include <Eigen/Core>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

inline Eigen::Vector3d to_eigen(const Indexed_triangle_mesh::Vector_3& v)
{
  return Eigen::Vector3d(v.x(), v.y(), v.z());
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_TO_EIGEN_H
