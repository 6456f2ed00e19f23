// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_MEAN_NORMAL_FILTER_H
#define CGAL_SURFACE_MESH_DENOISING_MEAN_NORMAL_FILTER_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Alpha_trimmed_normal_filter.h>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingFilters
*
* The class `Mean_normal_filter` replaces each face normal by the area-weighted mean of the normals around it \cgalCite{cgal:yob-msmmf-02}.
*
* In each iteration the normal of a face becomes the unit vector along \f$ \sum_j a_j n_j \f$, where \f$ j \f$ runs over the faces that share a
* vertex with it and \f$ a_j \f$ is the area of face \f$ j \f$. Edges become round.
* Yagou et al. move the vertices after each iteration: see the parameter `number_of_rounds` of `denoise_with_normals()`.
*
* The complexity of one iteration is linear in the number of faces.
*
* \cgalModels `FaceNormalFilter`
*/
class Mean_normal_filter
  : public Alpha_trimmed_normal_filter
{
public:
  Mean_normal_filter() : Alpha_trimmed_normal_filter(0) {}
};

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_MEAN_NORMAL_FILTER_H
