// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Adds noise to a generated part, denoises it, and prints the errors before and after; or denoises a mesh in a file.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_denoising/add_noise.h>
#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/measure_error.h>

#include "include/generated_models.h"
#include "../../examples/Surface_mesh_denoising/include/mesh_files.h"

#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>

namespace SMD = CGAL::Surface_mesh_denoising;
namespace models = generated_models;

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                   Mesh;

const char* const usage = "usage: demo [--output FOLDER] [MESH]";

// one line of the table: a measure of the noisy and of the denoised mesh
void print_row(const std::string& name, const double noisy, const double denoised, const std::string& unit)
{
  std::cout << "  " << std::left << std::setw(34) << name << std::right << std::setprecision(3) << std::fixed
            << std::setw(10) << noisy << std::setw(10) << denoised << "  " << unit << "\n";
}

void print_row(const std::string& name, const std::size_t noisy, const std::size_t denoised)
{
  std::cout << "  " << std::left << std::setw(34) << name << std::right
            << std::setw(10) << noisy << std::setw(10) << denoised << "\n";
}

void print_errors(const SMD::Denoising_error& noisy, const SMD::Denoising_error& denoised)
{
  const SMD::Vertex_distance_error noisy_vertices = noisy.vertex_distance.in_mean_edge_lengths();
  const SMD::Vertex_distance_error denoised_vertices = denoised.vertex_distance.in_mean_edge_lengths();
  const std::string edges = "mean edge lengths";

  std::cout << "\nErrors against the part without noise\n"
            << std::string(36, ' ') << std::setw(10) << "noisy" << std::setw(10) << "denoised" << "\n";
  print_row("mean angle of the face normals", noisy.angular.mean, denoised.angular.mean, "degrees");
  print_row("mean distance of the vertices", noisy_vertices.mean, denoised_vertices.mean, edges);
  print_row("  the same, area-weighted L2", noisy_vertices.area_weighted_l2, denoised_vertices.area_weighted_l2, edges);
  print_row("  the greatest", noisy_vertices.maximum, denoised_vertices.maximum, edges);
  print_row("Hausdorff distance", noisy.symmetric_distance.in_mean_edge_lengths().maximum,
            denoised.symmetric_distance.in_mean_edge_lengths().maximum, edges);
  print_row("volume change", 100 * noisy.relative_volume_change, 100 * denoised.relative_volume_change, "%");
  print_row("flipped faces", noisy.angular.number_of_flipped_faces, denoised.angular.number_of_flipped_faces);
  print_row("degenerate faces", noisy.number_of_degenerate_faces, denoised.number_of_degenerate_faces);
  std::cout << std::endl;
}

Mesh denoised(const Mesh& noisy)
{
  Mesh mesh(noisy);
  const auto start = std::chrono::steady_clock::now();
  const SMD::Denoising_result result = SMD::denoise_anisotropic_fitting<CGAL::Parallel_if_available_tag>(mesh);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::cout << "Denoised in " << std::setprecision(2) << std::fixed << seconds << " s: " << result.number_of_iterations
            << " iterations, " << (result.has_converged ? "" : "not ") << "converged" << std::endl;
  return mesh;
}

void write(const std::string& folder, const std::string& name, const Mesh& mesh)
{
  const std::string path = folder + "/" + name + ".ply";
  mesh_files::write_triangle_mesh(path, mesh);
  std::cout << "Wrote " << path << std::endl;
}

void print_size(const std::string& name, const Mesh& mesh)
{
  std::cout << name << ": " << mesh.number_of_vertices() << " vertices, " << mesh.number_of_faces() << " faces"
            << std::endl;
}

void run_on_generated_part(const std::string& folder)
{
  models::Options options;
  options.number_of_vertices = 30000;
  options.triangles = models::Triangles::IRREGULAR;
  options.seed = 1;
  const Mesh part = models::to_mesh<Mesh>(models::cad_part(options));

  const double noise_level = 0.3;
  Mesh noisy(part);
  SMD::add_noise(noisy, CGAL::parameters::noise_level(noise_level).random_seed(1));
  print_size("Generated part", part);
  std::cout << "Noise: Gaussian along the normals, standard deviation " << noise_level << " mean edge lengths"
            << std::endl;

  const Mesh result = denoised(noisy);
  print_errors(SMD::measure_error<CGAL::Parallel_if_available_tag>(noisy, part),
               SMD::measure_error<CGAL::Parallel_if_available_tag>(result, part));
  write(folder, "noise_free", part);
  write(folder, "noisy", noisy);
  write(folder, "denoised", result);
}

void run_on_file(const std::string& folder, const std::string& path)
{
  Mesh noisy;
  const mesh_files::Reading_report report = mesh_files::read_triangle_mesh(path, noisy);
  print_size(path, noisy);
  if(report.is_repaired)
    std::cout << "Made from a repaired polygon soup" << std::endl;
  if(report.is_triangulated)
    std::cout << "Triangulated" << std::endl;

  const Mesh result = denoised(noisy);
  write(folder, "noisy", noisy);
  write(folder, "denoised", result);
}

int main(int argc, char* argv[])
{
  try
  {
    std::string folder = ".", path;
    for(int i=1; i<argc; ++i)
    {
      const std::string argument = argv[i];
      if(argument == "--help")
      {
        std::cout << usage << std::endl;
        return EXIT_SUCCESS;
      }
      if(argument == "--output" && i + 1 < argc)
        folder = argv[++i];
      else if(path.empty() && !argument.empty() && argument[0] != '-')
        path = argument;
      else
        throw std::invalid_argument(usage);
    }

    std::filesystem::create_directories(folder);
    if(path.empty())
      run_on_generated_part(folder);
    else
      run_on_file(folder, path);
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << "demo: " << e.what() << std::endl;
    return 2;
  }
}
