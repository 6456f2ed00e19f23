// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes the meshes and the numbers from which scripts/figures draws the pictures of the manual.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_denoising/Bilateral_normal_filter.h>
#include <CGAL/Surface_mesh_denoising/Guided_normal_filter.h>
#include <CGAL/Surface_mesh_denoising/add_noise.h>
#include <CGAL/Surface_mesh_denoising/anisotropic_neighborhood.h>
#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/denoise_bilateral.h>
#include <CGAL/Surface_mesh_denoising/denoise_isotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/denoise_taubin.h>
#include <CGAL/Surface_mesh_denoising/denoise_with_normals.h>
#include <CGAL/Surface_mesh_denoising/measure_error.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include "generated_models.h"

#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace SMD = CGAL::Surface_mesh_denoising;
namespace np = CGAL::parameters;

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                   Mesh;
typedef Mesh::Vertex_index                                    Vertex;
typedef Mesh::Face_index                                      Face;
typedef CGAL::Parallel_if_available_tag                       Concurrency;

std::string folder;

std::ofstream output(const std::string& name)
{
  std::ofstream out(folder + "/" + name);
  if(!out)
    throw std::runtime_error(folder + "/" + name + ": cannot be written");
  out.precision(12);
  return out;
}

void write(const std::string& name, const Mesh& mesh)
{
  if(!CGAL::IO::write_polygon_mesh(folder + "/" + name + ".off", mesh, np::stream_precision(9)))
    throw std::runtime_error(folder + "/" + name + ".off: cannot be written");
}

// the angle between the normals of corresponding faces, in degrees
void write_angles(const std::string& name, const Mesh& mesh, const Mesh& ground_truth)
{
  const auto normal = [](const Mesh& m, const Face f)
  {
    std::vector<Kernel::Point_3> p;
    for(const Vertex v : m.vertices_around_face(m.halfedge(f)))
      p.push_back(m.point(v));
    return CGAL::cross_product(p[1] - p[0], p[2] - p[0]);
  };
  std::ofstream out = output(name + ".txt");
  for(const Face f : mesh.faces())
  {
    const Kernel::Vector_3 a = normal(mesh, f), b = normal(ground_truth, f);
    out << std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b) * 180 / generated_models::pi << '\n';
  }
}

generated_models::Model generated_model(const std::string& model, const std::size_t number_of_vertices)
{
  generated_models::Options options;
  options.number_of_vertices = number_of_vertices;
  options.triangles = generated_models::Triangles::IRREGULAR;
  return generated_models::generate(model, options);
}

Mesh generated(const std::string& model, const std::size_t number_of_vertices)
{
  return generated_models::to_mesh<Mesh>(generated_model(model, number_of_vertices));
}

template <typename NamedParameters>
Mesh with_noise(Mesh mesh, const NamedParameters& parameters)
{
  SMD::add_noise(mesh, parameters);
  return mesh;
}

// a line of the table of errors
void report(const std::string& name, const Mesh& mesh, const Mesh& ground_truth)
{
  const SMD::Angular_error angular = SMD::angular_error(mesh, ground_truth);
  const SMD::Vertex_distance_error distance = SMD::vertex_distance_error(mesh, ground_truth).in_mean_edge_lengths();
  std::cout << "| " << name << " | " << angular.mean << " | " << distance.area_weighted_l2 << " | "
            << angular.number_of_flipped_faces << " | " << 100 * SMD::relative_volume_change(mesh, ground_truth) << " |"
            << std::endl;
}

template <typename Denoise>
void write_denoised(const std::string& name, const Mesh& noisy, const Mesh& ground_truth, const Denoise& denoise)
{
  Mesh mesh = noisy;
  denoise(mesh);
  write(name, mesh);
  write_angles(name, mesh, ground_truth);
  report(name, mesh, ground_truth);
}

void kinds_of_noise()
{
  const Mesh mesh = generated("cut_sphere", 6000);
  write("noise_none", mesh);
  write("noise_normal", with_noise(mesh, np::noise_level(0.3)));
  write("noise_random", with_noise(mesh, np::noise_level(0.3).noise_direction(SMD::Noise_direction::RANDOM)));
  write("noise_impulsive", with_noise(mesh, np::noise_level(0.8).noise_share(0.1)));
}

// the neighborhoods of a vertex beside a sharp edge, and the surface that is fitted to one of them
void neighborhoods()
{
  const Mesh ground_truth = generated("cube", 3000);
  Mesh mesh = with_noise(ground_truth, np::noise_level(0.25));
  auto face_normals = mesh.add_property_map<Face, Kernel::Vector_3>("f:normal").first;
  auto vertex_normals = mesh.add_property_map<Vertex, Kernel::Vector_3>("v:normal").first;
  SMD::denoise_anisotropic_fitting(mesh, np::number_of_iterations(0).face_normal_map(face_normals)
                                                                   .vertex_normal_map(vertex_normals));
  write("neighborhood", mesh);

  // beside the middle of an edge, the vertex that the first iteration moves most
  Mesh moved = mesh;
  SMD::denoise_anisotropic_fitting(moved, np::number_of_iterations(1).relaxation_factor(1.));
  const Kernel::Point_3 target(1, 0, 0.85);
  Vertex v;
  double largest_displacement = 0;
  for(const Vertex w : mesh.vertices())
  {
    const double displacement = CGAL::squared_distance(mesh.point(w), moved.point(w));
    if(CGAL::squared_distance(ground_truth.point(w), target) < 0.04 && ground_truth.point(w).x() > 0.999
       && ground_truth.point(w).z() < 0.93 && displacement > largest_displacement)
    {
      largest_displacement = displacement;
      v = w;
    }
  }
  Face seed = mesh.face(mesh.halfedge(v));
  for(const Face f : mesh.faces_around_target(mesh.halfedge(v)))
    if(face_normals[f] * vertex_normals[v] > face_normals[seed] * vertex_normals[v])
      seed = f;

  std::vector<Face> faces;
  for(const double weight : { 0.01, 200. })
    for(const unsigned int size : { 12u, 120u, 40u })
    {
      faces.clear();
      SMD::anisotropic_neighborhood(seed, mesh, std::back_inserter(faces),
                                    np::neighborhood_size(size).normal_weight(weight).face_normal_map(face_normals));
      std::vector<double> rank(mesh.number_of_faces(), std::numeric_limits<double>::quiet_NaN());
      for(std::size_t i=0; i<faces.size(); ++i)
        rank[faces[i]] = double(i + 1);
      std::ofstream out = output("neighborhood_" + std::string(weight < 1 ? "isotropic" : "anisotropic") + "_"
                                 + std::to_string(size) + ".txt");
      for(const double r : rank)
        out << r << '\n';
    }

  // the vertex, its normal, where it goes, and the points of the last neighborhood
  std::ofstream out = output("fit.txt");
  out << mesh.point(v) << '\n' << vertex_normals[v] << '\n' << moved.point(v) << '\n';
  std::set<Vertex> vertices;
  for(const Face f : faces)
    for(const Vertex w : mesh.vertices_around_face(mesh.halfedge(f)))
      if(vertices.insert(w).second)
        out << mesh.point(w) << '\n';
}

// each parameter too low, right and too high, the others at their defaults
void parameters(const std::string& model, const std::size_t number_of_vertices)
{
  const Mesh mesh = generated(model, number_of_vertices);
  const Mesh noisy = with_noise(mesh, np::noise_level(0.3));
  const std::string prefix = "parameter_" + model + "_";
  write(prefix + "noisy", noisy);
  const auto run = [&](const std::string& name, const auto& low, const auto& right, const auto& high)
  {
    const auto run_one = [&](const std::string& value, const auto& parameters)
    {
      write_denoised(prefix + name + "_" + value, noisy, mesh,
                     [&](Mesh& m) { SMD::denoise_anisotropic_fitting<Concurrency>(m, parameters); });
    };
    run_one("low", low);
    run_one("right", right);
    run_one("high", high);
  };
  run("angle_threshold", np::angle_threshold(0.05), np::angle_threshold(0.5), np::angle_threshold(0.95));
  run("number_of_normal_iterations", np::number_of_normal_iterations(0), np::number_of_normal_iterations(5),
      np::number_of_normal_iterations(60));
  run("neighborhood_size", np::neighborhood_size(6), np::neighborhood_size(40), np::neighborhood_size(400));
  run("normal_weight", np::normal_weight(1.), np::normal_weight(200.), np::normal_weight(1e5));
  run("number_of_iterations", np::number_of_iterations(2), np::number_of_iterations(30),
      np::number_of_iterations(300).convergence_threshold(1e-6));
}

void methods(const std::string& model)
{
  const Mesh mesh = generated(model, 10000);
  const Mesh noisy = with_noise(mesh, np::noise_level(0.3));
  const std::string prefix = "method_" + model + "_";
  write(prefix + "ground_truth", mesh);
  const auto run = [&](const std::string& name, const auto& denoise) { write_denoised(prefix + name, noisy, mesh, denoise); };
  run("noisy", [](Mesh&) {});
  run("anisotropic_fitting", [](Mesh& m) { SMD::denoise_anisotropic_fitting<Concurrency>(m); });
  run("paper", [](Mesh& m) { SMD::denoise_anisotropic_fitting<Concurrency>(m, np::number_of_iterations(30)); });
  run("isotropic_fitting", [](Mesh& m) { SMD::denoise_isotropic_fitting<Concurrency>(m); });
  run("sun", [](Mesh& m) { SMD::denoise_with_normals<Concurrency>(m); });
  run("zheng", [](Mesh& m)
      { SMD::denoise_with_normals<Concurrency>(m, np::face_normal_filter(SMD::Bilateral_normal_filter())); });
  run("guided", [](Mesh& m)
      {
        SMD::denoise_with_normals<Concurrency>(m, np::face_normal_filter(SMD::Guided_normal_filter())
                                                     .number_of_normal_iterations(1).number_of_rounds(20));
      });
  run("fleishman", [](Mesh& m) { SMD::denoise_bilateral<Concurrency>(m); });
  run("taubin", [](Mesh& m) { SMD::denoise_taubin<Concurrency>(m); });
}

// what each stage of the adaptive method brings: all of them, and all but one
void ablation_of(const std::string& title, const Mesh& mesh, const Mesh& noisy)
{
  const auto run = [&](const std::string& name, const auto& parameters)
  {
    Mesh denoised = noisy;
    SMD::denoise_anisotropic_fitting<Concurrency>(denoised, parameters);
    report("ablation_" + title + "_" + name, denoised, mesh);
  };
  run("none", np::default_values());
  run("use_adaptive_neighborhoods", np::use_adaptive_neighborhoods(false));
  run("use_adaptive_degree", np::use_adaptive_degree(false));
  run("use_round_patches", np::use_round_patches(false));
  run("refit_patches", np::refit_patches(false));
  run("use_gentle_path", np::use_gentle_path(false));
  run("use_linear_path", np::use_linear_path(false));
  run("use_quadric_path", np::use_quadric_path(false));
  run("remove_tangential_noise", np::remove_tangential_noise(false));
  run("remove_impulses", np::remove_impulses(false));
  run("locate_noise", np::locate_noise(false));
  run("refine_noise_level", np::refine_noise_level(false));
  run("reassign_faces", np::reassign_faces(false));
  run("unfold_faces", np::unfold_faces(false));
  run("preserve_volume", np::preserve_volume(false));
}

template <typename NamedParameters>
void ablation(const std::string& title, const Mesh& mesh, const NamedParameters& noise)
{
  ablation_of(title, mesh, with_noise(mesh, noise));
}

int main(int argc, char* argv[])
{
  if(argc != 2)
  {
    std::cerr << "usage: manual_figures FOLDER" << std::endl;
    return 2;
  }
  folder = argv[1];
  try
  {
    std::cout << "| mesh | E_a (degrees) | E_v (mean edge lengths) | flipped faces | volume (%) |\n| --- | --- | --- | --- | --- |" << std::endl;
    kinds_of_noise();
    neighborhoods();
    methods("cad_part");
    methods("organic_shape");
    for(const char* model : { "cad_part", "cut_sphere", "organic_shape" })
      ablation(model, generated(model, 10000), np::noise_level(0.3));
    for(const char* model : { "cad_part", "organic_shape" })
      ablation(std::string(model) + "_in_all_directions", generated(model, 10000),
               np::noise_level(0.3).noise_direction(SMD::Noise_direction::RANDOM));
    ablation("cad_part_with_impulses", generated("cad_part", 10000), np::noise_level(0.5).noise_share(0.1));
    for(const char* model : { "cad_part", "organic_shape" })
      ablation(std::string("coarse_") + model, generated(model, 1500), np::noise_level(0.05));
    const Mesh part = generated("cad_part", 10000);
    Mesh noisy_part = part;
    SMD::add_noise(generated_models::vertices_on_one_side(part), noisy_part, np::noise_level(0.3));
    ablation_of("cad_part_on_one_side", part, noisy_part);
    const generated_models::Model uneven = generated_models::uneven(generated_model("organic_shape", 10000));
    ablation("uneven", generated_models::to_mesh<Mesh>(uneven), np::noise_level(0.3));
    parameters("cad_part", 5000);
    parameters("twirl", 5000);
    parameters("organic_shape", 5000);
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << "manual_figures: " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
}
