// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_MESH_DUAL_GRAPH_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_MESH_DUAL_GRAPH_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/internal/named_parameters.h>
#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Neighborhood_search.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// The dual graph of a mesh of the user's, read only where a search comes to. Its coordinates are relative to a seed
// face, in units of the size of that face. Without a map (`Param_not_found`), face normals are those of the triangles.
template <typename TriangleMesh, typename VertexPointMap, typename FaceNormalMap, typename EdgeIsConstrainedMap>
class Mesh_dual_graph
{
  typedef boost::graph_traits<TriangleMesh>             Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor    halfedge_descriptor;
  typedef Indexed_triangle_mesh::Point_3                Point_3;
  typedef Indexed_triangle_mesh::Vector_3               Vector_3;

public:
  typedef typename Graph_traits::face_descriptor        Face;

  Mesh_dual_graph(const TriangleMesh& tmesh, const Face seed, const double omega, const VertexPointMap vertex_points,
                  const FaceNormalMap face_normals, const EdgeIsConstrainedMap edge_is_constrained)
    : m_tmesh(tmesh), m_vertex_points(vertex_points), m_face_normals(face_normals),
      m_edge_is_constrained(edge_is_constrained), m_omega(omega), m_origin(0, 0, 0), m_unit(1)
  {
    const std::array<Point_3, 3> t = triangle(seed);
    m_origin = t[0];
    const double size = std::sqrt((std::max)((t[1] - t[0]).squared_length(), (t[2] - t[0]).squared_length()));
    if(size > 0)
      m_unit = size;
  }

  double unit() const { return m_unit; }

  bool has_neighbor(const Face f, const int i) const
  {
    const halfedge_descriptor h = side(f, i);
    return !is_border(opposite(h, m_tmesh), m_tmesh) && !get(m_edge_is_constrained, edge(h, m_tmesh));
  }

  Face neighbor(const Face f, const int i) const { return face(opposite(side(f, i), m_tmesh), m_tmesh); }

  Dual_edge dual_edge(const Face f, const int i) const
  {
    const std::array<Point_3, 3> t = triangle(f), u = triangle(neighbor(f, i));
    return make_dual_edge(centroid(t[0], t[1], t[2]), centroid(u[0], u[1], u[2]), midpoint(t[i], t[(i+1)%3]),
                          normal(f), normal(neighbor(f, i)), m_omega);
  }

  Vector_3 normal(const Face f) const
  {
    if constexpr (std::is_same<FaceNormalMap, internal_np::Param_not_found>::value)
    {
      const std::array<Point_3, 3> t = triangle(f);
      return normalized_or_null(cross_product(t[1] - t[0], t[2] - t[0]));
    }
    else
    {
      const auto& n = get(m_face_normals, f);
      return Vector_3(CGAL::to_double(n.x()), CGAL::to_double(n.y()), CGAL::to_double(n.z()));
    }
  }

  double normal_weight() const { return m_omega; }

private:
  halfedge_descriptor side(const Face f, const int i) const
  {
    halfedge_descriptor h = halfedge(f, m_tmesh);
    for(int k=0; k<i; ++k)
      h = next(h, m_tmesh);
    return h;
  }

  // the points at the sources of the sides
  std::array<Point_3, 3> triangle(const Face f) const
  {
    if(side(f, 3) != side(f, 0))
      throw std::invalid_argument("Surface_mesh_denoising: the mesh is not a triangle mesh");
    std::array<Point_3, 3> t;
    for(int i=0; i<3; ++i)
    {
      const auto& p = get(m_vertex_points, source(side(f, i), m_tmesh));
      t[i] = Point_3((CGAL::to_double(p.x()) - m_origin.x()) / m_unit,
                     (CGAL::to_double(p.y()) - m_origin.y()) / m_unit,
                     (CGAL::to_double(p.z()) - m_origin.z()) / m_unit);
    }
    return t;
  }

  const TriangleMesh& m_tmesh;
  VertexPointMap m_vertex_points;
  FaceNormalMap m_face_normals;
  EdgeIsConstrainedMap m_edge_is_constrained;
  double m_omega;
  Point_3 m_origin;
  double m_unit;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_MESH_DUAL_GRAPH_H
