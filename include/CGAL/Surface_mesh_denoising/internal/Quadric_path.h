// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_QUADRIC_PATH_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_QUADRIC_PATH_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Adaptive_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Gaussian.h>
#include <CGAL/Surface_mesh_denoising/internal/Local_numbering.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>
#include <CGAL/Surface_mesh_denoising/internal/smooth_over_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/to_eigen.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// A path for surfaces that are smooth but bent within few triangles, see Path_estimate.h. The planes of the triangles around
// it tell a vertex where it ought to be (Jones, Durand, Desbrun): that leaves less noise than many small steps, as the weights
// fall smoothly with the distance, whatever the triangles are like. The normals of the planes are averages, of more and more
// triangles from step to step. The planes come as quadrics, which are averaged over neighborhoods (Legrand, Thiery,
// Boubekeur), so that averages of averages reach further. Where the surface bends, all this leaves vertices on one side of it:
// the heights of the observed points above them, smoothed, are given back.
//
// Vertices at borders stay, and the quadrics of their triangles do not count.
template <typename ConcurrencyTag>
class Quadric_path
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  // `disturbances` are lengths along `normals`. Keeps references; of `mesh` only the faces count, and its points are as before
  // after each call
  Quadric_path(Indexed_triangle_mesh& mesh, const std::vector<Point_3>& observed, const std::vector<bool>& is_movable,
               const Vertex_neighbors& neighbors, const std::vector<Vector_3>& normals,
               const std::vector<double>& disturbances, const double mean_edge_length, const Adaptive_parameters& parameters)
    : m_mesh(mesh), m_observed(observed), m_is_movable(is_movable), m_neighbors(neighbors), m_normals(normals),
      m_disturbances(disturbances), m_mean_edge_length(mean_edge_length), m_parameters(parameters),
      m_disturbed(observed.size()), m_states(observed.size())
  {
    for_each_index<ConcurrencyTag>(observed.size(), [&](const std::size_t v)
    {
      m_disturbed[v] = observed[v] + disturbances[v] * normals[v];
      m_states[v].disturbance = disturbances[v];
    });
    std::vector<double> ignored_areas;
    compute_normals(m_disturbed, m_disturbed_normals, ignored_areas);
    compute_normals(observed, m_face_normals, m_face_areas);
    find_neighborhoods();
  }

  Point_3 point(const std::size_t v) const { return m_observed[v] + m_states[v].displacement; }

  double noise_share(const std::size_t v) const { return m_disturbances[v] * m_states[v].disturbance; }

  double least_weight(std::size_t, std::size_t) const { return 0; }

  // each step smooths the heights once more
  void go_to(const std::size_t end)
  {
    const std::size_t delay = m_parameters.quadric_delay_of_normal_averages;
    const std::size_t number_of_normal_averages = (end > delay) ? end - delay : 1;
    const std::size_t number_of_averages = 1 + end / m_parameters.quadric_steps_by_average;
    if(number_of_normal_averages != m_number_of_normal_averages || number_of_averages != m_number_of_averages)
    {
      const std::size_t number_of_further_ones = number_of_normal_averages - m_number_of_normal_averages;
      average_normals(number_of_further_ones, m_face_normals);
      average_normals(number_of_further_ones, m_disturbed_normals);
      m_ways = ways_to_planes(m_observed, m_face_normals, number_of_averages);
      m_disturbed_ways = ways_to_planes(m_disturbed, m_disturbed_normals, number_of_averages);
      m_number_of_normal_averages = number_of_normal_averages;
      m_number_of_averages = number_of_averages;
    }

    std::vector<Height> heights(m_states.size(), Height::Zero());
    for_each_index<ConcurrencyTag>(heights.size(), [&](const std::size_t v)
    {
      if(moves(v))
        heights[v] = -Height(m_normals[v] * m_ways[v], m_normals[v] * (m_disturbed_ways[v] - m_ways[v]));
    });
    std::vector<Height> smoothed = heights;
    smooth_over_neighbors<ConcurrencyTag>(m_neighbors, m_is_movable, end, m_parameters.laplacian_shares, smoothed);
    for_each_index<ConcurrencyTag>(heights.size(), [&](const std::size_t v)
    {
      if(moves(v))
        m_states[v] = State{ m_ways[v] + smoothed[v][0] * m_normals[v],
                             m_disturbances[v] + (smoothed[v][1] - heights[v][1]) };
    });
  }

private:
  typedef Eigen::Matrix<float, 3, 4> Quadric; // the mean of n n^T, and the mean way to the planes, n n^T times that to a centroid
  typedef Eigen::Array2d Height;              // of the observed point, and what the disturbance adds to that

  struct State
  {
    Vector_3 displacement = Vector_3(0, 0, 0);
    double disturbance = 0; // what is left of it
  };

  // those of the vertices of a block, one after the other
  struct Neighborhoods
  {
    std::vector<std::size_t> ends;
    std::vector<Index> vertices;
    std::vector<float> weights;
  };

  static constexpr std::size_t vertices_in_block = 1024;

  bool moves(const std::size_t v) const { return m_is_movable[v] && m_neighbors.is_inside(v); }

  void compute_normals(std::vector<Point_3> points, std::vector<Vector_3>& normals, std::vector<double>& areas) const
  {
    m_mesh.swap_points(points);
    compute_face_normals<ConcurrencyTag>(m_mesh, normals, areas);
    m_mesh.swap_points(points);
  }

  void average_normals(const std::size_t number_of_times, std::vector<Vector_3>& normals) const
  {
    std::vector<Vector_3> vertex_normals;
    for(std::size_t k=0; k<number_of_times; ++k)
    {
      compute_vertex_normals<ConcurrencyTag>(m_mesh, normals, m_face_areas, vertex_normals);
      average_vertex_normals<ConcurrencyTag>(m_mesh, vertex_normals, normals);
    }
  }

  void find_neighborhoods()
  {
    const std::size_t n = m_observed.size();
    m_vertex_areas.resize(n);
    const double unit = m_mean_edge_length * m_mean_edge_length;
    for_each_index<ConcurrencyTag>(n, [&](const std::size_t v)
    {
      double sum = 0;
      for(const Index f : m_mesh.faces_around_vertex(v))
        sum += m_face_areas[f];
      m_vertex_areas[v] = sum / unit;
    });

    m_blocks.resize((n + vertices_in_block - 1) / vertices_in_block);
    for_each_block<ConcurrencyTag>(m_blocks.size(), [&](const std::size_t first, const std::size_t last)
    {
      Local_numbering<Index> seen;
      for(std::size_t b=first; b<last; ++b)
        for(std::size_t v=b*vertices_in_block; v<(std::min)(n, (b+1)*vertices_in_block); ++v)
        {
          if(moves(v))
            add_neighborhood(v, seen, m_blocks[b]);
          m_blocks[b].ends.push_back(m_blocks[b].vertices.size());
        }
    }, 1);
  }

  // The vertices in a ball around vertex `v` that it is connected to there. The search ends with a ring, so that the order of
  // vertices does not matter
  void add_neighborhood(const std::size_t v, Local_numbering<Index>& seen, Neighborhoods& block) const
  {
    const double sigma = m_parameters.quadric_sigma * m_mean_edge_length, radius = m_parameters.quadric_reach * sigma;
    const Gaussian gaussian(sigma);
    double sum = 0;
    const auto add = [&](const Index w, const double squared_distance)
    {
      const double weight = m_vertex_areas[w] * gaussian(squared_distance);
      block.vertices.push_back(w);
      block.weights.push_back(float(weight));
      sum += weight;
    };
    const std::size_t begin = block.vertices.size();
    seen.clear();
    seen.insert(Index(v));
    add(Index(v), 0);
    for(std::size_t first=begin, last=begin+1;
        first < last && last - begin < m_parameters.quadric_largest_neighborhood; first = last, last = block.vertices.size())
      for(std::size_t i=first; i<last; ++i)
        for(const Index w : m_neighbors(block.vertices[i]))
          if(seen.insert(w).second && m_neighbors.is_inside(w))
          {
            const double d = squared_distance(m_observed[v], m_observed[w]);
            if(d <= radius * radius)
              add(w, d);
          }
    for(std::size_t i=begin; i<block.weights.size(); ++i)
      block.weights[i] = (sum > 0) ? float(block.weights[i] / sum) : 0.f;
  }

  // the mean ways from `points` to the planes around
  std::vector<Vector_3> ways_to_planes(const std::vector<Point_3>& points, const std::vector<Vector_3>& face_normals,
                                       const std::size_t number_of_averages) const
  {
    std::vector<Quadric> quadrics = make_quadrics(points, face_normals), means(quadrics.size());
    for(std::size_t k=0; k<number_of_averages; ++k)
    {
      for_each_index<ConcurrencyTag>(m_blocks.size(), [&](const std::size_t b)
      {
        const Neighborhoods& block = m_blocks[b];
        std::size_t i = 0;
        for(std::size_t j=0; j<block.ends.size(); ++j)
        {
          const std::size_t v = b * vertices_in_block + j;
          Quadric mean = Quadric::Zero();
          for(; i<block.ends[j]; ++i)
          {
            const Index w = block.vertices[i];
            const Eigen::Vector3f way = to_eigen(points[w] - points[v]).template cast<float>();
            mean += block.weights[i] * quadrics[w];
            mean.col(3) += block.weights[i] * (quadrics[w].template leftCols<3>() * way);
          }
          means[v] = mean;
        }
      });
      quadrics.swap(means);
    }
    std::vector<Vector_3> ways(points.size());
    for_each_index<ConcurrencyTag>(ways.size(), [&](const std::size_t v)
    { ways[v] = Vector_3(quadrics[v](0, 3), quadrics[v](1, 3), quadrics[v](2, 3)); });
    return ways;
  }

  std::vector<Quadric> make_quadrics(const std::vector<Point_3>& points, const std::vector<Vector_3>& normals) const
  {
    const double unit = m_mean_edge_length * m_mean_edge_length;
    std::vector<Quadric> quadrics(points.size());
    for_each_index<ConcurrencyTag>(quadrics.size(), [&](const std::size_t v)
    {
      Eigen::Matrix<double, 3, 4> sum = Eigen::Matrix<double, 3, 4>::Zero();
      for(const Index f : m_mesh.faces_around_vertex(v))
      {
        const std::array<Index, 3>& t = m_mesh.vertices(f);
        const Vector_3 to_centroid = ((points[t[0]] - points[v]) + (points[t[1]] - points[v]) + (points[t[2]] - points[v])) / 3;
        const Eigen::Vector3d n = to_eigen(normals[f]), weighted = (m_face_areas[f] / unit) * n;
        sum.leftCols<3>() += weighted * n.transpose();
        sum.col(3) += (normals[f] * to_centroid) * weighted;
      }
      if(m_vertex_areas[v] > 0)
        sum /= m_vertex_areas[v];
      quadrics[v] = sum.cast<float>();
    });
    return quadrics;
  }

  Indexed_triangle_mesh& m_mesh;
  const std::vector<Point_3>& m_observed;
  const std::vector<bool>& m_is_movable;
  const Vertex_neighbors& m_neighbors;
  const std::vector<Vector_3>& m_normals;
  const std::vector<double>& m_disturbances;
  double m_mean_edge_length;
  const Adaptive_parameters& m_parameters;

  std::vector<Point_3> m_disturbed;
  std::vector<State> m_states;
  std::vector<double> m_face_areas, m_vertex_areas; // of the observed points; those of vertices in the square of the unit
  std::vector<Neighborhoods> m_blocks;
  std::vector<Vector_3> m_face_normals, m_disturbed_normals; // averages of those of the faces
  std::size_t m_number_of_normal_averages = 0;
  std::vector<Vector_3> m_ways, m_disturbed_ways;
  std::size_t m_number_of_averages = 0;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_QUADRIC_PATH_H
