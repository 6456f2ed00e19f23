// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstddef>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

double mean_height(const Mesh& mesh)
{
  double sum = 0.;
  for(const Mesh::Vertex_index v : mesh.vertices())
    sum += std::abs(mesh.point(v).z());
  return sum / static_cast<double>(mesh.number_of_vertices());
}

int main()
{
  const auto rough_plane = [](const std::size_t i, const std::size_t j)
  {
    const double height = 0.1 * (static_cast<double>((7 * i + 3 * j * j) % 5) - 2.);
    return Point(static_cast<double>(i), static_cast<double>(j), height);
  };
  Mesh mesh;
  CGAL::make_grid(20, 20, mesh, rough_plane, true);

  const double before = mean_height(mesh);
  CGAL::Surface_mesh_denoising::denoise_anisotropic_fitting(mesh);
  CGAL::Surface_mesh_denoising::denoise_anisotropic_fitting(
    mesh, CGAL::parameters::angle_threshold(0.4).number_of_iterations(2).normal_weight(10.));
  return mean_height(mesh) < 0.5 * before ? 0 : 1;
}
