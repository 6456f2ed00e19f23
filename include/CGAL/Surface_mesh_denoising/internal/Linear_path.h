// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_LINEAR_PATH_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_LINEAR_PATH_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Adaptive_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// A path of lambda-mu smoothing (Taubin), see Path_estimate.h. It needs no normals, which mean nothing where triangles
// are smaller than the noise. It is linear, so the points and what a disturbance changes go along it side by side.
// Vertices at borders stay.
template <typename ConcurrencyTag>
class Linear_path
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  // keeps references
  Linear_path(const std::vector<Point_3>& observed, const std::vector<bool>& is_movable,
              const Vertex_neighbors& neighbors, const std::vector<double>& disturbances,
              const Adaptive_parameters& parameters)
    : m_is_movable(is_movable), m_neighbors(neighbors), m_disturbances(disturbances), m_parameters(parameters),
      m_states(observed.size()), m_next(observed.size())
  {
    for_each_index<ConcurrencyTag>(observed.size(), [&](const std::size_t v)
    { m_states[v] = State{ observed[v] - ORIGIN, disturbances[v] }; });
  }

  Point_3 point(const std::size_t v) const { return ORIGIN + m_states[v].position; }
  double noise_share(const std::size_t v) const { return m_disturbances[v] * m_states[v].disturbance; }

  void go_to(const std::size_t end)
  {
    for(; m_step<end; ++m_step)
      for(const double share : m_parameters.lambda_mu)
      {
        for_each_index<ConcurrencyTag>(m_states.size(), [&](const std::size_t v)
        {
          State s = m_states[v];
          if(m_is_movable[v] && m_neighbors.is_inside(v))
          {
            State sum = { Vector_3(0, 0, 0), 0 };
            for(const Index w : m_neighbors(v))
            {
              sum.position += m_states[w].position;
              sum.disturbance += m_states[w].disturbance;
            }
            const double number = double(m_neighbors(v).size());
            s.position += share * (sum.position / number - s.position);
            s.disturbance += share * (sum.disturbance / number - s.disturbance);
          }
          m_next[v] = s;
        });
        m_states.swap(m_next);
      }
  }

private:
  struct State
  {
    Vector_3 position;
    double disturbance; // along the normal, which neighbors share
  };

  const std::vector<bool>& m_is_movable;
  const Vertex_neighbors& m_neighbors;
  const std::vector<double>& m_disturbances;
  const Adaptive_parameters& m_parameters;
  std::vector<State> m_states, m_next;
  std::size_t m_step = 0;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_LINEAR_PATH_H
