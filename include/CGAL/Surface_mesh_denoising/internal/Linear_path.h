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
#include <CGAL/Surface_mesh_denoising/internal/Noise_map.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/mixing.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>
#include <CGAL/Surface_mesh_denoising/internal/smooth_over_neighbors.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// A path of linear smoothing, see Path_estimate.h. It needs no normals to smooth, which mean nothing where triangles are
// smaller than the noise. It is linear, so the points and what a disturbance changes go along it side by side. Vertices at
// borders stay.
//
// First come steps of lambda-mu smoothing (Taubin), which spares detail. It would take a thousand of them to leave nothing
// of strong noise: the steps after them start from the observed points again and are of Laplacian smoothing. What that
// shrinks, and what many steps of the former inflate, is given back: the heights of the observed points above the smoothed ones,
// along the normals of these, smoothed in turn. Hardly any noise is in them, and unlike positions they hardly change along a
// bent surface.
template <typename ConcurrencyTag>
class Linear_path
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  // Keeps references; of `mesh` only the faces count, and its points are as before after each call
  Linear_path(Indexed_triangle_mesh& mesh, const std::vector<Point_3>& observed, const std::vector<bool>& is_movable,
              const Vertex_neighbors& neighbors, const std::vector<double>& disturbances, const Noise_map& noise,
              const Adaptive_parameters& parameters)
    : m_mesh(mesh), m_observed(observed), m_is_movable(is_movable), m_neighbors(neighbors),
      m_disturbances(disturbances), m_noise(noise), m_parameters(parameters), m_states(observed.size())
  {
    start_from_observed_points();
  }

  Point_3 point(const std::size_t v) const
  {
    const Point_3 p = smoothed_point(v);
    return m_heights.empty() ? p : p + double(m_heights[v][0]) * m_normals[v];
  }

  double noise_share(const std::size_t v) const
  {
    return m_disturbances[v] * (m_states[v][3] + (m_heights.empty() ? 0. : double(m_heights[v][1])));
  }

  // Laplacian smoothing is for places where triangles are small beside the noise
  double least_weight(const std::size_t v, const std::size_t end) const
  {
    return (end > m_parameters.linear_number_of_lambda_mu_steps) ? m_least_weights[v] : 0;
  }

  void go_to(const std::size_t end)
  {
    const std::size_t last = m_parameters.linear_number_of_lambda_mu_steps;
    const auto go_on = [&](const std::size_t step, const auto& shares)
    {
      if(m_step < step)
        smooth_over_neighbors<ConcurrencyTag>(m_neighbors, m_is_movable, step - m_step, shares, m_states);
      m_step = (std::max)(m_step, step);
    };
    go_on((std::min)(end, last), m_parameters.lambda_mu);
    if(end == last)
      compute_heights(m_parameters.lambda_mu_number_of_height_steps);
    if(end <= last)
      return;
    if(m_step == last)
      start_from_observed_points();
    go_on(end, m_parameters.laplacian_shares);
    compute_heights(m_parameters.height_steps_by_step * (end - last));
  }

private:
  typedef Eigen::Array4d State;    // a position and a disturbance along the normal, which neighbors share
  typedef Eigen::Array2f Height;   // that of the observed point, and of the disturbance that smoothing took

  void start_from_observed_points()
  {
    for_each_index<ConcurrencyTag>(m_states.size(), [&](const std::size_t v)
    {
      const Point_3& p = m_observed[v];
      m_states[v] = State(p.x(), p.y(), p.z(), m_disturbances[v]);
    });
  }

  Point_3 smoothed_point(const std::size_t v) const { return Point_3(m_states[v][0], m_states[v][1], m_states[v][2]); }

  void compute_heights(const std::size_t number_of_steps)
  {
    const std::size_t n = m_states.size();
    {
      std::vector<Point_3> points(n);
      for_each_index<ConcurrencyTag>(n, [&](const std::size_t v) { points[v] = smoothed_point(v); });
      m_mesh.swap_points(points);
      std::vector<Vector_3> face_normals;
      std::vector<double> areas;
      compute_face_normals<ConcurrencyTag>(m_mesh, face_normals, areas);
      compute_vertex_normals<ConcurrencyTag>(m_mesh, face_normals, areas, m_normals);
      compare_with_triangles(areas);
      m_mesh.swap_points(points);
    }
    m_heights.resize(n);
    for_each_index<ConcurrencyTag>(n, [&](const std::size_t v)
    {
      m_heights[v] = Height(float((m_observed[v] - smoothed_point(v)) * m_normals[v]),
                            float(m_disturbances[v] - m_states[v][3]));
    });
    smooth_over_neighbors<ConcurrencyTag>(m_neighbors, m_is_movable, number_of_steps, m_parameters.laplacian_shares,
                                          m_heights);
  }

  // by the mean height of the triangles around a vertex
  void compare_with_triangles(const std::vector<double>& areas)
  {
    m_least_weights.resize(m_states.size());
    for_each_index<ConcurrencyTag>(m_states.size(), [&](const std::size_t v)
    {
      const double height = mean_height_of_faces(m_mesh, m_mesh.faces_around_vertex(v), [&](const Index f) { return areas[f]; });
      const double certainty = ramp(m_noise.at(v), m_parameters.least_laplacian_noise * height,
                                    m_parameters.sure_laplacian_noise * height);
      m_least_weights[v] = float(1 - smooth_step(certainty));
    });
  }

  Indexed_triangle_mesh& m_mesh;
  const std::vector<Point_3>& m_observed;
  const std::vector<bool>& m_is_movable;
  const Vertex_neighbors& m_neighbors;
  const std::vector<double>& m_disturbances;
  const Noise_map& m_noise;
  const Adaptive_parameters& m_parameters;

  std::vector<State> m_states;
  std::size_t m_step = 0;

  // of Laplacian smoothing only
  std::vector<Vector_3> m_normals;
  std::vector<Height> m_heights;
  std::vector<float> m_least_weights;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_LINEAR_PATH_H
