// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_MOVE_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_MOVE_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Shortens displacements by which a face would come to face against its surroundings: `outwards` are the normals of these, for
// each face.
template <typename ConcurrencyTag>
void prevent_flips(const Indexed_triangle_mesh& mesh,
                   const std::vector<Indexed_triangle_mesh::Vector_3>& outwards,
                   std::vector<Indexed_triangle_mesh::Vector_3>& displacements)
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  const int number_of_halvings = 3; // after that nothing is left of a displacement, so the loop ends
  std::vector<std::uint8_t> is_flipped(mesh.number_of_faces());
  for(int round=1; ; ++round)
  {
    for_each_index<ConcurrencyTag>(mesh.number_of_faces(), [&](const std::size_t f)
    {
      const std::array<Index, 3>& t = mesh.vertices(f);
      const Point_3 p = mesh.point(t[0]) + displacements[t[0]];
      const Vector_3 n = cross_product(mesh.point(t[1]) + displacements[t[1]] - p,
                                       mesh.point(t[2]) + displacements[t[2]] - p);
      is_flipped[f] = (n * outwards[f] < 0 && mesh.area_vector(f) * outwards[f] > 0);
    });
    if(std::find(is_flipped.begin(), is_flipped.end(), 1) == is_flipped.end())
      return;
    for_each_index<ConcurrencyTag>(mesh.number_of_vertices(), [&](const std::size_t v)
    {
      for(const Index f : mesh.faces_around_vertex(v))
        if(is_flipped[f])
        {
          displacements[v] = (round > number_of_halvings ? 0 : 0.5) * displacements[v];
          return;
        }
    });
  }
}

// Moves the vertices and returns the largest squared length of a displacement. `points` then holds the points before the move
template <typename ConcurrencyTag>
double move_vertices(Indexed_triangle_mesh& mesh,
                     const std::vector<Indexed_triangle_mesh::Vector_3>& displacements,
                     std::vector<Indexed_triangle_mesh::Point_3>& points)
{
  points.resize(displacements.size());
  for_each_index<ConcurrencyTag>(points.size(), [&](const std::size_t v)
  {
    points[v] = mesh.point(v) + displacements[v];
  });
  mesh.swap_points(points);
  double squared_maximum = 0;
  for(const Indexed_triangle_mesh::Vector_3& d : displacements)
    squared_maximum = (std::max)(squared_maximum, d.squared_length());
  return squared_maximum;
}

// Chooses how far each vertex goes: a share of the way to its projection, which is halved when the vertex turns back after a
// long step. Without that, single vertices at corners go to and fro between the surfaces that meet there and never settle.
class Damping
{
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;

public:
  Damping(const std::size_t number_of_vertices, const double relaxation_factor, const double long_step)
    : m_shares(number_of_vertices, relaxation_factor), m_last(number_of_vertices, Vector_3(0, 0, 0)),
      m_long_step(long_step)
  {}

  template <typename ConcurrencyTag>
  void operator()(std::vector<Vector_3>& displacements, ConcurrencyTag)
  {
    for_each_index<ConcurrencyTag>(displacements.size(), [&](const std::size_t v)
    {
      Vector_3 step = m_shares[v] * displacements[v];
      if(step * m_last[v] < 0 && step.squared_length() > m_long_step * m_long_step)
      {
        m_shares[v] *= 0.5;
        step = 0.5 * step;
      }
      m_last[v] = step;
      displacements[v] = step;
    });
  }

private:
  std::vector<double> m_shares;
  std::vector<Vector_3> m_last;
  double m_long_step;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_MOVE_H
