// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_THRESHOLDED_NORMAL_FILTER_H
#define CGAL_SURFACE_MESH_DENOISING_THRESHOLDED_NORMAL_FILTER_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/check_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingFilters
*
* The class `Thresholded_normal_filter` replaces each face normal by a weighted mean of the normals around it that differ from it by
* less than a threshold.
*
* In each iteration the normal \f$ n_i \f$ of face \f$ i \f$ becomes the unit vector along \f$ \sum_j h_j n_j \f$, where
* \f$ j \f$ runs over the face itself and all faces that share a vertex with it, and
* \f$ h_j = (n_i \cdot n_j - T)^p \f$ if \f$ n_i \cdot n_j > T \f$, else \f$ h_j = 0 \f$.
* Sun et al.\ \cgalCite{cgal:srml-fefmd-07} use \f$ p = 2 \f$, Wang and Yu \cgalCite{cgal:wy-fpmd-12} use \f$ p = 4 \f$.
*
* The complexity of one iteration is linear in the number of faces.
*
* \cgalModels `FaceNormalFilter`
*/
class Thresholded_normal_filter
{
public:
  /*!
  * @param angle_threshold \f$ T \f$, a cosine in the range (0, 1): the larger, the finer are the features that stay
  * @param exponent \f$ p \f$, 2 or 4
  *
  * @throw std::invalid_argument if a parameter is out of its range
  */
  explicit Thresholded_normal_filter(const double angle_threshold = 0.5, const int exponent = 4)
    : m_angle_threshold(internal::checked_open_unit_interval("angle_threshold", angle_threshold)),
      m_exponent(exponent)
  {
    if(exponent != 2 && exponent != 4)
      internal::throw_out_of_range("normal_exponent", exponent, "2 or 4");
  }

  /// filters `normals`, the unit normals of the faces of `mesh`, `number_of_iterations` times.
  template <typename ConcurrencyTag>
  void operator()(const Indexed_triangle_mesh& mesh, std::vector<Indexed_triangle_mesh::Vector_3>& normals,
                  const std::size_t number_of_iterations, ConcurrencyTag) const
  {
    typedef Indexed_triangle_mesh::Vector_3 Vector_3;

    std::vector<Vector_3> filtered(normals.size());
    for(std::size_t iteration=0; iteration<number_of_iterations; ++iteration)
    {
      internal::for_each_index<ConcurrencyTag>(normals.size(), [&](const std::size_t f)
      {
        const Vector_3 n = normals[f];
        Vector_3 sum = weight(n * n) * n;
        for(const Indexed_triangle_mesh::Index g : mesh.faces_around_face(f))
          sum += weight(n * normals[g]) * normals[g];
        filtered[f] = internal::normalized_or_null(sum);
      });
      normals.swap(filtered);
    }
  }

private:
  double weight(const double cosine) const
  {
    const double x = (std::max)(cosine - m_angle_threshold, 0.);
    return (m_exponent == 2) ? x*x : (x*x) * (x*x);
  }

  double m_angle_threshold;
  int m_exponent;
};

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_THRESHOLDED_NORMAL_FILTER_H
