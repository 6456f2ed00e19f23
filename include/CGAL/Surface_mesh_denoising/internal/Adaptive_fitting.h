// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_ADAPTIVE_FITTING_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_ADAPTIVE_FITTING_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Denoising_result.h>
#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Adaptive_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Face_unfolding.h>
#include <CGAL/Surface_mesh_denoising/internal/Gentle_estimate.h>
#include <CGAL/Surface_mesh_denoising/internal/Normal_evolution.h>
#include <CGAL/Surface_mesh_denoising/internal/Patch_blend.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/keep_volume.h>
#include <CGAL/Surface_mesh_denoising/internal/mixing.h>
#include <CGAL/Surface_mesh_denoising/internal/noise_level.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>
#include <CGAL/Surface_mesh_denoising/internal/sine_key.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Anisotropic surface fitting that chooses for itself: noise level -> pilot -> patches, and beside them a gentle path
// -> mixing -> unfolding -> volume. Each stage knows only what the ones before it hand on.
template <typename ConcurrencyTag>
class Adaptive_fitting
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  // the noise level in mean edge lengths of the surface without noise; if negative, it is estimated
  Adaptive_fitting(const Adaptive_parameters& parameters, const double noise_level)
    : m_parameters(parameters), m_noise_level(noise_level)
  {}

  const std::vector<Vector_3>& face_normals() const { return m_face_normals; }
  const std::vector<Vector_3>& vertex_normals() const { return m_vertex_normals; }

  // the vertex normals that belong to the face normals which the result was made to agree with
  void compute_normals(const Indexed_triangle_mesh& mesh)
  {
    std::vector<Vector_3> normals;
    std::vector<double> areas;
    compute_face_normals<ConcurrencyTag>(mesh, normals, areas);
    if(m_face_normals.empty())
      m_face_normals.swap(normals);
    compute_vertex_normals<ConcurrencyTag>(mesh, m_face_normals, areas, m_vertex_normals);
  }

  template <typename Report>
  Denoising_result run(Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable, const Report& report)
  {
    Denoising_result result;
    m_mean_edge_length = mesh.mean_edge_length<ConcurrencyTag>();
    const Vertex_neighbors neighbors(mesh);
    m_noise = (m_noise_level >= 0) ? in_noisy_edge_lengths(m_noise_level) * m_mean_edge_length
                                   : noise_level<ConcurrencyTag>(mesh, neighbors, is_movable);
    if(!(m_noise > m_parameters.negligible_noise * m_mean_edge_length))
    {
      result.number_of_iterations = 1;
      result.has_converged = true;
      report(1, 0., true);
      return result;
    }

    const std::vector<Point_3> observed = mesh.points();
    std::vector<Point_3> pilot;
    for(bool is_first_round = true; ; is_first_round = false)
    {
      if(!run_pilot(mesh, is_movable, report, result))
        return result;
      pilot = mesh.points();
      fit_patches(mesh, observed, is_movable);
      // with a noise level of the user's there is nothing to correct
      if(!is_first_round || m_noise_level >= 0 || !correct_noise_level(mesh, observed, is_movable))
        break;
      std::vector<Point_3> points = observed;
      mesh.swap_points(points);
    }

    if(m_parameters.use_gentle_path)
    {
      std::vector<Vector_3> normals;
      compute_vertex_normals<ConcurrencyTag>(mesh, normals);
      const Gentle_estimate gentle
        = estimate_gently<ConcurrencyTag>(mesh, observed, is_movable, neighbors, normals,
                                          make_disturbances(mesh, observed, is_movable), m_noise, m_mean_edge_length,
                                          m_parameters);
      mix(mesh, observed, normals, neighbors, gentle);
    }
    if(m_parameters.unfold_faces)
      Face_unfolding<ConcurrencyTag>(mesh, is_movable, neighbors, m_noise, m_parameters).run();
    if(m_parameters.preserve_volume)
      keep_volume<ConcurrencyTag>(mesh, observed, is_movable, m_noise, m_parameters.volume_number_of_rounds);

    ++result.number_of_iterations;
    result.has_converged = true;
    report(result.number_of_iterations, largest_displacement(pilot, mesh.points()), true);
    return result;
  }

private:
  static double largest_displacement(const std::vector<Point_3>& from, const std::vector<Point_3>& to)
  {
    double squared_maximum = 0;
    for(std::size_t v=0; v<from.size(); ++v)
      squared_maximum = (std::max)(squared_maximum, squared_distance(from[v], to[v]));
    return std::sqrt(squared_maximum);
  }

  // Bilateral normals and normal-driven moves in turn. Returns whether to go on
  template <typename Report>
  bool run_pilot(Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable, const Report& report,
                 Denoising_result& result)
  {
    const double noise = m_noise / m_mean_edge_length;
    const double first_range = (std::min)(m_parameters.pilot_first_range * noise, m_parameters.largest_range);
    const double last_range = (std::min)(m_parameters.pilot_last_range * noise, m_parameters.pilot_maximal_last_range);
    Normal_evolution<ConcurrencyTag> evolve;
    for(std::size_t k=0; k<m_parameters.pilot_number_of_steps; ++k)
    {
      const double progress = double(k) / double(m_parameters.pilot_number_of_steps - 1);
      const std::vector<Point_3> before = mesh.points();
      evolve.update_weights(mesh);
      evolve(mesh, is_movable, Evolution_step{ first_range * std::pow(last_range / first_range, progress), true,
                                               1, m_parameters.pilot_number_of_moves });
      ++result.number_of_iterations;
      if(!report(result.number_of_iterations, largest_displacement(before, mesh.points()), false))
      {
        m_face_normals = evolve.face_normals();
        return false;
      }
    }
    return true;
  }

  // Impulses leave the median of the residuals, on which the noise level rests, as it is. Returns whether it was wrong
  bool correct_noise_level(const Indexed_triangle_mesh& mesh, const std::vector<Point_3>& observed,
                           const std::vector<bool>& is_movable)
  {
    std::vector<Vector_3> normals;
    compute_vertex_normals<ConcurrencyTag>(mesh, normals);
    std::vector<double> residuals(observed.size());
    for_each_index<ConcurrencyTag>(residuals.size(), [&](const std::size_t v)
    { residuals[v] = (observed[v] - mesh.point(v)) * normals[v]; });

    const double median_deviation = median_of_absolutes(residuals, is_movable) / median_of_normal_distribution;
    const double number = double(std::count(is_movable.begin(), is_movable.end(), true));
    const auto root_mean_square = [&](const double limit)
    {
      return std::sqrt(sum<ConcurrencyTag>(residuals.size(), [&](const std::size_t v)
      {
        const double r = is_movable[v] ? (std::min)(std::abs(residuals[v]), limit) : 0;
        return r * r;
      }) / number);
    };
    if(!(median_deviation > 0))
      return false;
    const double ratio = root_mean_square(m_parameters.largest_tail * median_deviation) / median_deviation;
    if(!(ratio >= m_parameters.heavy_tail))
      return false;
    m_noise = (std::min)(ratio * m_noise, m_parameters.maximal_correction
                                          * root_mean_square((std::numeric_limits<double>::max)()));
    return true;
  }

  // lengths along the normals, with the standard deviation of the noise
  std::vector<double> make_disturbances(const Indexed_triangle_mesh& mesh, const std::vector<Point_3>& observed,
                                        const std::vector<bool>& is_movable) const
  {
    std::vector<double> disturbances(observed.size());
    for_each_index<ConcurrencyTag>(disturbances.size(), [&](const std::size_t v)
    {
      const double length = std::sqrt(squared_distance(mesh.point(v), observed[v])) / m_mean_edge_length;
      disturbances[v] = is_movable[v] ? std::sqrt(2.) * m_noise * sine_key(length) : 0;
    });
    return disturbances;
  }

  void fit_patches(Indexed_triangle_mesh& mesh, const std::vector<Point_3>& observed,
                   const std::vector<bool>& is_movable)
  {
    std::vector<Point_3> points;
    {
      const Patch_blend<ConcurrencyTag> blend(mesh, observed, is_movable, m_noise, m_mean_edge_length, m_parameters);
      m_face_normals = blend.face_normals();
      points = blend.points();
      m_leverages = blend.leverages();
    }
    mesh.swap_points(points);
    Normal_evolution<ConcurrencyTag>().move_to_agree(mesh, is_movable, m_face_normals,
                                                     m_parameters.final_number_of_moves);
  }

  // the covariance of the noise and the result of the patches at vertex `v`
  double patch_noise_share(const std::size_t v) const
  {
    const double l = m_leverages[v];
    return (l + m_parameters.adaptation_factor * (std::max)(0., l - m_parameters.unadapted_leverage))
         * m_noise * m_noise;
  }

  // Patches are best where the surface is made of smooth pieces, the gentle estimate where it is full of detail
  void mix(Indexed_triangle_mesh& mesh, const std::vector<Point_3>& observed, const std::vector<Vector_3>& normals,
           const Vertex_neighbors& neighbors, const Gentle_estimate& gentle)
  {
    const std::size_t n = mesh.number_of_vertices();
    std::vector<Mixing_moments<1> > moments(n);
    for_each_index<ConcurrencyTag>(n, [&](const std::size_t v)
    {
      // what vertices slide along the surface does not count
      const double difference = (gentle.points[v] - mesh.point(v)) * normals[v];
      const double noise_share = gentle.noise_shares[v] - patch_noise_share(v);
      moments[v].products[0] = float((observed[v] - mesh.point(v)) * normals[v] * difference - noise_share);
      moments[v].squares[0] = float(difference * difference);
    });
    std::vector<std::array<float, 1> > weights
      = local_weights<ConcurrencyTag>(neighbors, m_parameters, m_noise * m_noise, m_parameters.patch_penalty, moments);

    // the mean of two good estimates is worse than the better one where edges are concerned
    for_each_index<ConcurrencyTag>(n, [&](const std::size_t v)
    {
      float& w = weights[v][0];
      for(std::size_t k=0; k<m_parameters.number_of_sharpenings; ++k)
        w = w * w * (3 - 2 * w);
    });

    std::vector<Point_3> points = gentle.points;
    std::vector<Vector_3> gentle_normals;
    std::vector<double> areas;
    mesh.swap_points(points);
    compute_face_normals<ConcurrencyTag>(mesh, gentle_normals, areas);
    for_each_index<ConcurrencyTag>(mesh.number_of_faces(), [&](const std::size_t f)
    {
      double w = 0;
      for(const Index v : mesh.vertices(f))
        w += weights[v][0] / 3;
      m_face_normals[f] = normalized_or((1 - w) * m_face_normals[f] + w * gentle_normals[f], m_face_normals[f]);
    });
    for_each_index<ConcurrencyTag>(n, [&](const std::size_t v)
    { points[v] = points[v] + double(weights[v][0]) * (gentle.points[v] - points[v]); });
    mesh.swap_points(points);
  }

  Adaptive_parameters m_parameters;
  double m_noise_level;

  double m_mean_edge_length;
  double m_noise; // in the unit of the coordinates
  std::vector<Vector_3> m_face_normals;
  std::vector<double> m_leverages;
  std::vector<Vector_3> m_vertex_normals;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_ADAPTIVE_FITTING_H
