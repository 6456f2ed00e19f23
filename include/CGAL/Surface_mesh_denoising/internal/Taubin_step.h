// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_TAUBIN_STEP_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_TAUBIN_STEP_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Mesh_normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Where the vertices move in one iteration of lambda-mu smoothing
template <typename ConcurrencyTag>
class Taubin_step : public Mesh_normals<ConcurrencyTag>
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  Taubin_step(const double lambda, const double mu) : m_lambda(lambda), m_mu(mu) {}

  void operator()(const Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                  std::vector<Vector_3>& displacements)
  {
    m_points = mesh.points();
    m_smoothed.resize(m_points.size());
    smooth(mesh, is_movable, m_lambda);
    if(m_mu != 0)
      smooth(mesh, is_movable, m_mu);
    for_each_index<ConcurrencyTag>(m_points.size(), [&](const std::size_t v)
    { displacements[v] = m_points[v] - mesh.point(v); });
  }

private:
  void smooth(const Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable, const double share)
  {
    for_each_index<ConcurrencyTag>(m_points.size(), [&](const std::size_t v)
    {
      m_smoothed[v] = m_points[v];
      if(is_movable[v])
        m_smoothed[v] = m_points[v] + share * laplacian(mesh, v);
    });
    m_points.swap(m_smoothed);
  }

  // from vertex `v` to the mean of its neighbors. On a curve of border and constrained edges these are the ones along
  // the curve, and there are none where it ends or branches
  Vector_3 laplacian(const Indexed_triangle_mesh& mesh, const std::size_t v) const
  {
    Vector_3 sum(0, 0, 0), sum_along_curve(0, 0, 0);
    std::size_t number = 0, number_along_curve = 0;
    const auto add = [&](const Index w, const bool is_on_curve)
    {
      const Vector_3 d = m_points[w] - m_points[v];
      sum += d;
      ++number;
      if(is_on_curve)
      {
        sum_along_curve += d;
        ++number_along_curve;
      }
    };
    for(const Index f : mesh.faces_around_vertex(v))
    {
      const std::array<Index, 3>& t = mesh.vertices(f);
      const int i = (t[0] == v) ? 0 : (t[1] == v) ? 1 : 2;
      add(t[(i+1)%3], mesh.neighbors(f)[i] == Indexed_triangle_mesh::null_index());
      if(mesh.is_border(f, (i+2)%3)) // else the next face around `v` adds that vertex
        add(t[(i+2)%3], true);
    }
    if(number_along_curve == 0)
      return (number != 0) ? sum / double(number) : sum;
    return (number_along_curve == 2) ? 0.5 * sum_along_curve : Vector_3(0, 0, 0);
  }

  double m_lambda;
  double m_mu;
  std::vector<Point_3> m_points;
  std::vector<Point_3> m_smoothed;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_TAUBIN_STEP_H
