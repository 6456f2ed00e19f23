// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_MESH_IO_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_MESH_IO_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/internal/named_parameters.h>
#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/check_parameters.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

typedef Indexed_triangle_mesh::Index    Index;
typedef Indexed_triangle_mesh::Point_3  Point_3;
typedef Indexed_triangle_mesh::Vector_3 Vector_3;

// moves the center of the points' bounding box to the origin and scales it, by a power of two, to a size of about one:
// no square of a length over- or underflows, and the unit of the coordinates plays no part
class Normalization
{
public:
  Normalization() : m_center{{0, 0, 0}}, m_exponent(0) {}

  explicit Normalization(const std::vector<Point_3>& points) : Normalization()
  {
    double half_extent = 0;
    for(int k=0; k<3 && !points.empty(); ++k)
    {
      const auto extrema = std::minmax_element(points.begin(), points.end(),
                                               [k](const Point_3& p, const Point_3& q) { return p[k] < q[k]; });
      const double low = (*extrema.first)[k], high = (*extrema.second)[k];
      m_center[k] = 0.5*low + 0.5*high;
      half_extent = (std::max)(half_extent, 0.5*high - 0.5*low);
    }
    if(half_extent > 0)
      m_exponent = std::ilogb(half_extent) + 1;
  }

  Point_3 inside(const Point_3& p) const { return Point_3(inside(p.x(), 0), inside(p.y(), 1), inside(p.z(), 2)); }
  Point_3 outside(const Point_3& p) const { return Point_3(outside(p.x(), 0), outside(p.y(), 1), outside(p.z(), 2)); }
  double length_outside(const double length) const { return std::ldexp(length, m_exponent); }

private:
  // halves, as the difference of two finite numbers need not be finite
  double inside(const double x, const int k) const { return std::ldexp(0.5*x - 0.5*m_center[k], 1 - m_exponent); }
  double outside(const double x, const int k) const { return m_center[k] + std::ldexp(x, m_exponent); }

  std::array<double, 3> m_center;
  int m_exponent;
};

// the index map that the user passes, or else one that numbers the elements in their order in the mesh
template <typename DynamicTag, typename InternalTag, typename TriangleMesh, typename Range, typename NamedParameters>
auto contiguous_index_map(const TriangleMesh& tmesh, const Range& elements, const InternalTag tag, const char* name,
                          const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters, InternalTag>::value)
  {
    CGAL_USE(tag);
    CGAL_USE(name);
    auto index_map = get(DynamicTag(), tmesh);
    Index i = 0;
    for(const auto element : elements)
      put(index_map, element, i++);
    return index_map;
  }
  else
  {
    auto index_map = parameters::get_parameter(np, tag);
    std::vector<bool> is_taken(elements.size(), false);
    for(const auto element : elements)
    {
      const std::size_t i = static_cast<std::size_t>(get(index_map, element));
      if(i >= is_taken.size() || is_taken[i])
        throw std::invalid_argument(std::string("Surface_mesh_denoising: the parameter ") + name
                                    + " must give each element an index of its own, from 0 on without a gap");
      is_taken[i] = true;
    }
    return index_map;
  }
}

// a mesh of the user's: read once, into indices and normalized coordinates, and written once
template <typename TriangleMesh, typename VertexPointMap, typename NamedParameters>
class Mesh_io
{
  typedef boost::graph_traits<TriangleMesh>                                             Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor                                    halfedge_descriptor;

public:
  typedef typename Graph_traits::vertex_descriptor                                      vertex_descriptor;
  typedef typename Graph_traits::face_descriptor                                        face_descriptor;
  typedef typename boost::property_traits<VertexPointMap>::value_type                   Point;
  typedef typename Require_floating_point<
    typename GetGeomTraits<TriangleMesh, NamedParameters>::type::FT>::type              FT;

  // `range` holds the vertices that may move, or faces: then the vertices may move that have no other faces
  template <typename Range>
  Mesh_io(const Range& range, const TriangleMesh& tmesh, const VertexPointMap vertex_point_map,
          const NamedParameters& np)
    : m_vertex_point_map(vertex_point_map)
  {
    typedef CGAL::dynamic_vertex_property_t<Index> Vertex_index_tag;
    typedef CGAL::dynamic_face_property_t<Index> Face_index_tag;
    m_vertices.assign(std::begin(vertices(tmesh)), std::end(vertices(tmesh)));
    m_faces.assign(std::begin(faces(tmesh)), std::end(faces(tmesh)));
    const auto vertex_index
      = contiguous_index_map<Vertex_index_tag>(tmesh, m_vertices, internal_np::vertex_index, "vertex_index_map", np);
    const auto face_index
      = contiguous_index_map<Face_index_tag>(tmesh, m_faces, internal_np::face_index, "face_index_map", np);
    sort_by_index(m_vertices, vertex_index);
    sort_by_index(m_faces, face_index);

    read_points();
    read_faces(tmesh, vertex_index, face_index, np);
    read_movable_vertices(range, vertex_index, face_index, np);
  }

  std::size_t number_of_vertices() const { return m_vertices.size(); }
  const std::vector<bool>& is_movable() const { return m_is_movable; }
  const Normalization& normalization() const { return m_normalization; }

  // the mesh in normalized coordinates; to be called once
  Indexed_triangle_mesh take_mesh()
  {
    return Indexed_triangle_mesh(std::move(m_points), std::move(m_triangles), std::move(m_neighbors),
                                 std::exchange(m_constrained_edges, {}));
  }

  // sets the points that differ from those that were read. If that throws, all points are as they were
  void write_points(const std::vector<Point_3>& original, const std::vector<Point_3>& points) const
  {
    std::vector<std::pair<vertex_descriptor, Point> > replaced;
    try
    {
      for(std::size_t v=0; v<points.size(); ++v)
      {
        if(points[v] == original[v])
          continue;
        const Point_3 p = m_normalization.outside(points[v]);
        const FT x = FT(p.x()), y = FT(p.y()), z = FT(p.z());
        // the range of FT may be smaller than that of double
        if(!(std::isfinite(x) && std::isfinite(y) && std::isfinite(z)))
          continue;
        replaced.emplace_back(m_vertices[v], Point(get(m_vertex_point_map, m_vertices[v])));
        put(m_vertex_point_map, m_vertices[v], Point(x, y, z));
      }
    }
    catch(...)
    {
      for(const auto& r : replaced)
        put(m_vertex_point_map, r.first, r.second);
      throw;
    }
  }

  template <typename FaceNormalMap>
  void write_face_normals(const std::vector<Vector_3>& normals, FaceNormalMap map) const
  { write_vectors(m_faces, normals, map); }

  template <typename VertexNormalMap>
  void write_vertex_normals(const std::vector<Vector_3>& normals, VertexNormalMap map) const
  { write_vectors(m_vertices, normals, map); }

private:
  template <typename Descriptor, typename IndexMap>
  static void sort_by_index(std::vector<Descriptor>& descriptors, const IndexMap index_map)
  {
    std::vector<Descriptor> sorted(descriptors.size());
    for(const Descriptor& d : descriptors)
      sorted[static_cast<std::size_t>(get(index_map, d))] = d;
    descriptors.swap(sorted);
  }

  void read_points()
  {
    m_points.reserve(m_vertices.size());
    for(const vertex_descriptor v : m_vertices)
    {
      const auto& p = get(m_vertex_point_map, v);
      const Point_3 q(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
      if(!(std::isfinite(q.x()) && std::isfinite(q.y()) && std::isfinite(q.z())))
      {
        std::ostringstream message;
        message << "Surface_mesh_denoising: vertex " << m_points.size() << " has the coordinates (" << q
                << "), which are not all finite";
        throw std::invalid_argument(message.str());
      }
      m_points.push_back(q);
    }
    m_normalization = Normalization(m_points);
    for(Point_3& p : m_points)
      p = m_normalization.inside(p);
  }

  template <typename VertexIndexMap, typename FaceIndexMap>
  void read_faces(const TriangleMesh& tmesh, const VertexIndexMap vertex_index, const FaceIndexMap face_index,
                  const NamedParameters& np)
  {
    typedef Static_boolean_property_map<typename Graph_traits::edge_descriptor, false> No_edge;
    const auto is_constrained
      = parameters::choose_parameter(parameters::get_parameter(np, internal_np::edge_is_constrained), No_edge());
    constexpr bool has_constraints
      = !parameters::is_default_parameter<NamedParameters, internal_np::edge_is_constrained_t>::value;

    m_triangles.resize(m_faces.size());
    m_neighbors.resize(m_faces.size());
    m_constrained_edges.resize(has_constraints ? m_faces.size() : 0, 0);
    for(std::size_t f=0; f<m_faces.size(); ++f)
    {
      halfedge_descriptor h = halfedge(m_faces[f], tmesh);
      for(int i=0; i<3; ++i, h = next(h, tmesh))
      {
        const face_descriptor g = face(opposite(h, tmesh), tmesh);
        m_triangles[f][i] = static_cast<Index>(get(vertex_index, source(h, tmesh)));
        m_neighbors[f][i] = (g == Graph_traits::null_face()) ? Indexed_triangle_mesh::null_index()
                                                             : static_cast<Index>(get(face_index, g));
        if(has_constraints && get(is_constrained, edge(h, tmesh)))
          m_constrained_edges[f] |= std::uint8_t(1 << i);
      }
      if(h != halfedge(m_faces[f], tmesh))
        throw std::invalid_argument("Surface_mesh_denoising: the mesh is not a triangle mesh, face "
                                    + std::to_string(f) + " has not three edges");
    }
  }

  template <typename Range, typename VertexIndexMap, typename FaceIndexMap>
  void read_movable_vertices(const Range& range, const VertexIndexMap vertex_index, const FaceIndexMap face_index,
                             const NamedParameters& np)
  {
    typedef typename std::iterator_traits<decltype(std::begin(range))>::value_type Descriptor;
    m_is_movable.assign(m_vertices.size(), false);
    if constexpr (std::is_same<Descriptor, vertex_descriptor>::value)
    {
      for(const vertex_descriptor v : range)
        m_is_movable[get(vertex_index, v)] = true;
    }
    else
    {
      static_assert(std::is_same<Descriptor, face_descriptor>::value,
                    "The range must hold vertex descriptors or face descriptors of the mesh.");
      std::vector<bool> is_in_range(m_faces.size(), false);
      for(const face_descriptor f : range)
        is_in_range[get(face_index, f)] = true;
      for(const bool in_range : {true, false})
        for(std::size_t f=0; f<m_faces.size(); ++f)
          if(is_in_range[f] == in_range)
            for(const Index v : m_triangles[f])
              m_is_movable[v] = in_range;
    }

    typedef Static_boolean_property_map<vertex_descriptor, false> No_vertex;
    const auto is_constrained
      = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_is_constrained), No_vertex());
    for(std::size_t v=0; v<m_vertices.size(); ++v)
      if(get(is_constrained, m_vertices[v]))
        m_is_movable[v] = false;
  }

  template <typename Descriptor, typename VectorMap>
  static void write_vectors(const std::vector<Descriptor>& descriptors, const std::vector<Vector_3>& vectors,
                            VectorMap map)
  {
    typedef typename boost::property_traits<VectorMap>::value_type Vector;
    for(std::size_t i=0; i<descriptors.size(); ++i)
      put(map, descriptors[i], Vector(FT(vectors[i].x()), FT(vectors[i].y()), FT(vectors[i].z())));
  }

  VertexPointMap m_vertex_point_map;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<face_descriptor> m_faces;
  Normalization m_normalization;
  std::vector<Point_3> m_points;
  std::vector<std::array<Index, 3> > m_triangles;
  std::vector<std::array<Index, 3> > m_neighbors;
  std::vector<std::uint8_t> m_constrained_edges;
  std::vector<bool> m_is_movable;
};

template <typename Range, typename TriangleMesh, typename VertexPointMap, typename NamedParameters>
Mesh_io<TriangleMesh, VertexPointMap, NamedParameters>
read_mesh(const Range& range, const TriangleMesh& tmesh, const VertexPointMap vertex_point_map,
          const NamedParameters& np)
{
  return Mesh_io<TriangleMesh, VertexPointMap, NamedParameters>(range, tmesh, vertex_point_map, np);
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_MESH_IO_H
