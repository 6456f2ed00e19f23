// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_ANISOTROPIC_FITTING_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_ANISOTROPIC_FITTING_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Local_numbering.h>
#include <CGAL/Surface_mesh_denoising/internal/Neighborhood_search.h>
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

// Where anisotropic surface fitting moves the vertices: normals -> neighborhoods -> fits.
// Holds the buffers of one run, so that no iteration allocates anything of the size of the mesh but the filter.
template <typename ConcurrencyTag, typename FaceNormalFilter>
class Anisotropic_fitting
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  Anisotropic_fitting(const FaceNormalFilter& filter, const std::size_t number_of_normal_iterations,
                      const std::size_t neighborhood_size, const double normal_weight)
    : m_filter(filter), m_number_of_normal_iterations(number_of_normal_iterations),
      m_neighborhood_size(neighborhood_size), m_normal_weight(normal_weight)
  {}

  const std::vector<Vector_3>& face_normals() const { return m_face_normals; }
  const std::vector<Vector_3>& vertex_normals() const { return m_vertex_normals; }

  // the filtered normals of the mesh as it is
  void compute_normals(const Indexed_triangle_mesh& mesh)
  {
    compute_face_normals<ConcurrencyTag>(mesh, m_face_normals, m_areas);
    m_filter(mesh, m_face_normals, m_number_of_normal_iterations, ConcurrencyTag());
    compute_vertex_normals<ConcurrencyTag>(mesh, m_face_normals, m_areas, m_vertex_normals);
  }

  // the vector from each movable vertex to its projection onto the surface that is fitted around it
  void operator()(const Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                  std::vector<Vector_3>& displacements)
  {
    compute_normals(mesh);
    choose_seeds(mesh, is_movable);

    const std::size_t neighborhood_size = (std::min)(m_neighborhood_size, mesh.number_of_faces());
    const Indexed_dual_graph dual(mesh, m_face_normals, m_normal_weight, m_dual_edges, ConcurrencyTag());
    displacements.assign(mesh.number_of_vertices(), Vector_3(0, 0, 0));
    for_each_block<ConcurrencyTag>(m_vertices_by_seed.size(), [&](const std::size_t first, const std::size_t last)
    {
      Neighborhood_search<Indexed_dual_graph> search(dual);
      Local_numbering<Index> numbering;
      std::vector<Point_3> points;
      Index seed = Indexed_triangle_mesh::null_index();
      for(std::size_t i=first; i<last; ++i)
      {
        const Index v = m_vertices_by_seed[i];
        if(m_seeds[v] != seed)
        {
          seed = m_seeds[v];
          points.clear();
          numbering.clear();
          for(const auto& neighbor : search(seed, neighborhood_size))
            for(const Index w : mesh.vertices(neighbor.face))
              if(numbering.insert(w).second)
                points.push_back(mesh.point(w));
        }
        displacements[v] = height_of_fit(mesh.point(v), m_vertex_normals[v], points) * m_vertex_normals[v];
      }
    });
  }

private:
  // the seed of a vertex is the incident face whose normal is closest to the vertex normal
  void choose_seeds(const Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable)
  {
    m_seeds.resize(mesh.number_of_vertices());
    for_each_index<ConcurrencyTag>(mesh.number_of_vertices(), [&](const std::size_t v)
    {
      m_seeds[v] = (is_movable[v] && !is_null(m_vertex_normals[v]))
                 ? closest_normal(mesh, m_face_normals, v, m_vertex_normals[v])
                 : Indexed_triangle_mesh::null_index();
    });

    // vertices that share a seed share its neighborhood: bring them together
    m_offsets.assign(mesh.number_of_faces() + 1, 0);
    for(const Index seed : m_seeds)
      if(seed != Indexed_triangle_mesh::null_index())
        ++m_offsets[seed + 1];
    for(std::size_t f=0; f<mesh.number_of_faces(); ++f)
      m_offsets[f+1] += m_offsets[f];
    m_vertices_by_seed.resize(m_offsets.back());
    for(std::size_t v=0; v<m_seeds.size(); ++v)
      if(m_seeds[v] != Indexed_triangle_mesh::null_index())
        m_vertices_by_seed[m_offsets[m_seeds[v]]++] = Index(v);
  }

  const FaceNormalFilter& m_filter;
  std::size_t m_number_of_normal_iterations;
  std::size_t m_neighborhood_size;
  double m_normal_weight;

  std::vector<Vector_3> m_face_normals;
  std::vector<double> m_areas;
  std::vector<Vector_3> m_vertex_normals;
  std::vector<Index> m_seeds;
  std::vector<Index> m_offsets;
  std::vector<Index> m_vertices_by_seed;
  std::vector<std::array<Dual_edge, 3> > m_dual_edges;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_ANISOTROPIC_FITTING_H
