// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_UNFOLD_FACES_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_UNFOLD_FACES_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Adaptive_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
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

// Where noise turned faces against the faces around them, their vertices slide along the surface towards the center of
// their neighbors, if that leaves no such face there, and no further than noise may have moved them. Only where the
// surface is flat: at edges, and where faces are large beside the noise, a turned face may be part of the shape.
template <typename ConcurrencyTag>
void unfold_faces(Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable, const Vertex_neighbors& neighbors,
                  const double noise, const Adaptive_parameters& parameters)
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  const double reach = parameters.unfolding_reach * noise;
  const std::vector<Point_3> original = mesh.points();
  std::vector<Point_3> points;
  std::vector<Vector_3> normals, normals_around(mesh.number_of_faces());
  std::vector<double> areas;
  std::vector<std::uint8_t> is_folded(mesh.number_of_faces());
  for(std::size_t round=0; round<parameters.unfolding_number_of_rounds; ++round)
  {
    compute_face_normals<ConcurrencyTag>(mesh, normals, areas);
    for_each_index<ConcurrencyTag>(mesh.number_of_faces(), [&](const std::size_t f)
    {
      Vector_3 sum(0, 0, 0);
      double area = 0;
      for(const Index g : mesh.faces_around_face(f))
      {
        sum += areas[g] * normals[g];
        area += areas[g];
      }
      normals_around[f] = normalized_or_null(sum);
      is_folded[f] = sum * normals[f] < 0
                  && area <= parameters.unfolding_area * noise * noise * double(mesh.faces_around_face(f).size());
    });
    if(std::find(is_folded.begin(), is_folded.end(), 1) == is_folded.end())
      return;

    points = mesh.points();
    for_each_index<ConcurrencyTag>(mesh.number_of_vertices(), [&](const std::size_t v)
    {
      const auto faces = mesh.faces_around_vertex(v);
      if(!is_movable[v] || neighbors.is_at_border(v)
         || std::none_of(faces.begin(), faces.end(), [&](const Index f) { return is_folded[f] != 0; }))
        return;

      const Point_3& p = mesh.point(v);
      Vector_3 normal(0, 0, 0), to_center(0, 0, 0);
      for(const Index f : faces)
        normal += areas[f] * normals[f];
      normal = normalized_or_null(normal);
      if(std::any_of(faces.begin(), faces.end(),
                     [&](const Index f) { return normals_around[f] * normal < parameters.unfolding_flatness; }))
        return;
      for(const Index w : neighbors(v))
        to_center += mesh.point(w) - p;
      to_center = to_center / double(neighbors(v).size());
      to_center -= (to_center * normal) * normal;

      for(const double share : {1., 0.5, 0.25})
      {
        const Point_3 q = p + share * to_center;
        if(squared_distance(q, original[v]) > reach * reach)
          continue;
        const bool unfolds = std::none_of(faces.begin(), faces.end(), [&](const Index f)
        {
          std::array<Point_3, 3> t;
          for(int i=0; i<3; ++i)
            t[i] = (mesh.vertices(f)[i] == v) ? q : mesh.point(mesh.vertices(f)[i]);
          const Vector_3 n = cross_product(t[1] - t[0], t[2] - t[0]);
          return n * normals_around[f] < parameters.unfolding_cosine * std::sqrt(n.squared_length());
        });
        if(unfolds)
        {
          points[v] = q;
          break;
        }
      }
    });
    mesh.swap_points(points);
  }
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_UNFOLD_FACES_H
