// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_MESH_NORMALS_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_MESH_NORMALS_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// The normals of the mesh as it is, for the methods that filter none
template <typename ConcurrencyTag>
class Mesh_normals
{
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  const std::vector<Vector_3>& face_normals() const { return m_face_normals; }
  const std::vector<Vector_3>& vertex_normals() const { return m_vertex_normals; }

  void compute_normals(const Indexed_triangle_mesh& mesh)
  {
    compute_face_normals<ConcurrencyTag>(mesh, m_face_normals, m_areas);
    compute_vertex_normals<ConcurrencyTag>(mesh, m_face_normals, m_areas, m_vertex_normals);
  }

  // the mean normals of the faces around each face: they tell a face that noise turned over from its neighbors
  std::vector<Vector_3> mean_normals(const Indexed_triangle_mesh& mesh) const
  {
    std::vector<Vector_3> normals(mesh.number_of_faces());
    for_each_index<ConcurrencyTag>(mesh.number_of_faces(), [&](const std::size_t f)
    {
      normals[f] = normalized_or_null(m_areas[f] * m_face_normals[f]
                                      + surroundings(mesh, f, m_face_normals, m_areas).area_vector);
    });
    return normals;
  }

private:
  std::vector<Vector_3> m_face_normals;
  std::vector<Vector_3> m_vertex_normals;
  std::vector<double> m_areas;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_MESH_NORMALS_H
