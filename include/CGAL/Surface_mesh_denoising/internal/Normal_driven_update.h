// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_NORMAL_DRIVEN_UPDATE_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_NORMAL_DRIVEN_UPDATE_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/move.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>
#include <CGAL/Surface_mesh_denoising/internal/repeat_step.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Filters the face normals, then moves the vertices until the faces are about perpendicular to them
template <typename ConcurrencyTag, typename FaceNormalFilter>
class Normal_driven_update
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  Normal_driven_update(const FaceNormalFilter& filter, const std::size_t number_of_rounds,
                       const std::size_t number_of_normal_iterations, const std::size_t number_of_iterations)
    : m_filter(filter), m_number_of_rounds(number_of_rounds),
      m_number_of_normal_iterations(number_of_normal_iterations), m_number_of_iterations(number_of_iterations)
  {}

  const std::vector<Vector_3>& face_normals() const { return m_face_normals; }
  const std::vector<Vector_3>& vertex_normals() const { return m_vertex_normals; }

  // the vertex normals that belong to the face normals of the last round
  void compute_normals(const Indexed_triangle_mesh& mesh)
  {
    compute_vertex_normals<ConcurrencyTag>(mesh, m_face_normals, m_areas, m_vertex_normals);
  }

  template <typename Report>
  Denoising_result run(Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable, const Report& report)
  {
    Denoising_result result;
    bool goes_on = true;
    for(std::size_t round=0; round<m_number_of_rounds && goes_on; ++round)
    {
      compute_face_normals<ConcurrencyTag>(mesh, m_face_normals, m_areas);
      m_filter(mesh, m_face_normals, m_number_of_normal_iterations, ConcurrencyTag());

      const std::size_t completed = result.number_of_iterations;
      const Denoising_result result_of_round = repeat_step<ConcurrencyTag>(
        mesh, is_movable, m_number_of_iterations, *this,
        [&](const std::size_t iteration, const double largest_displacement, const bool has_converged)
        { return goes_on = report(completed + iteration, largest_displacement, has_converged); });
      result.number_of_iterations += result_of_round.number_of_iterations;
      result.has_converged = result_of_round.has_converged;
    }
    return result;
  }

  // Each vertex goes to the mean of its projections onto the planes through the centroids of its faces
  void operator()(const Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                  std::vector<Vector_3>& displacements) const
  {
    for_each_index<ConcurrencyTag>(mesh.number_of_vertices(), [&](const std::size_t v)
    {
      const auto faces = mesh.faces_around_vertex(v);
      if(!is_movable[v] || faces.empty())
        return;
      for(const Index f : faces)
        displacements[v] += ((mesh.centroid(f) - mesh.point(v)) * m_face_normals[f]) * m_face_normals[f];
      displacements[v] = displacements[v] / double(faces.size());
    });
    prevent_flips<ConcurrencyTag>(mesh, m_face_normals, displacements);
  }

private:
  const FaceNormalFilter& m_filter;
  std::size_t m_number_of_rounds;
  std::size_t m_number_of_normal_iterations;
  std::size_t m_number_of_iterations;

  std::vector<Vector_3> m_face_normals;
  std::vector<double> m_areas;
  std::vector<Vector_3> m_vertex_normals;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_NORMAL_DRIVEN_UPDATE_H
