// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_VERTEX_NEIGHBORS_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_VERTEX_NEIGHBORS_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// The vertices that share an edge with each vertex, and the vertices at open or constrained edges
class Vertex_neighbors
{
  typedef Indexed_triangle_mesh::Index        Index;

public:
  typedef Indexed_triangle_mesh::Index_range  Index_range;

  explicit Vertex_neighbors(const Indexed_triangle_mesh& mesh) : m_is_at_border(mesh.number_of_vertices(), false)
  {
    for(std::size_t f=0; f<mesh.number_of_faces(); ++f)
      for(int i=0; i<3; ++i)
        if(mesh.neighbors(f)[i] == Indexed_triangle_mesh::null_index())
          m_is_at_border[mesh.vertices(f)[i]] = m_is_at_border[mesh.vertices(f)[(i+1)%3]] = true;

    std::vector<Index> last_seen_from(mesh.number_of_vertices(), Indexed_triangle_mesh::null_index());
    m_offsets.reserve(mesh.number_of_vertices() + 1);
    m_offsets.push_back(0);
    m_neighbors.reserve(6 * mesh.number_of_vertices());
    for(std::size_t v=0; v<mesh.number_of_vertices(); ++v)
    {
      last_seen_from[v] = Index(v);
      for(const Index f : mesh.faces_around_vertex(v))
        for(const Index w : mesh.vertices(f))
          if(last_seen_from[w] != v)
          {
            last_seen_from[w] = Index(v);
            m_neighbors.push_back(w);
          }
      m_offsets.push_back(Index(m_neighbors.size()));
    }
  }

  Index_range operator()(const std::size_t v) const
  {
    return Index_range(m_neighbors.data() + m_offsets[v], m_neighbors.data() + m_offsets[v+1]);
  }

  bool is_at_border(const std::size_t v) const { return m_is_at_border[v]; }

  // whether vertex `v` has neighbors all around it
  bool is_inside(const std::size_t v) const { return !m_is_at_border[v] && !(*this)(v).empty(); }

private:
  std::vector<Index> m_offsets, m_neighbors;
  std::vector<bool> m_is_at_border;
};

// from vertex `v`, which has neighbors, to their center
inline Indexed_triangle_mesh::Vector_3 to_center(const Indexed_triangle_mesh& mesh, const Vertex_neighbors& neighbors,
                                                 const std::size_t v)
{
  Indexed_triangle_mesh::Vector_3 sum(0, 0, 0);
  for(const Indexed_triangle_mesh::Index w : neighbors(v))
    sum += mesh.point(w) - mesh.point(v);
  return sum / double(neighbors(v).size());
}

// the mean length of the edges of vertex `v`, which has neighbors
inline double mean_length_of_edges(const Indexed_triangle_mesh& mesh, const Vertex_neighbors& neighbors, const std::size_t v)
{
  double sum = 0;
  for(const Indexed_triangle_mesh::Index w : neighbors(v))
    sum += std::sqrt(squared_distance(mesh.point(v), mesh.point(w)));
  return sum / double(neighbors(v).size());
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_VERTEX_NEIGHBORS_H
