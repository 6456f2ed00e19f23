// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever the number of threads, the result is the same to the last bit.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/denoise_isotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/filter_vertex_normals.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <gtest/gtest.h>

#include <tuple>

// all that a function returns or writes
typedef std::tuple<std::vector<Point>, std::vector<Vector>, std::vector<Vector>, std::size_t, bool> Everything;

template <typename Denoise>
Everything run(Mesh mesh, const Denoise& denoise)
{
  auto face_normals = mesh.add_property_map<Face, Vector>("f:normal").first;
  auto vertex_normals = mesh.add_property_map<Vertex, Vector>("v:normal").first;
  const auto result = denoise(mesh, params::face_normal_map(face_normals).vertex_normal_map(vertex_normals));
  return Everything(points_of(mesh), std::vector<Vector>(face_normals.begin(), face_normals.end()),
                    std::vector<Vector>(vertex_normals.begin(), vertex_normals.end()),
                    result.number_of_iterations, result.has_converged);
}

// without and with parameters of the iterations
template <typename ConcurrencyTag>
Everything run_adaptive(const Mesh& mesh)
{
  return run(mesh, [](Mesh& m, const auto& np) { return SMD::denoise_anisotropic_fitting<ConcurrencyTag>(m, np); });
}

template <typename ConcurrencyTag>
Everything run_iterative(const Mesh& mesh)
{
  return run(mesh, [](Mesh& m, const auto& np)
  {
    return SMD::denoise_anisotropic_fitting<ConcurrencyTag>(m, np.number_of_iterations(30));
  });
}

template <typename ConcurrencyTag>
Everything run_isotropic(const Mesh& mesh)
{
  return run(mesh, [](Mesh& m, const auto& np) { return SMD::denoise_isotropic_fitting<ConcurrencyTag>(m, np); });
}

template <typename ConcurrencyTag>
std::vector<Vector> filtered_normals(Mesh mesh)
{
  auto normals = mesh.add_property_map<Vertex, Vector>("v:normal").first;
  SMD::filter_vertex_normals<ConcurrencyTag>(mesh, normals, params::number_of_iterations(10));
  return std::vector<Vector>(normals.begin(), normals.end());
}

// more vertices than the blocks into which work and sums are cut
Mesh noisy_cylinder() { return noisy_mesh(generated_models::cylinder, 4500, 0.3); }

TEST(Concurrency, The_default_is_sequential)
{
  const Mesh noisy = noisy_mesh(generated_models::cube, 500, 0.3);
  const auto by_default
    = run(noisy, [](Mesh& m, const auto& np) { return SMD::denoise_anisotropic_fitting(m, np); });
  EXPECT_TRUE(by_default == run_adaptive<CGAL::Sequential_tag>(noisy));
}

TEST(Concurrency, Parallel_if_available)
{
  const Mesh noisy = noisy_cylinder();
  EXPECT_TRUE(run_adaptive<CGAL::Parallel_if_available_tag>(noisy) == run_adaptive<CGAL::Sequential_tag>(noisy));
  const Mesh partly_noisy = with_noise_on_one_side(irregular_mesh(generated_models::cylinder, 4500), 0.3);
  EXPECT_TRUE(run_adaptive<CGAL::Parallel_if_available_tag>(partly_noisy)
              == run_adaptive<CGAL::Sequential_tag>(partly_noisy));
  EXPECT_TRUE(run_iterative<CGAL::Parallel_if_available_tag>(noisy) == run_iterative<CGAL::Sequential_tag>(noisy));
  EXPECT_TRUE(run_isotropic<CGAL::Parallel_if_available_tag>(noisy) == run_isotropic<CGAL::Sequential_tag>(noisy));
  EXPECT_EQ(filtered_normals<CGAL::Parallel_if_available_tag>(noisy), filtered_normals<CGAL::Sequential_tag>(noisy));
}

#ifdef CGAL_LINKED_WITH_TBB

TEST(Concurrency, Any_number_of_threads)
{
  const Mesh noisy = noisy_cylinder();
  const Everything adaptive = run_adaptive<CGAL::Sequential_tag>(noisy);
  const Everything iterative = run_iterative<CGAL::Sequential_tag>(noisy);
  const Everything isotropic = run_isotropic<CGAL::Sequential_tag>(noisy);
  const std::vector<Vector> normals = filtered_normals<CGAL::Sequential_tag>(noisy);
  for(const std::size_t number_of_threads : { 1, 2, 5 })
  {
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, number_of_threads);
    EXPECT_TRUE(run_adaptive<CGAL::Parallel_tag>(noisy) == adaptive) << number_of_threads;
    EXPECT_TRUE(run_iterative<CGAL::Parallel_tag>(noisy) == iterative) << number_of_threads;
    EXPECT_TRUE(run_isotropic<CGAL::Parallel_tag>(noisy) == isotropic) << number_of_threads;
    EXPECT_EQ(filtered_normals<CGAL::Parallel_tag>(noisy), normals) << number_of_threads;
  }
}

struct Thrown {};

struct Throwing_filter
{
  template <typename ConcurrencyTag>
  void operator()(const SMD::Indexed_triangle_mesh& mesh, std::vector<Vector>&, std::size_t, ConcurrencyTag) const
  {
    SMD::internal::for_each_index<ConcurrencyTag>(mesh.number_of_faces(), [](const std::size_t f)
    {
      if(f % 1000 == 999)
        throw Thrown();
    });
  }
};

TEST(Concurrency, Exceptions_leave_the_mesh_as_it_was)
{
  const Mesh noisy = noisy_cylinder();
  Mesh mesh = noisy;
  EXPECT_THROW(SMD::denoise_anisotropic_fitting<CGAL::Parallel_tag>(
                 mesh, params::face_normal_filter(Throwing_filter())), Thrown);
  EXPECT_EQ(points_of(mesh), points_of(noisy));
}

#endif // CGAL_LINKED_WITH_TBB
