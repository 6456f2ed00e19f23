// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_PATCH_BLEND_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_PATCH_BLEND_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Adaptive_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Face_geometry.h>
#include <CGAL/Surface_mesh_denoising/internal/Local_numbering.h>
#include <CGAL/Surface_mesh_denoising/internal/Neighborhood_search.h>
#include <CGAL/Surface_mesh_denoising/internal/Noise_map.h>
#include <CGAL/Surface_mesh_denoising/internal/Patch_fit.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/mixing.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>
#include <CGAL/Surface_mesh_denoising/internal/sine_key.h>
#include <CGAL/Surface_mesh_denoising/internal/to_eigen.h>

#include <CGAL/tags.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Covers the mesh with overlapping patches, surfaces fitted to anisotropic neighborhoods, and blends them.
//
// Neighborhoods grow over the pilot, whose normals know the edges, while the surfaces fit the observed points, which
// the pilot has not bent. Each patch has the size and the degree of its own that promise the least error.
template <typename ConcurrencyTag>
class Patch_blend
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

public:
  // `mesh` holds the pilot's points. Keeps references
  Patch_blend(const Indexed_triangle_mesh& mesh, const std::vector<Point_3>& observed,
              const std::vector<bool>& is_movable, const Noise_map& noise, const double mean_edge_length,
              const Adaptive_parameters& parameters, const Pilot_error& pilot_error, const Patch_effort& effort)
    : m_mesh(mesh), m_observed(observed), m_is_movable(is_movable), m_parameters(parameters),
      m_pilot_error(pilot_error), m_effort(effort),
      m_geometry(mesh, ConcurrencyTag()), m_mean_edge_length(mean_edge_length),
      m_extent(parameters.patch_extent * m_geometry.mean_centroid_distance()),
      m_noise(noise), m_squared_noise((std::max)(noise.level * noise.level, 1e-16 * mean_edge_length * mean_edge_length)),
      m_is_in_core(mesh.number_of_faces(), false), m_normal_sums(mesh.number_of_faces(), Vector_3(0, 0, 0)),
      m_centroid_normal_sums(mesh.number_of_faces(), Vector_3(0, 0, 0)),
      m_vertex_sums(mesh.number_of_vertices())
  {
    std::vector<double> areas;
    compute_face_normals<ConcurrencyTag>(mesh, m_normals, areas);
    if(!(m_extent > 0))
      return;
    // strong noise makes low faces itself, everywhere
    const std::array<double, 2>& limits = parameters.low_face_noise;
    const double share = 1 - ramp(noise.level, limits[0] * mean_edge_length, limits[1] * mean_edge_length);
    steady_normals_of_low_faces<ConcurrencyTag>(mesh, areas, share * parameters.low_face_error * noise.level,
                                                parameters.number_of_normal_averages, m_normals);
    replace_turned_normals<ConcurrencyTag>(mesh, areas, parameters.agreement, m_normals);

    std::vector<std::array<Dual_edge, 3> > dual_edges;
    const Indexed_dual_graph dual(mesh, m_normals, parameters.normal_weight, dual_edges, ConcurrencyTag());
    compute_keys();
    std::vector<Index> seeds;
    Worker worker(*this, dual);
    for(std::size_t round=0; round<parameters.number_of_rounds; ++round)
    {
      choose_seeds(round, seeds);
      if(seeds.empty())
        break;
      add_patches(dual, worker, seeds);
    }
    m_keys = std::vector<double>();
  }

  // the normals of the patches that cover each face, blended; those of the pilot where there are none
  std::vector<Vector_3> face_normals() const
  {
    std::vector<Vector_3> normals(m_normals.size());
    for_each_index<ConcurrencyTag>(normals.size(), [&](const std::size_t f)
    { normals[f] = normalized_or(m_normal_sums[f], m_normals[f]); });
    return normals;
  }

  // How far the normals of faces are from those of the patches at their centroids, as patches bend; zero where triangles are
  // so coarse beside the bends that it means nothing. Where triangles are regular deviations cancel at each vertex, and only
  // what noise makes of them remains: all shrink by the share of that, which rests on the `leverages`
  std::vector<Vector_3> normal_deviations(const std::vector<double>& leverages) const
  {
    std::vector<Vector_3> deviations(m_normals.size());
    for_each_index<ConcurrencyTag>(deviations.size(), [&](const std::size_t f)
    {
      const Vector_3 d = normalized_or(m_normal_sums[f], m_normals[f])
                       - normalized_or(m_centroid_normal_sums[f], m_normals[f]);
      const double limit = m_parameters.largest_normal_deviation;
      deviations[f] = (d.squared_length() <= limit * limit) ? d : Vector_3(0, 0, 0);
    });
    const double share = share_of_shape(deviations, leverages);
    for_each_index<ConcurrencyTag>(deviations.size(), [&](const std::size_t f) { deviations[f] = share * deviations[f]; });
    return deviations;
  }

  // Each vertex where the squared distances to the patches that cover it are least, by their weights. In directions that
  // they leave free, or hardly tell as their normals are almost the same, it keeps to the observed point: noise is mostly
  // along the normals. Where triangles are smaller than the noise they mean nothing, and it keeps to the pilot, which has
  // evened triangles out; so it does where there are no patches
  std::vector<Point_3> points() const
  {
    std::vector<Point_3> points(m_mesh.points());
    for_each_index<ConcurrencyTag>(points.size(), [&](const std::size_t v)
    {
      const Vertex_sum& s = m_vertex_sums[v];
      if(!m_is_movable[v] || !(s.weight > 0))
        return;
      Eigen::Matrix3d matrix;
      matrix << s.m[0], s.m[1], s.m[2],
                s.m[1], s.m[3], s.m[4],
                s.m[2], s.m[4], s.m[5];
      matrix /= s.weight;
      Eigen::Matrix3d damped = matrix * matrix;
      damped.diagonal().array() += m_parameters.tangential_weight * m_parameters.tangential_weight;
      const double height = mean_height_of_faces(m_mesh, m_mesh.faces_around_vertex(v),
                                                 [&](const Index f) { return m_geometry.area(f); });
      const std::array<double, 2>& limits = m_parameters.noise_to_keep_to_pilot;
      const double share_of_pilot = ramp(std::sqrt(squared_noise(v)), limits[0] * height, limits[1] * height);
      const Point_3 start = m_observed[v] + share_of_pilot * (points[v] - m_observed[v]);
      const Eigen::Vector3d residual = to_eigen(s.rhs) / s.weight - matrix * to_eigen(start - m_observed[v]);
      const Eigen::Vector3d d = damped.inverse() * (matrix * residual);
      if(d.allFinite())
        points[v] = start + Vector_3(d[0], d[1], d[2]);
    });
    return points;
  }

  // how far each vertex follows its observed point, if that moves along the normal and the patches keep their faces
  std::vector<double> leverages() const { return means(&Vertex_sum::leverage); }

  // See mixing.h. Patches follow the noise by their coefficients, and by the choice of their sizes and degrees, which follows
  // it, too: together as if they had some more coefficients than a plane, the more the fewer their points are, whatever
  // their degrees. Where edges are shorter than the noise it takes part in the choice of faces
  std::vector<double> noise_shares(const Vertex_neighbors& neighbors) const
  {
    std::vector<double> shares = means(&Vertex_sum::inverse_size);
    const std::array<double, 2>& limits = m_parameters.noise_to_choose_faces;
    for_each_index<ConcurrencyTag>(shares.size(), [&](const std::size_t v)
    {
      const double noise = std::sqrt(squared_noise(v));
      const double choice = (std::min)(1., m_parameters.points_of_full_choice * shares[v]);
      const double length = neighbors(v).empty() ? 0 : mean_length_of_edges(m_mesh, neighbors, v);
      shares[v] = ((3 + m_parameters.coefficients_by_choice * choice) * shares[v]
                   + m_parameters.noise_share_by_faces * ramp(noise, limits[0] * length, limits[1] * length))
                * squared_noise(v);
    });
    return shares;
  }

private:
  typedef Neighborhood_search<Indexed_dual_graph> Search;

  double squared_noise(const std::size_t v) const { return m_noise.squared_ratio(v) * m_squared_noise; }

  // what a patch says of a face and of a vertex
  struct Face_term
  {
    Index face;
    Vector_3 weighted_normal;          // of the face
    Vector_3 weighted_centroid_normal; // of the patch
  };

  struct Vertex_term
  {
    Index vertex;
    double weight;
    double leverage; // how far the surface follows the observed point
    Vector_3 normal;
    double distance; // of the surface from the observed point, along the normal
  };

  struct Patch
  {
    std::vector<Face_term> faces;
    std::vector<Vertex_term> vertices;
  };

  // The share of the shape in the squared ways that vertices go to agree with normals that deviate. The noise in these ways is
  // that of second derivatives, which goes as the leverages of fits to the power of 3/2
  double share_of_shape(const std::vector<Vector_3>& deviations, const std::vector<double>& leverages) const
  {
    const double squares = sum<ConcurrencyTag>(m_mesh.number_of_vertices(), [&](const std::size_t v)
    {
      const auto faces = m_mesh.faces_around_vertex(v);
      if(faces.empty())
        return 0.;
      double way = 0;
      for(const Index f : faces)
        way += deviations[f] * (m_geometry.centroid(f) - m_mesh.point(v)) / double(faces.size());
      return way * way;
    });
    const double factor = m_parameters.deviation_by_noise;
    const double by_noise = factor * factor * m_squared_noise
                          * sum<ConcurrencyTag>(leverages.size(), [&](const std::size_t v)
                            { return m_noise.squared_ratio(v) * leverages[v] * leverages[v] * leverages[v]; });
    return (squares > by_noise) ? 1 - by_noise / squares : 0;
  }

  // the sum of weight (n n^T), of weight distance n, of the weights, of weight leverage, and of weight over how many points
  // the patch fits
  struct Vertex_sum
  {
    std::array<double, 6> m = {{ 0, 0, 0, 0, 0, 0 }};
    Vector_3 rhs = Vector_3(0, 0, 0);
    double weight = 0;
    double leverage = 0;
    double inverse_size = 0;

    void add(const Vertex_term& t, const std::size_t number_of_points)
    {
      const Vector_3& n = t.normal;
      const Vector_3 wn = t.weight * n;
      m[0] += wn.x() * n.x();
      m[1] += wn.x() * n.y();
      m[2] += wn.x() * n.z();
      m[3] += wn.y() * n.y();
      m[4] += wn.y() * n.z();
      m[5] += wn.z() * n.z();
      rhs += t.distance * wn;
      weight += t.weight;
      leverage += t.weight * t.leverage;
      inverse_size += t.weight / double(number_of_points);
    }
  };

  // at each vertex, by the weights of the patches; zero where there are none
  std::vector<double> means(double Vertex_sum::* const weighted_sum) const
  {
    std::vector<double> result(m_vertex_sums.size());
    for_each_index<ConcurrencyTag>(result.size(), [&](const std::size_t v)
    {
      const Vertex_sum& s = m_vertex_sums[v];
      result[v] = (s.weight > 0) ? s.*weighted_sum / s.weight : 0;
    });
    return result;
  }

  // Computes patches; one for each thread
  class Worker
  {
  public:
    Worker(const Patch_blend& blend, const Indexed_dual_graph& dual)
      : m_blend(blend), m_search(dual, blend.m_mesh.number_of_faces()),
        m_fit(blend.m_parameters, blend.m_pilot_error, blend.m_effort, blend.m_extent)
    {}

    void operator()(const Index seed, Patch& patch)
    {
      patch.faces.clear();
      patch.vertices.clear();
      const Vector_3& axis = m_blend.m_normals[seed];
      if(is_null(axis))
        return;
      const double ratio = m_blend.m_noise.ratio_of_face(m_blend.m_mesh, seed);
      m_squared_noise = ratio * ratio * m_blend.m_squared_noise;
      m_frame = Patch_frame(m_blend.m_geometry.centroid(seed), axis, m_blend.m_extent);
      const auto& faces = grow(seed);
      if(m_fit.best().number_of_faces != 0)
        list_terms(faces, patch);
    }

  private:
    // the faces of the patch come first
    const std::vector<typename Search::Neighbor>& grow(const Index seed)
    {
      const Adaptive_parameters& parameters = m_blend.m_parameters;
      const Indexed_triangle_mesh& mesh = m_blend.m_mesh;
      m_fit.clear(m_squared_noise);
      m_points.clear();
      m_numbering.clear();

      const bool is_adaptive = parameters.use_adaptive_neighborhoods;
      const std::size_t largest = is_adaptive ? parameters.patch_sizes.back() : parameters.fixed_patch_size;
      auto next_size = parameters.patch_sizes.begin();
      std::size_t size = 0, fitted_size = 0;
      const auto& faces = m_search(seed, (std::min)(largest, mesh.number_of_faces()),
                                   [&](const typename Search::Neighbor& neighbor)
      {
        const std::size_t rank = m_points.size(); // the vertices of one face come in no order
        for(const Index v : mesh.vertices(neighbor.face))
          if(m_numbering.insert(v).second)
          {
            const Point_3& p = m_blend.m_observed[v];
            const Patch_point q = { v, rank, m_frame.u(p), m_frame.v(p), m_frame.height(p) };
            m_points.push_back(q);
            m_fit.insert(q.u, q.v, q.height, m_frame.height(mesh.point(v)));
          }
        ++size;
        if(!is_adaptive || size < *next_size)
          return true;
        ++next_size;
        fitted_size = size;
        return m_fit.update(size);
      });
      if(fitted_size == 0) // a fixed size, or the faces ended before the least one
        m_fit.update(size);
      return faces;
    }

    void list_terms(const std::vector<typename Search::Neighbor>& faces, Patch& patch)
    {
      const Patch_surface& surface = m_fit.best();
      const double squared_edge_length = m_blend.m_mean_edge_length * m_blend.m_mean_edge_length;

      // Weights are those of the inverse squared error, and fall towards the rim. Where the surface leaves the fit by a
      // bias, the slopes do so by that over a length of about half the radius.
      const double slope_bias = 4 * surface.squared_bias
                              / (0.2 * double(surface.number_of_faces) * squared_edge_length)
                              + 2e-6 * m_squared_noise / squared_edge_length;
      const double slope_unit = m_squared_noise / (m_blend.m_extent * m_blend.m_extent);
      const double height_bias = surface.squared_bias + 1e-3 * m_squared_noise;
      const auto taper = [](const std::size_t k, const std::size_t n) { return 1.02 - double(k) / double(n); };

      const auto slope_at = [&](const double u, const double v)
      {
        const Vector_3 n = surface.normal(m_frame, u, v);
        return Slope{ n, std::sqrt(n.squared_length()), surface.variance_of_slopes(u, v) };
      };
      const bool is_plane = surface.is_plane();
      const Slope slope_of_plane = slope_at(0, 0);

      m_feet.clear();
      for(std::size_t k=0; k<surface.number_of_points; ++k)
      {
        const Patch_point& q = m_points[k];
        const Vector_3 n = is_plane ? slope_of_plane.normal : surface.normal(m_frame, q.u, q.v);
        const double cosine = 1 / std::sqrt(n.squared_length());
        const double leverage = surface.variance_of_height(q.u, q.v);
        const double weight = taper(q.rank, surface.number_of_points) / (m_squared_noise * leverage + height_bias);
        patch.vertices.push_back(Vertex_term{ q.vertex, weight, leverage, cosine * n,
                                              cosine * (surface.height(q.u, q.v) - q.height) });
        const Vertex_term& t = patch.vertices.back();
        m_feet.push_back(m_blend.m_observed[q.vertex] + t.distance * t.normal);
      }
      for(std::size_t k=0; k<surface.number_of_faces; ++k)
      {
        const Index f = faces[k].face;
        const Point_3& c = m_blend.m_geometry.centroid(f);
        const Slope slope = is_plane ? slope_of_plane : slope_at(m_frame.u(c), m_frame.v(c));
        const double weight = taper(k, surface.number_of_faces)
                            / ((slope_unit * slope.variance + slope_bias) * slope.length);
        patch.faces.push_back(Face_term{ f, weight * normal_of_face(f, slope), weight * slope.normal });
      }
    }

    // of the surface of a patch, at a point: the same everywhere on a plane
    struct Slope
    {
      Vector_3 normal;
      double length;
      double variance;
    };

    // The normal that a face has when its vertices are on the surface. Where that bends, it may differ much from the normal
    // of the surface at the centroid: for a sphere, it is that at the circumcenter. Over a coarse pilot patches follow what
    // is no shape, and faces take that of the surface, as they do on planes. The result is as long as that
    Vector_3 normal_of_face(const Index f, const Slope& slope)
    {
      if(!m_blend.m_pilot_error.is_fine || m_fit.best().is_plane())
        return slope.normal;
      std::array<Point_3, 3> feet;
      std::transform(m_blend.m_mesh.vertices(f).begin(), m_blend.m_mesh.vertices(f).end(), feet.begin(),
                     [&](const Index v) { return m_feet[m_numbering.insert(v).first]; });
      const Vector_3 area = cross_product(feet[1] - feet[0], feet[2] - feet[0]);
      return (area * slope.normal > 0) ? slope.length / std::sqrt(area.squared_length()) * area
                                       : slope.normal; // noise along the surface turns faces
    }

    struct Patch_point
    {
      Index vertex;
      std::size_t rank;
      double u, v, height;
    };

    const Patch_blend& m_blend;
    Search m_search;
    Patch_fit m_fit;
    double m_squared_noise = 0; // at the seed
    Patch_frame m_frame;
    Local_numbering<Index> m_numbering;
    std::vector<Patch_point> m_points;
    std::vector<Point_3> m_feet; // of the points on the best surface
  };

  // the key of a face: what the pilot moved its vertices, scrambled
  void compute_keys()
  {
    m_keys.resize(m_mesh.number_of_faces());
    for_each_index<ConcurrencyTag>(m_keys.size(), [&](const std::size_t f)
    {
      double length = 0;
      bool has_movable_vertex = false;
      for(const Index v : m_mesh.vertices(f))
      {
        length += std::sqrt(squared_distance(m_observed[v], m_mesh.point(v)));
        has_movable_vertex = has_movable_vertex || m_is_movable[v];
      }
      // what has no vertex to move needs no patches
      m_keys[f] = has_movable_vertex ? sine_key(length / m_mean_edge_length) : 2;
    });
  }

  // Faces outside the cores of all patches, with the least key of the faces like that in some rings around them: fewer rings
  // from round to round, so that large patches leave large distances between seeds. No order of the faces plays a part.
  void choose_seeds(const std::size_t round, std::vector<Index>& seeds) const
  {
    const std::size_t number_of_rings
      = (round + 1 < m_parameters.rings_around_first_seeds) ? m_parameters.rings_around_first_seeds - round : 1;
    const auto is_candidate = [&](const std::size_t f) { return m_keys[f] <= 1 && !m_is_in_core[f]; };
    std::vector<double> least_keys(m_keys.size()), wider_least_keys(m_keys.size());
    for_each_index<ConcurrencyTag>(least_keys.size(), [&](const std::size_t f)
    { least_keys[f] = is_candidate(f) ? m_keys[f] : 2; });
    for(std::size_t k=0; k<number_of_rings; ++k)
    {
      for_each_index<ConcurrencyTag>(least_keys.size(), [&](const std::size_t f)
      {
        double least = least_keys[f];
        for(const Index g : m_mesh.faces_around_face(f))
          least = (std::min)(least, least_keys[g]);
        wider_least_keys[f] = least;
      });
      least_keys.swap(wider_least_keys);
    }
    seeds.clear();
    for(std::size_t f=0; f<m_keys.size(); ++f)
      if(is_candidate(f) && m_keys[f] == least_keys[f])
        seeds.push_back(Index(f));
  }

  // Patches are computed in parallel, some at a time, and added up in the order of their seeds
  void add_patches(const Indexed_dual_graph& dual, Worker& worker, const std::vector<Index>& seeds)
  {
    const std::size_t number_at_a_time = std::is_convertible<ConcurrencyTag, Parallel_tag>::value ? 512 : 1;
    const std::size_t grain_size = 16;
    std::vector<Patch> patches(number_at_a_time);
    for(std::size_t first=0; first<seeds.size(); first+=number_at_a_time)
    {
      const std::size_t n = (std::min)(number_at_a_time, seeds.size() - first);
      if(n == 1)
        worker(seeds[first], patches[0]);
      else
        for_each_block<ConcurrencyTag>(n, [&](const std::size_t begin, const std::size_t end)
        {
          Worker own_worker(*this, dual);
          for(std::size_t i=begin; i<end; ++i)
            own_worker(seeds[first + i], patches[i]);
        }, grain_size);

      for(std::size_t i=0; i<n; ++i)
      {
        const std::vector<Face_term>& faces = patches[i].faces; // the nearest first
        for(const Face_term& t : faces)
        {
          m_normal_sums[t.face] += t.weighted_normal;
          m_centroid_normal_sums[t.face] += t.weighted_centroid_normal;
        }
        for(std::size_t k=0; double(k) < m_effort.core_share * double(faces.size()); ++k)
          m_is_in_core[faces[k].face] = true;
        for(const Vertex_term& t : patches[i].vertices)
          m_vertex_sums[t.vertex].add(t, patches[i].vertices.size());
      }
    }
    // a seed without a fit will not get one
    for(const Index f : seeds)
      if(!m_is_in_core[f])
        m_keys[f] = 2;
  }

  const Indexed_triangle_mesh& m_mesh;
  const std::vector<Point_3>& m_observed;
  const std::vector<bool>& m_is_movable;
  const Adaptive_parameters& m_parameters;
  Pilot_error m_pilot_error;
  Patch_effort m_effort;
  Face_geometry m_geometry;
  double m_mean_edge_length;
  double m_extent;
  const Noise_map& m_noise;
  double m_squared_noise; // where it is strong

  std::vector<Vector_3> m_normals;
  std::vector<double> m_keys;
  std::vector<bool> m_is_in_core; // of a patch
  std::vector<Vector_3> m_normal_sums, m_centroid_normal_sums;
  std::vector<Vertex_sum> m_vertex_sums;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_PATCH_BLEND_H
