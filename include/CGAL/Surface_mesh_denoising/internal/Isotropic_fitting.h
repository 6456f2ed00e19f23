// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_ISOTROPIC_FITTING_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_ISOTROPIC_FITTING_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/bilateral_vertex_normals.h>
#include <CGAL/Surface_mesh_denoising/internal/Local_numbering.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>
#include <CGAL/Surface_mesh_denoising/internal/surface_fit.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Where isotropic surface fitting moves the vertices: normals -> neighborhoods -> fits
template <typename ConcurrencyTag>
class Isotropic_fitting
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  // `spatial_sigma` in mean edge lengths
  Isotropic_fitting(const std::size_t number_of_normal_iterations, const double spatial_sigma,
                    const double normal_sigma, const std::size_t neighborhood_ring_size)
    : m_number_of_normal_iterations(number_of_normal_iterations), m_spatial_sigma(spatial_sigma),
      m_normal_sigma(normal_sigma), m_ring_size(neighborhood_ring_size)
  {}

  const std::vector<Vector_3>& face_normals() const { return m_face_normals; }
  const std::vector<Vector_3>& vertex_normals() const { return m_vertex_normals; }

  // the filtered vertex normals, and for each face the mean of those of its vertices
  void compute_normals(const Indexed_triangle_mesh& mesh)
  {
    compute_vertex_normals<ConcurrencyTag>(mesh, m_vertex_normals);
    filter_vertex_normals<ConcurrencyTag>(mesh, std::vector<bool>(mesh.number_of_vertices(), true),
                                          m_spatial_sigma * mesh.mean_edge_length<ConcurrencyTag>(), m_normal_sigma,
                                          m_number_of_normal_iterations, m_vertex_normals);
    average_vertex_normals<ConcurrencyTag>(mesh, m_vertex_normals, m_face_normals);
  }

  // the vector from each movable vertex to its projection onto the surface that is fitted around it
  void operator()(const Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                  std::vector<Vector_3>& displacements)
  {
    compute_normals(mesh);
    displacements.assign(mesh.number_of_vertices(), Vector_3(0, 0, 0));
    for_each_block<ConcurrencyTag>(mesh.number_of_vertices(), [&](const std::size_t first, const std::size_t last)
    {
      Ring_search search(mesh);
      for(std::size_t v=first; v<last; ++v)
        if(is_movable[v] && !is_null(m_vertex_normals[v]))
        {
          const Index seed = closest_normal(mesh, m_face_normals, v, m_vertex_normals[v]);
          displacements[v] = height_of_fit(mesh.point(v), m_vertex_normals[v], search(v, seed, m_ring_size))
                           * m_vertex_normals[v];
        }
    });
  }

private:
  // finds the vertices up to `k` edges away from a vertex, without crossing constrained edges
  class Ring_search
  {
  public:
    explicit Ring_search(const Indexed_triangle_mesh& mesh) : m_mesh(mesh) {}

    // where constrained edges separate the faces around `v`, the side of `seed` counts
    const std::vector<Point_3>& operator()(const std::size_t v, const Index seed, const std::size_t k)
    {
      m_points.clear();
      m_seen_vertices.clear();
      m_seen_faces.clear();
      m_mesh.find_sector(v, seed, m_faces);
      for(const Index f : m_faces)
        m_seen_faces.insert(f);
      std::size_t first = 0;
      for(std::size_t ring=1; ring<=k && first<m_faces.size(); ++ring)
      {
        const std::size_t last = m_faces.size();
        for(std::size_t i=first; i<last; ++i)
        {
          for(const Index w : m_mesh.vertices(m_faces[i]))
            if(m_seen_vertices.insert(w).second)
              m_points.push_back(m_mesh.point(w));
          if(ring < k)
            for(const Index g : m_mesh.faces_around_face(m_faces[i]))
              if(m_seen_faces.insert(g).second)
                m_faces.push_back(g);
        }
        first = last;
      }
      return m_points;
    }

  private:
    const Indexed_triangle_mesh& m_mesh;
    Local_numbering<Index> m_seen_vertices, m_seen_faces;
    std::vector<Index> m_faces;
    std::vector<Point_3> m_points;
  };

  std::size_t m_number_of_normal_iterations;
  double m_spatial_sigma;
  double m_normal_sigma;
  std::size_t m_ring_size;

  std::vector<Vector_3> m_face_normals;
  std::vector<Vector_3> m_vertex_normals;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_ISOTROPIC_FITTING_H
