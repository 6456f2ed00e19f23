// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_meshes.h"

#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/denoise_isotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/measure_error.h>

#include <gtest/gtest.h>

#include <functional>

struct Call
{
  std::size_t iteration;
  double largest_displacement;
  bool has_converged;
};

// keeps what it is told, and ends the run after some iteration
struct Recorder
{
  std::size_t last_iteration = std::numeric_limits<std::size_t>::max();
  std::vector<Call> calls = {};

  Recorder() = default;
  explicit Recorder(const std::size_t last_iteration) : last_iteration(last_iteration) {}
  Recorder(const Recorder&) = delete; // std::ref passes it on without a copy
  Recorder& operator=(const Recorder&) = delete;

  bool iteration_completed(const std::size_t iteration, const double largest_displacement, const bool has_converged)
  {
    calls.push_back(Call{iteration, largest_displacement, has_converged});
    return iteration < last_iteration;
  }
};

// the same through a pointer: it can be passed by value
struct Copyable_recorder
{
  Recorder* recorder;
  bool iteration_completed(const std::size_t iteration, const double largest_displacement, const bool has_converged)
  {
    return recorder->iteration_completed(iteration, largest_displacement, has_converged);
  }
};

template <typename NamedParameters>
SMD::Denoising_result denoise(const bool anisotropic, Mesh& mesh, const NamedParameters& np)
{
  // a parameter of the iterations, with its default value
  return anisotropic ? SMD::denoise_anisotropic_fitting(mesh, np.relaxation_factor(0.5))
                     : SMD::denoise_isotropic_fitting(mesh, np);
}

Mesh noisy_model(const bool anisotropic)
{
  return noisy_mesh(anisotropic ? generated_models::cube : generated_models::sphere, 800, 0.2);
}

TEST(Visitor, Is_told_of_each_iteration)
{
  for(const bool anisotropic : { true, false })
  {
    Mesh mesh = noisy_model(anisotropic);
    const double length = mean_edge_length(mesh);
    Recorder recorder;
    const auto result = denoise(anisotropic, mesh, params::visitor(std::ref(recorder)));

    EXPECT_TRUE(result.has_converged);
    EXPECT_LE(result.number_of_iterations, 30u);
    ASSERT_EQ(recorder.calls.size(), result.number_of_iterations);
    for(std::size_t i=0; i<recorder.calls.size(); ++i)
    {
      EXPECT_EQ(recorder.calls[i].iteration, i + 1);
      EXPECT_EQ(recorder.calls[i].has_converged, i + 1 == recorder.calls.size());
    }
    EXPECT_GT(recorder.calls.front().largest_displacement, 0.1 * length);
    EXPECT_LT(recorder.calls.back().largest_displacement, 0.1 * recorder.calls.front().largest_displacement);
  }
}

TEST(Visitor, Is_told_the_largest_displacement_in_the_unit_of_the_coordinates)
{
  for(const bool anisotropic : { true, false })
    for(const double scale : { 1., 1000. })
    {
      Mesh before = noisy_model(anisotropic);
      for(const Vertex v : vertices(before))
        before.point(v) = CGAL::ORIGIN + scale * (before.point(v) - CGAL::ORIGIN);
      Recorder recorder;
      Mesh first = before, second = before;
      denoise(anisotropic, first, params::number_of_iterations(1).visitor(std::ref(recorder)));
      denoise(anisotropic, second, params::number_of_iterations(2).visitor(std::ref(recorder)));
      ASSERT_EQ(recorder.calls.size(), 3u);
      EXPECT_NEAR(recorder.calls[0].largest_displacement, largest_distance(first, before), 1e-12 * scale);
      EXPECT_EQ(recorder.calls[1].largest_displacement, recorder.calls[0].largest_displacement);
      EXPECT_NEAR(recorder.calls[2].largest_displacement, largest_distance(second, first), 1e-12 * scale);
    }
}

TEST(Visitor, May_be_passed_by_value)
{
  Mesh mesh = noisy_model(true);
  Recorder recorder;
  const auto result = denoise(true, mesh, params::visitor(Copyable_recorder{&recorder}));
  EXPECT_EQ(recorder.calls.size(), result.number_of_iterations);
}

TEST(Visitor, Ends_the_run_after_the_last_iteration_completed)
{
  for(const bool anisotropic : { true, false })
    for(const std::size_t k : { 1, 2, 5 })
    {
      Mesh stopped = noisy_model(anisotropic), capped = stopped;
      Recorder recorder(k);
      const auto result = denoise(anisotropic, stopped, params::visitor(std::ref(recorder)));
      EXPECT_EQ(result.number_of_iterations, k);
      EXPECT_FALSE(result.has_converged);
      EXPECT_EQ(recorder.calls.size(), k);

      const auto capped_result = denoise(anisotropic, capped, params::number_of_iterations(k));
      EXPECT_EQ(capped_result.number_of_iterations, k);
      EXPECT_FALSE(capped_result.has_converged);
      EXPECT_EQ(points_of(stopped), points_of(capped));
    }
}

TEST(Visitor, Hears_nothing_without_iterations)
{
  Mesh mesh = noisy_model(true);
  Recorder recorder;
  SMD::denoise_anisotropic_fitting(mesh, params::number_of_iterations(0).visitor(std::ref(recorder)));
  EXPECT_TRUE(recorder.calls.empty());
}

TEST(Convergence, Further_iterations_change_little)
{
  for(const auto generate : { generated_models::cube, generated_models::cylinder })
  {
    const Mesh truth = irregular_mesh(generate, 1500), noisy = with_noise(truth, 0.2);
    Mesh converged = noisy, further = noisy;
    const auto result = SMD::denoise_anisotropic_fitting(converged, params::number_of_iterations(30));
    ASSERT_TRUE(result.has_converged);
    // a threshold that is never met
    const auto further_result = SMD::denoise_anisotropic_fitting(
      further, params::convergence_threshold(1e-9).number_of_iterations(result.number_of_iterations + 10));
    EXPECT_EQ(further_result.number_of_iterations, result.number_of_iterations + 10);
    EXPECT_FALSE(further_result.has_converged);

    // degrees
    EXPECT_NEAR(SMD::angular_error(further, truth).mean, SMD::angular_error(converged, truth).mean, 1);
    EXPECT_LT(largest_distance(further, converged), 0.25 * mean_edge_length(truth));
  }
}

TEST(Convergence, The_smaller_the_threshold_the_more_iterations)
{
  const Mesh noisy = noisy_mesh(generated_models::cube, 800, 0.2);
  std::size_t last = 0;
  for(const double threshold : { 1., 0.2, 0.05, 0.01 })
  {
    Mesh mesh = noisy;
    const auto result = SMD::denoise_anisotropic_fitting(
      mesh, params::convergence_threshold(threshold).number_of_iterations(100));
    EXPECT_GT(result.number_of_iterations, last);
    last = result.number_of_iterations;
  }
}

TEST(Convergence, A_mesh_without_noise_converges_at_once)
{
  Mesh mesh = irregular_mesh(generated_models::cube, 800);
  const auto result = SMD::denoise_anisotropic_fitting(mesh, params::number_of_iterations(30));
  EXPECT_TRUE(result.has_converged);
  EXPECT_EQ(result.number_of_iterations, 1u);
}
