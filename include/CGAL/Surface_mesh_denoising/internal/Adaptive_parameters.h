// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_ADAPTIVE_PARAMETERS_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_ADAPTIVE_PARAMETERS_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// What is known of the points that patches grow over
struct Pilot_error
{
  double noise;       // what is left of the noise in them, times noise
  double correlation; // about so many neighbors share it
  bool is_fine;       // they tell what bends: patches over them may be cubics, and faces have the normals of triangles
};

// How much work patches are worth
struct Patch_effort
{
  double hopeless_risk; // a patch stops growing when its risk is so many times the least
  double core_share;    // the share of the faces of a patch that need none of their own
};

// How far noise may have gone where it turned faces over. Times noise
struct Unfolding_limits
{
  double reach;       // that of a vertex
  double height;      // faces that are lower than this may be turned whatever their areas
};

// All constants of adaptive fitting. Lengths are in mean edge lengths; `noise` stands for the noise level in mean edge
// lengths. None of them belongs to a model: they hold for all meshes.
struct Adaptive_parameters
{
  // what can be switched off
  bool use_adaptive_neighborhoods = true;
  bool use_adaptive_degree = true;
  bool use_round_patches = true;
  bool refit_patches = true;
  bool use_gentle_path = true;
  bool use_linear_path = true;
  bool use_quadric_path = true;
  bool remove_tangential_noise = true;
  bool remove_impulses = true;
  bool refine_noise_level = true;
  bool locate_noise = true;
  bool reassign_faces = true;
  bool unfold_faces = true;
  bool preserve_volume = true;

  // Below this the mesh counts as free of noise.
  double negligible_noise = 1e-4;

  // What the patches tell of the noise may send back to the pilot,
  std::size_t correction_number_of_rounds = 2;  // or more while most of what they leave is shape.
  double shape_noise = 0.2;                     // Below this, what they leave may be shape

  // Where all seems to be shape, patches show noise if the level that they tell is less than so many times that which seemed,
  double level_of_hidden_noise = 0.85;
  double leverage_of_hidden_noise = 0.15;       // they do not follow all that there is (half of them have less leverage),
  double correlation_of_hidden_noise = 0.1;     // neighbors in quiet places have less in common than this,
  double uniformity_of_hidden_noise = 0.7;      // and what they leave is no less uniform than this or does not lie together.
  double weak_hidden_noise = 0.006;             // Detail may be as weak as so many mean edge lengths: below,
  double uniformity_of_weak_hidden_noise = 0.75; // it has to be more uniform, and not lie together at all.
  // They are noise, too, if their level is more than so many mean edge lengths,
  double least_plain_noise = 0.02;
  double level_of_plain_noise = 1.25;           // less than so many times that which seemed,
  double height_of_plain_noise = 0.25;          // and than so many times the mean height of triangles,
  double correlation_of_plain_noise = -0.05;    // neighbors in quiet places have less in common than this,
  double uniformity_of_plain_noise = 0.75;      // and they are more uniform than this.

  // Residuals whose root mean square is less than so many times the median height of an arc of the shape over an edge are those
  // of the triangulation, and there is no noise.
  double triangulation_noise = 2;
  double white_triangulation_noise = 1.5;       // the same where there is white noise beside cubics

  // Impulses: the root mean square of the residuals is more than so many times what their median tells of a normal
  // distribution. The noise then counts for as much more, but for no more than so many times its root mean square.
  double heavy_tail = 1.08;
  double least_share_of_impulses = 8e-4;        // of the vertices stand alone, else weak noise has no impulses,
  double least_share_of_impulses_in_shape = 0.015; // or so many where residuals have been mostly of shape
  double largest_tail = 10;                     // standard deviations, as the median tells them: beyond, residuals are cut,
  double largest_residual = 4;                  // and the observed points here
  double maximal_correction = 1.5;              // and in later rounds for just so many times that of what remains

  // Noise is stronger in some places than in others if what patches leave where it is strongest, see noise_level.h,
  double located_share_of_level = 0.6;          // is no less than so many times what was thought,
  double least_located_noise = 0.06;            // no weaker than this,
  double largest_located_correlation = -0.19;   // white: neighbors have no more in common than this;
  double located_normality = 0.85;              // nearly normally distributed, or
  double spread_beyond_impulses = 10;           // more than so many times what they leave where it is weakest;
  double least_located_spread = 1.6;            // and at least so many times that,
  double located_spread_by_correlation = 45;    // and the more times the further the correlation of neighbors is
  double correlation_of_located_noise = -0.22;  // above that of noise.
  // Noise that is no more than so many times the strongest is none, and no place has more than so many times that;
  std::array<double, 2> limits_of_located_ratios = {{ 0.02, 1.5 }};
  double least_located_ratio = 0.1;             // from weaker noise than this its level is not refined
  // What patches leave is noise, however it differs from place to place, if it is white, by the correlations of neighbors and of
  // differences, and where it is strongest about normally distributed and no weaker than this and than it seemed.
  double least_white_noise = 0.03;
  double correlation_of_white_noise = -0.01;
  double correlation_of_white_differences = -0.21;
  double normality_of_white_noise = 0.8;

  // The refined noise level. One that is a little too high costs less than one that is too low.
  double refined_level_factor = 1.1;            // times what the residuals tell,
  double refined_level_limit = 0.85;            // counts if it is less than so many times the level before,
  double least_refined_level = 0.5;             // but for no less than so many times that.
  std::array<double, 2> refined_level_of_shape = {{ 0.25, 0.5 }}; // Between these times that, while most is shape
  double least_share_of_first_level = 0.1;      // with less of the level before any of this, there is no noise
  double least_rest_of_noise = 0.1;             // the share of the noise in the residual of a vertex
  // Only the share of the noise in the squares of the residuals counts, by the correlation of neighbors:
  double correlation_by_leverage = 0.35;        // minus this, times the root of the median leverage, where all is noise,
  double correlation_of_shape = 0.3;            // and this where all is shape
  double least_share_of_noise = 0.25;           // with less, most is shape

  // The pilot. The normal of a face is off by about twice the noise: the range of the filter starts above that and shrinks to
  // what noise leaves in the end, so that first the noise goes and then the edges come out, obtuse ones last.
  std::size_t pilot_number_of_steps = 10;       // and more where
  double pilot_strong_noise = 0.43;             // noise is more than this,
  double pilot_steps_by_strong_noise = 200;     // so many for each edge length more
  std::size_t pilot_steps_between_weights = 3;  // areas and distances become weights once in so many steps
  std::size_t pilot_number_of_moves = 3;
  double pilot_first_range = 3.25;              // times noise
  double pilot_last_range = 0.3;                // times noise
  double pilot_maximal_last_range = 0.16;

  // The share of the area around a face that the sum of the area vectors there must have to tell which side is out.
  double agreement = 0.75;

  // Noise along the surface, by the ratio in tangential_noise.h
  double least_share_of_turned_faces = 1e-3;    // adds to the number that is expected
  double turning_ratio = 0.1;                   // above this, noise may have turned any face,
  double least_tangential_ratio = 0.25;         // and vertices slide, the further,
  double sure_tangential_ratio = 0.4;           // up to this, the larger it is
  double least_told_share = 0.02;               // Where fewer faces are to turn, the ways to the centers of neighbors tell, too:
  std::array<double, 2> medians_of_noisy_ways = {{ 0.4, 0.95 }}; // the median of their squares is that of noise,
  std::array<double, 2> quartiles_of_noisy_ways = {{ 0.27, 2.2 }}; // and the quartiles differ from it by more than this;
  double mean_cosine_of_noisy_ways = 0.05;      // between those of neighbors
  std::size_t sliding_number_of_steps = 3;
  double sliding_share = 0.5;                   // of the way to the center of the neighbors
  double sliding_range = 0.35;                  // of the deviation of normals around a vertex
  std::size_t sliding_number_of_averages = 12;  // over windows of about seventy vertices

  // The gentle path: a wide range, which spares small detail as it tells little from noise, and many small steps.
  double gentle_range = 9;                      // times noise, and more for what surfaces bend from triangle to triangle:
  double gentle_range_of_bends = 0.4;           // the squares of the two add up
  double gentle_normal_growth = 0.625;          // step k filters the normals 1 + growth (noise k)^2 times
  double gentle_move_growth = 1;                // and moves the vertices 2 + growth noise k times
  double gentle_maximal_growth = 3;             // each of the two grows by no more than this
  double largest_range = 1.5;
  double largest_normal_deviation = 0.2;        // of a face from the surface that it is part of
  double deviation_by_noise = 0.4;              // the way of a vertex by those, times noise leverage^(3/2) of patches
  std::size_t gentle_number_of_steps = 19;      // before one step of relaxation; those after it
  std::size_t gentle_last_number_of_moves = 6;  // move the vertices so often,
  std::size_t gentle_number_of_height_steps = 80; // and heights are smoothed so often
  double gentle_largest_share_in_planes = 0.5;  // unless so many edges are in planes
  double gentle_largest_share_of_sharp_edges = 0.02; // or so many are sharp (see below): then they are left out
  std::size_t gentle_steps_between_weights = 6; // or less, where a band ends
  std::array<std::size_t, 3> gentle_global_band_ends = {{ 1, 2, 4 }};
  std::array<std::size_t, 6> gentle_local_band_ends = {{ 6, 9, 13, 19, 20, 28 }};
  std::size_t number_of_relaxations = 3;
  double relaxation_range_along_normals = 0.25; // times noise
  double relaxation_range_across_normals = 0.75;

  // The linear path. One of the first steps smooths with lambda and then with mu; those after them are of Laplacian smoothing.
  std::array<double, 2> lambda_mu = {{ 0.5, -0.53 }};
  std::size_t linear_number_of_lambda_mu_steps = 40;
  std::size_t lambda_mu_number_of_height_steps = 20; // after the last of them
  std::array<double, 1> laplacian_shares = {{ 2./3 }}; // of the way to the mean of the neighbors
  std::size_t height_steps_by_step = 2;         // how much more heights are smoothed than points
  double least_laplacian_noise = 0.25;          // below so many times the height of triangles no Laplacian smoothing counts,
  double sure_laplacian_noise = 0.8;            // above so many it counts fully
  std::array<std::size_t, 1> linear_global_band_ends = {{ 10 }};
  std::array<std::size_t, 3> linear_local_band_ends = {{ 40, 50, 80 }};

  // The quadric path
  double quadric_largest_noise = 0.35;          // times the mean height of triangles: beyond, other results are better
  double quadric_sigma = 1;                     // of the Gaussian weights,
  double quadric_reach = 2.25;                  // times which is the radius of neighborhoods,
  std::size_t quadric_largest_neighborhood = 200; // or they end with the ring that brings so many vertices
  std::size_t quadric_delay_of_normal_averages = 2; // after so many steps, each averages the normals of planes once more,
  std::size_t quadric_steps_by_average = 10;    // and one in so many averages the quadrics once more
  std::array<std::size_t, 1> quadric_global_band_ends = {{ 1 }};
  std::array<std::size_t, 4> quadric_local_band_ends = {{ 3, 5, 7, 10 }};

  // Faces that are low beside the noise, in the points that patches grow over and in mixed ones, take the normals around them.
  double low_face_error = 0.6;                  // Such a height, times noise, halves the share of their own;
  std::array<double, 2> low_face_noise = {{ 0.3, 0.5 }}; // for patches it is less from the first noise on, zero at the second
  std::size_t number_of_normal_averages = 3;

  // Patches
  double normal_weight = 150;
  std::array<std::size_t, 14> patch_sizes{{12, 18, 27, 40, 60, 90, 135, 200, 300, 450, 675, 1000, 1500, 2250}}; // faces
  std::size_t fixed_patch_size = 40;            // where sizes are not adaptive
  std::size_t least_number_of_points = 8;
  double patch_extent = 14;                     // a length of about the radius of a patch, in distances of centroids
  double cylinder_threshold = 8;                // a parabolic cylinder takes this gain in squared residuals over a plane, in
  double quadric_threshold = 12;                // noise^2, and a quadric takes this;
  double cubic_threshold = 40;                  // a cubic takes this gain over a quadric,
  double largest_bias_of_cubic = 0.15;          // leaves no more than this share of the bias of simpler surfaces,
  double least_pivot_of_cubic = 0.01;           // and of each cubic monomial those before it leave this share unexplained
  Pilot_error pilot_error = { 0.3, 6, false };
  Pilot_error first_patches_error = { 0.15, 15, true }; // where they are the pilot of the second ones
  Patch_effort first_patches_effort = { 1.5, 0.35 };
  Patch_effort last_patches_effort = { 3, 0.2 };
  std::size_t number_of_rounds = 10;            // in which seeds are chosen,
  std::size_t rings_around_first_seeds = 5;     // without another seed in so many rings, one less from round to round
  double tangential_weight = 0.03;              // holds a vertex in the directions that its patches leave free
  std::array<double, 2> noise_to_keep_to_pilot = {{ 1, 2 }}; // Between these times the height of triangles, from none to all
  std::size_t patch_number_of_moves = 5;
  double patch_relaxation = 0.4;                // of these moves
  std::size_t moves_between_weights = 5;        // The weights of these moves, and of those in the end, are anew once in so many

  // Mixing. Local sums run over a window made by averaging over neighbors again and again.
  std::size_t window_number_of_averages = 80;
  double window_points_per_average = 6.2;       // the window then has about so many points for each average
  double band_penalty = 3;                      // how far local weights keep to that of the whole mesh
  double mixing_penalty = 32;                   // that of two estimates
  double least_height_of_importance = 0.3;      // Vertices count by the inverse heights of triangles, beside this times noise,
  std::array<double, 2> limits_of_importance = {{ 0.25, 4 }}; // within these limits around the mean
  double mesh_penalty = 8;                      // how far the weight of the whole mesh keeps to zero,
  double mesh_penalty_of_smooth_surfaces = 1.5; // and that of the gentle path where patches see no more than such shares of the
  std::array<double, 2> shares_in_planes = {{ 0.15, 0.25 }}; // edges in planes, where the two normals differ by less than 0.3
  double cosine_in_planes = 0.999986;           // degrees,
  std::array<double, 2> shares_of_sharp_edges = {{ 0.001, 0.003 }}; // or sharp ones, where they differ by more than 25 degrees,
  double cosine_at_edges = 0.9063;
  std::array<double, 2> noise_of_smooth_surfaces = {{ 0.15, 0.25 }}; // and the noise is no weaker than this;
  double mesh_penalty_of_quadric_path = 2;      // and that of the quadric path, which is good where it is made at all;
  double advantage_over_quadric_path = 0.03;    // but at the same distance from the surface patches have better angles
  // Patches follow the noise as if they had so many coefficients more than a plane,
  double coefficients_by_choice = 3;
  double points_of_full_choice = 50;            // if they fit so few points, or less, and fewer if they fit more;
  double noise_share_by_faces = 0.06;           // and by this share of it where it is so long as three edges, or longer
  std::array<double, 2> noise_to_choose_faces = {{ 0.9, 3 }}; // beside edges, and by nothing below the first length

  // Reassignment of faces
  double reassignment_edge_cosine = 0.8;        // that of the least angle of an edge,
  double reassignment_plane_cosine = 0.98;      // and between planes that differ
  double reassignment_least_height = 0.5;       // that the triangles around a face have, times noise
  double reassignment_reach = 3;                // times noise: observed points that are further away count less
  double reassignment_stiffness = 5;            // the weight of the plane of a face,
  double reassignment_tangential_weight = 1.5;  // and that of ways along the surface where there is no noise along it:
  std::array<double, 2> normal_noise_ratios = {{ 0.1, 0.2 }}; // surely below the first ratio in tangential_noise.h,
                                                // not beyond the second
  double reassignment_slide = 0.5;              // the share of the slides that observed points take part in
  double reassignment_evenness = 0.8;           // that of a neighbor where edges are as long as the noise
  std::size_t reassignment_number_of_moves = 2;
  std::size_t reassignment_number_of_rounds = 20;

  // In the end the vertices move to agree with the normals that came with the result.
  double final_number_of_moves = 100;           // times noise,
  std::size_t final_least_number_of_moves = 6;  // or this where it is more
  double final_relaxation = 0.5;

  // Faces that face against their surroundings
  std::size_t unfolding_number_of_rounds = 20;
  std::size_t unfolding_rounds_of_centers = 3;  // before vertices may move in another way
  std::size_t unfolding_rounds_with_care = 2;   // before vertices go to centers whatever that does to faces
  double unfolding_agreement = 0.6;             // as above
  double unfolding_far_agreement = 0.5;         // that of the faces around the faces around,
  double unfolding_cluster_agreement = 0.45;    // and around a cluster
  std::size_t unfolding_largest_cluster = 30;   // faces
  double unfolding_share_by_shape = 5e-4;       // no more than this share of all faces is turned by the shape
  double unfolding_largest_area = 20;           // faces among larger ones than this, times noise^2, are not turned by noise
  double unfolding_flatness = 0.6;              // the cosine of the largest angle at a vertex that goes to a center
  double unfolding_cosine = 0.1;                // that of the largest angle of a face there
  Unfolding_limits unfolding_of_pilot = { 4, 0 }; // which is far from the surface at large folds
  Unfolding_limits unfolding_of_result = { 2, 2 };
  double unfolding_least_area = 0.1;            // that a face is to have, times the mean of those around
  double unfolding_stiffness = 3000;            // how much more than areas distances from the surface count
  double unfolding_drag = 0.01;                 // and ways along it

  double volume_penalty = 1;                    // how far the offset in the end keeps to zero
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_ADAPTIVE_PARAMETERS_H
