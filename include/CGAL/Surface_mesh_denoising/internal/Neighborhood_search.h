// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_NEIGHBORHOOD_SEARCH_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_NEIGHBORHOOD_SEARCH_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Local_numbering.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/dijkstra_shortest_paths_no_color_map.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// What the normal-weighted distance needs of the dual edge between faces j and k. As seen from seed i its weight is
//   length [1 + omega (A + B + C)],  A = |n_j - n_k|^2 / 6,  B = |n_i - n_j|^2 / 2,  C = |n_i - n_k|^2 / 2
struct Dual_edge
{
  double length;          // |c_j - m_jk| + |c_k - m_jk|
  double seedless_weight; // length [1 + omega A]
};

inline Dual_edge make_dual_edge(const Indexed_triangle_mesh::Point_3& centroid_j,
                                const Indexed_triangle_mesh::Point_3& centroid_k,
                                const Indexed_triangle_mesh::Point_3& edge_midpoint,
                                const Indexed_triangle_mesh::Vector_3& normal_j,
                                const Indexed_triangle_mesh::Vector_3& normal_k,
                                const double omega)
{
  const double length = std::sqrt(squared_distance(centroid_j, edge_midpoint))
                      + std::sqrt(squared_distance(centroid_k, edge_midpoint));
  return { length, length * (1 + omega * (normal_j - normal_k).squared_length() / 6) };
}

// The dual graph of an indexed mesh, with its lengths and angles computed once for all seeds.
class Indexed_dual_graph
{
public:
  typedef Indexed_triangle_mesh::Index    Face;
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;

  // keeps references
  template <typename ConcurrencyTag>
  Indexed_dual_graph(const Indexed_triangle_mesh& mesh, const std::vector<Vector_3>& normals,
                     const double omega, std::vector<std::array<Dual_edge, 3> >& edges, ConcurrencyTag)
    : m_mesh(mesh), m_normals(normals), m_edges(edges), m_omega(omega)
  {
    edges.resize(mesh.number_of_faces());
    for_each_index<ConcurrencyTag>(mesh.number_of_faces(), [&](const std::size_t f)
    {
      for(int i=0; i<3; ++i)
      {
        const Face g = mesh.neighbors(f)[i];
        if(g == Indexed_triangle_mesh::null_index())
          continue;
        const std::array<Face, 3>& t = mesh.vertices(f);
        edges[f][i] = make_dual_edge(mesh.centroid(f), mesh.centroid(g),
                                     midpoint(mesh.point(t[i]), mesh.point(t[(i+1)%3])),
                                     normals[f], normals[g], omega);
      }
    });
  }

  bool has_neighbor(const Face f, const int i) const
  { return m_mesh.neighbors(f)[i] != Indexed_triangle_mesh::null_index(); }
  Face neighbor(const Face f, const int i) const { return m_mesh.neighbors(f)[i]; }
  Dual_edge dual_edge(const Face f, const int i) const { return m_edges[f][i]; }
  const Vector_3& normal(const Face f) const { return m_normals[f]; }
  double normal_weight() const { return m_omega; }

private:
  const Indexed_triangle_mesh& m_mesh;
  const std::vector<Vector_3>& m_normals;
  const std::vector<std::array<Dual_edge, 3> >& m_edges;
  double m_omega;
};

// Finds the faces nearest to a seed face, in the normal-weighted distance, with Boost's Dijkstra. The graph that Boost sees, the
// nested `View`, is the part of the dual graph that the search meets, with local indices: so a search costs what its faces
// cost, whatever the size of the mesh. An object may be used again and again, by one thread.
//
// `DualGraph` has the type `Face`, which std::hash takes, and
//   bool has_neighbor(Face, int), Face neighbor(Face, int), Dual_edge dual_edge(Face, int)  for 0, 1, 2
//   Vector_3 normal(Face), double normal_weight()
template <typename DualGraph>
class Neighborhood_search
{
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;
  typedef typename DualGraph::Face          Face;
  typedef typename Local_numbering<Face>::Local_index Local_index;

public:
  struct Neighbor
  {
    Face face;
    double distance;
  };

  // the fewer faces there are in all, if they are counted, the less memory is filled for each search
  explicit Neighborhood_search(const DualGraph& dual,
                               const std::size_t number_of_faces = (std::numeric_limits<std::size_t>::max)())
    : m_dual(dual), m_number_of_faces(number_of_faces)
  {}

  // the `n` faces nearest to `seed` (fewer if there are no more), the nearest, `seed` itself, first
  const std::vector<Neighbor>& operator()(const Face seed, const std::size_t n)
  {
    return (*this)(seed, n, [](const Neighbor&) { return true; });
  }

  // the same, but the search ends as soon as `goes_on(neighbor)`, called for each face in this order, says no
  template <typename GoesOn>
  const std::vector<Neighbor>& operator()(const Face seed, const std::size_t n, const GoesOn& goes_on)
  {
    reserve(n);
    m_seed_normal = m_dual.normal(seed);
    m_neighborhood.clear();
    m_nodes.clear();
    m_numbering.clear();
    const Local_index start = local_index(seed);
    m_distances[start] = 0;

    const auto distance_map
      = boost::make_iterator_property_map(m_distances.begin(), boost::typed_identity_property_map<Local_index>());
    boost::dijkstra_shortest_paths_no_color_map_no_init(
      View{this}, start, boost::dummy_property_map(), distance_map, Weight_map(),
      boost::typed_identity_property_map<Local_index>(), std::less<double>(), std::plus<double>(),
      (std::numeric_limits<double>::max)(), 0., Visitor<GoesOn>(this, goes_on));
    return m_neighborhood;
  }

  // the number of faces that the last search met
  std::size_t number_of_met_faces() const { return m_nodes.size(); }

  // The part of the dual graph that a search meets: a model of Boost's IncidenceGraph
  struct View
  {
    typedef Local_index                          vertex_descriptor;
    struct edge_descriptor { Local_index source, target; double weight; };
    typedef const edge_descriptor*               out_edge_iterator;
    typedef boost::directed_tag                  directed_category;
    typedef boost::disallow_parallel_edge_tag    edge_parallel_category;
    typedef std::size_t                          vertices_size_type;
    typedef std::size_t                          edges_size_type;
    typedef std::size_t                          degree_size_type;
    // of a VertexListGraph only the number of vertices is used: Boost's heap then keeps its indices in one array
    struct traversal_category : boost::incidence_graph_tag, boost::vertex_list_graph_tag {};

    typedef std::pair<out_edge_iterator, out_edge_iterator> Edge_range;

    Neighborhood_search* search;

    std::size_t max_number_of_nodes() const { return search->m_distances.size(); }
    Edge_range edges_from(const Local_index u) const { return search->edges_from(u); }

    friend Local_index source(const edge_descriptor& e, const View&) { return e.source; }
    friend Local_index target(const edge_descriptor& e, const View&) { return e.target; }
    friend std::size_t num_vertices(const View& g) { return g.max_number_of_nodes(); }
    friend Edge_range out_edges(const Local_index u, const View& g) { return g.edges_from(u); }
    friend std::size_t out_degree(const Local_index u, const View& g)
    {
      const Edge_range edges = g.edges_from(u);
      return edges.second - edges.first;
    }
  };

private:
  typedef typename View::edge_descriptor Edge;

  struct Weight_map
  {
    typedef Edge                                 key_type;
    typedef double                               value_type;
    typedef double                               reference;
    typedef boost::readable_property_map_tag     category;
    friend double get(const Weight_map&, const Edge& e) { return e.weight; }
  };

  template <typename GoesOn>
  struct Visitor : boost::dijkstra_visitor<>
  {
    Neighborhood_search* search;
    const GoesOn* goes_on;
    Visitor(Neighborhood_search* search, const GoesOn& goes_on) : search(search), goes_on(&goes_on) {}
    void examine_vertex(const Local_index u, const View&) const
    {
      search->settle(u);
      // Boost ends a search when the nearest node is not nearer than infinity
      if(!(*goes_on)(search->m_neighborhood.back()) || search->m_neighborhood.size() == search->m_size)
        search->m_distances[u] = (std::numeric_limits<double>::max)();
    }
  };

  // a face with a local index
  struct Node
  {
    Face face;
    double squared_normal_difference; // |n_seed - n_face|^2
    bool is_settled;
  };

  void reserve(const std::size_t n)
  {
    if(n == m_size)
      return;
    m_size = n;
    // the seed has three neighbors, and each further face that is settled brings at most two new ones
    const std::size_t max_number_of_nodes = (std::min)(2*n + 2, m_number_of_faces);
    m_distances.resize(max_number_of_nodes);
    m_nodes.reserve(max_number_of_nodes);
    m_neighborhood.reserve(n);
  }

  void settle(const Local_index u)
  {
    m_nodes[u].is_settled = true;
    m_neighborhood.push_back(Neighbor{m_nodes[u].face, m_distances[u]});
  }

  // the edges from `u` to the faces that are not settled yet: no path through the others is shorter
  typename View::Edge_range edges_from(const Local_index u)
  {
    Edge* const first = m_out_edges.data();
    Edge* last = first;
    const Node node = m_nodes[u];
    for(int i=0; i<3; ++i)
    {
      if(!m_dual.has_neighbor(node.face, i))
        continue;
      const Local_index v = local_index(m_dual.neighbor(node.face, i));
      if(m_nodes[v].is_settled)
        continue;
      const Dual_edge e = m_dual.dual_edge(node.face, i);
      const double b_plus_c
        = 0.5 * (node.squared_normal_difference + m_nodes[v].squared_normal_difference);
      *last++ = Edge{u, v, e.seedless_weight + m_dual.normal_weight() * e.length * b_plus_c};
    }
    return { first, last };
  }

  Local_index local_index(const Face& face)
  {
    const std::pair<Local_index, bool> result = m_numbering.insert(face);
    if(result.second)
    {
      m_distances[result.first] = (std::numeric_limits<double>::max)();
      m_nodes.push_back(Node{face, (m_dual.normal(face) - m_seed_normal).squared_length(), false});
    }
    return result.first;
  }

  const DualGraph& m_dual;
  std::size_t m_number_of_faces;
  std::size_t m_size = 0;
  Vector_3 m_seed_normal;
  std::vector<Neighbor> m_neighborhood;
  std::vector<Node> m_nodes;
  std::vector<double> m_distances;
  std::array<Edge, 3> m_out_edges; // of one node: Boost is done with those before
  Local_numbering<Face> m_numbering;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_NEIGHBORHOOD_SEARCH_H
