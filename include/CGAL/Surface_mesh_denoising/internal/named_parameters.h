// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_NAMED_PARAMETERS_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_NAMED_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

#ifndef CGAL_SURFACE_MESH_DENOISING_NAMED_PARAMETERS
#error "Surface_mesh_denoising: the include folder of this package must come before that of CGAL (with CMake, link with CGAL::Surface_mesh_denoising)."
// GCC and Clang would go on, and report every use of a parameter that is missing.
#include "compilation stops here"
#endif

#include <type_traits>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

template <typename T>
struct Is_named_parameters : std::false_type {};

template <typename T, typename Tag, typename Base>
struct Is_named_parameters<Named_function_parameters<T, Tag, Base> > : std::true_type {};

// Without it, in a call with a mesh and named parameters that are not constant, these would be taken for the mesh and the mesh for a range
template <typename T>
using Enable_if_not_named_parameters = typename std::enable_if<!Is_named_parameters<T>::value, int>::type;

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_NAMED_PARAMETERS_H
