// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_KEEP_VOLUME_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_KEEP_VOLUME_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Offsets the surface until the mean signed distance of the observed points from it is zero: noise that is as often
// outside as inside then leaves the enclosed volume as it was.
template <typename ConcurrencyTag>
void keep_volume(Indexed_triangle_mesh& mesh, const std::vector<Indexed_triangle_mesh::Point_3>& observed,
                 const std::vector<bool>& is_movable, const std::size_t number_of_rounds)
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  std::vector<Vector_3> normals, vertex_normals;
  std::vector<double> areas;
  std::vector<Point_3> points;
  for(std::size_t round=0; round<number_of_rounds; ++round)
  {
    compute_face_normals<ConcurrencyTag>(mesh, normals, areas);
    compute_vertex_normals<ConcurrencyTag>(mesh, normals, areas, vertex_normals);
    const auto area = [&](const std::size_t v)
    {
      double a = 0;
      if(is_movable[v])
        for(const Index f : mesh.faces_around_vertex(v))
          a += areas[f];
      return a;
    };
    const double whole_area = sum<ConcurrencyTag>(mesh.number_of_vertices(), area);
    const double volume = sum<ConcurrencyTag>(mesh.number_of_vertices(), [&](const std::size_t v)
    { return area(v) * ((observed[v] - mesh.point(v)) * vertex_normals[v]); });
    if(!(whole_area > 0))
      return;
    points = mesh.points();
    for_each_index<ConcurrencyTag>(points.size(), [&](const std::size_t v)
    {
      if(is_movable[v])
        points[v] = points[v] + (volume / whole_area) * vertex_normals[v];
    });
    mesh.swap_points(points);
  }
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_KEEP_VOLUME_H
