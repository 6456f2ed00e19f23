// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LICENSE_SURFACE_MESH_DENOISING_H
#define CGAL_LICENSE_SURFACE_MESH_DENOISING_H

#include <CGAL/config.h>
#include <CGAL/license.h>

// CGAL/license.h lets a program ask, with either macro, where it relies on the GPL.
// There is no other license of this package.
#ifdef CGAL_LICENSE_WARNING
CGAL_pragma_warning("\nThe package Surface Mesh Denoising is available under the terms of the GPLv3+ only.")
#endif

#ifdef CGAL_LICENSE_ERROR
#error "The package Surface Mesh Denoising is available under the terms of the GPLv3+ only. \
You get this error, as you defined CGAL_LICENSE_ERROR."
#endif

#endif // CGAL_LICENSE_SURFACE_MESH_DENOISING_H
