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
#include <CGAL/Surface_mesh_denoising/internal/Noise_map.h>
#include <CGAL/Surface_mesh_denoising/internal/Vector_pair.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

template <typename Number>
Number to_the_64th(Number x)
{
  for(int i=0; i<6; ++i)
    x *= x;
  return x;
}

// (1 - x/64)^64 for 0 <= x < 64, and zero from there on: exp(-x), a little narrower, several times faster
inline double bell(const double x) { return to_the_64th((std::max)(1 - x / 64, 0.)); }

inline double positive_part(const double x) { return (std::max)(x, 0.); }
inline Number_pair positive_part(const Number_pair& x) { return x.max(0.); }

struct Evolution_step
{
  double range;                    // sigma of differences of normals, where noise is strong
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

  // makes the areas and distances in `mesh` the weights of the steps to come, whose ranges go with the noise
  void update_weights(const Indexed_triangle_mesh& mesh, const Noise_map& noise)
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
      float* weight = m_weights.data() + (faces.begin() - first_entry);
      for(const Index g : faces)
        *weight++ = float(geometry.area(g)
                          * bell(factor * squared_distance(geometry.centroid(f), geometry.centroid(g))));
      m_own_weights[f] = float(geometry.area(f));
    });

    m_range_factors.resize(noise.is_uniform() ? 0 : n);
    for_each_index<ConcurrencyTag>(m_range_factors.size(), [&](const std::size_t f)
    {
      const double ratio = noise.ratio_of_face(mesh, f);
      m_range_factors[f] = float(1 / (ratio * ratio));
    });
  }

  void operator()(Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable, const Evolution_step& step)
  {
    compute_face_normals<ConcurrencyTag>(mesh, m_normals, m_areas);
    filter(mesh, step, m_normals, m_single.normals);
    std::vector<Point_3> points;
    mesh.swap_points(points);
    move_to_agree(mesh, points, is_movable, m_normals, step.number_of_moves, m_single);
    mesh.swap_points(points);
  }

  // The same for `mesh` and for the mesh with its vertices at `other_points`, with the same weights, in little more time.
  // The filter sees the normals without their deviations, which uneven triangles have where the surface bends. `face_normals()`
  // are then of no use
  void operator()(Indexed_triangle_mesh& mesh, std::vector<Point_3>& other_points, const std::vector<bool>& is_movable,
                  const std::vector<Vector_3>& deviations, const Evolution_step& step)
  {
    std::vector<Vector_pair>& normals = m_pairs_of_normals;
    compute_face_normals<ConcurrencyTag>(mesh, m_normals, m_areas);
    pair_up(m_normals, m_normals, normals); // the second ones come when the first have left their buffer
    mesh.swap_points(other_points);
    compute_face_normals<ConcurrencyTag>(mesh, m_normals, m_areas);
    mesh.swap_points(other_points);
    for_each_index<ConcurrencyTag>(normals.size(), [&](const std::size_t f)
    { normals[f] = Vector_pair(normals[f].first(), m_normals[f]); });
    const auto add_deviations = [&](const double factor)
    {
      for_each_index<ConcurrencyTag>(normals.size(), [&](const std::size_t f)
      { normals[f] = normalized_or(normals[f] + factor * Vector_pair(deviations[f], deviations[f]), normals[f]); });
    };
    add_deviations(-1);
    filter(mesh, step, normals, m_pair.normals);
    add_deviations(1);

    std::vector<Point_3> points;
    mesh.swap_points(points);
    std::vector<Vector_pair>& positions = m_pairs_of_positions;
    pair_up(points, other_points, positions);
    move_to_agree(mesh, positions, is_movable, normals, step.number_of_moves, m_pair);
    for_each_index<ConcurrencyTag>(points.size(), [&](const std::size_t v)
    {
      points[v] = ORIGIN + positions[v].first();
      other_points[v] = ORIGIN + positions[v].second();
    });
    mesh.swap_points(points);
  }

private:
  // what a step writes to; kept, as steps are many and memory that is new costs more than what is done with it
  template <typename Point, typename Vector>
  struct Workspace
  {
    std::vector<Vector> normals;
    std::vector<Point> points;
    std::vector<decltype(std::declval<Vector>().squared_length())> offsets; // of the planes, along the normals
  };

  template <typename Elements>
  static void pair_up(const Elements& first, const Elements& second, std::vector<Vector_pair>& pairs)
  {
    pairs.resize(first.size());
    for_each_index<ConcurrencyTag>(first.size(), [&](const std::size_t i)
    { pairs[i] = Vector_pair(to_vector(first[i]), to_vector(second[i])); });
  }

  // Each of `points` goes to the mean of its projections onto the planes through the centroids of its faces. Of `mesh` only
  // the faces count
  template <typename Point, typename Vector>
  static void move_to_agree(const Indexed_triangle_mesh& mesh, std::vector<Point>& points,
                            const std::vector<bool>& is_movable, const std::vector<Vector>& normals,
                            const std::size_t number_of_moves, Workspace<Point, Vector>& workspace)
  {
    auto& offsets = workspace.offsets;
    std::vector<Point>& moved = workspace.points;
    offsets.resize(mesh.number_of_faces());
    moved.resize(points.size());
    for(std::size_t k=0; k<number_of_moves; ++k)
    {
      for_each_index<ConcurrencyTag>(offsets.size(), [&](const std::size_t f)
      {
        const std::array<Index, 3>& t = mesh.vertices(f);
        offsets[f] = normals[f]
                   * ((to_vector(points[t[0]]) + to_vector(points[t[1]]) + to_vector(points[t[2]])) / 3.);
      });
      for_each_index<ConcurrencyTag>(points.size(), [&](const std::size_t v)
      {
        moved[v] = points[v];
        const auto faces = mesh.faces_around_vertex(v);
        if(!is_movable[v] || faces.empty())
          return;
        const Vector p = to_vector(points[v]);
        Vector sum = 0. * p;
        for(const Index f : faces)
          sum += (offsets[f] - normals[f] * p) * normals[f];
        moved[v] = points[v] + sum / double(faces.size());
      });
      points.swap(moved);
    }
  }

  template <typename Vector>
  void filter(const Indexed_triangle_mesh& mesh, const Evolution_step& step, std::vector<Vector>& normals,
              std::vector<Vector>& filtered) const
  {
    const std::size_t n = mesh.number_of_faces();
    if(n == 0)
      return;
    const double range_factor = 0.5 / (step.range * step.range);
    const Index* const first_entry = mesh.faces_around_face(0).begin();
    filtered.resize(n);
    for(std::size_t k=0; k<step.number_of_normal_iterations; ++k)
    {
      for_each_index<ConcurrencyTag>(n, [&](const std::size_t f)
      {
        const auto faces = mesh.faces_around_face(f);
        const float* weight = m_weights.data() + (faces.begin() - first_entry);
        const Vector normal = normals[f];
        // bell(factor |m - n|^2) is (1 - slope + slope m n)^64 or zero, as normals have the length one
        const double slope = (m_range_factors.empty() ? range_factor : range_factor * double(m_range_factors[f])) / 32;
        const Vector scaled_normal = slope * normal;
        Vector sum = (step.counts_own_normal ? double(m_own_weights[f]) : 0.) * normal;
        for(const Index g : faces)
        {
          const Vector& other = normals[g];
          sum += (double(*weight++) * to_the_64th(positive_part(1 - slope + scaled_normal * other))) * other;
        }
        filtered[f] = normalized_or(sum, normal);
      });
      normals.swap(filtered);
    }
  }

  std::vector<float> m_weights, m_own_weights;
  std::vector<float> m_range_factors; // for each face, on one over the square of the range; none where noise is uniform
  std::vector<Vector_3> m_normals;
  std::vector<double> m_areas;
  std::vector<Vector_pair> m_pairs_of_normals, m_pairs_of_positions;
  Workspace<Point_3, Vector_3> m_single;
  Workspace<Vector_pair, Vector_pair> m_pair;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_NORMAL_EVOLUTION_H
