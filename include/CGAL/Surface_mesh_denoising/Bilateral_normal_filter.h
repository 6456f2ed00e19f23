// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_BILATERAL_NORMAL_FILTER_H
#define CGAL_SURFACE_MESH_DENOISING_BILATERAL_NORMAL_FILTER_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/check_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Face_geometry.h>
#include <CGAL/Surface_mesh_denoising/internal/Gaussian.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingFilters
*
* The class `Bilateral_normal_filter` replaces each face normal by a mean of the normals around it, in which near faces and normals
* that differ little weigh more: the local scheme of Zheng et al.\ \cgalCite{cgal:zfat-bnfmd-11}.
*
* In each iteration the normal \f$ n_i \f$ of face \f$ i \f$ becomes the unit vector along
* \f[ \sum_j a_j \exp\left( -\frac{|c_i - c_j|^2}{2 \sigma_c^2} - \frac{|n_i - n_j|^2}{2 \sigma_s^2} \right) n_j, \f]
* where \f$ j \f$ runs over all faces that share a vertex with face \f$ i \f$, which itself is not among them: its own normal counts only
* through the weights. \f$ a_j \f$ is the area of face \f$ j \f$ and \f$ c_j \f$ its centroid.
*
* The complexity of one iteration is linear in the number of faces.
*
* \cgalModels `FaceNormalFilter`
*/
class Bilateral_normal_filter
{
public:
  /*!
  * @param normal_sigma \f$ \sigma_s \f$, a positive number: the smaller, the finer are the features that stay
  * @param spatial_sigma \f$ \sigma_c \f$ in mean distances of the centroids of adjacent faces, a positive number
  *
  * @throw std::invalid_argument if a parameter is out of its range
  */
  explicit Bilateral_normal_filter(const double normal_sigma = 0.35, const double spatial_sigma = 1)
    : m_normal_sigma(internal::checked_positive("normal_sigma", normal_sigma)),
      m_spatial_sigma(internal::checked_positive("spatial_sigma", spatial_sigma))
  {}

  /// filters `normals`, the unit normals of the faces of `mesh`, `number_of_iterations` times.
  template <typename ConcurrencyTag>
  void operator()(const Indexed_triangle_mesh& mesh, std::vector<Indexed_triangle_mesh::Vector_3>& normals,
                  const std::size_t number_of_iterations, ConcurrencyTag) const
  {
    typedef Indexed_triangle_mesh::Vector_3 Vector_3;

    const internal::Face_geometry geometry(mesh, ConcurrencyTag());
    const internal::Gaussian spatial(m_spatial_sigma * geometry.mean_centroid_distance());
    const internal::Gaussian range(m_normal_sigma);
    std::vector<Vector_3> filtered(normals.size());
    for(std::size_t iteration=0; iteration<number_of_iterations; ++iteration)
    {
      internal::for_each_index<ConcurrencyTag>(normals.size(), [&](const std::size_t f)
      {
        Vector_3 sum(0, 0, 0);
        for(const Indexed_triangle_mesh::Index g : mesh.faces_around_face(f))
          sum += geometry.area(g)
               * std::exp(spatial.exponent(squared_distance(geometry.centroid(f), geometry.centroid(g)))
                          + range.exponent((normals[f] - normals[g]).squared_length())) * normals[g];
        filtered[f] = internal::normalized_or(sum, normals[f]);
      });
      normals.swap(filtered);
    }
  }

private:
  double m_normal_sigma;
  double m_spatial_sigma;
};

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_BILATERAL_NORMAL_FILTER_H
