// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Pairs of a noise-free mesh and a noisy one, from files or generated.

#ifndef SURFACE_MESH_DENOISING_MESH_PAIRS_H
#define SURFACE_MESH_DENOISING_MESH_PAIRS_H

#include "../../../examples/Surface_mesh_denoising/include/mesh_files.h"
#include "generated_models.h"

#include <CGAL/Surface_mesh_denoising/add_noise.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace mesh_pairs {

template <typename Mesh>
struct Meshes
{
  Mesh noise_free, noisy;
};

template <typename Mesh>
struct Pair
{
  std::string name;
  std::function<Meshes<Mesh>()> load;
};

template <typename Mesh>
void check_same_faces(const std::string& name, const Meshes<Mesh>& meshes)
{
  const Mesh& a = meshes.noise_free;
  const Mesh& b = meshes.noisy;
  bool are_same = a.number_of_vertices() == b.number_of_vertices() && a.number_of_faces() == b.number_of_faces();
  for(std::size_t f=0; are_same && f<a.number_of_faces(); ++f)
  {
    const auto corners = [f](const Mesh& mesh)
    {
      const auto face = typename Mesh::Face_index(typename Mesh::size_type(f));
      std::array<std::size_t, 3> c;
      std::size_t i = 0;
      for(const auto v : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
        c[i++] = v;
      std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
      return c;
    };
    are_same = corners(a) == corners(b);
  }
  if(!are_same)
    throw std::runtime_error(name + ": the two meshes do not have the same faces");
}

template <typename Mesh>
Pair<Mesh> from_files(const std::string& name, const std::string& noise_free, const std::string& noisy)
{
  return { name, [=]()
  {
    Meshes<Mesh> meshes;
    mesh_files::read_triangle_mesh(noise_free, meshes.noise_free);
    mesh_files::read_triangle_mesh(noisy, meshes.noisy);
    check_same_faces(name, meshes);
    return meshes;
  } };
}

struct Noise_kind
{
  std::string name, description;
  CGAL::Surface_mesh_denoising::Noise_distribution distribution;
  CGAL::Surface_mesh_denoising::Noise_direction direction;
  double share;
};

inline const std::vector<Noise_kind>& noise_kinds()
{
  typedef CGAL::Surface_mesh_denoising::Noise_distribution Distribution;
  typedef CGAL::Surface_mesh_denoising::Noise_direction Direction;

  static const std::vector<Noise_kind> kinds = {
    { "gaussian", "Gaussian, along the normals", Distribution::GAUSSIAN, Direction::NORMAL, 1 },
    { "uniform", "uniform, along the normals", Distribution::UNIFORM, Direction::NORMAL, 1 },
    { "random", "Gaussian, in random directions", Distribution::GAUSSIAN, Direction::RANDOM, 1 },
    { "impulsive", "Gaussian, along the normals, of a tenth of the vertices", Distribution::GAUSSIAN, Direction::NORMAL,
      0.1 }
  };
  return kinds;
}

template <typename Mesh>
Pair<Mesh> generated(const std::string& model, const std::size_t number_of_vertices,
                     const generated_models::Triangles triangles, const Noise_kind& kind, const double level,
                     const unsigned seed)
{
  namespace np = CGAL::parameters;

  std::ostringstream name;
  name << model << "_" << number_of_vertices
       << (triangles == generated_models::Triangles::REGULAR ? "_regular_" : "_irregular_") << kind.name << level;
  return { name.str(), [=]()
  {
    generated_models::Options options;
    options.number_of_vertices = number_of_vertices;
    options.triangles = triangles;
    options.seed = seed;
    Meshes<Mesh> meshes;
    meshes.noise_free = generated_models::to_mesh<Mesh>(generated_models::generate(model, options));
    meshes.noisy = meshes.noise_free;
    CGAL::Surface_mesh_denoising::add_noise(meshes.noisy, np::noise_level(level).noise_distribution(kind.distribution)
                                                             .noise_direction(kind.direction).noise_share(kind.share)
                                                             .random_seed(seed));
    return meshes;
  } };
}

} // namespace mesh_pairs

#endif // SURFACE_MESH_DENOISING_MESH_PAIRS_H
