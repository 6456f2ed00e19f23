// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_TURN_FACES_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_TURN_FACES_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Vertices move along normals so that faces turn to them. How far a vertex is above the opposite edge, in the direction of the
// normal, divided by its height in the triangle, is the slope that it gives the face: each vertex goes towards the least sum of
// squared slopes. A face weighs as the square of its least height: so no weight is above one, and slivers, whose normals tell
// little, do not rule their vertices. With `relaxation` below 2/3 the sum of all never grows while the weights stay, which are
// computed anew once in so many moves.
template <typename ConcurrencyTag>
void turn_faces(Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                const std::vector<Indexed_triangle_mesh::Vector_3>& normals, const std::size_t number_of_moves,
                const std::size_t moves_between_weights, const double relaxation)
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  struct Corner
  {
    double weight = 0;
    double share = 0.5; // where the foot of the height is on the opposite edge
  };
  const auto corner_of = [&](const Index f, const std::size_t v)
  {
    const std::array<Index, 3>& t = mesh.vertices(f);
    return std::size_t(t[1] == v) + 2 * std::size_t(t[2] == v); // without branches
  };
  std::vector<std::array<Corner, 3> > corners(mesh.number_of_faces());
  std::vector<double> weights(mesh.number_of_vertices());
  const auto update_weights = [&]()
  {
    for_each_index<ConcurrencyTag>(corners.size(), [&](const std::size_t f)
    {
      const std::array<Index, 3>& t = mesh.vertices(f);
      std::array<Vector_3, 3> edges;
      std::array<double, 3> squared_lengths;
      for(int i=0; i<3; ++i)
      {
        edges[i] = mesh.point(t[(i+2)%3]) - mesh.point(t[(i+1)%3]);
        squared_lengths[i] = edges[i].squared_length();
      }
      const double largest = *std::max_element(squared_lengths.begin(), squared_lengths.end());
      corners[f] = std::array<Corner, 3>();
      for(int i=0; i<3; ++i)
        if(squared_lengths[i] > 0)
        {
          corners[f][i].weight = squared_lengths[i] / largest; // heights are to each other as the inverses of the edges
          corners[f][i].share = -(edges[(i+2)%3] * edges[i]) / squared_lengths[i];
        }
    });
    for_each_index<ConcurrencyTag>(weights.size(), [&](const std::size_t v)
    {
      weights[v] = 0;
      for(const Index f : mesh.faces_around_vertex(v))
        weights[v] += corners[f][corner_of(f, v)].weight;
    });
  };

  std::vector<std::array<double, 3> > rises(mesh.number_of_faces()); // to the planes that the normals tell, with the weights
  std::vector<Point_3> points = mesh.points();
  for(std::size_t k=0; k<number_of_moves; ++k)
  {
    if(k % moves_between_weights == 0)
      update_weights();
    for_each_index<ConcurrencyTag>(rises.size(), [&](const std::size_t f)
    {
      const std::array<Index, 3>& t = mesh.vertices(f);
      // from the first vertex, so that the place of the mesh does not matter
      const std::array<double, 3> heights = {{ 0, normals[f] * (mesh.point(t[1]) - mesh.point(t[0])),
                                               normals[f] * (mesh.point(t[2]) - mesh.point(t[0])) }};
      for(int i=0; i<3; ++i)
      {
        const Corner& c = corners[f][i];
        rises[f][i] = c.weight * ((1 - c.share) * heights[(i+1)%3] + c.share * heights[(i+2)%3] - heights[i]);
      }
    });
    for_each_index<ConcurrencyTag>(points.size(), [&](const std::size_t v)
    {
      points[v] = mesh.point(v);
      if(!is_movable[v] || !(weights[v] > 0))
        return;
      Vector_3 sum(0, 0, 0);
      for(const Index f : mesh.faces_around_vertex(v))
        sum += rises[f][corner_of(f, v)] * normals[f];
      points[v] = points[v] + (relaxation / weights[v]) * sum;
    });
    mesh.swap_points(points);
  }
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_TURN_FACES_H
