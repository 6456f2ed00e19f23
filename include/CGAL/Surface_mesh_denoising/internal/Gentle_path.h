// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_GENTLE_PATH_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_GENTLE_PATH_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Adaptive_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Noise_map.h>
#include <CGAL/Surface_mesh_denoising/internal/Normal_evolution.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>
#include <CGAL/Surface_mesh_denoising/internal/smooth_over_neighbors.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// A path that spares small detail (see Path_estimate.h): many gentle steps of bilateral normals and normal-driven moves,
// each of which takes more of the noise and more of the shape away. After some of them comes a relaxation of what noise is
// left between neighbors. If there are large smooth surfaces, the last steps start again from before it, and go as far as
// those ask for. That takes them to the inside where they bend: the heights of the observed points above them, smoothed, are
// given back. The path is gone by the observed points and by disturbed ones.
template <typename ConcurrencyTag>
class Gentle_path
{
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  // `disturbances` are lengths along `normals` of about the noise,
  // `normal_deviations` those of the patches (see Patch_blend.h). Keeps references, and uses `mesh`, which is as before when
  // the path is destroyed
  Gentle_path(Indexed_triangle_mesh& mesh, const std::vector<Point_3>& observed, const std::vector<bool>& is_movable,
              const Vertex_neighbors& neighbors, const std::vector<Vector_3>& normals,
              const std::vector<double>& disturbances, const std::vector<Vector_3>& normal_deviations, const Noise_map& noise,
              const double mean_edge_length, const bool has_last_steps, const Adaptive_parameters& parameters)
    : m_mesh(mesh), m_observed(observed), m_is_movable(is_movable), m_neighbors(neighbors), m_normals(normals),
      m_disturbances(disturbances), m_normal_deviations(normal_deviations), m_noise(noise),
      m_relative_noise(noise.level / mean_edge_length), m_has_last_steps(has_last_steps), m_parameters(parameters),
      m_points_before(observed), m_disturbed(observed.size())
  {
    for_each_index<ConcurrencyTag>(observed.size(), [&](const std::size_t v)
    { m_disturbed[v] = observed[v] + disturbances[v] * normals[v]; });
    m_mesh.swap_points(m_points_before);
  }

  Gentle_path(const Gentle_path&) = delete;
  Gentle_path& operator=(const Gentle_path&) = delete;

  ~Gentle_path() { m_mesh.swap_points(m_points_before); }

  Point_3 point(const std::size_t v) const
  { return m_heights.empty() ? m_mesh.point(v) : m_mesh.point(v) + double(m_heights[v][0]) * m_normals[v]; }

  double noise_share(const std::size_t v) const
  { return m_disturbances[v] * (rest_of_disturbance(v) + (m_heights.empty() ? 0. : double(m_heights[v][1]))); }

  double least_weight(std::size_t, std::size_t) const { return 0; }

  void go_to(const std::size_t end)
  {
    const std::size_t relaxation = m_parameters.gentle_number_of_steps;
    go_on((std::min)(end, relaxation));
    if(end > relaxation && m_step == relaxation)
    {
      m_evolve = Normal_evolution<ConcurrencyTag>(); // its memory is needed elsewhere
      m_unrelaxed_points = m_mesh.points();
      m_unrelaxed_disturbed = m_disturbed;
      relax();
      m_mesh.swap_points(m_disturbed);
      relax();
      m_mesh.swap_points(m_disturbed);
      ++m_step;
    }
    if(end <= m_step || !m_has_last_steps)
      return;
    if(m_step == relaxation + 1)
    {
      m_mesh.swap_points(m_unrelaxed_points);
      m_disturbed.swap(m_unrelaxed_disturbed);
      m_unrelaxed_points = std::vector<Point_3>();
      m_unrelaxed_disturbed = std::vector<Point_3>();
    }
    go_on(end);
    m_evolve = Normal_evolution<ConcurrencyTag>();
    compute_heights();
  }

private:
  typedef Eigen::Array2f Height;   // that of the observed point, and of the disturbance that the steps took

  void go_on(const std::size_t end)
  {
    for(std::size_t k=0; m_step<end; ++k, ++m_step)
    {
      if(k % m_parameters.gentle_steps_between_weights == 0)
        m_evolve.update_weights(m_mesh, m_noise);
      m_evolve(m_mesh, m_disturbed, m_is_movable, m_normal_deviations, step());
    }
  }

  double rest_of_disturbance(const std::size_t v) const { return m_normals[v] * (m_disturbed[v] - m_mesh.point(v)); }

  // at borders, which go their own way, none
  void compute_heights()
  {
    m_heights.assign(m_observed.size(), Height::Zero());
    for_each_index<ConcurrencyTag>(m_heights.size(), [&](const std::size_t v)
    {
      if(m_neighbors.is_inside(v))
        m_heights[v] = Height(float((m_observed[v] - m_mesh.point(v)) * m_normals[v]),
                              float(m_disturbances[v] - rest_of_disturbance(v)));
    });
    smooth_over_neighbors<ConcurrencyTag>(m_neighbors, m_is_movable, m_parameters.gentle_number_of_height_steps,
                                          m_parameters.laplacian_shares, m_heights);
  }

  Evolution_step step() const
  {
    const Adaptive_parameters& p = m_parameters;
    const auto growth = [&](const double g) { return std::size_t((std::min)(g, p.gentle_maximal_growth)); };
    const double progress = m_relative_noise * double((std::min)(m_step, p.gentle_number_of_steps));
    const double range = std::hypot(p.gentle_range * m_relative_noise, p.gentle_range_of_bends);
    return { (std::min)(range, p.largest_range), false,
             1 + growth(p.gentle_normal_growth * progress * progress),
             (m_step > p.gentle_number_of_steps) ? p.gentle_last_number_of_moves
                                                 : 2 + growth(p.gentle_move_growth * progress) };
  }

  // Lambda-mu smoothing (Taubin), of what noise may have left only: a vertex far from the center of its neighbors, beside
  // the noise, stays, and moves along its normal and across it count each for itself.
  void relax()
  {
    const auto weight = [&](const double range, const std::size_t v, const Vector_3& way)
    {
      const double noise = m_noise.at(v);
      return bell(0.5 / (range * range * noise * noise) * way.squared_length());
    };
    std::vector<Point_3> points(m_mesh.number_of_vertices());
    for(std::size_t k=0; k<m_parameters.number_of_relaxations; ++k)
      for(const double share : m_parameters.lambda_mu)
      {
        for_each_index<ConcurrencyTag>(points.size(), [&](const std::size_t v)
        {
          points[v] = m_mesh.point(v);
          if(!m_is_movable[v] || !m_neighbors.is_inside(v))
            return;
          const Vector_3 whole = to_center(m_mesh, m_neighbors, v);
          const Vector_3 along = (whole * m_normals[v]) * m_normals[v], across = whole - along;
          points[v] = points[v]
                    + (share * weight(m_parameters.relaxation_range_along_normals, v, along)) * along
                    + (share * weight(m_parameters.relaxation_range_across_normals, v, across)) * across;
        });
        m_mesh.swap_points(points);
      }
  }

  Indexed_triangle_mesh& m_mesh;
  const std::vector<Point_3>& m_observed;
  const std::vector<bool>& m_is_movable;
  const Vertex_neighbors& m_neighbors;
  const std::vector<Vector_3>& m_normals;
  const std::vector<double>& m_disturbances;
  const std::vector<Vector_3>& m_normal_deviations;
  const Noise_map& m_noise;
  double m_relative_noise;
  bool m_has_last_steps;
  const Adaptive_parameters& m_parameters;

  std::vector<Point_3> m_points_before, m_disturbed;
  std::vector<Point_3> m_unrelaxed_points, m_unrelaxed_disturbed;
  std::vector<Height> m_heights;   // of the last steps only
  Normal_evolution<ConcurrencyTag> m_evolve;
  std::size_t m_step = 0;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_GENTLE_PATH_H
