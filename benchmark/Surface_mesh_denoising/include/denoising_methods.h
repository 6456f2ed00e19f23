// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The methods that are compared: a new one is one more entry of all().

#ifndef SURFACE_MESH_DENOISING_DENOISING_METHODS_H
#define SURFACE_MESH_DENOISING_DENOISING_METHODS_H

#include <CGAL/Surface_mesh_denoising/Adaptive_gaussian_normal_filter.h>
#include <CGAL/Surface_mesh_denoising/Alpha_trimmed_normal_filter.h>
#include <CGAL/Surface_mesh_denoising/Bilateral_normal_filter.h>
#include <CGAL/Surface_mesh_denoising/Guided_normal_filter.h>
#include <CGAL/Surface_mesh_denoising/Mean_normal_filter.h>
#include <CGAL/Surface_mesh_denoising/Median_normal_filter.h>
#include <CGAL/Surface_mesh_denoising/Thresholded_normal_filter.h>
#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/denoise_bilateral.h>
#include <CGAL/Surface_mesh_denoising/denoise_isotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/denoise_noniterative.h>
#include <CGAL/Surface_mesh_denoising/denoise_prescribed_mean_curvature.h>
#include <CGAL/Surface_mesh_denoising/denoise_taubin.h>
#include <CGAL/Surface_mesh_denoising/denoise_with_normals.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/smooth_shape.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace denoising_methods {

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                   Mesh;

typedef std::vector<double> Values;

// a parameter and the values of it that the search for the best result tries
struct Axis
{
  std::string parameter;
  Values values;
};

struct Method
{
  std::string name;        // for options and tables
  std::string description;
  // these denoise the mesh and return the number of iterations
  std::function<std::size_t(Mesh&)> denoise_by_default;
  std::vector<Axis> grid;  // empty if there is nothing to tune
  std::function<std::size_t(Mesh&, const Values&)> denoise;
};

// one point of a method's grid
struct Setting
{
  std::string parameters;
  Values values;
};

inline std::string to_string(const double value)
{
  std::ostringstream out;
  out << value;
  return out.str();
}

// all points of the grid
inline std::vector<Setting> settings(const Method& method)
{
  std::vector<Setting> all;
  if(method.grid.empty())
    return all;
  all.emplace_back();
  for(const Axis& axis : method.grid)
  {
    std::vector<Setting> longer;
    for(const Setting& s : all)
      for(const double value : axis.values)
      {
        longer.push_back(s);
        longer.back().values.push_back(value);
        longer.back().parameters += (s.parameters.empty() ? "" : ", ") + axis.parameter + " " + to_string(value);
      }
    all.swap(longer);
  }
  return all;
}

// CGAL's function has no default of the time; edge lengths make it independent of the size of the mesh
inline std::size_t smooth_shape(Mesh& mesh, const double time_in_square_edge_lengths)
{
  double sum = 0;
  for(const Mesh::Edge_index e : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  const double mean = sum / double(mesh.number_of_edges());
  CGAL::Polygon_mesh_processing::smooth_shape(mesh, time_in_square_edge_lengths * mean * mean);
  return 1;
}

inline Method smooth_shape_method(const double time, const std::vector<Axis>& grid = {})
{
  return { "smooth_shape_" + to_string(time),
           "CGAL's smooth_shape(), time " + to_string(time) + " square mean edge lengths; Desbrun et al. 1999",
           [=](Mesh& mesh) { return smooth_shape(mesh, time); },
           grid, [](Mesh& mesh, const Values& v) { return smooth_shape(mesh, v[0]); } };
}

// the rounds of Yagou et al., of Ohtake et al. and of Zhang et al. 2015: the vertices move after each iteration of the filter
template <typename Filter>
std::size_t denoise_in_rounds(Mesh& mesh, const Filter& filter, const double number_of_rounds)
{
  return CGAL::Surface_mesh_denoising::denoise_with_normals(mesh,
    CGAL::parameters::face_normal_filter(filter)
                     .number_of_normal_iterations(1)
                     .number_of_rounds(int(number_of_rounds))).number_of_iterations;
}

inline const std::vector<Method>& all()
{
  namespace SMD = CGAL::Surface_mesh_denoising;
  namespace np = CGAL::parameters;

  static const std::vector<Method> methods = {
    // the mesh decides everything
    { "anisotropic_fitting", "denoise_anisotropic_fitting() without parameters",
      [](Mesh& mesh) { return SMD::denoise_anisotropic_fitting(mesh).number_of_iterations; },
      {}, nullptr },

    { "anisotropic_fitting_paper", "denoise_anisotropic_fitting() with a number of iterations; Wang and Yu 2012",
      [](Mesh& mesh)
      { return SMD::denoise_anisotropic_fitting(mesh, np::number_of_iterations(30)).number_of_iterations; },
      { { "number_of_iterations", { 5, 30 } }, { "number_of_normal_iterations", { 2, 5, 10 } },
        { "neighborhood_size", { 20, 40 } } },
      [](Mesh& mesh, const Values& v)
      {
        return SMD::denoise_anisotropic_fitting(mesh, np::number_of_iterations(int(v[0]))
                                                         .number_of_normal_iterations(int(v[1]))
                                                         .neighborhood_size(int(v[2]))).number_of_iterations;
      } },

    { "isotropic_fitting", "denoise_isotropic_fitting(); Wang and Yu 2012, Section 2",
      [](Mesh& mesh) { return SMD::denoise_isotropic_fitting(mesh).number_of_iterations; },
      { { "number_of_iterations", { 2, 5, 30 } }, { "neighborhood_ring_size", { 1, 2 } } },
      [](Mesh& mesh, const Values& v)
      {
        return SMD::denoise_isotropic_fitting(mesh, np::number_of_iterations(int(v[0]))
                                                       .neighborhood_ring_size(int(v[1]))).number_of_iterations;
      } },

    { "bilateral", "denoise_bilateral(); Fleishman et al. 2003",
      [](Mesh& mesh) { return SMD::denoise_bilateral(mesh).number_of_iterations; },
      { { "number_of_iterations", { 5, 10, 15 } }, { "spatial_sigma", { 0.7, 1, 1.5 } } },
      [](Mesh& mesh, const Values& v)
      {
        return SMD::denoise_bilateral(mesh, np::number_of_iterations(int(v[0]))
                                               .spatial_sigma(v[1])).number_of_iterations;
      } },

    { "noniterative", "denoise_noniterative(); Jones et al. 2003",
      [](Mesh& mesh) { SMD::denoise_noniterative(mesh); return std::size_t(1); },
      { { "spatial_sigma", { 1, 1.5, 2 } }, { "height_sigma", { 0.5, 1, 2 } } },
      [](Mesh& mesh, const Values& v)
      {
        SMD::denoise_noniterative(mesh, np::spatial_sigma(v[0]).height_sigma(v[1]));
        return std::size_t(1);
      } },

    { "mean_normals", "denoise_with_normals() and Mean_normal_filter in 10 rounds; Yagou et al. 2002",
      [](Mesh& mesh) { return denoise_in_rounds(mesh, SMD::Mean_normal_filter(), 10); },
      { { "number_of_rounds", { 2, 5, 10, 20 } } },
      [](Mesh& mesh, const Values& v) { return denoise_in_rounds(mesh, SMD::Mean_normal_filter(), v[0]); } },

    { "median_normals", "denoise_with_normals() and Median_normal_filter in 10 rounds; Yagou et al. 2002",
      [](Mesh& mesh) { return denoise_in_rounds(mesh, SMD::Median_normal_filter(), 10); },
      { { "number_of_rounds", { 5, 10, 20, 40 } } },
      [](Mesh& mesh, const Values& v) { return denoise_in_rounds(mesh, SMD::Median_normal_filter(), v[0]); } },

    { "alpha_trimmed_normals", "denoise_with_normals() and Alpha_trimmed_normal_filter in 10 rounds; Yagou et al. 2003",
      [](Mesh& mesh) { return denoise_in_rounds(mesh, SMD::Alpha_trimmed_normal_filter(), 10); },
      { { "number_of_rounds", { 5, 10, 20 } }, { "trimmed_share", { 0.15, 0.25, 0.4 } } },
      [](Mesh& mesh, const Values& v)
      { return denoise_in_rounds(mesh, SMD::Alpha_trimmed_normal_filter(v[1]), v[0]); } },

    { "adaptive_gaussian_normals",
      "denoise_with_normals() and Adaptive_gaussian_normal_filter in 10 rounds; Ohtake et al. 2002",
      [](Mesh& mesh) { return denoise_in_rounds(mesh, SMD::Adaptive_gaussian_normal_filter(), 10); },
      { { "number_of_rounds", { 3, 5, 10, 20 } }, { "scale_weight", { 0.1, 0.3 } } },
      [](Mesh& mesh, const Values& v)
      { return denoise_in_rounds(mesh, SMD::Adaptive_gaussian_normal_filter(v[1]), v[0]); } },

    { "thresholded_normals", "denoise_with_normals(); Sun et al. 2007",
      [](Mesh& mesh) { return SMD::denoise_with_normals(mesh).number_of_iterations; },
      { { "angle_threshold", { 0.2, 0.4, 0.5, 0.6 } }, { "number_of_normal_iterations", { 5, 10, 20, 40 } } },
      [](Mesh& mesh, const Values& v)
      {
        return SMD::denoise_with_normals(mesh, np::face_normal_filter(SMD::Thresholded_normal_filter(v[0], 2))
                                                  .number_of_normal_iterations(int(v[1]))).number_of_iterations;
      } },

    { "prescribed_mean_curvature", "denoise_prescribed_mean_curvature(); Hildebrandt and Polthier 2004",
      [](Mesh& mesh) { return SMD::denoise_prescribed_mean_curvature(mesh).number_of_iterations; },
      { { "number_of_iterations", { 20, 40, 80 } }, { "angle_threshold", { 0.8, 0.9, 0.95 } } },
      [](Mesh& mesh, const Values& v)
      {
        return SMD::denoise_prescribed_mean_curvature(mesh, np::number_of_iterations(int(v[0]))
                                                               .angle_threshold(v[1])).number_of_iterations;
      } },

    { "bilateral_normals", "denoise_with_normals() and Bilateral_normal_filter; Zheng et al. 2011, local",
      [](Mesh& mesh)
      {
        return SMD::denoise_with_normals(mesh, np::face_normal_filter(SMD::Bilateral_normal_filter()))
               .number_of_iterations;
      },
      { { "normal_sigma", { 0.25, 0.35, 0.5, 1 } }, { "number_of_normal_iterations", { 5, 10, 20, 40 } } },
      [](Mesh& mesh, const Values& v)
      {
        return SMD::denoise_with_normals(mesh, np::face_normal_filter(SMD::Bilateral_normal_filter(v[0]))
                                                  .number_of_normal_iterations(int(v[1]))).number_of_iterations;
      } },

    { "guided_normals", "denoise_with_normals() and Guided_normal_filter in 20 rounds; Zhang et al. 2015, local",
      [](Mesh& mesh) { return denoise_in_rounds(mesh, SMD::Guided_normal_filter(), 20); },
      { { "number_of_rounds", { 5, 20, 40 } }, { "normal_sigma", { 0.25, 0.35, 0.5 } } },
      [](Mesh& mesh, const Values& v) { return denoise_in_rounds(mesh, SMD::Guided_normal_filter(v[1]), v[0]); } },

    { "laplacian", "denoise_taubin() with mu = 0; Field 1988",
      [](Mesh& mesh) { return SMD::denoise_taubin(mesh, np::mu(0.)).number_of_iterations; },
      { { "number_of_iterations", { 2, 5, 10, 20 } } },
      [](Mesh& mesh, const Values& v)
      { return SMD::denoise_taubin(mesh, np::mu(0.).number_of_iterations(int(v[0]))).number_of_iterations; } },

    { "taubin", "denoise_taubin(); Taubin 1995",
      [](Mesh& mesh) { return SMD::denoise_taubin(mesh).number_of_iterations; },
      { { "number_of_iterations", { 10, 20, 40, 80 } } },
      [](Mesh& mesh, const Values& v)
      { return SMD::denoise_taubin(mesh, np::number_of_iterations(int(v[0]))).number_of_iterations; } },

    smooth_shape_method(0.1),
    smooth_shape_method(0.3, { { "time", { 0.03, 0.1, 0.3, 1, 3 } } }),
    smooth_shape_method(1)
  };
  return methods;
}

} // namespace denoising_methods

#endif // SURFACE_MESH_DENOISING_DENOISING_METHODS_H
