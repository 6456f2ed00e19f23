// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_ALPHA_TRIMMED_NORMAL_FILTER_H
#define CGAL_SURFACE_MESH_DENOISING_ALPHA_TRIMMED_NORMAL_FILTER_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/check_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Face_geometry.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingFilters
*
* The class `Alpha_trimmed_normal_filter` replaces each face normal by the mean of the normals around it, without those that differ from it
* the least and the most: the alpha-trimmed mean of Yagou et al.\ \cgalCite{cgal:yob-msmmf-02}, \cgalCite{cgal:yob-mdiat-03}.
*
* In each iteration the normals \f$ n_j \f$ of the \f$ m \f$ faces that share a vertex with face \f$ i \f$ are ranked by their angles with
* \f$ n_i \f$, and \f$ n_i \f$ becomes the unit vector along \f$ \sum_j a_j n_j \f$, where \f$ a_j \f$ is the area of face \f$ j \f$, and
* \f$ j \f$ runs over the faces that remain without the first \f$ \lfloor \alpha (m-1) \rfloor \f$ and as many at the end. A normal with the
* same angle as one that remains remains as well.
*
* With \f$ \alpha = 0 \f$ this is `Mean_normal_filter`, with \f$ \alpha = 1/2 \f$ it is `Median_normal_filter`.
* Yagou et al. move the vertices after each iteration: see the parameter `number_of_rounds` of `denoise_with_normals()`.
*
* The complexity of one iteration is linear in the number of faces.
*
* \cgalModels `FaceNormalFilter`
*/
class Alpha_trimmed_normal_filter
{
public:
  /*!
  * @param trimmed_share \f$ \alpha \f$, in the range [0, 1/2]: the larger, the better do edges stay
  *
  * @throw std::invalid_argument if the parameter is out of its range
  */
  explicit Alpha_trimmed_normal_filter(const double trimmed_share = 0.25)
    : m_trimmed_share(trimmed_share)
  {
    if(!(trimmed_share >= 0 && trimmed_share <= 0.5))
      internal::throw_out_of_range("trimmed_share", trimmed_share, "in the range [0, 0.5]");
  }

  /// filters `normals`, the unit normals of the faces of `mesh`, `number_of_iterations` times.
  template <typename ConcurrencyTag>
  void operator()(const Indexed_triangle_mesh& mesh, std::vector<Indexed_triangle_mesh::Vector_3>& normals,
                  const std::size_t number_of_iterations, ConcurrencyTag) const
  {
    typedef Indexed_triangle_mesh::Vector_3 Vector_3;

    const internal::Face_geometry geometry(mesh, ConcurrencyTag());
    std::vector<Vector_3> filtered(normals.size());
    for(std::size_t iteration=0; iteration<number_of_iterations; ++iteration)
    {
      internal::for_each_block<ConcurrencyTag>(normals.size(), [&](const std::size_t first, const std::size_t last)
      {
        std::vector<double> cosines;
        for(std::size_t f=first; f<last; ++f)
        {
          const Indexed_triangle_mesh::Index_range neighbors = mesh.faces_around_face(f);
          cosines.clear();
          for(const Indexed_triangle_mesh::Index g : neighbors)
            cosines.push_back(normals[f] * normals[g]);
          std::sort(cosines.begin(), cosines.end(), std::greater<double>());

          Vector_3 sum(0, 0, 0);
          if(!cosines.empty())
          {
            const std::size_t trimmed = std::size_t(m_trimmed_share * double(cosines.size() - 1));
            const double largest = cosines[trimmed], least = cosines[cosines.size() - 1 - trimmed];
            for(const Indexed_triangle_mesh::Index g : neighbors)
            {
              const double cosine = normals[f] * normals[g];
              if(least <= cosine && cosine <= largest)
                sum += geometry.area(g) * normals[g];
            }
          }
          filtered[f] = internal::normalized_or(sum, normals[f]);
        }
      });
      normals.swap(filtered);
    }
  }

private:
  double m_trimmed_share;
};

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_ALPHA_TRIMMED_NORMAL_FILTER_H
