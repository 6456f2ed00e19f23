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
#include <CGAL/Surface_mesh_denoising/internal/Face_reassignment.h>
#include <CGAL/Surface_mesh_denoising/internal/Face_unfolding.h>
#include <CGAL/Surface_mesh_denoising/internal/Gentle_path.h>
#include <CGAL/Surface_mesh_denoising/internal/Linear_path.h>
#include <CGAL/Surface_mesh_denoising/internal/Noise_map.h>
#include <CGAL/Surface_mesh_denoising/internal/Normal_evolution.h>
#include <CGAL/Surface_mesh_denoising/internal/Patch_blend.h>
#include <CGAL/Surface_mesh_denoising/internal/Path_estimate.h>
#include <CGAL/Surface_mesh_denoising/internal/Quadric_path.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/keep_volume.h>
#include <CGAL/Surface_mesh_denoising/internal/mixing.h>
#include <CGAL/Surface_mesh_denoising/internal/noise_level.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>
#include <CGAL/Surface_mesh_denoising/internal/sine_key.h>
#include <CGAL/Surface_mesh_denoising/internal/tangential_noise.h>
#include <CGAL/Surface_mesh_denoising/internal/turn_faces.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Anisotropic surface fitting that chooses for itself: noise level -> pilot -> tangential noise -> patches, again from the
// pilot on where they show other noise than was thought, or that it differs from place to place -> patches anew, and beside
// them a gentle, a linear and a quadric path -> mixing -> reassignment of faces -> moves of agreement -> unfolding -> volume.
// Each stage knows only what the ones before it hand on.
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
  Denoising_result run(Indexed_triangle_mesh& mesh, std::vector<bool> is_movable, const Report& report)
  {
    Denoising_result result;
    m_mean_edge_length = mesh.mean_edge_length<ConcurrencyTag>();
    const Vertex_neighbors neighbors(mesh);
    find_noise_level(mesh, is_movable, neighbors);
    std::vector<Point_3> observed = mesh.points();
    std::vector<Point_3> original; // if other than the observed points
    const auto given = [&]() -> const std::vector<Point_3>& { return original.empty() ? observed : original; };
    std::vector<Point_3> pilot = observed;
    const auto end = [&]()
    {
      ++result.number_of_iterations;
      result.has_converged = true;
      report(result.number_of_iterations, largest_displacement(pilot, mesh.points()), true);
      return result;
    };
    if(m_strong_noise > 0 && !locate_noise(mesh, is_movable, neighbors, report, result))
      return result;
    if(is_free_of_noise())
      return end();

    for(std::size_t round=0; ; ++round)
    {
      if(!run_pilot(mesh, is_movable, report, result))
        return result;
      if(m_parameters.remove_tangential_noise)
        remove_tangential_noise(mesh, is_movable, neighbors, observed, original);
      pilot = mesh.points();
      fit_patches(mesh, observed, is_movable, neighbors, m_parameters.pilot_error,
                  m_parameters.refit_patches ? m_parameters.first_patches_effort : m_parameters.last_patches_effort);
      // with a noise level of the user's there is nothing to correct
      if(m_noise_level >= 0 || !correct_noise(round, mesh, is_movable, neighbors, observed, original))
        break;
      std::vector<Point_3> points = is_free_of_noise() ? given() : observed;
      mesh.swap_points(points);
      if(is_free_of_noise())
      {
        m_face_normals.clear();
        return end();
      }
    }

    if(m_parameters.refit_patches)
      fit_patches(mesh, observed, is_movable, neighbors, m_parameters.first_patches_error, m_parameters.last_patches_effort);

    m_patch_shares.assign(mesh.number_of_faces(), 1);
    if(m_parameters.use_gentle_path || m_parameters.use_linear_path || m_parameters.use_quadric_path)
      mix_with_paths(mesh, observed, is_movable, neighbors);
    const std::size_t number_of_moves = (std::max)(m_parameters.final_least_number_of_moves,
                                                   std::size_t(m_parameters.final_number_of_moves * relative_noise()));
    if(m_parameters.reassign_faces)
    {
      move_to_agree(mesh, is_movable, m_parameters.final_least_number_of_moves, m_parameters.final_relaxation);
      reassign_faces(mesh, given(), observed, is_movable, neighbors);
    }
    move_to_agree(mesh, is_movable, number_of_moves, m_parameters.final_relaxation);
    if(m_parameters.unfold_faces)
      unfold_faces(mesh, observed, is_movable, neighbors, m_parameters.unfolding_of_result);
    if(m_parameters.preserve_volume)
      keep_volume<ConcurrencyTag>(mesh, m_has_impulses ? observed : given(), is_movable, m_noise,
                                  m_parameters.volume_penalty);

    return end();
  }

private:
  double relative_noise() const { return m_noise.level / m_mean_edge_length; }
  bool is_negligible(const double noise) const { return !(noise > m_parameters.negligible_noise * m_mean_edge_length); }
  bool is_free_of_noise() const { return is_negligible(m_noise.level); }

  // about how far chance takes a correlation or a ratio of two levels
  static double error_of_statistics(const std::vector<bool>& counts)
  { return 1 / std::sqrt(double(std::count(counts.begin(), counts.end(), true))); }

  // noise that is located has shown that it is no shape
  bool residuals_may_be_shape() const { return m_noise.is_uniform() && relative_noise() < m_parameters.shape_noise; }

  void find_noise_level(Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable, const Vertex_neighbors& neighbors)
  {
    if(m_noise_level >= 0)
    {
      m_noise.level = in_noisy_edge_lengths(m_noise_level) * m_mean_edge_length;
      return;
    }
    const Noise_estimate estimate = estimate_noise<ConcurrencyTag>(mesh, m_mean_edge_length, neighbors, is_movable,
                                                                   m_parameters.locate_noise);
    m_may_be_free_of_noise = estimate.may_be_shape;
    m_noise.level = (m_may_be_free_of_noise && !m_parameters.refine_noise_level) ? 0 : estimate.level;
    if(estimate.strong_level > m_parameters.least_located_noise * m_mean_edge_length)
      m_strong_noise = estimate.strong_level;
  }

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
    const double noise = relative_noise();
    const double first_range = (std::min)(m_parameters.pilot_first_range * noise, m_parameters.largest_range);
    const double last_range = (std::min)(m_parameters.pilot_last_range * noise, m_parameters.pilot_maximal_last_range);
    const std::size_t number_of_steps
      = m_parameters.pilot_number_of_steps
      + std::size_t(m_parameters.pilot_steps_by_strong_noise * (std::max)(0., noise - m_parameters.pilot_strong_noise));
    Normal_evolution<ConcurrencyTag> evolve;
    for(std::size_t k=0; k<number_of_steps; ++k)
    {
      const double progress = double(k) / double(number_of_steps - 1);
      const std::vector<Point_3> before = mesh.points();
      if(k % m_parameters.pilot_steps_between_weights == 0)
        evolve.update_weights(mesh, m_noise);
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

  // Patches that take the noise to be as strong everywhere as where it seems strongest tell whether that is noise, and how strong
  // it is in each place. Vertices that have none are not to move. Leaves the points as they are. Returns whether to go on
  template <typename Report>
  bool locate_noise(Indexed_triangle_mesh& mesh, std::vector<bool>& is_movable, const Vertex_neighbors& neighbors,
                    const Report& report, Denoising_result& result)
  {
    const std::vector<Point_3> observed = mesh.points();
    const double level = m_noise.level;
    m_noise.level = m_strong_noise;
    if(!run_pilot(mesh, is_movable, report, result))
      return false;
    fit_patches(mesh, observed, is_movable, neighbors, m_parameters.pilot_error, m_parameters.first_patches_effort);
    const Local_levels local = levels_of_residuals(mesh, observed, is_movable, neighbors);
    std::vector<Point_3> points = observed;
    mesh.swap_points(points);
    m_noise.level = level;
    if(!is_noise_of_places(local))
      return true;
    set_noise(local);
    for(std::size_t v=0; v<is_movable.size(); ++v)
      is_movable[v] = is_movable[v] && m_noise.ratios[v] > float(m_parameters.limits_of_located_ratios[0]);
    m_may_be_free_of_noise = false;
    return true;
  }

  // Detail of the shape and impulses make residuals that differ from place to place, too. But those of detail are not as white as
  // noise, and the less they are, the more they have to differ; and those of impulses have heavy tails, but never differ much
  bool is_noise_of_places(const Local_levels& local) const
  {
    const Adaptive_parameters& p = m_parameters;
    const double correlation = (std::max)(local.correlations[0], local.correlations[1]);
    const double least_spread = p.least_located_spread
      + p.located_spread_by_correlation * (std::max)(0., correlation - p.correlation_of_located_noise);
    return local.strong > p.located_share_of_level * m_strong_noise
        && local.strong > p.least_located_noise * m_mean_edge_length
        && local.correlations[0] < p.largest_located_correlation
        && (local.normality > p.located_normality || local.strong > p.spread_beyond_impulses * local.weak)
        && local.strong > least_spread * local.weak;
  }

  // of what the patches leave, with what they follow
  Local_levels levels_of_residuals(const Indexed_triangle_mesh& mesh, const std::vector<Point_3>& observed,
                                   const std::vector<bool>& is_movable, const Vertex_neighbors& neighbors) const
  {
    std::vector<Vector_3> normals;
    compute_vertex_normals<ConcurrencyTag>(mesh, normals);
    std::vector<double> residuals = compute_residuals(mesh, observed, normals);
    add_what_patches_follow(residuals);
    return local_levels<ConcurrencyTag>(neighbors, is_movable, std::move(residuals), 1, deviation_of_differences());
  }

  // What seems to be shape as it differs from place to place is noise all the same if it is white. Returns whether it is
  bool locate_white_noise(const std::vector<bool>& is_movable, const Vertex_neighbors& neighbors,
                          const std::vector<double>& residuals)
  {
    const Adaptive_parameters& p = m_parameters;
    if(!(correlation_of_neighbors<ConcurrencyTag>(neighbors, residuals, is_movable) < p.correlation_of_white_noise))
      return false;
    const Local_levels local = local_levels<ConcurrencyTag>(neighbors, is_movable, residuals, 1, deviation_of_differences());
    if(!(local.strong > (std::max)(p.least_white_noise * m_mean_edge_length, m_noise.level)
         && local.normality > p.normality_of_white_noise
         && (std::max)(local.correlations[0], local.correlations[1]) < p.correlation_of_white_differences))
      return false;
    set_noise(local);
    return true;
  }

  void set_noise(const Local_levels& local)
  {
    m_noise.level = m_parameters.refined_level_factor * local.strong;
    const std::array<double, 2>& limits = m_parameters.limits_of_located_ratios;
    m_noise.ratios.resize(local.levels.size());
    for_each_index<ConcurrencyTag>(m_noise.ratios.size(), [&](const std::size_t v)
    { m_noise.ratios[v] = float((std::min)((std::max)(local.levels[v] / local.strong, limits[0]), limits[1])); });
  }

  void move_to_agree(Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable, const std::size_t number_of_moves,
                     const double relaxation) const
  {
    turn_faces<ConcurrencyTag>(mesh, is_movable, m_face_normals, number_of_moves, m_parameters.moves_between_weights,
                               relaxation);
  }

  // Slides depend on where the pilot saw the edges: observed points take part in them with care
  void reassign_faces(Indexed_triangle_mesh& mesh, const std::vector<Point_3>& given, const std::vector<Point_3>& observed,
                      const std::vector<bool>& is_movable, const Vertex_neighbors& neighbors)
  {
    std::vector<Point_3> partly_slid;
    if(m_vertices_slide)
    {
      partly_slid.resize(given.size());
      for_each_index<ConcurrencyTag>(given.size(), [&](const std::size_t v)
      { partly_slid[v] = given[v] + m_parameters.reassignment_slide * (observed[v] - given[v]); });
    }
    const std::array<double, 2>& ratios = m_parameters.normal_noise_ratios;
    const double certainty = m_parameters.remove_tangential_noise // else nothing is known of it
      ? 1 - ramp(m_bound_of_tangential_noise, ratios[0], ratios[1]) : 0;
    const double tangential_weight = m_parameters.reassignment_tangential_weight * certainty;
    Face_reassignment<ConcurrencyTag>(mesh, m_vertices_slide ? partly_slid : given, is_movable, neighbors, m_noise,
                                      tangential_weight, m_patch_shares, m_parameters, m_face_normals).run();
  }

  void unfold_faces(Indexed_triangle_mesh& mesh, const std::vector<Point_3>& observed, const std::vector<bool>& is_movable,
                    const Vertex_neighbors& neighbors, const Unfolding_limits& limits) const
  {
    Face_unfolding<ConcurrencyTag>(mesh, observed, is_movable, neighbors, m_noise.level, m_noise_turns_faces, limits,
                                   m_parameters).run();
  }

  // Where noise moved vertices along the surface, too, they slide back to where triangles are even, in `mesh` and by the
  // same way in `observed`; `original` keeps what was observed. Unfolding the pilot first keeps large folds from spreading
  void remove_tangential_noise(Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                               const Vertex_neighbors& neighbors, std::vector<Point_3>& observed,
                               std::vector<Point_3>& original)
  {
    const Tangential_noise_ratio ratio = tangential_noise_ratio<ConcurrencyTag>(mesh, observed, m_noise, m_parameters);
    m_noise_turns_faces = m_noise_turns_faces || ratio.value > m_parameters.turning_ratio;
    m_bound_of_tangential_noise = (std::max)(m_bound_of_tangential_noise, ratio.upper_bound);
    double certainty = ramp(ratio.value, m_parameters.least_tangential_ratio, m_parameters.sure_tangential_ratio);
    if(certainty < 1 && ratio.expected_share < m_parameters.least_told_share)
    {
      std::vector<Vector_3> normals, ways;
      compute_vertex_normals<ConcurrencyTag>(mesh, normals);
      compute_ways_to_centers<ConcurrencyTag>(mesh, neighbors, normals, ways);
      if(are_ways_of_noise<ConcurrencyTag>(ways, neighbors, m_noise, m_parameters))
        certainty = 1;
    }
    if(certainty == 0)
      return;
    m_vertices_slide = true;
    const std::vector<Point_3> before = mesh.points();
    if(m_parameters.unfold_faces)
      unfold_faces(mesh, observed, is_movable, neighbors, m_parameters.unfolding_of_pilot);
    relax_along_surface<ConcurrencyTag>(mesh, is_movable, neighbors,
                                        m_parameters.sliding_share * certainty, m_noise, m_parameters);

    std::vector<Vector_3> normals;
    compute_vertex_normals<ConcurrencyTag>(mesh, normals);
    if(original.empty())
      original = observed;
    for_each_index<ConcurrencyTag>(observed.size(), [&](const std::size_t v)
    {
      observed[v] = observed[v] + along_surface(mesh.point(v) - before[v], normals[v]);
    });
  }

  // What the patches tell of the noise. Returns whether that is something else than was thought: then they are to be made anew
  bool correct_noise(const std::size_t round, const Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                     const Vertex_neighbors& neighbors, std::vector<Point_3>& observed, std::vector<Point_3>& original)
  {
    if(round == 0)
      m_first_noise = m_noise.level;
    const bool were_of_shape = m_residuals_are_shape;
    if(round >= m_parameters.correction_number_of_rounds && !were_of_shape)
      return false;
    m_residuals_are_shape = false;

    std::vector<Vector_3> normals;
    compute_vertex_normals<ConcurrencyTag>(mesh, normals);
    std::vector<double> residuals = compute_residuals(mesh, observed, normals);
    // from here on as if noise were as strong everywhere
    for_each_index<ConcurrencyTag>(residuals.size(), [&](const std::size_t v) { residuals[v] /= m_noise.ratio(v); });
    const std::vector<bool> counts = places_with_noise(is_movable);
    const auto is_white = [&]()
    {
      return level_of_white_noise<ConcurrencyTag>(mesh, observed, m_mean_edge_length, neighbors, is_movable) > 0;
    };
    if(round == 0 && ((m_may_be_free_of_noise && !are_of_noise_after_all(mesh, counts, neighbors, residuals))
                      || (m_parameters.refine_noise_level
                          && are_of_triangulation(mesh, counts, residuals, is_white))))
    {
      m_noise.level = 0;
      return true;
    }
    if(m_parameters.remove_impulses
       && remove_impulses(counts, neighbors, normals, residuals, were_of_shape, observed, original))
      return true;
    return m_parameters.refine_noise_level && !m_has_impulses
           && refine_noise_level(round, counts, neighbors, std::move(residuals), is_white);
  }

  // the vertices that tell of the noise: none where there is hardly any
  std::vector<bool> places_with_noise(const std::vector<bool>& is_movable) const
  {
    std::vector<bool> result = is_movable;
    for(std::size_t v=0; v<result.size(); ++v)
      result[v] = result[v] && m_noise.ratio(v) > m_parameters.least_located_ratio;
    return result;
  }

  // how far observed points are above the surface
  static std::vector<double> compute_residuals(const Indexed_triangle_mesh& mesh, const std::vector<Point_3>& observed,
                                               const std::vector<Vector_3>& normals)
  {
    std::vector<double> residuals(observed.size());
    for_each_index<ConcurrencyTag>(residuals.size(), [&](const std::size_t v)
    { residuals[v] = (observed[v] - mesh.point(v)) * normals[v]; });
    return residuals;
  }

  static double root_mean_square(const std::vector<bool>& is_movable, const std::vector<double>& residuals, const double limit)
  {
    const double squares = sum<ConcurrencyTag>(residuals.size(), [&](const std::size_t v)
    {
      const double r = is_movable[v] ? (std::min)(std::abs(residuals[v]), limit) : 0;
      return r * r;
    });
    return std::sqrt(squares / double(std::count(is_movable.begin(), is_movable.end(), true)));
  }

  // Vertices of level sets of functions on grids lie on chords: what they are off is no more than triangles leave of the shape.
  // `is_white()` tells whether there is white noise beside cubics
  template <typename Is_white>
  bool are_of_triangulation(const Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                            const std::vector<double>& residuals, const Is_white& is_white) const
  {
    if(!residuals_may_be_shape())
      return false;
    const double size = root_mean_square(is_movable, residuals, (std::numeric_limits<double>::max)());
    const double sagitta = median_sagitta(mesh, m_face_normals);
    return size < m_parameters.white_triangulation_noise * sagitta
        || (size < m_parameters.triangulation_noise * sagitta && !is_white());
  }

  // to the residuals: the share of the noise that their leverages tell
  void add_what_patches_follow(std::vector<double>& residuals) const
  {
    for_each_index<ConcurrencyTag>(residuals.size(), [&](const std::size_t v)
    { residuals[v] /= std::sqrt((std::max)(1 - m_leverages[v], m_parameters.least_rest_of_noise)); });
  }

  double refined_level(const std::vector<bool>& is_movable, const Vertex_neighbors& neighbors,
                       std::vector<double> residuals) const
  {
    subtract_mean_of_neighbors<ConcurrencyTag>(neighbors, residuals);
    return m_parameters.refined_level_factor * median_of_absolutes(residuals, is_movable)
         / (median_of_normal_distribution * deviation_of_differences());
  }

  // that of white noise with the deviation one, less the mean of six neighbors, as there are in the mean
  static double deviation_of_differences() { return std::sqrt(1 + 1. / 6); }

  // Edges on coarse triangles hide weak noise from quadrics of two rings, which take all for shape, but not from patches: they
  // fit the edges, and what they leave is less than it seemed, and nowhere shape. Detail they leave, too, or they follow it.
  // What is as strong everywhere and has opposite signs at neighbors is noise even if it is as much as it seemed
  bool are_of_noise_after_all(const Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                              const Vertex_neighbors& neighbors, std::vector<double> residuals) const
  {
    const Adaptive_parameters& p = m_parameters;
    add_what_patches_follow(residuals);
    const double level = refined_level(is_movable, neighbors, residuals);
    if(is_negligible(level))
      return false;
    const Quiet_places quiet = quiet_places<ConcurrencyTag>(neighbors, residuals, is_movable);
    const double correlation = correlation_of_neighbors<ConcurrencyTag>(neighbors, residuals, quiet.are_there);
    if(level > p.least_plain_noise * m_mean_edge_length && level < p.level_of_plain_noise * m_noise.level
       && level < p.height_of_plain_noise * mean_height_of_all_faces(mesh)
       && correlation < p.correlation_of_plain_noise && quiet.uniformity > p.uniformity_of_plain_noise)
      return true;
    if(!(level < p.level_of_hidden_noise * m_noise.level)
       || median_of_absolutes(m_leverages, is_movable) > p.leverage_of_hidden_noise
       || !(correlation < p.correlation_of_hidden_noise))
      return false;
    if(level < p.weak_hidden_noise * m_mean_edge_length)
      return quiet.uniformity > p.uniformity_of_weak_hidden_noise
          && correlation_of_sizes<ConcurrencyTag>(neighbors, residuals, is_movable) < 0;
    return !are_mostly_of_shape<ConcurrencyTag>(neighbors, residuals, is_movable, quiet, p.uniformity_of_hidden_noise);
  }

  // What patches leave of noise has opposite signs at neighbors, the more the patches follow it; what they leave of the shape
  // has the same sign, most of it at edges and in other places that are not quiet
  static double correlation_of_residuals(const std::vector<bool>& is_movable, const Vertex_neighbors& neighbors,
                                         const std::vector<double>& residuals, const Quiet_places& quiet)
  {
    return (std::min)(correlation_of_neighbors<ConcurrencyTag>(neighbors, residuals, is_movable),
                      correlation_of_neighbors<ConcurrencyTag>(neighbors, residuals, quiet.are_there));
  }

  // The noise level rests on quadrics of two rings, which know no edges and hide detail of the shape in the noise. Patches tell
  // them apart, unless most of what they leave is shape: then a lower level makes patches that follow it. Where hardly any of
  // the first level is left there is no noise. Returns whether the level has become much lower
  template <typename Is_white>
  bool refine_noise_level(const std::size_t round, const std::vector<bool>& is_movable, const Vertex_neighbors& neighbors,
                          std::vector<double> residuals, const Is_white& is_white)
  {
    add_what_patches_follow(residuals);
    double share = 1;
    if(residuals_may_be_shape())
    {
      const Quiet_places quiet = quiet_places<ConcurrencyTag>(neighbors, residuals, is_movable);
      const double correlation = correlation_of_residuals(is_movable, neighbors, residuals, quiet);
      const double correlation_of_noise = -m_parameters.correlation_by_leverage
                                        * std::sqrt(median_of_absolutes(m_leverages, is_movable));
      const auto share_of_noise = [&](const double c)
      { return 1 - ramp(c, correlation_of_noise, m_parameters.correlation_of_shape); };
      share = share_of_noise(correlation); // in the squares of the residuals
      m_residuals_are_shape = share_of_noise(correlation + 2 * error_of_statistics(is_movable))
                              < m_parameters.least_share_of_noise
                           || are_mostly_of_shape<ConcurrencyTag>(neighbors, residuals, is_movable, quiet);
      if(m_residuals_are_shape && round == 0)
      {
        // they are noise that differs from place to place, or of a shape that patches are too stiff for, and cubics are not
        const bool is_located = m_parameters.locate_noise && locate_white_noise(is_movable, neighbors, residuals);
        if(is_located || is_white())
        {
          m_residuals_are_shape = false;
          return is_located;
        }
      }
      m_residuals_are_shape = m_residuals_are_shape && share < 1; // else they are as those of noise, however they differ
    }
    const double level = std::sqrt(share) * refined_level(is_movable, neighbors, std::move(residuals));
    if(m_residuals_are_shape)
    {
      const std::array<double, 2>& limits = m_parameters.refined_level_of_shape;
      m_noise.level = (std::min)((std::max)(level, limits[0] * m_noise.level), limits[1] * m_noise.level);
      if(m_noise.level < m_parameters.least_share_of_first_level * m_first_noise)
        m_noise.level = 0;
      return true;
    }
    if(round >= m_parameters.correction_number_of_rounds || !(level < m_parameters.refined_level_limit * m_noise.level))
      return false;
    m_noise.level = (std::max)(level, m_parameters.least_refined_level * m_noise.level);
    return true;
  }

  // Impulses leave the median of the residuals, on which the noise level rests, as it is: tails that are too heavy for it tell
  // them, unless the shape makes them, as where residuals `were_of_shape` the time before. Then the observed points lose what
  // their residuals have too much, and the noise level is raised so that a pilot leaves nothing of what remains; later rounds
  // see how much that is, and lower it, or need not. `original` keeps what was observed. Returns whether there is more to do
  bool remove_impulses(const std::vector<bool>& is_movable, const Vertex_neighbors& neighbors,
                       const std::vector<Vector_3>& normals, const std::vector<double>& residuals, const bool were_of_shape,
                       std::vector<Point_3>& observed, std::vector<Point_3>& original)
  {
    const double median_deviation = median_of_absolutes(residuals, is_movable) / median_of_normal_distribution;
    const auto size_of_residuals = [&](const double limit) { return root_mean_square(is_movable, residuals, limit); };
    if(!(median_deviation > 0))
      return false;
    const double limit = m_parameters.largest_residual * median_deviation;
    if(!m_has_impulses)
    {
      const double ratio = size_of_residuals(m_parameters.largest_tail * median_deviation) / median_deviation;
      const double least_share = were_of_shape ? m_parameters.least_share_of_impulses_in_shape
                                               : m_parameters.least_share_of_impulses;
      const double chance = residuals_may_be_shape() ? error_of_statistics(is_movable) / 2 : 0;
      if(!(ratio >= m_parameters.heavy_tail + chance)
         || (residuals_may_be_shape()
             && (are_of_shape<ConcurrencyTag>(neighbors, residuals, is_movable, limit)
                 || share_of_impulses<ConcurrencyTag>(neighbors, residuals, is_movable) < least_share)))
        return false;
      m_has_impulses = true;
      m_noise.level = (std::min)(ratio * m_noise.level,
                                 m_parameters.maximal_correction * size_of_residuals((std::numeric_limits<double>::max)()));
    }
    else
    {
      const double noise = m_parameters.maximal_correction * size_of_residuals(limit);
      if(!(noise < m_noise.level))
        return false;
      m_noise.level = noise;
    }

    if(original.empty())
      original = observed;
    for_each_index<ConcurrencyTag>(residuals.size(), [&](const std::size_t v)
    {
      const double r = residuals[v];
      if(is_movable[v] && std::abs(r) > limit)
        observed[v] = observed[v] + ((std::copysign(limit, r) - r) * m_noise.ratio(v)) * normals[v];
    });
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
      disturbances[v] = is_movable[v] ? std::sqrt(2.) * m_noise.at(v) * sine_key(length) : 0;
    });
    return disturbances;
  }

  // `mesh` holds the pilot, and then the result. The first patches are a better pilot than the one that they grow over
  void fit_patches(Indexed_triangle_mesh& mesh, const std::vector<Point_3>& observed, const std::vector<bool>& is_movable,
                   const Vertex_neighbors& neighbors, const Pilot_error& pilot_error, const Patch_effort& effort)
  {
    std::vector<Point_3> points;
    {
      const Patch_blend<ConcurrencyTag> blend(mesh, observed, is_movable, m_noise, m_mean_edge_length, m_parameters,
                                              pilot_error, effort);
      m_face_normals = blend.face_normals();
      points = blend.points();
      m_leverages = blend.leverages();
      m_noise_shares = blend.noise_shares(neighbors);
      m_normal_deviations = blend.normal_deviations(m_leverages);
    }
    mesh.swap_points(points);
    move_to_agree(mesh, is_movable, m_parameters.patch_number_of_moves, m_parameters.patch_relaxation);
  }

  // Patches are best where the surface is made of smooth pieces, the gentle path where it is full of detail, the linear one
  // where triangles are smaller than the noise, and the quadric one where the surface is smooth but bent within few of them
  void mix_with_paths(Indexed_triangle_mesh& mesh, const std::vector<Point_3>& observed,
                      const std::vector<bool>& is_movable, const Vertex_neighbors& neighbors)
  {
    std::vector<Vector_3> normals;
    compute_vertex_normals<ConcurrencyTag>(mesh, normals);
    const std::vector<double> disturbances = make_disturbances(mesh, observed, is_movable);
    const auto mix_with_path = [&](const auto& make_path, const auto& global_band_ends, const auto& local_band_ends,
                                   const Preference& preference)
    {
      Estimate estimate;
      {
        auto path = make_path(); // may use `mesh` as long as it lives
        estimate = estimate_along<ConcurrencyTag>(path, observed, normals, neighbors, m_noise, global_band_ends,
                                                  local_band_ends, m_parameters);
        // ways along the surface are only for places that the path is for
        for_each_index<ConcurrencyTag>(observed.size(), [&](const std::size_t v)
        {
          const Vector_3 way = along_surface(estimate.points[v] - mesh.point(v), normals[v]);
          estimate.points[v] = estimate.points[v] - path.least_weight(v, local_band_ends.back()) * way;
        });
      }
      mix(mesh, observed, normals, neighbors, preference, estimate);
    };
    if(m_parameters.use_gentle_path)
    {
      const Shares_of_edges shares = shares_of_edges(mesh);
      const bool has_last_steps = shares.in_planes < m_parameters.gentle_largest_share_in_planes
                               && shares.sharp < m_parameters.gentle_largest_share_of_sharp_edges;
      mix_with_path([&]()
                    {
                      return Gentle_path<ConcurrencyTag>(mesh, observed, is_movable, neighbors, normals, disturbances,
                                                         m_normal_deviations, m_noise, m_mean_edge_length, has_last_steps,
                                                         m_parameters);
                    }, m_parameters.gentle_global_band_ends, m_parameters.gentle_local_band_ends,
                    Preference{ mesh_penalty_of_gentle_path(shares), 0 });
    }
    if(m_parameters.use_linear_path)
      mix_with_path([&]()
                    {
                      return Linear_path<ConcurrencyTag>(mesh, observed, is_movable, neighbors, disturbances, m_noise,
                                                         m_parameters);
                    }, m_parameters.linear_global_band_ends, m_parameters.linear_local_band_ends,
                    Preference{ m_parameters.mesh_penalty, 0 });
    if(m_parameters.use_quadric_path && !m_has_impulses
       && m_noise.level < m_parameters.quadric_largest_noise * mean_height_of_all_faces(mesh))
      mix_with_path([&]()
                    {
                      return Quadric_path<ConcurrencyTag>(mesh, observed, is_movable, neighbors, normals, disturbances,
                                                          m_mean_edge_length, m_parameters);
                    }, m_parameters.quadric_global_band_ends, m_parameters.quadric_local_band_ends,
                    Preference{ m_parameters.mesh_penalty_of_quadric_path,
                                m_parameters.advantage_over_quadric_path });
  }

  // what patches see of planes and of edges: the shares of all edges
  struct Shares_of_edges
  {
    double in_planes, sharp;
  };

  Shares_of_edges shares_of_edges(const Indexed_triangle_mesh& mesh) const
  {
    std::size_t number = 0, number_in_planes = 0, number_of_sharp = 0;
    for(std::size_t f=0; f<mesh.number_of_faces(); ++f)
      for(const Index g : mesh.neighbors(f))
        if(g != Indexed_triangle_mesh::null_index() && g > f)
        {
          const double cosine = m_face_normals[f] * m_face_normals[g];
          ++number;
          number_in_planes += (cosine > m_parameters.cosine_in_planes);
          number_of_sharp += (cosine < m_parameters.cosine_at_edges);
        }
    if(number == 0)
      return { 1, 1 };
    return { double(number_in_planes) / double(number), double(number_of_sharp) / double(number) };
  }

  // Where all is smooth and noise is strong, hardly anything speaks for patches beforehand
  double mesh_penalty_of_gentle_path(const Shares_of_edges& shares) const
  {
    const Adaptive_parameters& p = m_parameters;
    const auto lack = [](const double share, const std::array<double, 2>& limits)
    { return 1 - ramp(share, limits[0], limits[1]); };
    const double smoothness = lack(shares.in_planes, p.shares_in_planes) * lack(shares.sharp, p.shares_of_sharp_edges);
    const double strength = ramp(relative_noise(), p.noise_of_smooth_surfaces[0], p.noise_of_smooth_surfaces[1]);
    return p.mesh_penalty + strength * smoothness * (p.mesh_penalty_of_smooth_surfaces - p.mesh_penalty);
  }

  // The lower the triangles around a vertex are, the further its error turns them. The mean is about one
  std::vector<float> importance_of_vertices(const Indexed_triangle_mesh& mesh) const
  {
    const double least_height = m_parameters.least_height_of_importance * m_noise.level;
    std::vector<float> importance(mesh.number_of_vertices());
    for_each_index<ConcurrencyTag>(importance.size(), [&](const std::size_t v)
    {
      const double height = mean_height_of_faces(mesh, mesh.faces_around_vertex(v),
                                                 [&](const Index f) { return mesh.area(f); });
      importance[v] = float(m_mean_edge_length / std::sqrt(height * height + least_height * least_height));
    });
    const double mean = sum<ConcurrencyTag>(importance.size(), [&](const std::size_t v) { return double(importance[v]); })
                      / double(importance.size());
    const std::array<double, 2>& limits = m_parameters.limits_of_importance;
    for_each_index<ConcurrencyTag>(importance.size(), [&](const std::size_t v)
    { importance[v] = float((std::min)((std::max)(importance[v] / mean, limits[0]), limits[1])); });
    return importance;
  }

  static double mean_height_of_all_faces(const Indexed_triangle_mesh& mesh)
  {
    return mean_height_of_faces(mesh, boost::irange(std::size_t(0), mesh.number_of_faces()),
                                [&](const std::size_t f) { return mesh.area(f); });
  }

  // of the result so far over an estimate
  struct Preference
  {
    double mesh_penalty; // see mixing.h
    double advantage;    // of patches, in squared distances, times noise^2
  };

  // what the faces around vertex `v` have of the patches
  double patch_share(const Indexed_triangle_mesh& mesh, const std::size_t v) const
  {
    const auto faces = mesh.faces_around_vertex(v);
    double sum = 0;
    for(const Index f : faces)
      sum += m_patch_shares[f];
    return faces.empty() ? 0 : sum / double(faces.size());
  }

  // mixes the result so far with another estimate, which has nothing to say where it has not left the observed points
  void mix(Indexed_triangle_mesh& mesh, const std::vector<Point_3>& observed, const std::vector<Vector_3>& normals,
           const Vertex_neighbors& neighbors, const Preference& preference, Estimate& estimate)
  {
    const std::size_t n = mesh.number_of_vertices();
    std::vector<Mixing_moments<1> > moments(n);
    for_each_index<ConcurrencyTag>(n, [&](const std::size_t v)
    {
      if(estimate.points[v] == observed[v])
      {
        estimate.points[v] = mesh.point(v);
        estimate.noise_shares[v] = m_noise_shares[v];
      }
      const double difference = (estimate.points[v] - mesh.point(v)) * normals[v];
      const double noise_share = estimate.noise_shares[v] - m_noise_shares[v]
                               + preference.advantage * patch_share(mesh, v) * m_noise.at(v) * m_noise.at(v);
      moments[v].products[0] = float((observed[v] - mesh.point(v)) * normals[v] * difference - noise_share);
      moments[v].squares[0] = float(difference * difference);
    });
    const std::vector<float> importance = importance_of_vertices(mesh);
    std::vector<std::array<float, 1> > weights
      = local_weights<ConcurrencyTag>(neighbors, m_parameters, m_noise.level * m_noise.level,
                                      Mixing_penalties{ preference.mesh_penalty, m_parameters.mixing_penalty },
                                      [&](const std::size_t v) { return importance[v] / m_noise.squared_ratio(v); }, moments);

    std::vector<Point_3> points(n);
    for_each_index<ConcurrencyTag>(n, [&](const std::size_t v)
    {
      // the mean of two good estimates is worse than the better one where edges are concerned
      float& weight = weights[v][0];
      weight = float(smooth_step(weight));
      const double w = weight;
      points[v] = mesh.point(v) + w * (estimate.points[v] - mesh.point(v));
      m_noise_shares[v] += w * (estimate.noise_shares[v] - m_noise_shares[v]);
    });
    mesh.swap_points(points);

    std::vector<Vector_3> mixed_normals;
    std::vector<double> areas;
    compute_face_normals<ConcurrencyTag>(mesh, mixed_normals, areas);
    steady_normals_of_low_faces<ConcurrencyTag>(mesh, areas, m_parameters.low_face_error * m_noise.level,
                                                m_parameters.number_of_normal_averages, mixed_normals);
    replace_turned_normals<ConcurrencyTag>(mesh, areas, m_parameters.agreement, mixed_normals);
    for_each_index<ConcurrencyTag>(mesh.number_of_faces(), [&](const std::size_t f)
    {
      double w = 0;
      for(const Index v : mesh.vertices(f))
        w += weights[v][0] / 3;
      m_patch_shares[f] *= float(1 - w);
      m_face_normals[f] = normalized_or((1 - w) * m_face_normals[f] + w * mixed_normals[f], m_face_normals[f]);
    });
  }

  Adaptive_parameters m_parameters;
  double m_noise_level;

  double m_mean_edge_length;
  Noise_map m_noise;
  double m_strong_noise = 0; // where noise may be stronger than thought, or zero
  std::vector<Vector_3> m_face_normals;
  std::vector<Vector_3> m_normal_deviations; // of the faces of the patches, see Patch_blend.h
  std::vector<double> m_leverages;    // of the patches
  std::vector<double> m_noise_shares; // of the result so far, see mixing.h
  std::vector<float> m_patch_shares;  // what each face has of the patches, in the result so far
  double m_first_noise;               // before the patches told what it is
  bool m_may_be_free_of_noise = false;
  bool m_noise_turns_faces = false;
  bool m_vertices_slide = false;
  double m_bound_of_tangential_noise = 0; // on the ratio in tangential_noise.h
  bool m_has_impulses = false;
  bool m_residuals_are_shape = false; // most of what the last patches left
  std::vector<Vector_3> m_vertex_normals;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_ADAPTIVE_FITTING_H
