// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_MESH_COMPARISON_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_MESH_COMPARISON_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Denoising_error.h>
#include <CGAL/Surface_mesh_denoising/internal/Mesh_io.h>
#include <CGAL/Surface_mesh_denoising/internal/Random_numbers.h>
#include <CGAL/Surface_mesh_denoising/internal/Surface_distance_query.h>
#include <CGAL/Surface_mesh_denoising/internal/check_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// a mesh to measure, in coordinates that are normalized by its own bounding box, or by that of another mesh
template <typename ConcurrencyTag>
class Measured_mesh
{
  template <typename MeshIo>
  explicit Measured_mesh(MeshIo io)
    : m_normalization(io.normalization()), m_mesh(io.take_mesh())
  { compute_face_normals<ConcurrencyTag>(m_mesh, m_normals, m_areas); }

public:
  template <typename TriangleMesh, typename NamedParameters>
  Measured_mesh(const TriangleMesh& tmesh, const NamedParameters& np)
    : Measured_mesh(read_mesh(vertices(tmesh), tmesh,
                              parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                           get_const_property_map(CGAL::vertex_point, tmesh)), np))
  {}

  // changes to the coordinates of another normalization. The normals stay, and so does what is degenerate
  void normalize_by(const Normalization& normalization)
  {
    std::vector<Point_3> points(m_mesh.points());
    for(Point_3& p : points)
      p = normalization.inside(m_normalization.outside(p));
    m_mesh.swap_points(points);
    m_normalization = normalization;
    for(std::size_t f=0; f<m_areas.size(); ++f)
      m_areas[f] = is_degenerate(f) ? 0 : m_mesh.area(f);
  }

  const Indexed_triangle_mesh& mesh() const { return m_mesh; }
  const Normalization& normalization() const { return m_normalization; }
  const std::vector<double>& areas() const { return m_areas; }
  bool is_degenerate(const std::size_t f) const { return m_areas[f] == 0; }

  std::size_t number_of_degenerate_faces() const
  {
    return static_cast<std::size_t>(std::count(m_areas.begin(), m_areas.end(), 0.));
  }

  // the enclosed volume, each border being closed by triangles from its edges to its centroid
  double volume() const
  {
    const double volume_of_cones = sum<ConcurrencyTag>(m_mesh.number_of_faces(), [this](const std::size_t f)
    {
      return m_mesh.area_vector(f) * (m_mesh.point(m_mesh.vertices(f)[0]) - ORIGIN) / 6;
    });
    return volume_of_cones + volume_of_cones_over_borders();
  }

  // a query for the distance to this mesh: built at the first call only
  const Surface_distance_query& distance_query(const bool hints_are_near)
  {
    if(!m_query)
      m_query = std::make_unique<Surface_distance_query>(m_mesh, m_areas, hints_are_near);
    return *m_query;
  }

  // points on the faces, one in each of `n` stretches of equal area, and the faces that they are on
  std::vector<std::pair<Point_3, Index> > sample(const std::size_t n, const std::uint64_t seed) const
  {
    double area = 0;
    std::size_t last = 0;
    for(std::size_t f=0; f<m_areas.size(); ++f)
      if(m_areas[f] > 0)
      {
        area += m_areas[f];
        last = f;
      }

    std::vector<std::pair<Point_3, Index> > samples;
    samples.reserve(n);
    Random_numbers random(seed);
    std::size_t f = 0;
    double area_up_to_f = m_areas[0];
    for(std::size_t i=0; i<n; ++i)
    {
      const double position = (double(i) + random.uniform()) * (area / double(n));
      while(f < last && (area_up_to_f <= position || is_degenerate(f)))
        area_up_to_f += m_areas[++f];

      const double r = random.uniform(), s = random.uniform();
      const double u = (r + s <= 1) ? r : 1 - r, v = (r + s <= 1) ? s : 1 - s;
      const std::array<Index, 3>& t = m_mesh.vertices(f);
      const Point_3& p = m_mesh.point(t[0]);
      samples.emplace_back(p + u * (m_mesh.point(t[1]) - p) + v * (m_mesh.point(t[2]) - p), Index(f));
    }
    return samples;
  }

  // degrees
  friend double angle_between_normals(const Measured_mesh& a, const Measured_mesh& b, const std::size_t f)
  {
    // unlike the arc cosine, this is accurate near 0 and 180 degrees
    const Vector_3& m = a.m_normals[f];
    const Vector_3& n = b.m_normals[f];
    return std::atan2(std::sqrt(cross_product(m, n).squared_length()), m * n) * (180 / CGAL_PI);
  }

private:
  double volume_of_cones_over_borders() const
  {
    std::multimap<Index, Index> border_edges;
    for(std::size_t f=0; f<m_mesh.number_of_faces(); ++f)
      for(int i=0; i<3; ++i)
        if(m_mesh.neighbors(f)[i] == Indexed_triangle_mesh::null_index())
          border_edges.emplace(m_mesh.vertices(f)[i], m_mesh.vertices(f)[(i+1)%3]);

    double volume = 0;
    std::vector<Vector_3> border;
    while(!border_edges.empty())
    {
      border.clear();
      Vector_3 centroid(0, 0, 0);
      const Index first = border_edges.begin()->first;
      Index v = first;
      do
      {
        border.push_back(m_mesh.point(v) - ORIGIN);
        centroid += border.back();
        const auto edge = border_edges.find(v);
        v = edge->second;
        border_edges.erase(edge);
      }
      while(v != first);
      centroid /= double(border.size());

      for(std::size_t i=0; i<border.size(); ++i)
        volume += cross_product(border[(i+1) % border.size()], border[i]) * centroid / 6;
    }
    return volume;
  }

  Normalization m_normalization;
  Indexed_triangle_mesh m_mesh;
  std::vector<Vector_3> m_normals;
  std::vector<double> m_areas;
  std::unique_ptr<Surface_distance_query> m_query;
};

// the named parameters of symmetric_distance()
struct Sampling_parameters
{
  template <typename NamedParameters1, typename NamedParameters2>
  Sampling_parameters(const NamedParameters1& np1, const NamedParameters2& np2)
    : numbers_of_points{{ number_of_points(np1), number_of_points(np2) }},
      seed(parameters::choose_parameter(parameters::get_parameter(np1, internal_np::random_seed), 0u)),
      number_of_bins(checked_count("number_of_bins",
        parameters::choose_parameter(parameters::get_parameter(np1, internal_np::number_of_bins), 50), 1)),
      bin_width(checked_positive("bin_width",
        parameters::choose_parameter(parameters::get_parameter(np1, internal_np::bin_width), 0.02)))
  {}

  // 0 stands for the default
  template <typename NamedParameters>
  static std::size_t number_of_points(const NamedParameters& np)
  {
    if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::number_of_points_on_faces_t>::value)
      return 0;
    else
      return checked_count("number_of_points_on_faces",
                           parameters::get_parameter(np, internal_np::number_of_points_on_faces), 1);
  }

  std::array<std::size_t, 2> numbers_of_points;
  std::uint64_t seed;
  std::size_t number_of_bins;
  double bin_width;
};

// two meshes in the same coordinates, and what several measures need of them
template <typename ConcurrencyTag>
class Mesh_comparison
{
public:
  template <typename TriangleMesh1, typename TriangleMesh2, typename NamedParameters1, typename NamedParameters2>
  Mesh_comparison(const TriangleMesh1& denoised, const TriangleMesh2& ground_truth,
                  const NamedParameters1& np1, const NamedParameters2& np2)
    : m_ground_truth(ground_truth, np2), m_denoised(denoised, np1),
      m_have_same_sizes(m_denoised.mesh().number_of_faces() == m_ground_truth.mesh().number_of_faces()
                        && m_denoised.mesh().number_of_vertices() == m_ground_truth.mesh().number_of_vertices()),
      m_mean_edge_length(m_ground_truth.mesh().template mean_edge_length<ConcurrencyTag>())
  {
    m_denoised.normalize_by(m_ground_truth.normalization());
  }

  std::size_t number_of_degenerate_faces() const { return m_denoised.number_of_degenerate_faces(); }

  double relative_volume_change() const
  {
    const double volume = m_ground_truth.volume();
    return (m_denoised.volume() - volume) / std::abs(volume);
  }

  Angular_error angular_error() const
  {
    const std::size_t n = m_denoised.mesh().number_of_faces();
    if(n != m_ground_truth.mesh().number_of_faces())
      throw std::invalid_argument("Surface_mesh_denoising: corresponding faces are compared, but one mesh has "
                                  + std::to_string(n) + " faces, and the other one has "
                                  + std::to_string(m_ground_truth.mesh().number_of_faces()));

    std::vector<double> angles(n);
    for_each_index<ConcurrencyTag>(n, [&](const std::size_t f)
    {
      angles[f] = is_known(f) ? angle_between_normals(m_denoised, m_ground_truth, f) : 0;
    });

    Angular_error error;
    double area = 0;
    for(std::size_t f=0; f<n; ++f)
    {
      if(!is_known(f))
      {
        ++error.number_of_unknown_faces;
        continue;
      }
      const double a = angles[f], w = m_denoised.areas()[f];
      area += w;
      error.mean += a;
      error.mean_square += square(a);
      error.area_weighted_mean += w * a;
      error.area_weighted_mean_square += w * square(a);
      error.maximum = (std::max)(error.maximum, a);
      if(a > 90)
        ++error.number_of_flipped_faces;
    }
    const double number_of_known_faces = double(n - error.number_of_unknown_faces);
    error.mean /= number_of_known_faces;
    error.mean_square /= number_of_known_faces;
    error.area_weighted_mean /= area;
    error.area_weighted_mean_square /= area;
    if(number_of_known_faces == 0)
      error.maximum = std::numeric_limits<double>::quiet_NaN();
    return error;
  }

  Vertex_distance_error vertex_distance_error()
  {
    const std::vector<double>& distances = vertex_distances();
    const Indexed_triangle_mesh& mesh = m_denoised.mesh();

    Vertex_distance_error error;
    std::size_t number_of_vertices = 0;
    double area = 0;
    for(std::size_t v=0; v<distances.size(); ++v)
    {
      if(mesh.faces_around_vertex(v).empty())
        continue;
      ++number_of_vertices;
      double area_of_v = 0;
      for(const Index f : mesh.faces_around_vertex(v))
        area_of_v += m_denoised.areas()[f];
      area += area_of_v;

      const double d = distances[v];
      error.mean += d;
      error.root_mean_square += square(d);
      error.area_weighted_l2 += area_of_v * square(d);
      error.maximum = (std::max)(error.maximum, d);
    }
    error.mean = length(error.mean / double(number_of_vertices));
    error.root_mean_square = length(std::sqrt(error.root_mean_square / double(number_of_vertices)));
    error.area_weighted_l2 = length(std::sqrt(error.area_weighted_l2 / area));
    error.maximum = length(error.maximum);
    error.mean_edge_length = length(m_mean_edge_length);
    return error;
  }

  Symmetric_distance symmetric_distance(const Sampling_parameters& sampling)
  {
    Symmetric_distance result;
    result.histogram.assign(sampling.number_of_bins, 0);

    std::size_t number_of_samples = 0;
    const auto add_samples = [&](Measured_mesh<ConcurrencyTag>& from, Measured_mesh<ConcurrencyTag>& to,
                                 const std::size_t number_of_points)
    {
      const Surface_distance_query& query = to.distance_query(m_have_same_sizes);
      const std::size_t n = (number_of_points == 0) ? 4 * from.mesh().number_of_faces() : number_of_points;
      const std::vector<std::pair<Point_3, Index> > samples = from.sample(n, sampling.seed);
      const std::vector<double> distances = measure(n, [&](const std::size_t i)
      {
        return query.distance(samples[i].first, samples[i].second);
      });
      for(const double d : distances)
      {
        result.mean += d;
        result.root_mean_square += square(d);
        result.maximum = (std::max)(result.maximum, d);
        // a distance in bins may be beyond the range of an integer
        const double bin = (std::min)(d / (sampling.bin_width * m_mean_edge_length),
                                      double(sampling.number_of_bins - 1));
        ++result.histogram[static_cast<std::size_t>(bin)];
      }
      number_of_samples += n;
    };
    // the distance queries find out whether the meshes have an area
    add_samples(m_denoised, m_ground_truth, sampling.numbers_of_points[0]);
    add_samples(m_ground_truth, m_denoised, sampling.numbers_of_points[1]);

    for(const double d : vertex_distances())
      result.maximum = (std::max)(result.maximum, d);
    for(const double d : distances_of_vertices(m_ground_truth, m_denoised))
      result.maximum = (std::max)(result.maximum, d);

    for(double& share : result.histogram)
      share /= double(number_of_samples);
    result.mean = length(result.mean / double(number_of_samples));
    result.root_mean_square = length(std::sqrt(result.root_mean_square / double(number_of_samples)));
    result.maximum = length(result.maximum);
    result.mean_edge_length = length(m_mean_edge_length);
    result.bin_width = sampling.bin_width * result.mean_edge_length;
    return result;
  }

private:
  bool is_known(const std::size_t f) const { return !m_denoised.is_degenerate(f) && !m_ground_truth.is_degenerate(f); }

  double length(const double normalized) const { return m_ground_truth.normalization().length_outside(normalized); }

  template <typename Distance>
  static std::vector<double> measure(const std::size_t n, const Distance& distance)
  {
    std::vector<double> distances(n);
    for_each_index<ConcurrencyTag>(n, [&](const std::size_t i) { distances[i] = distance(i); });
    return distances;
  }

  // zero for a vertex without a face
  std::vector<double> distances_of_vertices(const Measured_mesh<ConcurrencyTag>& from,
                                            Measured_mesh<ConcurrencyTag>& to) const
  {
    const Surface_distance_query& query = to.distance_query(m_have_same_sizes);
    return measure(from.mesh().number_of_vertices(), [&](const std::size_t v)
    {
      const Indexed_triangle_mesh::Index_range incident = from.mesh().faces_around_vertex(v);
      return incident.empty() ? 0. : query.distance(from.mesh().point(v), *incident.begin());
    });
  }

  const std::vector<double>& vertex_distances()
  {
    if(m_vertex_distances.empty())
      m_vertex_distances = distances_of_vertices(m_denoised, m_ground_truth);
    return m_vertex_distances;
  }

  Measured_mesh<ConcurrencyTag> m_ground_truth, m_denoised;
  bool m_have_same_sizes;
  double m_mean_edge_length;
  std::vector<double> m_vertex_distances;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_MESH_COMPARISON_H
