// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INDEXED_TRIANGLE_MESH_H
#define CGAL_SURFACE_MESH_DENOISING_INDEXED_TRIANGLE_MESH_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingRef
*
* The class `Indexed_triangle_mesh` is what the stages of denoising see of a triangle mesh: indices from zero
* and coordinates in double precision, whatever the type of the mesh and its kernel.
* Its connectivity is fixed at construction. Vertices may be isolated or non-manifold, faces may be degenerate.
*
* A model of `FaceNormalFilter` reads the mesh through this class.
*/
class Indexed_triangle_mesh
{
public:
  /// the kernel of the coordinates
  typedef Simple_cartesian<double>                           Geom_traits;
  /// point type
  typedef Geom_traits::Point_3                               Point_3;
  /// vector type
  typedef Geom_traits::Vector_3                              Vector_3;
  /// index of a vertex or of a face
  typedef std::uint32_t                                      Index;
  /// range of indices
  typedef Iterator_range<const Index*>                       Index_range;

  /// stands for the face that is not there
  static constexpr Index null_index() { return (std::numeric_limits<Index>::max)(); }

  /// \name Construction
  /// @{

  /*!
  * constructs the mesh.
  *
  * @param points the points of the vertices
  * @param faces the three vertices of each face, counterclockwise
  * @param neighbors for each face the face on the other side of the edge from its vertex `i` to its vertex `(i+1)%3`,
  *        or `null_index()` on the border
  * @param constrained_edges for each face, bit `i` is set if that edge is constrained; empty if none is
  *
  * @throw std::length_error if there are more vertices or faces than an `Index` can count
  */
  Indexed_triangle_mesh(std::vector<Point_3> points,
                        std::vector<std::array<Index, 3> > faces,
                        std::vector<std::array<Index, 3> > neighbors,
                        const std::vector<std::uint8_t>& constrained_edges = {})
    : m_points(std::move(points)), m_faces(std::move(faces)), m_neighbors(std::move(neighbors))
  {
    // the lists of faces around faces hold about 13 entries a face
    if((std::max)(m_points.size(), m_faces.size()) > null_index() / 16)
      throw std::length_error("Surface_mesh_denoising: the mesh has too many vertices or faces");

    m_border_edges.resize(m_faces.size(), 0);
    for(std::size_t f=0; f<m_faces.size(); ++f)
      for(int i=0; i<3; ++i)
        if(m_neighbors[f][i] == null_index())
          m_border_edges[f] |= std::uint8_t(1 << i);

    for(std::size_t f=0; f<constrained_edges.size(); ++f)
      for(int i=0; i<3; ++i)
        if(constrained_edges[f] & (1 << i))
          m_neighbors[f][i] = null_index();

    list_faces_around_vertices();
    list_faces_around_faces(constrained_edges);
  }

  /// @}
  /// \name Connectivity
  /// @{

  /// returns the number of vertices.
  std::size_t number_of_vertices() const { return m_points.size(); }

  /// returns the number of faces.
  std::size_t number_of_faces() const { return m_faces.size(); }

  /// returns the vertices of face `f`.
  const std::array<Index, 3>& vertices(const std::size_t f) const { return m_faces[f]; }

  /// returns the faces across the edges of face `f`, the first being the edge from the first to the second vertex of
  /// `vertices(f)`. It is `null_index()` on the border and where the edge is constrained.
  const std::array<Index, 3>& neighbors(const std::size_t f) const { return m_neighbors[f]; }

  /// returns whether the edge from vertex `i` of face `f` to vertex `(i+1)%3` has no other face.
  bool is_border(const std::size_t f, const int i) const { return (m_border_edges[f] & (1 << i)) != 0; }

  /// returns the faces incident to vertex `v`.
  Index_range faces_around_vertex(const std::size_t v) const { return range(m_vertex_offsets, m_vertex_faces, v); }

  /// returns the faces that share a vertex with face `f`, without `f` itself, and without those that constrained edges
  /// separate from `f` at the vertex that they share. Around a vertex with more than 32 incident faces only the 31
  /// nearest to `f` count, so that the ranges of all faces together are linear in the size of the mesh.
  Index_range faces_around_face(const std::size_t f) const { return range(m_face_offsets, m_face_faces, f); }

  /*!
  * sets `sector` to the faces incident to vertex `v` to which a path of neighbors leads around `v` from face `f`, one of them, without
  * crossing a constrained edge: `f` first, the nearest to `f` next, and at most 32 in all.
  */
  void find_sector(const std::size_t v, const std::size_t f, std::vector<Index>& sector) const
  {
    sector.assign(1, Index(f));
    for(std::size_t k=0; k<sector.size(); ++k)
      for(int i=0; i<3; ++i)
      {
        const std::array<Index, 3>& t = m_faces[sector[k]];
        const Index g = m_neighbors[sector[k]][i];
        if((t[i] == v || t[(i+1)%3] == v) && g != null_index() && sector.size() < max_sector_size
           && std::find(sector.begin(), sector.end(), g) == sector.end())
          sector.push_back(g);
      }
  }

  /// @}
  /// \name Geometry
  /// @{

  /// returns the point of vertex `v`.
  const Point_3& point(const std::size_t v) const { return m_points[v]; }

  /// returns the points of all vertices.
  const std::vector<Point_3>& points() const { return m_points; }

  /// exchanges the points of all vertices for `points`.
  void swap_points(std::vector<Point_3>& points) { m_points.swap(points); }

  /// returns the centroid of face `f`.
  Point_3 centroid(const std::size_t f) const
  {
    const std::array<Index, 3>& t = m_faces[f];
    return CGAL::centroid(m_points[t[0]], m_points[t[1]], m_points[t[2]]);
  }

  /// returns a vector along the normal of face `f`, its length twice the area of the face.
  Vector_3 area_vector(const std::size_t f) const
  {
    const std::array<Index, 3>& t = m_faces[f];
    return cross_product(m_points[t[1]] - m_points[t[0]], m_points[t[2]] - m_points[t[0]]);
  }

  /// returns the area of face `f`.
  double area(const std::size_t f) const { return 0.5 * std::sqrt(area_vector(f).squared_length()); }

  /// returns the length of the edge from vertex `i` of face `f` to vertex `(i+1)%3`.
  double edge_length(const std::size_t f, const int i) const
  {
    const std::array<Index, 3>& t = m_faces[f];
    return std::sqrt(squared_distance(m_points[t[i]], m_points[t[(i+1)%3]]));
  }

  /// returns the length of the longest edge of face `f`.
  double longest_edge_length(const std::size_t f) const
  {
    const std::array<Index, 3>& t = m_faces[f];
    const Point_3 &p = m_points[t[0]], &q = m_points[t[1]], &r = m_points[t[2]];
    return std::sqrt((std::max)({ squared_distance(p, q), squared_distance(q, r), squared_distance(r, p) }));
  }

  /// returns the mean length of the edges, zero if there are none.
  template <typename ConcurrencyTag = Sequential_tag>
  double mean_edge_length() const
  {
    const double length = internal::sum<ConcurrencyTag>(number_of_faces(), [this](const std::size_t f)
    {
      return edge_share(f, 0) * edge_length(f, 0) + edge_share(f, 1) * edge_length(f, 1)
           + edge_share(f, 2) * edge_length(f, 2);
    });
    const double number_of_edges = internal::sum<ConcurrencyTag>(number_of_faces(), [this](const std::size_t f)
    {
      return edge_share(f, 0) + edge_share(f, 1) + edge_share(f, 2);
    });
    return number_of_edges > 0 ? length / number_of_edges : 0;
  }

  /// @}

private:
  static constexpr std::size_t max_sector_size = 32;

  // the faces at an edge own it in equal shares
  double edge_share(const std::size_t f, const int i) const { return is_border(f, i) ? 1 : 0.5; }

  static Index_range range(const std::vector<Index>& offsets, const std::vector<Index>& entries, const std::size_t i)
  {
    return Index_range(entries.data() + offsets[i], entries.data() + offsets[i+1]);
  }

  void list_faces_around_vertices()
  {
    m_vertex_offsets.assign(m_points.size() + 1, 0);
    for(const std::array<Index, 3>& t : m_faces)
      for(const Index v : t)
        ++m_vertex_offsets[v + 1];
    for(std::size_t v=0; v<m_points.size(); ++v)
      m_vertex_offsets[v+1] += m_vertex_offsets[v];

    m_vertex_faces.resize(m_vertex_offsets.back());
    std::vector<Index> next(m_vertex_offsets.begin(), m_vertex_offsets.end() - 1);
    for(std::size_t f=0; f<m_faces.size(); ++f)
      for(const Index v : m_faces[f])
        m_vertex_faces[next[v]++] = Index(f);
  }

  void list_faces_around_faces(const std::vector<std::uint8_t>& constrained_edges)
  {
    std::vector<bool> is_restricted(m_points.size());
    for(std::size_t v=0; v<m_points.size(); ++v)
      is_restricted[v] = (faces_around_vertex(v).size() > max_sector_size);
    for(std::size_t f=0; f<constrained_edges.size(); ++f)
      for(int i=0; i<3; ++i)
        if(constrained_edges[f] & (1 << i))
          is_restricted[m_faces[f][i]] = is_restricted[m_faces[f][(i+1)%3]] = true;

    m_face_offsets.reserve(m_faces.size() + 1);
    m_face_offsets.push_back(0);
    m_face_faces.reserve(13 * m_faces.size());
    std::vector<Index> sector;
    for(std::size_t f=0; f<m_faces.size(); ++f)
    {
      const std::size_t first = m_face_faces.size();
      const auto insert = [&](const Index g)
      {
        if(g != f && std::find(m_face_faces.begin() + first, m_face_faces.end(), g) == m_face_faces.end())
          m_face_faces.push_back(g);
      };
      for(const Index v : m_faces[f])
      {
        if(is_restricted[v])
        {
          find_sector(v, f, sector);
          std::for_each(sector.begin(), sector.end(), insert);
        }
        else
        {
          const Index_range incident = faces_around_vertex(v);
          std::for_each(incident.begin(), incident.end(), insert);
        }
      }
      if(m_face_faces.size() > null_index())
        throw std::length_error("Surface_mesh_denoising: too many faces share vertices");
      m_face_offsets.push_back(Index(m_face_faces.size()));
    }
  }

  std::vector<Point_3> m_points;
  std::vector<std::array<Index, 3> > m_faces;
  std::vector<std::array<Index, 3> > m_neighbors;
  std::vector<std::uint8_t> m_border_edges; // bit i: the edge from vertex i to vertex (i+1)%3 has one face
  std::vector<Index> m_vertex_offsets, m_vertex_faces;
  std::vector<Index> m_face_offsets, m_face_faces;
};

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INDEXED_TRIANGLE_MESH_H
