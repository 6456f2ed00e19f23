// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_PATCH_FIT_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_PATCH_FIT_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Adaptive_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/surface_fit.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// The frame of a patch: heights over a tangent plane, whose coordinates are in units of `extent`
struct Patch_frame
{
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  Point_3 origin;
  Vector_3 axis;
  std::array<Vector_3, 2> tangents; // divided by the extent

  Patch_frame() {}
  Patch_frame(const Point_3& origin, const Vector_3& axis, const double extent)
    : origin(origin), axis(axis), tangents(tangent_frame(axis))
  {
    for(Vector_3& t : tangents)
      t = t / extent;
  }

  double u(const Point_3& p) const { return (p - origin) * tangents[0]; }
  double v(const Point_3& p) const { return (p - origin) * tangents[1]; }
  double height(const Point_3& p) const { return (p - origin) * axis; }
};

// A surface h(u,v) = c0 + c1 u + c2 v + c3 u^2 + c4 uv + c5 v^2 over the plane of a patch, with the covariance of its
// coefficients in units of the squared noise of the points
struct Patch_surface
{
  typedef Eigen::Matrix<double, 6, 1>       Vector;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  Vector coefficients = Vector::Zero();
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  double risk = std::numeric_limits<double>::infinity(); // mean squared error expected
  double squared_bias = 0;                               // the share of it that is not noise
  std::size_t number_of_faces = 0, number_of_points = 0;

  static Vector monomials(const double u, const double v) { return (Vector() << 1, u, v, u*u, u*v, v*v).finished(); }

  double height(const double u, const double v) const { return coefficients.dot(monomials(u, v)); }

  double variance_of_height(const double u, const double v) const
  {
    const Vector m = monomials(u, v);
    return m.dot(covariance * m);
  }

  // the sum of the variances of the two slopes, in units of the extent
  double variance_of_slopes(const double u, const double v) const
  {
    const Vector du = (Vector() << 0, 1, 0, 2*u, v, 0).finished(), dv = (Vector() << 0, 0, 1, 0, u, 2*v).finished();
    return du.dot(covariance * du) + dv.dot(covariance * dv);
  }

  // a vector along the normal, whose component along the axis of the frame is one
  Vector_3 normal(const Patch_frame& frame, const double u, const double v) const
  {
    const Vector& c = coefficients;
    return frame.axis - (c[1] + 2*c[3]*u + c[4]*v) * frame.tangents[0] - (c[2] + c[4]*u + 2*c[5]*v) * frame.tangents[1];
  }
};

// Fits planes, parabolic cylinders and quadrics to a growing set of points, and keeps the one with the least risk.
//
// Coefficients are those that fit the observed points best; what they are worth is told by the pilot's points, which
// hold much less noise and so show sooner where the surface leaves the fit. They tell the axis of a cylinder, too, which
// so takes but one coefficient more than a plane.
class Patch_fit
{
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Patch_surface::Vector             Vector;
  typedef Eigen::Matrix<double, 6, 6>       Matrix;
  typedef Eigen::Matrix<double, 6, 4>       Matrix_6x4;

public:
  Patch_fit(const Adaptive_parameters& parameters, const Pilot_error& pilot_error, const double hopeless_risk,
            const double squared_noise)
    : m_parameters(parameters), m_pilot_error(pilot_error), m_hopeless_risk(hopeless_risk),
      m_squared_noise(squared_noise)
  {}

  void clear()
  {
    m_matrix.setZero();
    m_rhs.setZero();
    m_pilot_rhs.setZero();
    m_squared_pilot_heights = 0;
    m_number_of_points = 0;
    m_best = Patch_surface();
  }

  const Patch_surface& best() const { return m_best; }

  void insert(const double u, const double v, const double height, const double pilot_height)
  {
    const Vector m = Patch_surface::monomials(u, v);
    m_matrix.noalias() += m * m.transpose();
    m_rhs += height * m;
    m_pilot_rhs += pilot_height * m;
    m_squared_pilot_heights += pilot_height * pilot_height;
    ++m_number_of_points;
  }

  // fits the points so far, those of so many faces, and returns whether more of them may improve the fit
  bool update(const std::size_t number_of_faces)
  {
    if(m_number_of_points < m_parameters.least_number_of_points)
      return true;

    // the leading block of the factor belongs to the plane
    const Eigen::LLT<Matrix> llt(m_matrix);
    const auto is_regular = [&](const int size)
    {
      // a pivot is the squared distance of a column from the span of those before it
      return (llt.matrixLLT().diagonal().head(size).array().square()
              > 1e-8 * m_matrix.diagonal().head(size).array()).all();
    };
    const bool has_quadric = llt.info() == Eigen::Success && is_regular(6);
    if(!has_quadric && !is_regular(3))
      return true;

    const Eigen::Matrix3d plane_factor = llt.matrixLLT().topLeftCorner<3, 3>();
    const Eigen::Vector3d plane_reduced
      = plane_factor.triangularView<Eigen::Lower>().solve(Eigen::Vector3d(m_rhs.head<3>()));

    // what a curved surface explains more than a plane must be worth its further coefficients
    Vector c = Vector::Zero();
    Matrix_6x4 cylinder_basis;
    std::size_t number_of_coefficients = 3;
    if(has_quadric)
    {
      const Vector reduced = llt.matrixL().solve(m_rhs), pilot_reduced = llt.matrixL().solve(m_pilot_rhs);
      const Eigen::Vector3d quadric_reduced = reduced.tail<3>();
      const Eigen::Matrix3d factor = llt.matrixLLT().bottomRightCorner<3, 3>();
      const auto lower = factor.triangularView<Eigen::Lower>();
      const Eigen::Vector3d bend = bend_of_cylinder(lower.transpose().solve(Eigen::Vector3d(pilot_reduced.tail<3>())));
      const Eigen::Vector3d reduced_bend = lower.transpose() * bend;
      const double curvature = reduced_bend.dot(quadric_reduced) / reduced_bend.squaredNorm();

      const double quadric_worth = worth(quadric_reduced.squaredNorm(), m_parameters.quadric_threshold),
                   cylinder_worth = worth(curvature * curvature * reduced_bend.squaredNorm(),
                                          m_parameters.cylinder_threshold);
      if(!m_parameters.use_adaptive_degree || (quadric_worth >= 0 && quadric_worth >= cylinder_worth))
      {
        c.tail<3>() = lower.transpose().solve(quadric_reduced);
        number_of_coefficients = 6;
      }
      else if(cylinder_worth >= 0)
      {
        c.tail<3>() = curvature * bend;
        cylinder_basis.setIdentity();
        cylinder_basis.col(3).tail<3>() = bend;
        number_of_coefficients = 4;
      }
    }
    const Eigen::Matrix3d lower_left = llt.matrixLLT().bottomLeftCorner<3, 3>();
    c.head<3>() = plane_factor.triangularView<Eigen::Lower>().transpose()
                              .solve(Eigen::Vector3d(plane_reduced - lower_left.transpose() * c.tail<3>()));
    if(!c.allFinite())
      return true;

    // The misfit to the pilot, less what the noise that the pilot holds would explain with some certainty, is bias
    const double n = double(m_number_of_points);
    const double pilot_variance = m_pilot_error.noise * m_pilot_error.noise * m_squared_noise;
    const double misfit = m_squared_pilot_heights - 2 * c.dot(m_pilot_rhs) + c.dot(m_matrix * c);
    const double explained
      = pilot_variance * (n - std::sqrt(2 * m_pilot_error.correlation * n));
    const double squared_bias = (std::max)(0., misfit - explained) / n;
    const double risk = squared_bias + double(number_of_coefficients) * m_squared_noise / n;
    if(!(risk < m_best.risk))
      return risk <= m_hopeless_risk * m_best.risk;

    m_best.coefficients = c;
    m_best.risk = risk;
    m_best.squared_bias = squared_bias;
    m_best.number_of_faces = number_of_faces;
    m_best.number_of_points = m_number_of_points;
    m_best.covariance.setZero();
    if(number_of_coefficients == 3)
    {
      Eigen::Matrix3d inverse = Eigen::Matrix3d::Identity();
      plane_factor.triangularView<Eigen::Lower>().solveInPlace(inverse);
      m_best.covariance.topLeftCorner<3, 3>() = inverse.transpose() * inverse;
    }
    else if(number_of_coefficients == 4)
    {
      const Eigen::Matrix4d matrix = cylinder_basis.transpose() * (m_matrix * cylinder_basis);
      m_best.covariance = cylinder_basis * matrix.llt().solve(Eigen::Matrix<double, 4, 6>(cylinder_basis.transpose()));
    }
    else
    {
      Matrix inverse = Matrix::Identity();
      llt.matrixL().solveInPlace(inverse);
      m_best.covariance = inverse.transpose() * inverse;
    }
    return true;
  }

private:
  // The part c3 u^2 + c4 uv + c5 v^2 of a parabolic cylinder with second derivative two, bent the way where the given one
  // bends most
  static Eigen::Vector3d bend_of_cylinder(const Eigen::Vector3d& c)
  {
    const double sign = (c[0] + c[2] < 0) ? -1 : 1;
    const double angle = 0.5 * std::atan2(sign * c[1], sign * (c[0] - c[2]));
    const double cosine = std::cos(angle), sine = std::sin(angle);
    return Eigen::Vector3d(cosine * cosine, 2 * cosine * sine, sine * sine);
  }

  // `gain` in squared residuals
  double worth(const double gain, const double threshold) const { return gain / m_squared_noise - threshold; }

  const Adaptive_parameters& m_parameters;
  Pilot_error m_pilot_error;
  double m_hopeless_risk;
  double m_squared_noise;

  Matrix m_matrix;
  Vector m_rhs, m_pilot_rhs;
  double m_squared_pilot_heights;
  std::size_t m_number_of_points;
  Patch_surface m_best;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_PATCH_FIT_H
