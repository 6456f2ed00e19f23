// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_FACE_GEOMETRY_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_FACE_GEOMETRY_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// the areas and centroids of the faces, while normals are filtered
class Face_geometry
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;

public:
  template <typename ConcurrencyTag>
  Face_geometry(const Indexed_triangle_mesh& mesh, ConcurrencyTag)
    : m_areas(mesh.number_of_faces()), m_centroids(mesh.number_of_faces())
  {
    for_each_index<ConcurrencyTag>(mesh.number_of_faces(), [&](const std::size_t f)
    {
      m_areas[f] = mesh.area(f);
      m_centroids[f] = mesh.centroid(f);
    });

    const auto has_neighbor = [&](const std::size_t f, const int i)
    { return mesh.neighbors(f)[i] != Indexed_triangle_mesh::null_index(); };
    const double length = sum<ConcurrencyTag>(mesh.number_of_faces(), [&](const std::size_t f)
    {
      double s = 0;
      for(int i=0; i<3; ++i)
        if(has_neighbor(f, i))
          s += std::sqrt(squared_distance(m_centroids[f], m_centroids[mesh.neighbors(f)[i]]));
      return s;
    });
    const double number = sum<ConcurrencyTag>(mesh.number_of_faces(), [&](const std::size_t f)
    { return double(has_neighbor(f, 0) + has_neighbor(f, 1) + has_neighbor(f, 2)); });
    m_mean_centroid_distance = (number > 0) ? length / number : 0;
  }

  double area(const std::size_t f) const { return m_areas[f]; }
  const Point_3& centroid(const std::size_t f) const { return m_centroids[f]; }

  // the mean distance of the centroids of faces that share an edge, zero if there are none
  double mean_centroid_distance() const { return m_mean_centroid_distance; }

private:
  std::vector<double> m_areas;
  std::vector<Point_3> m_centroids;
  double m_mean_centroid_distance;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_FACE_GEOMETRY_H
