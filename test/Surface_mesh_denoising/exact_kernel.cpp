// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Does not compile, and the compiler says why.

#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/denoise_isotropic_fitting.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

int main()
{
  CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3> mesh;
  CGAL::Surface_mesh_denoising::denoise_anisotropic_fitting(mesh);
  CGAL::Surface_mesh_denoising::denoise_isotropic_fitting(mesh);
}
