// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_GUIDED_NORMAL_FILTER_H
#define CGAL_SURFACE_MESH_DENOISING_GUIDED_NORMAL_FILTER_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Ball_search.h>
#include <CGAL/Surface_mesh_denoising/internal/check_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Face_geometry.h>
#include <CGAL/Surface_mesh_denoising/internal/Gaussian.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingFilters
*
* The class `Guided_normal_filter` replaces each face normal by a mean of the normals around it, in which near faces weigh more, and faces whose
* guidance differs little: the local scheme of Zhang et al.\ \cgalCite{cgal:zdzbl-gmnf-15}. The guidance comes from flat patches and tells
* weak features from noise better than the normals themselves do.
*
* In each iteration the normal \f$ n_i \f$ of face \f$ i \f$ becomes the unit vector along
* \f[ \sum_j a_j \exp\left( -\frac{|c_i - c_j|^2}{2 \sigma_s^2} - \frac{|g_i - g_j|^2}{2 \sigma_r^2} \right) n_j, \f]
* where \f$ j \f$ runs over the faces whose centroids \f$ c_j \f$ are within a radius of \f$ c_i \f$, face \f$ i \f$ included, and \f$ a_j \f$ is
* the area of face \f$ j \f$. The guidance \f$ g_i \f$ is the area-weighted mean normal of a patch: a face with the
* faces that share a vertex with it. Of all patches that hold face \f$ i \f$ it is the one with the least
* \f[ \max_{j,k} |n_j - n_k| \cdot \frac{\max_e \varphi_e}{\varepsilon + \sum_e \varphi_e}, \f]
* where \f$ j \f$ and \f$ k \f$ are faces of the patch, \f$ e \f$ is an edge inside it and \f$ \varphi_e \f$ the length of the difference of
* the normals at \f$ e \f$.
*
* Zhang et al. move the vertices after each iteration of the filter, and begin the next one with the normals of the mesh that results:
* \code{.cpp}
* denoise_with_normals(mesh, parameters::face_normal_filter(Guided_normal_filter())
*                                       .number_of_normal_iterations(1).number_of_iterations(10).number_of_rounds(20));
* \endcode
*
* The complexity of one iteration is \f$ O(n k) \f$, where \f$ n \f$ is the number of faces and \f$ k \f$ the number of faces within the
* radius. The search for them ends when it has found 512, at the end of a ring, so that \f$ k \f$ does not grow with \f$ n \f$.
*
* \cgalModels `FaceNormalFilter`
*/
class Guided_normal_filter
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  /*!
  * @param normal_sigma \f$ \sigma_r \f$, a positive number: the smaller, the finer are the features that stay
  * @param spatial_sigma \f$ \sigma_s \f$ in mean distances of the centroids of adjacent faces, a positive number
  * @param radius the radius in mean distances of the centroids of adjacent faces, a positive number
  *
  * @throw std::invalid_argument if a parameter is out of its range
  */
  explicit Guided_normal_filter(const double normal_sigma = 0.35, const double spatial_sigma = 1,
                                const double radius = 2)
    : m_normal_sigma(internal::checked_positive("normal_sigma", normal_sigma)),
      m_spatial_sigma(internal::checked_positive("spatial_sigma", spatial_sigma)),
      m_radius(internal::checked_positive("radius", radius))
  {}

  /// filters `normals`, the unit normals of the faces of `mesh`, `number_of_iterations` times.
  template <typename ConcurrencyTag>
  void operator()(const Indexed_triangle_mesh& mesh, std::vector<Vector_3>& normals,
                  const std::size_t number_of_iterations, ConcurrencyTag) const
  {
    const internal::Face_geometry geometry(mesh, ConcurrencyTag());
    const double radius = m_radius * geometry.mean_centroid_distance();
    const internal::Gaussian spatial(m_spatial_sigma * geometry.mean_centroid_distance());
    const internal::Gaussian range(m_normal_sigma);
    const auto centroid = [&](const std::size_t f) -> const Point_3& { return geometry.centroid(f); };

    std::vector<Patch> patches(normals.size());
    std::vector<Vector_3> guidance(normals.size()), filtered(normals.size());
    for(std::size_t iteration=0; iteration<number_of_iterations; ++iteration)
    {
      compute_guidance<ConcurrencyTag>(mesh, geometry, normals, patches, guidance);
      internal::for_each_block<ConcurrencyTag>(normals.size(), [&](const std::size_t first, const std::size_t last)
      {
        internal::Ball_search search(mesh);
        for(std::size_t f=first; f<last; ++f)
        {
          Vector_3 sum(0, 0, 0);
          for(const Index g : search.faces_around_face(f, centroid, radius * radius))
            sum += geometry.area(g)
                 * std::exp(spatial.exponent(squared_distance(centroid(f), centroid(g)))
                            + range.exponent((guidance[f] - guidance[g]).squared_length())) * normals[g];
          filtered[f] = internal::normalized_or(sum, normals[f]);
        }
      });
      normals.swap(filtered);
    }
  }

private:
  struct Patch
  {
    Vector_3 mean_normal;
    double inconsistency;
  };

  template <typename ConcurrencyTag>
  static void compute_guidance(const Indexed_triangle_mesh& mesh, const internal::Face_geometry& geometry,
                               const std::vector<Vector_3>& normals, std::vector<Patch>& patches,
                               std::vector<Vector_3>& guidance)
  {
    internal::for_each_block<ConcurrencyTag>(normals.size(), [&](const std::size_t first, const std::size_t last)
    {
      std::vector<Index> faces;
      for(std::size_t f=first; f<last; ++f)
      {
        faces.assign(1, Index(f));
        faces.insert(faces.end(), mesh.faces_around_face(f).begin(), mesh.faces_around_face(f).end());
        Vector_3 sum(0, 0, 0);
        for(const Index g : faces)
          sum += geometry.area(g) * normals[g];
        patches[f] = Patch{internal::normalized_or(sum, normals[f]), inconsistency(mesh, normals, faces)};
      }
    });
    internal::for_each_index<ConcurrencyTag>(normals.size(), [&](const std::size_t f)
    {
      const Patch* best = &patches[f];
      for(const Index g : mesh.faces_around_face(f))
        if(patches[g].inconsistency < best->inconsistency)
          best = &patches[g];
      guidance[f] = best->mean_normal;
    });
  }

  static double inconsistency(const Indexed_triangle_mesh& mesh, const std::vector<Vector_3>& normals,
                              const std::vector<Index>& faces)
  {
    double largest_difference = 0; // squared
    double most_salient_edge = 0, sum_over_edges = 0;
    for(auto f = faces.begin(); f != faces.end(); ++f)
    {
      for(auto g = faces.begin(); g != f; ++g)
        largest_difference = (std::max)(largest_difference, (normals[*f] - normals[*g]).squared_length());
      for(const Index g : mesh.neighbors(*f))
      {
        if(g == Indexed_triangle_mesh::null_index() || g < *f || std::find(faces.begin(), faces.end(), g) == faces.end())
          continue;
        const double saliency = std::sqrt((normals[*f] - normals[g]).squared_length());
        most_salient_edge = (std::max)(most_salient_edge, saliency);
        sum_over_edges += saliency;
      }
    }
    const double epsilon = 1e-9;
    return std::sqrt(largest_difference) * most_salient_edge / (epsilon + sum_over_edges);
  }

  double m_normal_sigma;
  double m_spatial_sigma;
  double m_radius;
};

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_GUIDED_NORMAL_FILTER_H
