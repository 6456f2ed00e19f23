// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_BALL_SEARCH_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_BALL_SEARCH_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Local_numbering.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Finds the part of the mesh inside a ball, as far as it is connected inside, and without crossing constrained edges.
// The search goes ring by ring, and ends after the ring that completes `max_number_of_faces`: what it costs is
// bounded also where the ball holds much of the mesh. An object may be used again and again, by one thread.
class Ball_search
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;

public:
  static constexpr std::size_t max_number_of_faces = 512;

  explicit Ball_search(const Indexed_triangle_mesh& mesh) : m_mesh(mesh) {}

  // face `f`, and the other faces whose centroids are in the ball around that of `f`
  template <typename Centroids>
  const std::vector<Index>& faces_around_face(const std::size_t f, const Centroids& centroid,
                                              const double squared_radius)
  {
    const Index start = Index(f);
    return search(Indexed_triangle_mesh::Index_range(&start, &start + 1), [&](const Index g)
    { return squared_distance(centroid(f), centroid(g)) <= squared_radius; });
  }

  // the faces of vertex `v`, and the other faces whose centroids are in the ball around it
  const std::vector<Index>& faces_around_vertex(const std::size_t v, const double squared_radius)
  {
    return search(m_mesh.faces_around_vertex(v), [&](const Index g)
    { return squared_distance(m_mesh.point(v), m_mesh.centroid(g)) <= squared_radius; });
  }

  // the vertices in the ball around vertex `v`, but for `v` itself
  const std::vector<Index>& vertices_around_vertex(const std::size_t v, const double squared_radius)
  {
    const auto is_inside = [&](const Index w)
    { return squared_distance(m_mesh.point(v), m_mesh.point(w)) <= squared_radius; };
    search(m_mesh.faces_around_vertex(v), [&](const Index g)
    {
      const auto& t = m_mesh.vertices(g);
      return is_inside(t[0]) || is_inside(t[1]) || is_inside(t[2]);
    });
    m_vertices.clear();
    m_seen.clear();
    m_seen.insert(Index(v));
    for(const Index g : m_faces)
      for(const Index w : m_mesh.vertices(g))
        if(m_seen.insert(w).second && is_inside(w))
          m_vertices.push_back(w);
    return m_vertices;
  }

private:
  template <typename IsInside>
  const std::vector<Index>& search(const Indexed_triangle_mesh::Index_range starts, const IsInside& is_inside)
  {
    m_faces.assign(starts.begin(), starts.end());
    m_seen.clear();
    for(const Index f : m_faces)
      m_seen.insert(f);
    for(std::size_t first = 0, last = m_faces.size(); first < last && last < max_number_of_faces;
        first = last, last = m_faces.size())
      for(std::size_t i=first; i<last; ++i)
        for(const Index g : m_mesh.faces_around_face(m_faces[i]))
          if(m_seen.insert(g).second && is_inside(g))
            m_faces.push_back(g);
    return m_faces;
  }

  const Indexed_triangle_mesh& m_mesh;
  Local_numbering<Index> m_seen;
  std::vector<Index> m_faces, m_vertices;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_BALL_SEARCH_H
