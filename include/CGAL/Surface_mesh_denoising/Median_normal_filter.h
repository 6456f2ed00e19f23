// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_MEDIAN_NORMAL_FILTER_H
#define CGAL_SURFACE_MESH_DENOISING_MEDIAN_NORMAL_FILTER_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Alpha_trimmed_normal_filter.h>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingFilters
*
* The class `Median_normal_filter` replaces each face normal by the angle median of the normals around it \cgalCite{cgal:yob-msmmf-02}.
*
* In each iteration the normal \f$ n_i \f$ of face \f$ i \f$ becomes that one of the normals of the faces that share a vertex with it whose
* angle with \f$ n_i \f$ is the median of these angles, or the area-weighted mean of the two in the middle. Where most faces
* around each face lie in its plane, edges stay as they are.
* Yagou et al. move the vertices after each iteration: see the parameter `number_of_rounds` of `denoise_with_normals()`.
*
* The complexity of one iteration is linear in the number of faces.
*
* \cgalModels `FaceNormalFilter`
*/
class Median_normal_filter
  : public Alpha_trimmed_normal_filter
{
public:
  Median_normal_filter() : Alpha_trimmed_normal_filter(0.5) {}
};

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_MEDIAN_NORMAL_FILTER_H
