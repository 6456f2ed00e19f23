// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_SURFACE_DISTANCE_QUERY_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_SURFACE_DISTANCE_QUERY_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>

#include <CGAL/AABB_tree.h>
#if __has_include(<CGAL/AABB_traits_3.h>)
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// a face of an Indexed_triangle_mesh in an AABB tree
class Face_primitive
{
public:
  typedef Indexed_triangle_mesh::Index         Id;
  typedef Indexed_triangle_mesh::Point_3       Point;
  typedef Simple_cartesian<double>::Triangle_3 Datum;
  typedef Point                                Point_reference;
  typedef Datum                                Datum_reference;

  struct Shared_data { const Indexed_triangle_mesh* mesh = nullptr; };

  Face_primitive() : m_face(0) {}
  template <typename Iterator>
  Face_primitive(const Iterator face, const Indexed_triangle_mesh&) : m_face(*face) {}

  static Shared_data construct_shared_data(const Indexed_triangle_mesh& mesh) { return Shared_data{ &mesh }; }

  Id id() const { return m_face; }
  Point reference_point(const Shared_data& data) const { return data.mesh->point(data.mesh->vertices(m_face)[0]); }
  Datum datum(const Shared_data& data) const
  {
    const std::array<Id, 3>& t = data.mesh->vertices(m_face);
    return Datum(data.mesh->point(t[0]), data.mesh->point(t[1]), data.mesh->point(t[2]));
  }

private:
  Id m_face;
};

// distances from points to the faces of a mesh whose area is not zero.
// Queries from several threads at a time are fine
class Surface_distance_query
{
#if __has_include(<CGAL/AABB_traits_3.h>)
  typedef AABB_traits_3<Simple_cartesian<double>, Face_primitive> Traits;
#else
  typedef AABB_traits<Simple_cartesian<double>, Face_primitive>   Traits;
#endif
  typedef Indexed_triangle_mesh::Index                            Index;
  typedef Indexed_triangle_mesh::Point_3                          Point_3;

public:
  // with `hints_are_near`, a query hands in the face that is probably near to its point
  Surface_distance_query(const Indexed_triangle_mesh& mesh, const std::vector<double>& areas, const bool hints_are_near)
    : m_mesh(mesh), m_areas(areas), m_hints_are_near(hints_are_near)
  {
    std::vector<Index> faces;
    for(std::size_t f=0; f<areas.size(); ++f)
      if(areas[f] > 0)
        faces.push_back(Index(f));
    if(faces.empty())
      throw std::invalid_argument("Surface_mesh_denoising: a mesh to measure the distance to has no area");

    if(m_hints_are_near)
      m_tree.do_not_accelerate_distance_queries();
    m_tree.insert(faces.begin(), faces.end(), mesh);
    m_tree.build();
  }

  double distance(const Point_3& p, const std::size_t face_hint) const
  {
    // the result must not depend on the queries before
    const double squared_distance = (m_hints_are_near && m_areas[face_hint] > 0)
      ? m_tree.squared_distance(p, m_mesh.point(m_mesh.vertices(face_hint)[0]))
      : m_tree.squared_distance(p);
    return std::sqrt(squared_distance);
  }

private:
  const Indexed_triangle_mesh& m_mesh;
  const std::vector<double>& m_areas;
  const bool m_hints_are_near;
  AABB_tree<Traits> m_tree;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_SURFACE_DISTANCE_QUERY_H
