// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_FACE_REASSIGNMENT_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_FACE_REASSIGNMENT_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Adaptive_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Noise_map.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>
#include <CGAL/Surface_mesh_denoising/internal/to_eigen.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Filters of normals tell by majority on which side of an edge a face lies, so where noise is strong an edge here and there
// runs beside the true one. Here faces take over the plane of a neighbor across an edge if that explains the observed
// points better, by the sum over the vertices of the least energy
//   w |p - y|^2 + w t |n x (p - y)|^2 + k sum_f (n_f (p - c_f))^2 + m sum_q |p - q|^2
// that a vertex has anywhere, as its point p is to be near its observed point y, where noise is along the normals in the
// direction n of these, on the planes of its faces, and, as triangles are even more often than not, amidst its neighbors q.
template <typename ConcurrencyTag>
class Face_reassignment
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  // The planes are those through the centroids of the faces with these normals. Faces whose share, what they have of patches,
  // is less than a half keep theirs. `tangential_weight` is t above. Keeps references
  Face_reassignment(Indexed_triangle_mesh& mesh, const std::vector<Point_3>& observed,
                    const std::vector<bool>& is_movable, const Vertex_neighbors& neighbors, const Noise_map& noise,
                    const double tangential_weight, const std::vector<float>& shares,
                    const Adaptive_parameters& parameters, std::vector<Vector_3>& normals)
    : m_mesh(mesh), m_observed(observed), m_is_movable(is_movable), m_neighbors(neighbors), m_noise(noise),
      m_tangential_weight(tangential_weight), m_shares(shares), m_parameters(parameters), m_normals(normals),
      m_offsets(normals.size()), m_areas(normals.size()), m_points(mesh.points()), m_energies(mesh.number_of_vertices())
  {
    for_each_index<ConcurrencyTag>(m_offsets.size(), [&](const std::size_t f)
    {
      m_offsets[f] = m_normals[f] * (m_mesh.centroid(f) - ORIGIN);
      m_areas[f] = m_mesh.area(f);
    });
  }

  // changes the normals, and moves the vertices of faces that it changes to where their energy is least
  void run()
  {
    std::vector<Index> faces, vertices, moved;
    find_faces_at_edges(faces);
    for(const Index f : faces)
      vertices.insert(vertices.end(), m_mesh.vertices(f).begin(), m_mesh.vertices(f).end());
    add_neighbors(vertices);
    settle(vertices, m_parameters.reassignment_number_of_moves);

    std::vector<Change> changes;
    for(std::size_t round=0; round<m_parameters.reassignment_number_of_rounds && !faces.empty(); ++round)
    {
      changes.resize(faces.size());
      for_each_block<ConcurrencyTag>(faces.size(), [&](const std::size_t first, const std::size_t last)
      {
        std::vector<Index> changed_faces, their_vertices;
        for(std::size_t i=first; i<last; ++i)
          changes[i] = best_change(faces[i], changed_faces, their_vertices);
      });
      apply(changes, vertices);
      moved.insert(moved.end(), vertices.begin(), vertices.end());

      add_neighbors(vertices);
      settle(vertices, m_parameters.reassignment_number_of_moves);
      faces.clear();
      for(const Index v : vertices)
        faces.insert(faces.end(), m_mesh.faces_around_vertex(v).begin(), m_mesh.faces_around_vertex(v).end());
      make_set(faces);
    }

    std::vector<Point_3> points = m_mesh.points();
    for(const Index v : moved)
      points[v] = m_points[v];
    m_mesh.swap_points(points);
  }

private:
  // A face takes over the plane of its neighbor across one of its edges, and with it, around either end of the edge or
  // both, the faces next to it that lie on its side
  struct Change
  {
    Index face;
    std::uint8_t edge;
    std::array<bool, 2> around_end;
    double gain;
  };

  // that of a vertex which moves by d: constant - 2 vector d + d matrix d
  struct Energy
  {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d vector = Eigen::Vector3d::Zero();
    double constant = 0;
    double least = 0;
    double across = 0;                    // the weight of ways from the observed point across the normal,
    Vector_3 area_vector{0, 0, 0};        // which has the direction of this

    void add_point(const double weight, const Vector_3& way)
    {
      matrix.diagonal().array() += weight;
      vector += weight * to_eigen(way);
      constant += weight * way.squared_length();
    }

    void add_plane(const double weight, const Vector_3& normal, const double distance)
    {
      const Eigen::Vector3d n = to_eigen(normal);
      matrix += weight * n * n.transpose();
      vector += weight * distance * n;
      constant += weight * distance * distance;
    }

    Eigen::Vector3d best_move() const { return matrix.inverse() * vector; }
  };

  static void make_set(std::vector<Index>& indices)
  {
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  }

  void add_neighbors(std::vector<Index>& vertices) const
  {
    make_set(vertices);
    const std::size_t n = vertices.size();
    for(std::size_t i=0; i<n; ++i)
      vertices.insert(vertices.end(), m_neighbors(vertices[i]).begin(), m_neighbors(vertices[i]).end());
    make_set(vertices);
  }

  // Whether face `g` lies on one side of an edge, with a face on the other side beside face `f`, whose plane is another than
  // that of `g`: that of the other side or, as blended normals are, one in between. Faces of a bent surface without
  // edges differ, too, and keep their planes
  bool is_edge(const std::size_t f, const Index g) const
  {
    if(g == Indexed_triangle_mesh::null_index() || m_shares[f] < 0.5 || m_shares[g] < 0.5
       || m_normals[f] * m_normals[g] >= m_parameters.reassignment_plane_cosine)
      return false;
    const auto around = m_mesh.faces_around_face(f);
    return std::any_of(around.begin(), around.end(), [&](const Index h)
    { return m_normals[h] * m_normals[g] < m_parameters.reassignment_edge_cosine; });
  }

  // Where triangles are much smaller than the noise, their planes mean nothing
  bool is_as_large_as_noise(const std::size_t f) const
  {
    return mean_height_of_faces(m_mesh, m_mesh.faces_around_face(f), [&](const Index g) { return m_mesh.area(g); })
         > m_parameters.reassignment_least_height * m_noise.level * m_noise.ratio_of_face(m_mesh, f);
  }

  void find_faces_at_edges(std::vector<Index>& faces) const
  {
    std::vector<std::uint8_t> is_at_edge(m_mesh.number_of_faces());
    for_each_index<ConcurrencyTag>(is_at_edge.size(), [&](const std::size_t f)
    {
      const std::array<Index, 3>& neighbors = m_mesh.neighbors(f);
      is_at_edge[f] = std::any_of(neighbors.begin(), neighbors.end(), [&](const Index g) { return is_edge(f, g); });
    });
    for(std::size_t f=0; f<is_at_edge.size(); ++f)
      if(is_at_edge[f])
        faces.push_back(Index(f));
  }

  double distance_to_plane(const std::size_t f, const std::size_t v) const
  {
    return m_offsets[f] - m_normals[f] * (m_points[v] - ORIGIN);
  }

  double least_energy(const Energy& energy, const std::size_t v) const
  {
    return m_is_movable[v] ? energy.constant - energy.vector.dot(energy.best_move()) : energy.constant;
  }

  void add_way_along_normal(Energy& energy, const double weight, const std::size_t v) const
  {
    const double length = std::sqrt(energy.area_vector.squared_length());
    if(!(length > 0))
      return;
    const Vector_3 normal = energy.area_vector / length;
    energy.add_plane(weight, normal, normal * (m_observed[v] - m_points[v]));
  }

  Energy compute_energy(const std::size_t v) const
  {
    Energy energy;
    // an observed point that is further away than noise explains, as one with an impulse, tells little
    const double reach = m_parameters.reassignment_reach * m_noise.at(v);
    const double squared_residual = squared_distance(m_observed[v], m_mesh.point(v));
    const double weight = (squared_residual > reach * reach) ? reach * reach / squared_residual : 1;
    energy.across = m_tangential_weight * weight;
    energy.add_point(weight + energy.across, m_observed[v] - m_points[v]);
    for(const Index f : m_mesh.faces_around_vertex(v))
    {
      energy.add_plane(m_parameters.reassignment_stiffness, m_normals[f], distance_to_plane(f, v));
      energy.area_vector = energy.area_vector + m_areas[f] * m_normals[f];
    }
    add_way_along_normal(energy, -energy.across, v);
    if(m_neighbors.is_inside(v))
    {
      double squared_length = 0;
      for(const Index w : m_neighbors(v))
        squared_length += squared_distance(m_mesh.point(v), m_mesh.point(w));
      squared_length /= double(m_neighbors(v).size());
      if(squared_length > 0)
        for(const Index w : m_neighbors(v))
          energy.add_point(m_parameters.reassignment_evenness * m_noise.at(v) * m_noise.at(v) / squared_length,
                           m_points[w] - m_points[v]);
    }
    energy.least = least_energy(energy, v);
    return energy;
  }

  // moves vertices to where their energies are least, again and again as their neighbors move, too
  void settle(const std::vector<Index>& vertices, const std::size_t number_of_moves)
  {
    for(std::size_t k=0; ; ++k)
    {
      for_each_index<ConcurrencyTag>(vertices.size(), [&](const std::size_t i)
      { m_energies[vertices[i]] = compute_energy(vertices[i]); });
      if(k == number_of_moves)
        return;
      for_each_index<ConcurrencyTag>(vertices.size(), [&](const std::size_t i)
      {
        const Index v = vertices[i];
        if(!m_is_movable[v])
          return;
        const Eigen::Vector3d d = m_energies[v].best_move();
        m_points[v] = m_points[v] + Vector_3(d[0], d[1], d[2]);
      });
    }
  }

  // lists the faces that a change is about, and their vertices
  void list_faces(const Change& change, std::vector<Index>& faces, std::vector<Index>& vertices) const
  {
    faces.assign(1, change.face);
    for(const int end : {0, 1})
      if(change.around_end[end])
        add_faces_of_side(change.face, m_mesh.neighbors(change.face)[change.edge],
                          m_mesh.vertices(change.face)[(change.edge + end) % 3], faces);
    vertices.clear();
    for(const Index f : faces)
      for(const Index v : m_mesh.vertices(f))
        if(std::find(vertices.begin(), vertices.end(), v) == vertices.end())
          vertices.push_back(v);
  }

  // from `f` on around `v`, away from `g`, as long as normals are closer to that of `f` than to that of `g`
  void add_faces_of_side(const Index f, const Index g, const Index v, std::vector<Index>& faces) const
  {
    Index current = f, previous = g;
    for(;;)
    {
      const std::array<Index, 3>& t = m_mesh.vertices(current);
      Index next = Indexed_triangle_mesh::null_index();
      for(int i=0; i<3; ++i)
        if((t[i] == v || t[(i+1)%3] == v) && m_mesh.neighbors(current)[i] != previous)
          next = m_mesh.neighbors(current)[i];
      if(next == Indexed_triangle_mesh::null_index() || next == g
         || !(m_normals[next] * m_normals[f] > m_normals[next] * m_normals[g])
         || std::find(faces.begin(), faces.end(), next) != faces.end())
        return;
      faces.push_back(next);
      previous = current;
      current = next;
    }
  }

  // the best of those that begin at face `f`; its gain is zero if there is none. `faces` and `vertices` are for use inside
  Change best_change(const Index f, std::vector<Index>& faces, std::vector<Index>& vertices) const
  {
    const double least_gain = 1e-6 * m_noise.level * m_noise.level; // less may be rounding
    Change best = { f, 0, {{ false, false }}, 0 };
    if(!is_as_large_as_noise(f))
      return best;
    for(std::uint8_t edge=0; edge<3; ++edge)
    {
      const Index g = m_mesh.neighbors(f)[edge];
      if(!is_edge(f, g))
        continue;
      for(const bool around_first : {false, true})
        for(const bool around_second : {false, true})
        {
          Change change = { f, edge, {{ around_first, around_second }}, 0 };
          list_faces(change, faces, vertices);
          if((around_first || around_second) && faces.size() == 1)
            continue;
          for(const Index v : vertices)
          {
            Energy energy = m_energies[v];
            add_way_along_normal(energy, energy.across, v);
            for(const Index h : faces)
              if(std::find(m_mesh.vertices(h).begin(), m_mesh.vertices(h).end(), v) != m_mesh.vertices(h).end())
              {
                energy.add_plane(-m_parameters.reassignment_stiffness, m_normals[h], distance_to_plane(h, v));
                energy.add_plane(m_parameters.reassignment_stiffness, m_normals[g], distance_to_plane(g, v));
                energy.area_vector = energy.area_vector + m_areas[h] * (m_normals[g] - m_normals[h]);
              }
            add_way_along_normal(energy, -energy.across, v);
            change.gain += m_energies[v].least - least_energy(energy, v);
          }
          if(change.gain > (std::max)(best.gain, least_gain))
            best = change;
        }
    }
    return best;
  }

  // makes changes in the order of their gains, but none where another one has changed a vertex's faces. `vertices` are those of
  // the faces that have changed
  void apply(std::vector<Change>& changes, std::vector<Index>& vertices)
  {
    changes.erase(std::remove_if(changes.begin(), changes.end(), [](const Change& c) { return !(c.gain > 0); }),
                  changes.end());
    std::sort(changes.begin(), changes.end(), [](const Change& a, const Change& b)
    { return a.gain > b.gain || (a.gain == b.gain && a.face < b.face); });

    vertices.clear();
    std::vector<bool> has_changed(m_mesh.number_of_vertices());
    std::vector<Index> faces, their_vertices;
    for(const Change& change : changes)
    {
      list_faces(change, faces, their_vertices);
      if(std::any_of(their_vertices.begin(), their_vertices.end(), [&](const Index v) { return has_changed[v]; }))
        continue;
      const Index g = m_mesh.neighbors(change.face)[change.edge];
      for(const Index f : faces)
      {
        m_normals[f] = m_normals[g];
        m_offsets[f] = m_offsets[g];
      }
      for(const Index v : their_vertices)
        has_changed[v] = true;
      vertices.insert(vertices.end(), their_vertices.begin(), their_vertices.end());
    }
  }

  Indexed_triangle_mesh& m_mesh;
  const std::vector<Point_3>& m_observed;
  const std::vector<bool>& m_is_movable;
  const Vertex_neighbors& m_neighbors;
  const Noise_map& m_noise;
  double m_tangential_weight;
  const std::vector<float>& m_shares;
  const Adaptive_parameters& m_parameters;

  std::vector<Vector_3>& m_normals; // of the planes,
  std::vector<double> m_offsets;    // their distances from the origin,
  std::vector<double> m_areas;      // and how much of them there is
  std::vector<Point_3> m_points;    // where the energies are about least
  std::vector<Energy> m_energies;   // of vertices near edges
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_FACE_REASSIGNMENT_H
