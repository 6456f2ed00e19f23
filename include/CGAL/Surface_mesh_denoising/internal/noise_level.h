// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_NOISE_LEVEL_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_NOISE_LEVEL_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/mixing.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>
#include <CGAL/Surface_mesh_denoising/internal/surface_fit.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// The height of the first of `points` above the polynomial that fits the others best, as seen along `axis` and over the places
// of `feet`, divided by the root of its variance in units of that of the points: so noise of the standard deviation s gives a
// residual of the standard deviation s. Not a number where the points determine no such polynomial. It has so many terms: six are
// a quadric, ten a cubic.
template <int number_of_terms>
double leave_one_out_residual(const std::vector<Indexed_triangle_mesh::Point_3>& points,
                                     const std::vector<Indexed_triangle_mesh::Point_3>& feet,
                                     const Indexed_triangle_mesh::Vector_3& axis)
{
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;
  typedef Eigen::Matrix<double, number_of_terms, number_of_terms> Matrix;
  typedef Eigen::Matrix<double, number_of_terms, 1> Vector;

  const double unknown = std::numeric_limits<double>::quiet_NaN();
  double radius = 0;
  for(const Indexed_triangle_mesh::Point_3& p : feet)
    radius = (std::max)(radius, squared_distance(p, feet[0]));
  radius = std::sqrt(radius);
  if(!(radius > 0) || is_null(axis))
    return unknown;

  const std::array<Vector_3, 2> tangents = tangent_frame(axis);
  Matrix matrix = Matrix::Zero();
  Vector rhs = Vector::Zero();
  for(std::size_t i=1; i<points.size(); ++i)
  {
    const Vector_3 d = (feet[i] - feet[0]) / radius;
    const double u = d * tangents[0], v = d * tangents[1];
    const Vector m = monomials<number_of_terms>(v, u).reverse(); // the constant is the last
    matrix.noalias() += m * m.transpose();
    rhs += ((points[i] - points[0]) * axis / radius) * m;
  }
  const Eigen::LLT<Matrix> llt(matrix);
  if(llt.info() != Eigen::Success
     || !(llt.matrixLLT().diagonal().array().square() > 1e-8 * matrix.diagonal().array()).all())
    return unknown;
  constexpr int constant = number_of_terms - 1;
  const Vector weights = llt.solve(Vector::Unit(constant)); // the height of the fit at the first point: weights . rhs
  return -radius * weights.dot(rhs) / std::sqrt(1 + weights[constant]);
}

// the median of the absolute values of a normal distribution, in standard deviations
const double median_of_normal_distribution = 0.6745;

// of those that count and are known; zero if none is
inline double quantile_of_absolutes(const std::vector<double>& values, const std::vector<bool>& counts, const double share)
{
  std::vector<double> absolutes;
  for(std::size_t i=0; i<values.size(); ++i)
    if(counts[i] && std::isfinite(values[i]))
      absolutes.push_back(std::abs(values[i]));
  if(absolutes.empty())
    return 0;
  const auto it = absolutes.begin() + std::size_t(share * double(absolutes.size()));
  std::nth_element(absolutes.begin(), it, absolutes.end());
  return *it;
}

inline double median_of_absolutes(const std::vector<double>& values, const std::vector<bool>& counts)
{
  return quantile_of_absolutes(values, counts, 0.5);
}

// of those that are known; zero if none is
inline double mean_of_neighbors(const Vertex_neighbors& neighbors, const std::vector<double>& values, const std::size_t v)
{
  double sum = 0;
  std::size_t number = 0;
  for(const Indexed_triangle_mesh::Index w : neighbors(v))
    if(std::isfinite(values[w]))
    {
      sum += values[w];
      ++number;
    }
  return (number > 0) ? sum / double(number) : 0;
}

// replaces each residual by what it differs from the mean of the neighbors' residuals
template <typename ConcurrencyTag>
void subtract_mean_of_neighbors(const Vertex_neighbors& neighbors, std::vector<double>& residuals)
{
  std::vector<double> differences(residuals.size());
  for_each_index<ConcurrencyTag>(residuals.size(), [&](const std::size_t v)
  { differences[v] = residuals[v] - mean_of_neighbors(neighbors, residuals, v); });
  residuals.swap(differences);
}

// Where residuals are small, in the mean of the absolute values around a vertex: in a third of the mesh
struct Quiet_places
{
  std::vector<bool> are_there; // for each vertex
  // How large residuals are where they are smallest, beside the largest here: noise is nearly as strong everywhere, detail of
  // the shape is not.
  double uniformity;
};

// Large residuals, as at edges, are cut
template <typename ConcurrencyTag>
Quiet_places quiet_places(const Vertex_neighbors& neighbors, const std::vector<double>& residuals,
                          const std::vector<bool>& counts)
{
  const std::size_t number_of_averages = 8; // over windows of about fifty vertices
  const double most = 1.5 * median_of_absolutes(residuals, counts);
  std::vector<Mixing_moments<1> > moments(residuals.size());
  const auto is_known = [&](const std::size_t v) { return counts[v] && std::isfinite(residuals[v]); };
  for_each_index<ConcurrencyTag>(residuals.size(), [&](const std::size_t v)
  {
    moments[v].products[0] = is_known(v) ? float((std::min)(std::abs(residuals[v]), most) / most) : 0;
    moments[v].squares[0] = is_known(v);
  });
  average_over_neighbors<ConcurrencyTag>(neighbors, number_of_averages, moments);

  const auto mean = [&](const std::size_t v) { return moments[v].products[0] / moments[v].squares[0]; };
  Quiet_places places = { std::vector<bool>(residuals.size(), false), 1 };
  std::vector<float> means;
  for(std::size_t v=0; v<moments.size(); ++v)
    if(is_known(v))
      means.push_back(mean(v));
  if(means.empty())
    return places;
  const auto quantile = [&](const double share)
  {
    const auto it = means.begin() + std::size_t(share * double(means.size()));
    std::nth_element(means.begin(), it, means.end());
    return *it;
  };
  const float usual = quantile(0.35);
  for(std::size_t v=0; v<moments.size(); ++v)
    places.are_there[v] = is_known(v) && mean(v) <= usual;
  places.uniformity = quantile(0.02) / usual;
  return places;
}

// The correlation of the residuals of neighbors, at the vertices that are `chosen`, where they are known. Large residuals are cut
template <typename ConcurrencyTag>
double correlation_of_neighbors(const Vertex_neighbors& neighbors, std::vector<double> residuals,
                                const std::vector<bool>& chosen)
{
  const double most = 3 * median_of_absolutes(residuals, chosen);
  for(double& r : residuals)
    if(std::isfinite(r))
      r = (std::max)(-most, (std::min)(most, r));
  const double products = sum<ConcurrencyTag>(residuals.size(), [&](const std::size_t v)
  { return chosen[v] ? residuals[v] * mean_of_neighbors(neighbors, residuals, v) : 0.; });
  const double squares = sum<ConcurrencyTag>(residuals.size(), [&](const std::size_t v)
  { return chosen[v] ? residuals[v] * residuals[v] : 0.; });
  return (squares > 0) ? products / squares : 0;
}

// The share of the vertices whose residual is large beside the `usual` one and much larger than those of all their neighbors:
// edges and detail are never of one vertex
template <typename ConcurrencyTag>
double share_of_impulses(const Vertex_neighbors& neighbors, const std::vector<double>& residuals,
                         const std::vector<bool>& counts, const double usual)
{
  const double least = 4 * usual, largest_neighbor = 0.35;
  const double number = sum<ConcurrencyTag>(residuals.size(), [&](const std::size_t v)
  {
    const double r = std::abs(residuals[v]);
    return double(counts[v] && r > least
                  && std::all_of(neighbors(v).begin(), neighbors(v).end(), [&](const Indexed_triangle_mesh::Index w)
                                 { return std::abs(residuals[w]) < largest_neighbor * r; }));
  });
  const double whole = sum<ConcurrencyTag>(residuals.size(), [&](const std::size_t v)
  { return double(counts[v] && std::isfinite(residuals[v])); });
  return (whole > 0) ? number / whole : 0;
}

template <typename ConcurrencyTag>
double share_of_impulses(const Vertex_neighbors& neighbors, const std::vector<double>& residuals,
                         const std::vector<bool>& counts)
{
  return share_of_impulses<ConcurrencyTag>(neighbors, residuals, counts, median_of_absolutes(residuals, counts));
}

// How far large residuals lie together: the correlation of the sizes of neighbors, less what chance explains where there is
// little to go by. Those of noise have nothing to do with their neighbors. Beyond `limit` it does not count how large they are
template <typename ConcurrencyTag>
double correlation_of_sizes(const Vertex_neighbors& neighbors, const std::vector<double>& residuals,
                            const std::vector<bool>& counts, const double limit)
{
  const auto size = [&](const std::size_t v) { return (std::min)(std::abs(residuals[v]), limit); };
  const double number = double(std::count(counts.begin(), counts.end(), true));
  const double mean = sum<ConcurrencyTag>(residuals.size(), [&](const std::size_t v)
  { return counts[v] ? size(v) : 0.; }) / number;
  std::vector<double> sizes(residuals.size(), std::numeric_limits<double>::quiet_NaN());
  for_each_index<ConcurrencyTag>(residuals.size(), [&](const std::size_t v)
  {
    if(counts[v])
      sizes[v] = size(v) - mean;
  });
  return correlation_of_neighbors<ConcurrencyTag>(neighbors, std::move(sizes), counts) - 2 / std::sqrt(number);
}

// the same with large residuals cut as usual
template <typename ConcurrencyTag>
double correlation_of_sizes(const Vertex_neighbors& neighbors, const std::vector<double>& residuals,
                            const std::vector<bool>& counts)
{
  return correlation_of_sizes<ConcurrencyTag>(neighbors, residuals, counts, 4 * median_of_absolutes(residuals, counts));
}

// Whether the shape makes the large residuals: then they lie together, and hardly any stands alone
template <typename ConcurrencyTag>
bool are_of_shape(const Vertex_neighbors& neighbors, const std::vector<double>& residuals, const std::vector<bool>& counts,
                  const double limit)
{
  const double largest_correlation = 0.04, largest_share_of_impulses = 0.01;

  return correlation_of_sizes<ConcurrencyTag>(neighbors, residuals, counts, limit) > largest_correlation
      && share_of_impulses<ConcurrencyTag>(neighbors, residuals, counts) < largest_share_of_impulses;
}

// Whether the shape makes most of the residuals: then even the others are no noise, which is nearly as strong everywhere
template <typename ConcurrencyTag>
bool are_mostly_of_shape(const Vertex_neighbors& neighbors, const std::vector<double>& residuals,
                         const std::vector<bool>& counts, const Quiet_places& quiet, const double least_uniformity = 0.8)
{
  const double largest_correlation = 0.14;

  return correlation_of_sizes<ConcurrencyTag>(neighbors, residuals, counts) > largest_correlation
      && quiet.uniformity < least_uniformity;
}

// Detail of the shape, in a mesh without noise, makes residuals that are not uniform, and no impulses. Either they are small, or
// neighbors have them in common even in quiet places, where white noise gives them opposite signs. `level` is the estimate,
// in mean edge lengths
template <typename ConcurrencyTag>
bool is_shape(const Vertex_neighbors& neighbors, std::vector<double> residuals, const std::vector<bool>& counts,
              const double level)
{
  const double largest_level = 0.2, largest_share_of_impulses = 0.005;
  const double small_level = 0.045, least_uniformity_of_small = 0.68;
  // what white noise gives: the correlations are those of the residuals and of what they differ from the neighbors' means
  const double uniformity_of_noise = 0.85, correlation_of_noise = -0.195, correlation_of_differences = -0.28;

  if(level > largest_level
     || share_of_impulses<ConcurrencyTag>(neighbors, residuals, counts) > largest_share_of_impulses)
    return false;
  const Quiet_places quiet = quiet_places<ConcurrencyTag>(neighbors, residuals, counts);
  if(level < small_level && quiet.uniformity < least_uniformity_of_small)
    return true;

  double evidence = uniformity_of_noise - quiet.uniformity
                  + correlation_of_neighbors<ConcurrencyTag>(neighbors, residuals, quiet.are_there)
                  - correlation_of_noise;
  subtract_mean_of_neighbors<ConcurrencyTag>(neighbors, residuals);
  evidence += 2 * (correlation_of_neighbors<ConcurrencyTag>(neighbors, residuals, quiet.are_there)
                   - correlation_of_differences);
  const double number = double(std::count(quiet.are_there.begin(), quiet.are_there.end(), true));
  const double least_evidence = 0.4 + 10 * (std::max)(0., level - 0.15); // hardly any shape makes so large residuals
  return evidence > least_evidence + 2 / std::sqrt(number); // the less there is to go by, the more chance explains
}

// For each vertex how far it stands out of the polynomial that is fitted to the two rings around it, without the vertex itself,
// where that is known. `mesh` holds the feet, `observed` the points
template <int number_of_terms, typename ConcurrencyTag>
std::vector<double> leave_one_out_residuals(const Indexed_triangle_mesh& mesh,
                                            const std::vector<Indexed_triangle_mesh::Point_3>& observed,
                                            const Vertex_neighbors& neighbors)
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  const std::size_t least_number_of_points = number_of_terms + 3, most_number_of_points = 64;

  std::vector<Vector_3> vertex_normals;
  compute_vertex_normals<ConcurrencyTag>(mesh, vertex_normals);

  std::vector<double> residuals(mesh.number_of_vertices(), std::numeric_limits<double>::quiet_NaN());
  for_each_block<ConcurrencyTag>(residuals.size(), [&](const std::size_t first, const std::size_t last)
  {
    std::vector<Index> ring;
    std::vector<Point_3> points, feet;
    for(std::size_t v=first; v<last; ++v)
    {
      if(neighbors.is_at_border(v))
        continue;
      ring.assign(1, Index(v));
      std::size_t end = 1;
      for(std::size_t k=0; k<end && ring.size()<=most_number_of_points; ++k)
      {
        for(const Index w : neighbors(ring[k]))
        {
          if(std::find(ring.begin(), ring.end(), w) == ring.end())
            ring.push_back(w);
          if(ring.size() > most_number_of_points)
            break;
        }
        if(k == 0)
          end = ring.size();
      }
      if(ring.size() < least_number_of_points || ring.size() > most_number_of_points)
        continue;
      points.clear();
      feet.clear();
      Vector_3 axis(0, 0, 0);
      for(const Index w : ring)
      {
        points.push_back(observed[w]);
        feet.push_back(mesh.point(w));
        axis += vertex_normals[w];
      }
      residuals[v] = leave_one_out_residual<number_of_terms>(points, feet, normalized_or_null(axis));
    }
  });
  return residuals;
}

// The standard deviation of the noise that left these residuals. What a vertex stands out is noise, and shape that is no
// quadric. Shape is smoother than noise: taking the mean of the neighbors' residuals away, again and again, leaves less of
// it, so the least of the estimates is the best. Medians keep edges out.
template <typename ConcurrencyTag>
double noise_level_of_residuals(const Vertex_neighbors& neighbors, const std::vector<bool>& counts,
                                std::vector<double> residuals)
{
  // The medians that white noise of the standard deviation one gives: the first is that of a normal distribution, the
  // others vary by some percent with the triangulation.
  const std::array<double, 3> medians_of_white_noise = {{ median_of_normal_distribution, 0.838, 1.09 }};

  double level = std::numeric_limits<double>::infinity();
  for(std::size_t i=0; ; ++i)
  {
    level = (std::min)(level, median_of_absolutes(residuals, counts) / medians_of_white_noise[i]);
    if(i + 1 == medians_of_white_noise.size())
      return level;
    subtract_mean_of_neighbors<ConcurrencyTag>(neighbors, residuals);
  }
}

// How far the four vertices of two triangles with a common edge are from one plane, divided as a residual is: so noise of the
// standard deviation s gives the standard deviation s. One for each such edge with four vertices that count
template <typename ConcurrencyTag>
std::vector<double> residuals_of_edges(const Indexed_triangle_mesh& mesh, const std::vector<bool>& counts)
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  std::vector<Vector_3> normals;
  compute_vertex_normals<ConcurrencyTag>(mesh, normals);

  std::vector<double> residuals;
  for(std::size_t f=0; f<mesh.number_of_faces(); ++f)
    for(const Index g : mesh.neighbors(f))
    {
      if(g == Indexed_triangle_mesh::null_index() || g < f)
        continue;
      const std::array<Index, 3>& face = mesh.vertices(f);
      const auto it = std::find_if(mesh.vertices(g).begin(), mesh.vertices(g).end(), [&](const Index v)
                                   { return std::find(face.begin(), face.end(), v) == face.end(); });
      if(it == mesh.vertices(g).end() || !counts[*it]
         || !std::all_of(face.begin(), face.end(), [&](const Index v) { return counts[v]; }))
        continue;
      // the volume of their tetrahedron, over the areas of its sides as seen along the normal: it is linear in the heights of
      // the vertices, and these areas are its derivatives
      const Point_3& p = mesh.point(face[0]);
      const Vector_3 a = mesh.point(face[1]) - p, b = mesh.point(face[2]) - p, c = mesh.point(*it) - p;
      const Vector_3 normal = normalized_or_null(normals[face[0]] + normals[face[1]] + normals[face[2]] + normals[*it]);
      const Vector_3 area = mesh.area_vector(f);
      const double ab = area * normal, bc = cross_product(b, c) * normal, ca = cross_product(c, a) * normal;
      const double squares = ab * ab + bc * bc + ca * ca + (ab + bc + ca) * (ab + bc + ca);
      if(squares > 0)
        residuals.push_back(area * c / std::sqrt(squares));
    }
  return residuals;
}

struct Level_by_edges
{
  double level;
  bool is_uniform; // as edges show: then what quadrics leave more of in some places is shape
};

// The `level` that the `residuals` of quadrics tell, unless edges of triangles show that it is much too high. On parts with few
// triangles quadrics of two rings cross the edges of the shape nearly everywhere; most edges of triangles do not bend with the
// shape, or hardly
template <typename ConcurrencyTag>
Level_by_edges level_by_edges(const Indexed_triangle_mesh& mesh, const double mean_edge_length,
                              const Vertex_neighbors& neighbors, const std::vector<bool>& counts,
                              const std::vector<double>& residuals, const double level)
{
  const std::size_t least_number = 50;
  const std::array<double, 2> quartiles_of_normal_distribution = {{ 0.3186, 1.1503 }}; // of absolute values, see the median
  // with stronger noise triangles are turned, and the less do they tell
  const double largest_level = 0.15, least_ratio = 2;
  const double factor = 1.4; // they tell too little where heights are small beside the noise
  const double least_evenness = 0.6, least_part_of_level = 0.05, largest_share_of_impulses = 0.005;

  const std::vector<double> edges = residuals_of_edges<ConcurrencyTag>(mesh, counts);
  if(edges.size() < least_number)
    return { level, false };
  const std::vector<bool> all(edges.size(), true);
  const double median = median_of_absolutes(edges, all);
  const double edge_level = median / median_of_normal_distribution;
  if(!(edge_level < largest_level * mean_edge_length && least_ratio * edge_level < level))
    return { level, false };
  const double lower_level = quantile_of_absolutes(edges, all, 0.25) / quartiles_of_normal_distribution[0];
  const double upper_level = quantile_of_absolutes(edges, all, 0.75) / quartiles_of_normal_distribution[1];
  const bool is_uniform = lower_level > least_evenness * edge_level && edge_level > least_evenness * upper_level;
  // impulses spare most edges
  const double usual = (std::max)(median, least_part_of_level * median_of_normal_distribution * level);
  if(!is_uniform && share_of_impulses<ConcurrencyTag>(neighbors, residuals, counts, usual) > largest_share_of_impulses)
    return { level, false };
  return { factor * edge_level, is_uniform };
}

// The level of white noise among what quadrics take for shape, or zero where there seems to be none. Cubics of two rings leave
// hardly anything of a smooth shape: then noise shows, as strong everywhere and as white as nothing else is. `mesh` holds the
// feet, `observed` the points
template <typename ConcurrencyTag>
double level_of_white_noise(const Indexed_triangle_mesh& mesh,
                            const std::vector<Indexed_triangle_mesh::Point_3>& observed, const double mean_edge_length,
                            const Vertex_neighbors& neighbors, const std::vector<bool>& counts)
{
  // weaker, vertices of meshes without noise seem to be noisy as well; stronger, coarse triangles
  const double least_level = 0.0125, largest_level = 0.13;
  const double least_uniformity = 0.72, least_number = 100; // of quiet places: fewer tell nothing
  // in quiet places: of differences, and of differences of these, as white noise gives -0.3 and -0.32
  const double largest_correlation = -0.25, largest_second_correlation = -0.3;

  std::vector<double> residuals = leave_one_out_residuals<10, ConcurrencyTag>(mesh, observed, neighbors);
  const double level = noise_level_of_residuals<ConcurrencyTag>(neighbors, counts, residuals);
  if(!(level > least_level * mean_edge_length && level < largest_level * mean_edge_length))
    return 0;
  const Quiet_places quiet = quiet_places<ConcurrencyTag>(neighbors, residuals, counts);
  const double number = double(std::count(quiet.are_there.begin(), quiet.are_there.end(), true));
  if(!(number >= least_number && quiet.uniformity > least_uniformity))
    return 0;
  const auto correlation_of_differences = [&]()
  {
    subtract_mean_of_neighbors<ConcurrencyTag>(neighbors, residuals);
    return correlation_of_neighbors<ConcurrencyTag>(neighbors, residuals, quiet.are_there);
  };
  return (correlation_of_differences() < largest_correlation - 0.3 / std::sqrt(number) // less what chance explains
          && correlation_of_differences() < largest_second_correlation) ? level : 0;
}

// How strong residuals are in each place, a window of about two hundred vertices
struct Local_levels
{
  std::vector<float> levels; // for each vertex, as standard deviations
  double strong, weak;       // those that few places exceed, or fall below
  double normality;          // of the strongest fifth: one for a normal distribution, less where edges make a few residuals large
  // Of neighbors in the strongest fifth, and in the fifth below that, for what residuals differ from those around them
  std::array<double, 2> correlations;
};

// The means of the neighbors are taken away from the residuals `number_of_differences` times, at least once. White noise with the
// standard deviation one then has the given one
template <typename ConcurrencyTag>
Local_levels local_levels(const Vertex_neighbors& neighbors, const std::vector<bool>& counts, std::vector<double> residuals,
                          const std::size_t number_of_differences, const double deviation_of_white_noise)
{
  const std::size_t number_of_averages = 30;
  // the means of a standard normal distribution: edges matter less to that of the fourth root
  const double mean_of_roots = 0.8826, mean_of_absolutes = 0.7979;

  subtract_mean_of_neighbors<ConcurrencyTag>(neighbors, residuals);
  const std::vector<double> first_differences = residuals;
  for(std::size_t k=1; k<number_of_differences; ++k)
    subtract_mean_of_neighbors<ConcurrencyTag>(neighbors, residuals);

  const std::size_t n = residuals.size();
  std::vector<Mixing_moments<2> > moments(n);
  for_each_index<ConcurrencyTag>(n, [&](const std::size_t v)
  {
    const bool is_known = counts[v] && std::isfinite(residuals[v]);
    const double r = is_known ? std::abs(residuals[v]) / deviation_of_white_noise : 0;
    moments[v].products = {{ float(std::sqrt(std::sqrt(r))), float(r) }};
    moments[v].squares = {{ float(is_known), float(is_known) }};
  });
  average_over_neighbors<ConcurrencyTag>(neighbors, number_of_averages, moments);

  Local_levels result = { std::vector<float>(n), 0, 0, 0, {{ 0, 0 }} };
  std::vector<float> known;
  for(std::size_t v=0; v<n; ++v)
    if(moments[v].squares[0] > 0)
    {
      const double root = moments[v].products[0] / (mean_of_roots * moments[v].squares[0]);
      result.levels[v] = float(root * root * root * root);
      if(counts[v])
        known.push_back(result.levels[v]);
    }
  if(known.empty())
    return result;
  std::sort(known.begin(), known.end());
  const auto quantile = [&](const double share) { return known[std::size_t(share * double(known.size() - 1))]; };
  result.strong = quantile(0.95);
  result.weak = quantile(0.1);

  const std::array<float, 3> limits = {{ quantile(1), quantile(0.8), quantile(0.6) }};
  for(std::size_t i=0; i<2; ++i)
  {
    std::vector<bool> is_chosen(n, false);
    double sum_of_levels = 0, sum_of_means = 0;
    for(std::size_t v=0; v<n; ++v)
      if(counts[v] && moments[v].squares[0] > 0 && std::isfinite(first_differences[v])
         && result.levels[v] >= limits[i+1] && result.levels[v] <= limits[i])
      {
        is_chosen[v] = true;
        sum_of_levels += result.levels[v];
        sum_of_means += moments[v].products[1] / (mean_of_absolutes * moments[v].squares[0]);
      }
    if(i == 0 && sum_of_means > 0)
      result.normality = sum_of_levels / sum_of_means;
    result.correlations[i] = correlation_of_neighbors<ConcurrencyTag>(neighbors, first_differences, is_chosen);
  }
  return result;
}

// Whether each vertex that counts belongs to a face that lies in one plane with a neighbor. Noise leaves hardly any face like that
template <typename ConcurrencyTag>
bool is_made_of_planes(const Indexed_triangle_mesh& mesh, const std::vector<bool>& counts)
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  const double largest_angle = 1e-3; // room for coordinates that are rounded, no more than noise of that many edge lengths

  std::vector<Vector_3> normals;
  std::vector<double> areas;
  compute_face_normals<ConcurrencyTag>(mesh, normals, areas);
  std::vector<bool> lies_in_plane(mesh.number_of_vertices(), false);
  for(std::size_t f=0; f<normals.size(); ++f)
    for(const Index g : mesh.neighbors(f))
      if(g != Indexed_triangle_mesh::null_index() && areas[f] > 0 && areas[g] > 0
         && cross_product(normals[f], normals[g]).squared_length() < largest_angle * largest_angle)
        for(const Index v : mesh.vertices(f))
          lies_in_plane[v] = true;
  for(std::size_t v=0; v<counts.size(); ++v)
    if(counts[v] && !lies_in_plane[v])
      return false;
  return true;
}

// What triangles leave of a smooth surface that has the given normals of faces: the height of an arc over its chord across an
// edge, the median of all edges
inline double median_sagitta(const Indexed_triangle_mesh& mesh, const std::vector<Indexed_triangle_mesh::Vector_3>& face_normals)
{
  typedef Indexed_triangle_mesh::Index Index;

  std::vector<double> sagittas;
  for(std::size_t f=0; f<mesh.number_of_faces(); ++f)
    for(int i=0; i<3; ++i)
    {
      const Index g = mesh.neighbors(f)[i];
      const double length = mesh.edge_length(f, i);
      if(g == Indexed_triangle_mesh::null_index() || g < f || !(length > 0))
        continue;
      const double chord = (mesh.area(f) + mesh.area(g)) / length;
      const double angle = std::acos((std::min)(1., (std::max)(-1., face_normals[f] * face_normals[g])));
      sagittas.push_back(chord * angle / 8);
    }
  return median_of_absolutes(sagittas, std::vector<bool>(sagittas.size(), true));
}

struct Noise_estimate
{
  double level;        // the standard deviation along the normals, in the unit of the coordinates
  bool may_be_shape;   // all that stands out seems to be shape, and there is no noise
  double strong_level; // that of the places where noise is strongest, if it seems to be much stronger there; else zero
};

// The level of the residuals where they are strongest, if they may be noise there, much stronger than `level`: normally
// distributed and white, as edges and detail are not. The less white, the stronger they have to be. Else zero
template <typename ConcurrencyTag>
double level_of_strong_noise(const Vertex_neighbors& neighbors, const std::vector<bool>& counts,
                             const std::vector<double>& residuals, const double level)
{
  const double deviation_of_white_noise = 1.62, correlation_of_white_noise = -0.25;
  const double least_normality = 0.8, least_ratio = 1.35, ratio_by_correlation = 6;

  const Local_levels local = local_levels<ConcurrencyTag>(neighbors, counts, residuals, 2, deviation_of_white_noise);
  const double ratio = least_ratio
    + ratio_by_correlation * (std::max)(0., local.correlations[0] - correlation_of_white_noise);
  return (local.strong > ratio * level && local.normality > least_normality) ? local.strong : 0;
}

// From the vertices that count; a few tell nothing. Places with stronger noise are looked for if `locates_noise`. `mesh` comes back
// as it was
template <typename ConcurrencyTag>
Noise_estimate estimate_noise(Indexed_triangle_mesh& mesh, const double mean_edge_length,
                              const Vertex_neighbors& neighbors, const std::vector<bool>& counts,
                              const bool locates_noise)
{
  typedef Indexed_triangle_mesh::Point_3 Point_3;

  const std::ptrdiff_t least_number_of_vertices = 50;
  // With fewer, a coarse shape may look like noise. With more, residuals tell it, and planes may be the faces of voxels
  const std::ptrdiff_t sure_number_of_vertices = 300;
  const double strong_noise = 0.2; // mean edge lengths
  const std::size_t number_of_averages = 8;
  // what that takes of the level, which else is 2 % too low at 0.5 mean edge lengths and 7 % at 0.8
  const double followed_noise = 0.16, least_followed_noise = 0.29;

  const std::ptrdiff_t number = std::count(counts.begin(), counts.end(), true);
  if(number < least_number_of_vertices
     || (number < sure_number_of_vertices && is_made_of_planes<ConcurrencyTag>(mesh, counts)))
    return { 0, false, 0 };
  std::vector<double> residuals = leave_one_out_residuals<6, ConcurrencyTag>(mesh, mesh.points(), neighbors);
  const Level_by_edges by_edges
    = level_by_edges<ConcurrencyTag>(mesh, mean_edge_length, neighbors, counts, residuals,
                                     noise_level_of_residuals<ConcurrencyTag>(neighbors, counts, residuals));
  const double level = by_edges.level;
  const double relative_level = level / mean_edge_length;
  const bool is_strong = relative_level > strong_noise;
  Noise_estimate estimate = { level, false, 0 };
  if(!is_strong)
  {
    if(locates_noise && !by_edges.is_uniform)
      estimate.strong_level = level_of_strong_noise<ConcurrencyTag>(neighbors, counts, residuals, level);
    estimate.may_be_shape = level > 0
                         && is_shape<ConcurrencyTag>(neighbors, std::move(residuals), counts, relative_level);
    if(estimate.may_be_shape)
    {
      const double white_level = level_of_white_noise<ConcurrencyTag>(mesh, mesh.points(), mean_edge_length, neighbors,
                                                                      counts);
      if(white_level > 0)
      {
        estimate.level = (std::min)(level, white_level);
        estimate.may_be_shape = false;
      }
    }
    if(!(estimate.strong_level > strong_noise * mean_edge_length))
      return estimate;
  }

  // Noise like that turns normals, and where triangles are small it hides itself: what it does seems to lie along the
  // surface. A smoothed mesh knows better where that is
  std::vector<Point_3> points = mesh.points(), observed = points;
  for(std::size_t k=0; k<number_of_averages; ++k)
  {
    for_each_index<ConcurrencyTag>(points.size(), [&](const std::size_t v)
    {
      points[v] = mesh.point(v);
      if(neighbors.is_inside(v))
        points[v] = points[v] + 0.5 * to_center(mesh, neighbors, v);
    });
    mesh.swap_points(points);
  }
  residuals = leave_one_out_residuals<6, ConcurrencyTag>(mesh, observed, neighbors);
  mesh.swap_points(observed);
  if(is_strong)
  {
    estimate.level = noise_level_of_residuals<ConcurrencyTag>(neighbors, counts, residuals);
    // it follows some of the noise, though, the more, the stronger that is
    estimate.level *= 1 + followed_noise * (std::max)(0., estimate.level / mean_edge_length - least_followed_noise);
  }
  if(locates_noise)
    estimate.strong_level = level_of_strong_noise<ConcurrencyTag>(neighbors, counts, residuals, estimate.level);
  return estimate;
}

// Noise along the normals lengthens the edges, by the factor that the difference of two normal deviates makes in the
// mean: E sqrt(1 + 2 level^2 z^2), by a quadrature of three nodes. These two take a level in mean edge lengths of the
// surface without the noise to one in mean edge lengths of the noisy mesh, and back.
inline double in_noisy_edge_lengths(const double level)
{
  return 3 * level / (2 + std::sqrt(1 + 6 * level * level));
}

inline double in_smooth_edge_lengths(const double level)
{
  // where nothing but noise makes the edges, the equation has no solution
  const double r = (std::min)(level, 1.2);
  return r * (2 + std::sqrt(1 + 2 * r * r)) / (3 - 2 * r * r);
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_NOISE_LEVEL_H
