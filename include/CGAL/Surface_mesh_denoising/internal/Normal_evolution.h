// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_NORMAL_EVOLUTION_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_NORMAL_EVOLUTION_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Face_geometry.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// (1 - x/64)^64 for 0 <= x < 64, and zero from there on: exp(-x), a little narrower, several times faster
inline double bell(const double x)
{
  double y = (std::max)(1 - x / 64, 0.);
  for(int i=0; i<6; ++i)
    y *= y;
  return y;
}

struct Evolution_step
{
  double range;                    // sigma of differences of normals
  bool counts_own_normal;          // whether the face itself is part of its mean
  std::size_t number_of_normal_iterations;
  std::size_t number_of_moves;
};

// One step of an evolution that many small steps make: a bilateral filter of the face normals, then moves of the
// vertices towards agreement with them. The same formulas as Bilateral_normal_filter and Normal_driven_update,
// with all that does not change inside a step computed once.
template <typename ConcurrencyTag>
class Normal_evolution
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  // the filtered normals of the last step
  const std::vector<Vector_3>& face_normals() const { return m_normals; }

  // makes the areas and distances in `mesh` the weights of the steps to come
  void update_weights(const Indexed_triangle_mesh& mesh)
  {
    const std::size_t n = mesh.number_of_faces();
    if(n == 0)
      return;
    const Face_geometry geometry(mesh, ConcurrencyTag());
    const double width = geometry.mean_centroid_distance();
    const double factor = (width > 0) ? 0.5 / (width * width) : 0;

    // one weight for each entry in the lists of faces around faces
    const Index* const first_entry = mesh.faces_around_face(0).begin();
    m_weights.resize(mesh.faces_around_face(n-1).end() - first_entry);
    m_own_weights.resize(n);
    for_each_index<ConcurrencyTag>(n, [&](const std::size_t f)
    {
      const auto faces = mesh.faces_around_face(f);
      double* weight = m_weights.data() + (faces.begin() - first_entry);
      for(const Index g : faces)
        *weight++ = geometry.area(g)
                  * bell(factor * squared_distance(geometry.centroid(f), geometry.centroid(g)));
      m_own_weights[f] = geometry.area(f);
    });
  }

  void operator()(Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable, const Evolution_step& step)
  {
    compute_face_normals<ConcurrencyTag>(mesh, m_normals, m_areas);
    filter(mesh, step);
    move_to_agree(mesh, is_movable, m_normals, step.number_of_moves);
  }

  // Each vertex goes to the mean of its projections onto the planes through the centroids of its faces, or `factor` times as far,
  // which saves moves. With more than 1.5 they need not converge
  void move_to_agree(Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                     const std::vector<Vector_3>& normals, const std::size_t number_of_moves,
                     const double factor = 1)
  {
    m_planes.resize(mesh.number_of_faces());
    m_points.resize(mesh.number_of_vertices());
    for(std::size_t k=0; k<number_of_moves; ++k)
    {
      for_each_index<ConcurrencyTag>(mesh.number_of_faces(), [&](const std::size_t f)
      {
        m_planes[f] = Plane{normals[f], normals[f] * (mesh.centroid(f) - ORIGIN)};
      });
      for_each_index<ConcurrencyTag>(mesh.number_of_vertices(), [&](const std::size_t v)
      {
        const Point_3 p = m_points[v] = mesh.point(v);
        const auto faces = mesh.faces_around_vertex(v);
        if(!is_movable[v] || faces.empty())
          return;
        Vector_3 sum(0, 0, 0);
        for(const Index f : faces)
          sum += (m_planes[f].offset - m_planes[f].normal * (p - ORIGIN)) * m_planes[f].normal;
        m_points[v] = p + (factor / double(faces.size())) * sum;
      });
      mesh.swap_points(m_points);
    }
  }

private:
  struct Plane
  {
    Vector_3 normal;
    double offset;
  };

  void filter(const Indexed_triangle_mesh& mesh, const Evolution_step& step)
  {
    const std::size_t n = mesh.number_of_faces();
    if(n == 0)
      return;
    const double range_factor = 0.5 / (step.range * step.range);
    const Index* const first_entry = mesh.faces_around_face(0).begin();
    m_filtered.resize(n);
    for(std::size_t k=0; k<step.number_of_normal_iterations; ++k)
    {
      for_each_index<ConcurrencyTag>(n, [&](const std::size_t f)
      {
        const auto faces = mesh.faces_around_face(f);
        const double* weight = m_weights.data() + (faces.begin() - first_entry);
        const Vector_3 normal = m_normals[f];
        Vector_3 sum = (step.counts_own_normal ? double(m_own_weights[f]) : 0) * normal;
        for(const Index g : faces)
        {
          const Vector_3& other = m_normals[g];
          sum += (double(*weight++) * bell(range_factor * (normal - other).squared_length())) * other;
        }
        m_filtered[f] = normalized_or(sum, normal);
      });
      m_normals.swap(m_filtered);
    }
  }

  std::vector<Vector_3> m_normals, m_filtered;
  std::vector<double> m_areas;
  std::vector<double> m_weights, m_own_weights;
  std::vector<Plane> m_planes;
  std::vector<Point_3> m_points;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_NORMAL_EVOLUTION_H
