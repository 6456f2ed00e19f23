// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_ADAPTIVE_GAUSSIAN_NORMAL_FILTER_H
#define CGAL_SURFACE_MESH_DENOISING_ADAPTIVE_GAUSSIAN_NORMAL_FILTER_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/check_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Gaussian.h>
#include <CGAL/Surface_mesh_denoising/internal/Neighborhood_search.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingFilters
*
* The class `Adaptive_gaussian_normal_filter` replaces each face normal by a Gaussian mean of the normals around it, whose width adapts to
* the place and whose distances grow across edges, after Ohtake, Belyaev and Seidel \cgalCite{cgal:obs-mssan-02}.
*
* In each iteration the normal of face \f$ i \f$ becomes the unit vector \f$ m_i(\sigma) \f$ along
* \f[ \sum_j w_j n_j, \quad w_j = a_j \exp\left( -\frac{d_{ij}^2}{2 \sigma^2} \right), \f]
* where \f$ j \f$ runs over the faces nearest to face \f$ i \f$, itself included, \f$ a_j \f$ is the area of face \f$ j \f$ and \f$ d_{ij} \f$
* its normal-weighted distance (see `anisotropic_neighborhood()`), in mean edge lengths. Of the widths \f$ \sigma \f$ from
* \f$ 1/2 \f$ to \f$ 4 \f$ mean edge lengths, by factors of \f$ \sqrt{2} \f$, the filter takes for each face the one with the least
* \f[ \frac{c}{\sigma^2} + \frac{\sum_j w_j \, |n_j - m_i(\sigma)|^2}{\sum_j w_j}: \f]
* a wide Gaussian in flat parts, where the normals vary by noise alone, and a narrow one near features.
*
* The complexity of one iteration is \f$ O(n k \log k) \f$, where \f$ n \f$ is the number of faces and \f$ k \f$ the size of a neighborhood.
*
* \cgalModels `FaceNormalFilter`
*/
class Adaptive_gaussian_normal_filter
{
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  /*!
  * @param scale_weight \f$ c \f$, a positive number: the smaller, the finer are the features that stay
  * @param normal_weight the weight \f$ \omega \f$ of the normals in the distance, at least zero: the larger, the sharper do edges stay;
  *        with zero the filter is isotropic
  * @param neighborhood_size the maximal number of faces in a neighborhood, at least 1
  *
  * @throw std::invalid_argument if a parameter is out of its range
  */
  explicit Adaptive_gaussian_normal_filter(const double scale_weight = 0.3, const double normal_weight = 5,
                                           const std::size_t neighborhood_size = 40)
    : m_scale_weight(internal::checked_positive("scale_weight", scale_weight)),
      m_normal_weight(internal::checked_not_negative("normal_weight", normal_weight)),
      m_neighborhood_size(internal::checked_count("neighborhood_size", neighborhood_size, 1))
  {}

  /// filters `normals`, the unit normals of the faces of `mesh`, `number_of_iterations` times.
  template <typename ConcurrencyTag>
  void operator()(const Indexed_triangle_mesh& mesh, std::vector<Vector_3>& normals,
                  const std::size_t number_of_iterations, ConcurrencyTag) const
  {
    const double unit = mesh.mean_edge_length<ConcurrencyTag>();
    std::vector<std::array<internal::Dual_edge, 3> > dual_edges;
    std::vector<Vector_3> filtered(normals.size());
    for(std::size_t iteration=0; iteration<number_of_iterations; ++iteration)
    {
      const internal::Indexed_dual_graph dual(mesh, normals, m_normal_weight, dual_edges, ConcurrencyTag());
      internal::for_each_block<ConcurrencyTag>(normals.size(), [&](const std::size_t first, const std::size_t last)
      {
        internal::Neighborhood_search<internal::Indexed_dual_graph> search(dual);
        std::vector<Weighted_normal> neighborhood;
        for(std::size_t f=first; f<last; ++f)
        {
          neighborhood.clear();
          for(const auto& neighbor : search(Indexed_triangle_mesh::Index(f), m_neighborhood_size))
            neighborhood.push_back(Weighted_normal{normals[neighbor.face], mesh.area(neighbor.face), neighbor.distance});
          filtered[f] = mean_of_best_width(neighborhood, unit, normals[f]);
        }
      });
      normals.swap(filtered);
    }
  }

private:
  struct Weighted_normal
  {
    Vector_3 normal;
    double area;
    double distance;
  };

  // `normal` if no width gives a mean
  Vector_3 mean_of_best_width(const std::vector<Weighted_normal>& neighborhood, const double unit,
                              const Vector_3& normal) const
  {
    const int number_of_widths = 7;
    Vector_3 best = normal;
    double least_error = (std::numeric_limits<double>::max)();
    for(int k=0; k<number_of_widths; ++k)
    {
      const double sigma = 0.5 * std::pow(2., 0.5 * k);
      const internal::Gaussian gaussian(sigma * unit);
      Vector_3 sum(0, 0, 0);
      double sum_of_weights = 0, sum_of_squares = 0;
      for(const Weighted_normal& n : neighborhood)
      {
        const double weight = n.area * gaussian(n.distance * n.distance);
        sum += weight * n.normal;
        sum_of_weights += weight;
        sum_of_squares += weight * n.normal.squared_length();
      }
      const Vector_3 mean = internal::normalized_or_null(sum);
      if(internal::is_null(mean))
        continue;
      const double variance = (sum_of_squares - 2 * (sum * mean)) / sum_of_weights + 1;
      const double error = m_scale_weight / (sigma * sigma) + variance;
      if(error < least_error)
      {
        least_error = error;
        best = mean;
      }
    }
    return best;
  }

  double m_scale_weight;
  double m_normal_weight;
  std::size_t m_neighborhood_size;
};

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_ADAPTIVE_GAUSSIAN_NORMAL_FILTER_H
