// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_FACE_UNFOLDING_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_FACE_UNFOLDING_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Adaptive_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>
#include <CGAL/Surface_mesh_denoising/internal/to_eigen.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Where noise turned faces against the faces around them, their vertices slide along the surface until the faces face
// outwards, and no further than noise may have moved them: to the center of their neighbors if that does, or else by as
// little as the faces' areas ask for. What then is left are clusters of turned faces, which no vertex can unfold alone: going
// to the centers whatever that does to single faces, their vertices do so together. The border has no centers.
template <typename ConcurrencyTag>
class Face_unfolding
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  // `noise_turns_faces` tells that noise may have turned faces of `observed`. Keeps references
  Face_unfolding(Indexed_triangle_mesh& mesh, const std::vector<Point_3>& observed, const std::vector<bool>& is_movable,
                 const Vertex_neighbors& neighbors, const double noise, const bool noise_turns_faces,
                 const Unfolding_limits& limits, const Adaptive_parameters& parameters)
    : m_mesh(mesh), m_observed(observed), m_is_movable(is_movable), m_neighbors(neighbors), m_parameters(parameters),
      m_limits(limits), m_squared_noise(noise * noise), m_noise_turns_faces(noise_turns_faces), m_original(mesh.points()),
      m_outwards(mesh.number_of_faces()), m_mean_areas(mesh.number_of_faces()), m_is_folded(mesh.number_of_faces())
  {}

  void run()
  {
    std::vector<Point_3> points;
    for(std::size_t round=0; round<m_parameters.unfolding_number_of_rounds; ++round)
    {
      find_folded_faces(round == 0);
      if(std::find(m_is_folded.begin(), m_is_folded.end(), 1) == m_is_folded.end())
        return;
      points = m_mesh.points();
      for_each_index<ConcurrencyTag>(points.size(), [&](const std::size_t v)
      {
        const auto faces = m_mesh.faces_around_vertex(v);
        if(m_is_movable[v] && std::any_of(faces.begin(), faces.end(), [&](const Index f) { return m_is_folded[f] != 0; })
           && (m_neighbors.is_at_border(v)
               || !go_to_center(v, round >= m_parameters.unfolding_rounds_with_care, points[v]))
           && round >= m_parameters.unfolding_rounds_of_centers)
          make_room(v, points[v]);
      });
      m_mesh.swap_points(points);
    }
  }

private:
  // Where the faces around do not agree, as at an edge, a turned face may be part of the shape. So may one that is turned in
  // the observed mesh, unless noise has done that, or there are many in the whole mesh.
  void find_folded_faces(const bool is_first_round)
  {
    compute_face_normals<ConcurrencyTag>(m_mesh, m_normals, m_areas);
    m_around.resize(m_mesh.number_of_faces());
    for_each_index<ConcurrencyTag>(m_around.size(), [&](const std::size_t f)
    { m_around[f] = surroundings(m_mesh, f, m_normals, m_areas); });
    for_each_index<ConcurrencyTag>(m_mesh.number_of_faces(), [&](const std::size_t f)
    {
      const auto faces = m_mesh.faces_around_face(f);
      m_mean_areas[f] = m_around[f].area / double((std::max)(faces.size(), std::size_t(1)));
      Surroundings around = m_around[f];
      bool agree = around.agree(m_parameters.unfolding_agreement);
      if(!agree)
      {
        // in a cluster of turned faces, further ones know better
        Surroundings far = { Vector_3(0, 0, 0), 0 };
        for(const Index g : faces)
          far += m_around[g];
        agree = far.agree(m_parameters.unfolding_far_agreement);
        if(!agree)
        {
          far = around_cluster(f);
          agree = far.agree(m_parameters.unfolding_cluster_agreement);
        }
        if(agree)
          around = far;
      }
      m_outwards[f] = normalized_or_null(around.area_vector);
      m_is_folded[f] = m_outwards[f] * m_normals[f] < 0 && agree
                    && (m_mean_areas[f] <= m_parameters.unfolding_largest_area * m_squared_noise || is_low(f));
    });
    if(is_first_round)
      m_noise_turns_faces = m_noise_turns_faces
                         || double(std::count(m_is_folded.begin(), m_is_folded.end(), 1))
                            > m_parameters.unfolding_share_by_shape * double(m_mesh.number_of_faces());
    if(!m_noise_turns_faces)
      for_each_index<ConcurrencyTag>(m_mesh.number_of_faces(), [&](const std::size_t f)
      {
        if(m_is_folded[f] && area_vector(m_mesh, f, m_observed) * m_outwards[f] < 0)
          m_is_folded[f] = 0;
      });
  }

  // so that noise that turns faces may have turned it, however large those around are
  bool is_low(const std::size_t f) const
  {
    const double height = height_of_face(m_mesh, f, m_areas);
    return m_noise_turns_faces && height * height < m_limits.height * m_limits.height * m_squared_noise;
  }

  // The faces around those that are on the same side of all folds as face `f`; none where these are many
  Surroundings around_cluster(const std::size_t f) const
  {
    const auto contains = [](const std::vector<Index>& faces, const Index g)
    { return std::find(faces.begin(), faces.end(), g) != faces.end(); };
    Surroundings around = { Vector_3(0, 0, 0), 0 };
    std::vector<Index> cluster(1, Index(f)), ring;
    for(std::size_t k=0; k<cluster.size(); ++k)
    {
      for(const Index g : m_mesh.neighbors(cluster[k]))
        if(g != Indexed_triangle_mesh::null_index() && m_normals[g] * m_normals[cluster[k]] > 0 && !contains(cluster, g))
          cluster.push_back(g);
      if(cluster.size() > m_parameters.unfolding_largest_cluster)
        return around;
    }
    for(const Index g : cluster)
      for(const Index h : m_mesh.faces_around_face(g))
        if(!contains(cluster, h) && !contains(ring, h))
        {
          ring.push_back(h);
          around += Surroundings{ m_areas[h] * m_normals[h], m_areas[h] };
        }
    return around;
  }

  // how many faces around `v` have a normal with less than that cosine to `m_outwards` if the vertex is at `p`
  std::size_t number_of_folded_faces(const std::size_t v, const Point_3& p, const double cosine) const
  {
    const auto faces = m_mesh.faces_around_vertex(v);
    return std::count_if(faces.begin(), faces.end(), [&](const Index f)
    {
      std::array<Point_3, 3> t;
      for(int i=0; i<3; ++i)
        t[i] = (m_mesh.vertices(f)[i] == v) ? p : m_mesh.point(m_mesh.vertices(f)[i]);
      const Vector_3 n = cross_product(t[1] - t[0], t[2] - t[0]);
      return n * m_outwards[f] < cosine * std::sqrt(n.squared_length());
    });
  }

  // moves `point`, that of vertex `v`, by the longest of three shares of `move` that is allowed and leaves at most so many
  // faces folded. Returns whether there is one
  bool move_by_share(const std::size_t v, const Vector_3& move, const double cosine, const std::size_t most,
                     Point_3& point) const
  {
    const double squared_reach = m_limits.reach * m_limits.reach * m_squared_noise;
    for(const double share : {1., 0.5, 0.25})
    {
      const Point_3 p = m_mesh.point(v) + share * move;
      if(squared_distance(p, m_original[v]) <= squared_reach && number_of_folded_faces(v, p, cosine) <= most)
      {
        point = p;
        return true;
      }
    }
    return false;
  }

  // Only where the surface is flat: elsewhere the center of the neighbors does not lie on it. `anyhow` allows faces to be
  // folded there
  bool go_to_center(const std::size_t v, const bool anyhow, Point_3& point) const
  {
    const auto faces = m_mesh.faces_around_vertex(v);
    Vector_3 normal(0, 0, 0);
    for(const Index f : faces)
      normal += m_areas[f] * (m_is_folded[f] ? m_outwards[f] : m_normals[f]);
    normal = normalized_or_null(normal);
    if(std::any_of(faces.begin(), faces.end(),
                   [&](const Index f) { return m_outwards[f] * normal < m_parameters.unfolding_flatness; }))
      return false;
    const Vector_3 move = to_center(m_mesh, m_neighbors, v);
    return move_by_share(v, move - (move * normal) * normal, m_parameters.unfolding_cosine,
                         anyhow ? faces.size() : 0, point);
  }

  // Least squares of what the faces lack of their least areas, and of what the vertex leaves the planes of the others by.
  // These count so much more that a vertex stays on the surface, at an edge on the edge, and in a corner where it is.
  void make_room(const std::size_t v, Point_3& point) const
  {
    const Point_3& p = m_mesh.point(v);
    const auto faces = m_mesh.faces_around_vertex(v);
    double area = 0;
    for(const Index f : faces)
      area += m_areas[f];
    if(!(area > 0))
      return;

    Eigen::Matrix3d planes = (m_parameters.unfolding_drag * area) * Eigen::Matrix3d::Identity();
    for(const Index f : faces)
      if(!m_is_folded[f])
      {
        const Eigen::Vector3d n = to_eigen(m_normals[f]);
        planes += (m_parameters.unfolding_stiffness * m_areas[f]) * n * n.transpose();
      }

    // the areas that come to be lacking, or cease to be, change the sum: a few iterations find them
    Eigen::Vector3d move = Eigen::Vector3d::Zero();
    for(int iteration=0; iteration<5; ++iteration)
    {
      Eigen::Matrix3d matrix = planes;
      Eigen::Vector3d rhs = Eigen::Vector3d::Zero();
      for(const Index f : faces)
      {
        const std::array<Index, 3>& t = m_mesh.vertices(f);
        const int i = (t[0] == v) ? 0 : (t[1] == v) ? 1 : 2;
        const Point_3& a = m_mesh.point(t[(i+1)%3]);
        const Point_3& b = m_mesh.point(t[(i+2)%3]);
        // twice the area as seen from outwards, and its gradient
        const Eigen::Vector3d gradient = to_eigen(cross_product(m_outwards[f], b - a));
        const double lack = 2 * m_parameters.unfolding_least_area * m_mean_areas[f]
                          - m_outwards[f] * cross_product(a - p, b - p);
        if(lack > gradient.dot(move))
        {
          const double weight = double(faces.size()) / area;
          matrix += weight * gradient * gradient.transpose();
          rhs += weight * lack * gradient;
        }
      }
      move = matrix.llt().solve(rhs);
    }
    const std::size_t number_of_folded = number_of_folded_faces(v, p, 0);
    if(move.allFinite() && number_of_folded > 0)
      move_by_share(v, Vector_3(move[0], move[1], move[2]), 0, number_of_folded - 1, point);
  }

  Indexed_triangle_mesh& m_mesh;
  const std::vector<Point_3>& m_observed;
  const std::vector<bool>& m_is_movable;
  const Vertex_neighbors& m_neighbors;
  const Adaptive_parameters& m_parameters;
  Unfolding_limits m_limits;
  double m_squared_noise;
  bool m_noise_turns_faces;

  std::vector<Point_3> m_original;
  std::vector<Vector_3> m_normals, m_outwards; // of the faces, and of the faces around them
  std::vector<double> m_areas, m_mean_areas;   // likewise
  std::vector<Surroundings> m_around;
  std::vector<std::uint8_t> m_is_folded;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_FACE_UNFOLDING_H
