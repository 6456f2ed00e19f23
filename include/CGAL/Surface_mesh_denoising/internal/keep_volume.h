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
#include <CGAL/Surface_mesh_denoising/internal/Noise_map.h>
#include <CGAL/Surface_mesh_denoising/internal/mixing.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// the volume that the surface sweeps while each vertex goes straight from its point in `from` to that in `to`, positive
// where it goes outwards
template <typename ConcurrencyTag>
double swept_volume(const Indexed_triangle_mesh& mesh, const std::vector<Indexed_triangle_mesh::Point_3>& from,
                    const std::vector<Indexed_triangle_mesh::Point_3>& to)
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  return sum<ConcurrencyTag>(mesh.number_of_faces(), [&](const std::size_t f)
  {
    // the integral of the area vector times the mean displacement: the former is quadratic in time, so Simpson's rule
    // is exact
    const std::array<Index, 3>& t = mesh.vertices(f);
    const Vector_3 d0 = to[t[0]] - from[t[0]], d1 = to[t[1]] - from[t[1]], d2 = to[t[2]] - from[t[2]];
    const Vector_3 a = from[t[1]] - from[t[0]], b = from[t[2]] - from[t[0]];
    const Vector_3 c = a + (d1 - d0), d = b + (d2 - d0);
    const Vector_3 mean_of_areas = (cross_product(a, b) + cross_product(a + c, b + d) + cross_product(c, d)) / 12;
    return mean_of_areas * (d0 + d1 + d2) / 3;
  });
}

// Offsets the surface, by no more than the noise and in proportion to it, towards the volume that it enclosed with the observed points. That is a
// sum of products of three different points: noise that is independent from vertex to vertex leaves its expectation
// as it was, but not the volume itself. What the noise moves it by in the mean is no reason for an offset.
template <typename ConcurrencyTag>
void keep_volume(Indexed_triangle_mesh& mesh, const std::vector<Indexed_triangle_mesh::Point_3>& observed,
                 const std::vector<bool>& is_movable, const Noise_map& noise, const double penalty)
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  std::vector<Vector_3> normals, vertex_normals;
  std::vector<double> areas;
  compute_face_normals<ConcurrencyTag>(mesh, normals, areas);
  compute_vertex_normals<ConcurrencyTag>(mesh, normals, areas, vertex_normals);
  const auto sum_of_movable = [&](const auto& value)
  {
    return sum<ConcurrencyTag>(mesh.number_of_vertices(), [&](const std::size_t v)
    { return is_movable[v] ? value(v) : 0.; });
  };
  const double area = sum_of_movable([&](const std::size_t v)
  {
    Vector_3 a(0, 0, 0);
    for(const Index f : mesh.faces_around_vertex(v))
      a += areas[f] / 3 * normals[f];
    return noise.ratio(v) * (a * vertex_normals[v]);
  });
  if(!(area > 0))
    return;
  const double wanted = swept_volume<ConcurrencyTag>(mesh, mesh.points(), observed) / area;
  const double number = double(std::count(is_movable.begin(), is_movable.end(), true));
  const double mean_square = sum_of_movable([&](const std::size_t v)
  {
    const double residual = (observed[v] - mesh.point(v)) * vertex_normals[v];
    return residual * residual;
  }) / number;
  const double offset = (std::max)(-noise.level, (std::min)(shrunk(wanted, number, mean_square, penalty), noise.level));
  std::vector<Point_3> points(mesh.points());
  for_each_index<ConcurrencyTag>(points.size(), [&](const std::size_t v)
  {
    if(is_movable[v])
      points[v] = points[v] + (offset * noise.ratio(v)) * vertex_normals[v];
  });
  mesh.swap_points(points);
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_KEEP_VOLUME_H
