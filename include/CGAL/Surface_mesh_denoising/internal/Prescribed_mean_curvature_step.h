// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_PRESCRIBED_MEAN_CURVATURE_STEP_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_PRESCRIBED_MEAN_CURVATURE_STEP_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/bilateral_vertex_normals.h>
#include <CGAL/Surface_mesh_denoising/internal/Mesh_normals.h>
#include <CGAL/Surface_mesh_denoising/internal/move.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Where the vertices move in one step of anisotropic prescribed mean curvature flow
template <typename ConcurrencyTag>
class Prescribed_mean_curvature_step : public Mesh_normals<ConcurrencyTag>
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  Prescribed_mean_curvature_step(const double angle_threshold, const double relaxation_factor)
    : m_threshold(std::sqrt(2 - 2 * angle_threshold)), m_relaxation_factor(relaxation_factor)
  {}

  void operator()(const Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                  std::vector<Vector_3>& displacements)
  {
    this->compute_normals(mesh);
    m_stars.resize(mesh.number_of_vertices());
    for_each_index<ConcurrencyTag>(mesh.number_of_vertices(), [&](const std::size_t v)
    { m_stars[v] = star(mesh, v); });

    for_each_index<ConcurrencyTag>(mesh.number_of_vertices(), [&](const std::size_t v)
    {
      const Star& s = m_stars[v];
      if(!is_movable[v] || !(s.stiffness > 0))
        return;
      double curvature = s.curvature, area = s.area;
      for_each_adjacent_vertex(mesh, v, [&](const Index w)
      {
        curvature += m_stars[w].curvature;
        area += m_stars[w].area;
      });
      if(area > 0)
        displacements[v] = (m_relaxation_factor / s.stiffness)
                         * ((curvature / area * s.area) * this->vertex_normals()[v] - s.curvature_vector);
    });
    prevent_flips<ConcurrencyTag>(mesh, this->mean_normals(mesh), displacements);
  }

private:
  struct Star
  {
    Vector_3 curvature_vector = Vector_3(0, 0, 0);  // the anisotropic mean curvature vector
    double curvature = 0;                           // its component along the vertex normal
    double area = 0;                                // a third of the area of the faces
    double stiffness = 0;                           // half the sum of the cotangents opposite to the edges
  };

  Star star(const Indexed_triangle_mesh& mesh, const std::size_t v) const
  {
    Star s;
    const Point_3& p = mesh.point(v);
    for(const Index f : mesh.faces_around_vertex(v))
    {
      const std::array<Index, 3>& t = mesh.vertices(f);
      const int i = (t[0] == v) ? 0 : (t[1] == v) ? 1 : 2;
      const Point_3& q = mesh.point(t[(i+1)%3]);
      const Point_3& r = mesh.point(t[(i+2)%3]);
      const double double_area = std::sqrt(mesh.area_vector(f).squared_length());
      s.area += double_area / 6;
      s.stiffness += 0.5 * (cotangent(p - r, q - r, double_area) + cotangent(p - q, r - q, double_area));

      // the edge from p to q. That from p to r is the turn of the next face around v
      const Index g = mesh.neighbors(f)[i];
      if(g != Indexed_triangle_mesh::null_index())
      {
        const Vector_3 difference = this->face_normals()[f] - this->face_normals()[g];
        s.curvature_vector += 0.5 * weight(std::sqrt(difference.squared_length())) * cross_product(q - p, difference);
      }
    }
    s.curvature = s.curvature_vector * this->vertex_normals()[v];
    return s;
  }

  // the absolute value of the cotangent of the angle between `a` and `b`, bounded for slivers
  static double cotangent(const Vector_3& a, const Vector_3& b, const double double_area)
  {
    const double size = a.squared_length() + b.squared_length();
    return (size > 0) ? std::abs(a * b) / (std::max)(double_area, 1e-6 * size) : 0;
  }

  double weight(const double difference) const
  {
    const double excess = (std::max)(difference - m_threshold, 0.);
    return m_threshold * m_threshold / (m_threshold * m_threshold + 10 * excess * excess);
  }

  double m_threshold;
  double m_relaxation_factor;
  std::vector<Star> m_stars;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_PRESCRIBED_MEAN_CURVATURE_STEP_H
