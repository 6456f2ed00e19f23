// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Extends CGAL's list of named parameters. CGAL includes this file several times,
// each time with another meaning of CGAL_add_named_parameter: hence no include guard.
#pragma GCC system_header // or -Wpedantic would warn of the next directive
#include_next <CGAL/STL_Extension/internal/parameters_interface.h>

#define CGAL_SURFACE_MESH_DENOISING_NAMED_PARAMETERS

// List of named parameters used in the package 'Surface Mesh Denoising'
CGAL_add_named_parameter(angle_threshold_t, angle_threshold, angle_threshold)
CGAL_add_named_parameter(number_of_normal_iterations_t, number_of_normal_iterations, number_of_normal_iterations)
CGAL_add_named_parameter(neighborhood_size_t, neighborhood_size, neighborhood_size)
CGAL_add_named_parameter(neighborhood_ring_size_t, neighborhood_ring_size, neighborhood_ring_size)
CGAL_add_named_parameter(normal_weight_t, normal_weight, normal_weight)
CGAL_add_named_parameter(normal_exponent_t, normal_exponent, normal_exponent)
CGAL_add_named_parameter(spatial_sigma_t, spatial_sigma, spatial_sigma)
CGAL_add_named_parameter(normal_sigma_t, normal_sigma, normal_sigma)
CGAL_add_named_parameter(convergence_threshold_t, convergence_threshold, convergence_threshold)
CGAL_add_named_parameter(relaxation_factor_t, relaxation_factor, relaxation_factor)
CGAL_add_named_parameter(face_normal_filter_t, face_normal_filter, face_normal_filter)
CGAL_add_named_parameter(distance_map_t, distance_map, distance_map)
CGAL_add_named_parameter(noise_level_t, noise_level, noise_level)
CGAL_add_named_parameter(noise_distribution_t, noise_distribution, noise_distribution)
CGAL_add_named_parameter(noise_direction_t, noise_direction, noise_direction)
CGAL_add_named_parameter(noise_share_t, noise_share, noise_share)
CGAL_add_named_parameter(number_of_bins_t, number_of_bins, number_of_bins)
CGAL_add_named_parameter(bin_width_t, bin_width, bin_width)
CGAL_add_named_parameter(number_of_rounds_t, number_of_rounds, number_of_rounds)
CGAL_add_named_parameter(height_sigma_t, height_sigma, height_sigma)
CGAL_add_named_parameter(lambda_t, lambda, lambda)
CGAL_add_named_parameter(mu_t, mu, mu)
CGAL_add_named_parameter(use_adaptive_neighborhoods_t, use_adaptive_neighborhoods, use_adaptive_neighborhoods)
CGAL_add_named_parameter(use_adaptive_degree_t, use_adaptive_degree, use_adaptive_degree)
CGAL_add_named_parameter(use_round_patches_t, use_round_patches, use_round_patches)
CGAL_add_named_parameter(refit_patches_t, refit_patches, refit_patches)
CGAL_add_named_parameter(use_gentle_path_t, use_gentle_path, use_gentle_path)
CGAL_add_named_parameter(use_linear_path_t, use_linear_path, use_linear_path)
CGAL_add_named_parameter(use_quadric_path_t, use_quadric_path, use_quadric_path)
CGAL_add_named_parameter(remove_tangential_noise_t, remove_tangential_noise, remove_tangential_noise)
CGAL_add_named_parameter(remove_impulses_t, remove_impulses, remove_impulses)
CGAL_add_named_parameter(locate_noise_t, locate_noise, locate_noise)
CGAL_add_named_parameter(refine_noise_level_t, refine_noise_level, refine_noise_level)
CGAL_add_named_parameter(reassign_faces_t, reassign_faces, reassign_faces)
CGAL_add_named_parameter(unfold_faces_t, unfold_faces, unfold_faces)
CGAL_add_named_parameter(preserve_volume_t, preserve_volume, preserve_volume)
