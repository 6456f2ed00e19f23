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

// A surface h(u,v) = c0 + c1 u + c2 v + c3 u^2 + c4 uv + c5 v^2 over the plane of a patch, or a cubic one, which has the terms
// c6 u^3 + c7 u^2 v + c8 u v^2 + c9 v^3, too, with the covariance of its coefficients in units of the squared noise of points.
// If it is round, this is h - roundness h^2 instead of h: parabolas become circles, as 2 r h = u^2 + h^2 is that of radius r
struct Patch_surface
{
  typedef Eigen::Matrix<double, 6, 1>       Quadric_vector;
  typedef Eigen::Matrix<double, 10, 1>      Vector;
  typedef Eigen::Matrix<double, 10, 10>     Matrix;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  Vector coefficients = Vector::Zero();
  Matrix covariance = Matrix::Zero();
  int number_of_terms = 3; // of a plane, a quadric or a cubic; the other coefficients are zero
  double roundness = 0;    // one over a length
  double risk = std::numeric_limits<double>::infinity(); // mean squared error expected
  double squared_bias = 0;                               // the share of it that is not noise
  std::size_t number_of_faces = 0, number_of_points = 0;

  // the least cosine of the angle of a round surface to its plane
  static constexpr double least_growth = 0.3;

  bool is_plane() const { return number_of_terms == 3; }
  bool is_cubic() const { return number_of_terms == 10; }

  double height(const double u, const double v) const
  {
    const double h = polynomial(u, v);
    return 2 * h / (1 + growth(h)); // a root of h - roundness h^2, without cancellation
  }

  double variance_of_height(const double u, const double v) const
  {
    const double g = growth(polynomial(u, v));
    return (is_plane() ? variance<3>(monomials<3>(u, v)) :
            is_cubic() ? variance<10>(monomials<10>(u, v)) : variance<6>(monomials<6>(u, v))) / (g * g);
  }

  // the sum of the variances of the two slopes, in units of the extent
  double variance_of_slopes(const double u, const double v) const
  {
    if(is_plane())
      return covariance(1, 1) + covariance(2, 2);
    const Quadric_vector du = (Quadric_vector() << 0, 1, 0, 2*u, v, 0).finished(),
                         dv = (Quadric_vector() << 0, 0, 1, 0, u, 2*v).finished();
    const double g = growth(polynomial(u, v));
    if(!is_cubic())
      return (variance<6>(du) + variance<6>(dv)) / (g * g);
    return (variance<10>((Vector() << du, 3*u*u, 2*u*v, v*v, 0).finished())
            + variance<10>((Vector() << dv, 0, u*u, 2*u*v, 3*v*v).finished())) / (g * g);
  }

  // a vector along the normal, whose component along the axis of the frame is one
  Vector_3 normal(const Patch_frame& frame, const double u, const double v) const
  {
    const Vector& c = coefficients;
    double slope_u = c[1] + 2*c[3]*u + c[4]*v, slope_v = c[2] + c[4]*u + 2*c[5]*v;
    if(is_cubic())
    {
      slope_u += 3*c[6]*u*u + 2*c[7]*u*v + c[8]*v*v;
      slope_v += c[7]*u*u + 2*c[8]*u*v + 3*c[9]*v*v;
    }
    const double g = growth(polynomial(u, v));
    return frame.axis - slope_u / g * frame.tangents[0] - slope_v / g * frame.tangents[1];
  }

private:
  double polynomial(const double u, const double v) const
  { return is_plane() ? value<3>(u, v) : is_cubic() ? value<10>(u, v) : value<6>(u, v); }

  // That of the polynomial, whose value is `h`, by height. On a circle it is the cosine of the angle to the plane
  double growth(const double h) const
  {
    return (roundness == 0) ? 1 : std::sqrt((std::max)(least_growth * least_growth, 1 - 4 * roundness * h));
  }

  template <int number>
  double value(const double u, const double v) const
  {
    return coefficients.head<number>().dot(monomials<number>(u, v));
  }

  // of the sum of the first coefficients times such factors
  template <int number>
  double variance(const Eigen::Matrix<double, number, 1>& factors) const
  {
    return factors.dot(covariance.topLeftCorner<number, number>() * factors);
  }
};

// Fits planes, parabolic cylinders, quadrics and, if asked to, cubics to a growing set of points, and keeps the one with the
// least risk.
//
// Coefficients are those that fit the observed points best; what they are worth is told by the pilot's points, which
// hold much less noise and so show sooner where the surface leaves the fit. They tell the axis of a cylinder, too, which
// so takes but one coefficient more than a plane. What bends may go on as circles do, which takes no coefficient at all.
class Patch_fit
{
  typedef Indexed_triangle_mesh::Point_3    Point_3;
  typedef Patch_surface::Vector             Vector;
  typedef Patch_surface::Quadric_vector     Quadric_vector;
  typedef Patch_surface::Matrix             Matrix;
  typedef Eigen::Matrix<double, 6, 6>       Quadric_matrix;
  typedef Eigen::Matrix<double, 6, 4>       Matrix_6x4;

public:
  Patch_fit(const Adaptive_parameters& parameters, const Pilot_error& pilot_error, const Patch_effort& effort,
            const double extent)
    : m_parameters(parameters), m_pilot_error(pilot_error), m_hopeless_risk(effort.hopeless_risk),
      m_has_cubics(pilot_error.is_fine && parameters.use_adaptive_degree),
      m_squared_extent(extent * extent)
  {}

  // starts anew, where noise has this variance
  void clear(const double squared_noise)
  {
    m_squared_noise = squared_noise;
    m_moments.setZero();
    m_rhs.setZero();
    m_pilot_rhs.setZero();
    m_square_rhs.setZero();
    m_powers_of_pilot_heights.setZero();
    m_least_pilot_height = m_largest_pilot_height = 0;
    m_number_of_points = 0;
    m_best = Patch_surface();
  }

  const Patch_surface& best() const { return m_best; }

  void insert(const double u, const double v, const double height, const double pilot_height)
  {
    if(m_has_cubics)
      add<10, 28>(u, v, height, pilot_height);
    else
      add<6, 15>(u, v, height, pilot_height);
    const double square = pilot_height * pilot_height;
    m_powers_of_pilot_heights += Eigen::Vector3d(square, square * pilot_height, square * square);
    m_least_pilot_height = (std::min)(m_least_pilot_height, pilot_height);
    m_largest_pilot_height = (std::max)(m_largest_pilot_height, pilot_height);
    ++m_number_of_points;
  }

  // fits the points so far, those of so many faces, and returns whether more of them may improve the fit
  bool update(const std::size_t number_of_faces)
  {
    if(m_number_of_points < m_parameters.least_number_of_points)
      return true;

    // the leading block of the factor belongs to the plane
    const Quadric_matrix matrix = normal_matrix<6>();
    const Eigen::LLT<Quadric_matrix> llt(matrix);
    const auto is_regular = [&](const int size)
    {
      // a pivot is the squared distance of a column from the span of those before it
      return (llt.matrixLLT().diagonal().head(size).array().square()
              > 1e-8 * matrix.diagonal().head(size).array()).all();
    };
    const bool has_quadric = llt.info() == Eigen::Success && is_regular(6);
    if(!has_quadric && !is_regular(3))
      return true;

    const Eigen::Matrix3d plane_factor = llt.matrixLLT().topLeftCorner<3, 3>();
    const Eigen::Vector3d plane_reduced
      = plane_factor.triangularView<Eigen::Lower>().solve(Eigen::Vector3d(m_rhs.head<3>()));

    // what a curved surface explains more than a plane must be worth its further coefficients
    Quadric_vector c = Quadric_vector::Zero();
    Matrix_6x4 cylinder_basis;
    Eigen::LLT<Eigen::Matrix4d> cylinder_llt;
    std::size_t number_of_coefficients = 3;
    if(has_quadric)
    {
      const Quadric_vector reduced = llt.matrixL().solve(m_rhs.head<6>()),
                           pilot_reduced = llt.matrixL().solve(m_pilot_rhs.head<6>());
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
        cylinder_llt.compute(cylinder_basis.transpose() * (matrix * cylinder_basis));
        number_of_coefficients = 4;
      }
    }
    const Eigen::Matrix3d lower_left = llt.matrixLLT().bottomLeftCorner<3, 3>();
    c.head<3>() = plane_factor.triangularView<Eigen::Lower>().transpose()
                              .solve(Eigen::Vector3d(plane_reduced - lower_left.transpose() * c.tail<3>()));
    double roundness = 0;
    if(number_of_coefficients == 6)
      roundness = make_round(matrix, [&](const Quadric_vector& rhs) -> Quadric_vector { return llt.solve(rhs); }, c);
    else if(number_of_coefficients == 4)
      roundness = make_round(matrix, [&](const Quadric_vector& rhs) -> Quadric_vector
                                     { return cylinder_basis * cylinder_llt.solve(cylinder_basis.transpose() * rhs); }, c);
    if(!c.allFinite())
      return true;

    const Risk risk = risk_of(misfit(matrix, c, roundness), number_of_coefficients);
    // four more coefficients must have some bias to take away
    if(m_has_cubics && has_quadric && risk.squared_bias > 4 * m_squared_noise / double(m_number_of_points)
       && update_by_cubic(number_of_faces, risk))
      return true;
    if(!(risk.total < m_best.risk))
      return risk.total <= m_hopeless_risk * m_best.risk;

    keep(risk, number_of_faces);
    m_best.coefficients.head<6>() = c;
    m_best.coefficients.tail<4>().setZero();
    m_best.number_of_terms = (number_of_coefficients == 3) ? 3 : 6;
    m_best.roundness = roundness;
    auto covariance = m_best.covariance.topLeftCorner<6, 6>();
    covariance.setZero();
    if(number_of_coefficients == 3)
    {
      Eigen::Matrix3d inverse = Eigen::Matrix3d::Identity();
      plane_factor.triangularView<Eigen::Lower>().solveInPlace(inverse);
      covariance.topLeftCorner<3, 3>() = inverse.transpose() * inverse;
    }
    else if(number_of_coefficients == 4)
    {
      covariance = cylinder_basis * cylinder_llt.solve(Eigen::Matrix<double, 4, 6>(cylinder_basis.transpose()));
    }
    else
    {
      Quadric_matrix inverse = Quadric_matrix::Identity();
      llt.matrixL().solveInPlace(inverse);
      covariance = inverse.transpose() * inverse;
    }
    return true;
  }

private:
  template <int number, int number_of_moments>
  void add(const double u, const double v, const double height, const double pilot_height)
  {
    const auto m = monomials<number_of_moments>(u, v);
    m_moments.head<number_of_moments>() += m;
    m_rhs.head<number>() += height * m.template head<number>();
    m_pilot_rhs.head<number>() += pilot_height * m.template head<number>();
    m_square_rhs.head<number>() += pilot_height * pilot_height * m.template head<number>();
  }

  // that of the first so many coefficients: the sums of the products of each two monomials, which are monomials, too
  template <int number>
  Eigen::Matrix<double, number, number> normal_matrix() const
  {
    const std::array<int, 10> degrees = {{ 0, 1, 1, 2, 2, 2, 3, 3, 3, 3 }};
    Eigen::Matrix<double, number, number> matrix;
    for(int k=0; k<number; ++k)
      for(int l=0; l<number; ++l)
        matrix(k, l) = m_moments[k + l + degrees[k] * degrees[l]];
    return matrix;
  }

  // of a surface with such coefficients to the pilot, in squares
  template <int number>
  double misfit(const Eigen::Matrix<double, number, number>& matrix, const Eigen::Matrix<double, number, 1>& c,
                const double roundness) const
  {
    const Eigen::Vector3d factors(1, -2 * roundness, roundness * roundness);
    return m_powers_of_pilot_heights.dot(factors) + c.dot(matrix * c)
         - 2 * c.dot(m_pilot_rhs.head<number>() - roundness * m_square_rhs.head<number>());
  }

  // Makes the surface with coefficients `c` a round one if that fits the pilot better, and returns its roundness. It then bends
  // as a circle where it bends most. The squares of its heights are those of the pilot; `solve` finds least squares
  template <int number, typename Solve>
  double make_round(const Eigen::Matrix<double, number, number>& matrix, const Solve& solve,
                    Eigen::Matrix<double, number, 1>& c) const
  {
    if(!m_parameters.use_round_patches)
      return 0;
    const Eigen::Matrix<double, number, 1> square = solve(m_square_rhs.head<number>());
    const auto round = [&](const double roundness) -> Eigen::Matrix<double, number, 1> { return c - roundness * square; };
    // the roundness that the bend of the round surface tells, on which that depends almost linearly, by secants from zero on
    const std::size_t number_of_steps = 3;
    const double first = largest_bend(c) / m_squared_extent;
    double roundness = first;
    for(std::size_t k=0; k<number_of_steps; ++k)
      roundness = first / (1 - (largest_bend(round(roundness)) / m_squared_extent - first) / roundness);
    if(!(1 - 2 * roundness * (roundness > 0 ? m_largest_pilot_height : m_least_pilot_height) > Patch_surface::least_growth)
       || !(misfit(matrix, round(roundness), roundness) < misfit<number>(matrix, c, 0)))
      return 0;
    c = round(roundness);
    return roundness;
  }

  struct Risk
  {
    double total, squared_bias;
  };

  // The misfit to the pilot, less what the noise that the pilot holds would explain with some certainty, is bias
  Risk risk_of(const double misfit, const std::size_t number_of_coefficients) const
  {
    const double n = double(m_number_of_points);
    const double pilot_variance = m_pilot_error.noise * m_pilot_error.noise * m_squared_noise;
    const double explained = pilot_variance * (n - std::sqrt(2 * m_pilot_error.correlation * n));
    const double squared_bias = (std::max)(0., misfit - explained) / n;
    return { squared_bias + double(number_of_coefficients) * m_squared_noise / n, squared_bias };
  }

  // what the best surface is to be, but for its coefficients
  void keep(const Risk& risk, const std::size_t number_of_faces)
  {
    m_best.risk = risk.total;
    m_best.squared_bias = risk.squared_bias;
    m_best.number_of_faces = number_of_faces;
    m_best.number_of_points = m_number_of_points;
  }

  // Keeps a cubic if it is better than all before and the best of the other surfaces that fit these points, whose risk is
  // given, and returns whether it did. Its slopes must be known everywhere, which they are not on a strip, and it must take
  // most of the bias away, which it does where the shape is smooth, but not across an edge
  bool update_by_cubic(const std::size_t number_of_faces, const Risk& other_risk)
  {
    const Matrix matrix = normal_matrix<10>();
    const Eigen::LLT<Matrix> llt(matrix);
    if(llt.info() != Eigen::Success
       || (llt.matrixLLT().diagonal().tail<4>().array().square()
           < m_parameters.least_pivot_of_cubic * matrix.diagonal().tail<4>().array()).any())
      return false;
    const Vector reduced = llt.matrixL().solve(m_rhs);
    if(worth(reduced.tail<4>().squaredNorm(), m_parameters.cubic_threshold) < 0)
      return false;
    Vector c = llt.matrixU().solve(reduced);
    const double roundness = make_round(matrix, [&](const Vector& rhs) -> Vector { return llt.solve(rhs); }, c);
    const Risk risk = risk_of(misfit(matrix, c, roundness), 10);
    if(!(risk.total < (std::min)(m_best.risk, other_risk.total))
       || !(risk.squared_bias <= m_parameters.largest_bias_of_cubic * other_risk.squared_bias) || !c.allFinite())
      return false;

    keep(risk, number_of_faces);
    m_best.coefficients = c;
    m_best.number_of_terms = 10;
    m_best.roundness = roundness;
    Matrix inverse = Matrix::Identity();
    llt.matrixL().solveInPlace(inverse);
    m_best.covariance.noalias() = inverse.transpose() * inverse;
    return true;
  }

  // the one of the two eigenvalues of c3 u^2 + c4 uv + c5 v^2 that is farther from zero
  template <int number>
  static double largest_bend(const Eigen::Matrix<double, number, 1>& c)
  {
    const double mean = (c[3] + c[5]) / 2;
    return mean + std::copysign(std::sqrt((c[3] - c[5]) * (c[3] - c[5]) + c[4] * c[4]) / 2, mean);
  }

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
  bool m_has_cubics;
  double m_squared_noise;
  double m_squared_extent;

  // sums over the points; without cubics, of the monomials that quadrics need
  Eigen::Matrix<double, 28, 1> m_moments;
  Vector m_rhs, m_pilot_rhs, m_square_rhs;
  Eigen::Vector3d m_powers_of_pilot_heights; // from the second on
  double m_least_pilot_height, m_largest_pilot_height;
  std::size_t m_number_of_points;
  Patch_surface m_best;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_PATCH_FIT_H
