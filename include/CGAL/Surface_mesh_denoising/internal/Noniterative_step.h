// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_NONITERATIVE_STEP_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_NONITERATIVE_STEP_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Ball_search.h>
#include <CGAL/Surface_mesh_denoising/internal/Gaussian.h>
#include <CGAL/Surface_mesh_denoising/internal/Mesh_normals.h>
#include <CGAL/Surface_mesh_denoising/internal/move.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Where non-iterative, feature-preserving smoothing moves the vertices
template <typename ConcurrencyTag>
class Noniterative_step : public Mesh_normals<ConcurrencyTag>
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  // both in mean edge lengths
  Noniterative_step(const double spatial_sigma, const double height_sigma)
    : m_spatial_sigma(spatial_sigma), m_height_sigma(height_sigma)
  {}

  void operator()(const Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                  std::vector<Vector_3>& displacements)
  {
    this->compute_normals(mesh);
    const double unit = mesh.mean_edge_length<ConcurrencyTag>();
    const double sigma_f = m_spatial_sigma * unit;
    const Gaussian mollifying(0.5 * sigma_f), spatial(sigma_f), influence(m_height_sigma * unit);

    // the points of the mollified mesh, of which only the normals count
    std::vector<Point_3> points(mesh.number_of_vertices());
    for_each_vertex(mesh, 2 * sigma_f, [&](const std::size_t v, const std::vector<Index>& faces)
    {
      Weighted_mean mean;
      for(const Index f : faces)
      {
        const Vector_3 c = mesh.centroid(f) - mesh.point(v);
        mean.add(mesh.area(f) * mollifying(c.squared_length()), c);
      }
      points[v] = mesh.point(v) + mean();
    });
    std::vector<Vector_3> normals;
    std::vector<double> areas;
    Indexed_triangle_mesh mollified = mesh;
    mollified.swap_points(points);
    compute_face_normals<ConcurrencyTag>(mollified, normals, areas);

    for_each_vertex(mesh, 2 * sigma_f, [&](const std::size_t v, const std::vector<Index>& faces)
    {
      if(!is_movable[v])
        return;
      Weighted_mean mean;
      for(const Index f : faces)
      {
        const Vector_3 c = mesh.centroid(f) - mesh.point(v);
        const double height = c * normals[f];
        mean.add(mesh.area(f) * spatial(c.squared_length()) * influence(height * height), height * normals[f]);
      }
      displacements[v] = mean();
    });
    prevent_flips<ConcurrencyTag>(mesh, this->mean_normals(mesh), displacements);
  }

private:
  class Weighted_mean
  {
  public:
    void add(const double weight, const Vector_3& v)
    {
      m_sum += weight * v;
      m_sum_of_weights += weight;
    }
    Vector_3 operator()() const { return m_sum_of_weights > 0 ? m_sum / m_sum_of_weights : Vector_3(0, 0, 0); }

  private:
    Vector_3 m_sum = Vector_3(0, 0, 0);
    double m_sum_of_weights = 0;
  };

  template <typename Body>
  static void for_each_vertex(const Indexed_triangle_mesh& mesh, const double radius, const Body& body)
  {
    for_each_block<ConcurrencyTag>(mesh.number_of_vertices(), [&](const std::size_t first, const std::size_t last)
    {
      Ball_search search(mesh);
      for(std::size_t v=first; v<last; ++v)
        body(v, search.faces_around_vertex(v, radius * radius));
    });
  }

  double m_spatial_sigma;
  double m_height_sigma;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_NONITERATIVE_STEP_H
