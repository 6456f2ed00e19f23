// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_DENOISE_MESH_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_DENOISE_MESH_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/internal/named_parameters.h>
#include <CGAL/Surface_mesh_denoising/Denoising_result.h>
#include <CGAL/Surface_mesh_denoising/internal/Mesh_io.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

struct Silent_visitor
{
  bool iteration_completed(std::size_t, double, bool) const { return true; }
};

// what a `std::reference_wrapper` refers to, or else the object itself
template <typename T>
T& unwrapped(T& object) { return object; }

template <typename T>
T& unwrapped(std::reference_wrapper<T>& reference) { return reference.get(); }

// The part that all methods share: from the user's mesh and named parameters into an indexed mesh, and back.
// `run(mesh, is_movable, report)` moves the points; `report(iteration, largest displacement, has converged)` says
// whether to go on. `normals` has compute_normals(mesh), called after the run, face_normals() and vertex_normals().
template <typename Range, typename TriangleMesh, typename NamedParameters, typename Run, typename Normals>
Denoising_result denoise_mesh(const Range& range, TriangleMesh& tmesh, const NamedParameters& np, const Run& run,
                              Normals& normals)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  auto passed_visitor = choose_parameter(get_parameter(np, internal_np::visitor), Silent_visitor());
  auto& visitor = unwrapped(passed_visitor);

  auto io = read_mesh(range, tmesh, choose_parameter(get_parameter(np, internal_np::vertex_point),
                                                     get_property_map(CGAL::vertex_point, tmesh)), np);
  Indexed_triangle_mesh mesh = io.take_mesh();
  const std::vector<Point_3> original = mesh.points();

  const auto report = [&](const std::size_t iteration, const double largest_displacement, const bool has_converged)
  {
    return visitor.iteration_completed(iteration, io.normalization().length_outside(largest_displacement),
                                       has_converged);
  };
  const Denoising_result result = run(mesh, io.is_movable(), report);

  // the points come last: if anything throws, they are as they were
  constexpr bool wants_face_normals
    = !parameters::is_default_parameter<NamedParameters, internal_np::face_normal_t>::value;
  constexpr bool wants_vertex_normals
    = !parameters::is_default_parameter<NamedParameters, internal_np::vertex_normal_map_t>::value;
  if constexpr (wants_face_normals || wants_vertex_normals)
    normals.compute_normals(mesh);
  if constexpr (wants_face_normals)
    io.write_face_normals(normals.face_normals(), get_parameter(np, internal_np::face_normal));
  if constexpr (wants_vertex_normals)
    io.write_vertex_normals(normals.vertex_normals(), get_parameter(np, internal_np::vertex_normal_map));
  io.write_points(original, mesh.points());
  return result;
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_DENOISE_MESH_H
