// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Named_function_parameters.h>

#include <gtest/gtest.h>

namespace params = CGAL::parameters;
namespace np = CGAL::internal_np;

// A new name starts, continues and ends a chain with names of CGAL.
#define CHECK_NAME(NAME)                                                             \
  TEST(Named_parameters, NAME)                                                       \
  {                                                                                  \
    const auto first = params::NAME(1).number_of_iterations(2).verbose(3);           \
    const auto middle = params::number_of_iterations(2).NAME(1).verbose(3);          \
    const auto last = params::verbose(3).number_of_iterations(2).NAME(1);            \
    const auto check = [](const auto& chain)                                         \
    {                                                                                \
      EXPECT_EQ(params::get_parameter(chain, np::NAME), 1);                          \
      EXPECT_EQ(params::get_parameter(chain, np::number_of_iterations), 2);          \
      EXPECT_EQ(params::get_parameter(chain, np::verbose), 3);                       \
    };                                                                               \
    check(first);                                                                    \
    check(middle);                                                                   \
    check(last);                                                                     \
  }

CHECK_NAME(angle_threshold)
CHECK_NAME(number_of_normal_iterations)
CHECK_NAME(neighborhood_size)
CHECK_NAME(neighborhood_ring_size)
CHECK_NAME(normal_weight)
CHECK_NAME(normal_exponent)
CHECK_NAME(spatial_sigma)
CHECK_NAME(normal_sigma)
CHECK_NAME(convergence_threshold)
CHECK_NAME(relaxation_factor)
CHECK_NAME(face_normal_filter)
CHECK_NAME(distance_map)
CHECK_NAME(noise_level)
CHECK_NAME(noise_distribution)
CHECK_NAME(noise_direction)
CHECK_NAME(noise_share)
CHECK_NAME(number_of_bins)
CHECK_NAME(bin_width)
CHECK_NAME(number_of_rounds)
CHECK_NAME(height_sigma)
CHECK_NAME(lambda)
CHECK_NAME(mu)
CHECK_NAME(use_adaptive_neighborhoods)
CHECK_NAME(use_adaptive_degree)
CHECK_NAME(use_round_patches)
CHECK_NAME(refit_patches)
CHECK_NAME(use_gentle_path)
CHECK_NAME(use_linear_path)
CHECK_NAME(use_quadric_path)
CHECK_NAME(remove_tangential_noise)
CHECK_NAME(remove_impulses)
CHECK_NAME(locate_noise)
CHECK_NAME(refine_noise_level)
CHECK_NAME(reassign_faces)
CHECK_NAME(unfold_faces)
CHECK_NAME(preserve_volume)

template <typename Chain>
void expect_all_in_place(const Chain& chain)
{
  EXPECT_EQ(params::get_parameter(chain, np::angle_threshold), 1);
  EXPECT_EQ(params::get_parameter(chain, np::number_of_normal_iterations), 2);
  EXPECT_EQ(params::get_parameter(chain, np::neighborhood_size), 3);
  EXPECT_EQ(params::get_parameter(chain, np::normal_weight), 4);
  EXPECT_EQ(params::get_parameter(chain, np::convergence_threshold), 5);
  EXPECT_EQ(params::get_parameter(chain, np::relaxation_factor), 6);
}

TEST(Named_parameters, New_names_chain_with_each_other)
{
  expect_all_in_place(params::angle_threshold(1).number_of_normal_iterations(2).neighborhood_size(3)
                             .normal_weight(4).convergence_threshold(5).relaxation_factor(6));
  expect_all_in_place(params::relaxation_factor(6).convergence_threshold(5).normal_weight(4)
                             .neighborhood_size(3).number_of_normal_iterations(2).angle_threshold(1));
}

TEST(Named_parameters, Chains_start_from_the_default_values)
{
  const auto chain = params::default_values().angle_threshold(1);
  EXPECT_EQ(params::get_parameter(chain, np::angle_threshold), 1);
}
