// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_SURFACE_FIT_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_SURFACE_FIT_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// two unit vectors that are orthogonal to the unit vector `n` and to each other
inline std::array<Indexed_triangle_mesh::Vector_3, 2> tangent_frame(const Indexed_triangle_mesh::Vector_3& n)
{
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;
  // Householder's reflection that takes the third axis to -n or n, whichever is further away
  const double s = (n.z() >= 0) ? 1 : -1;
  const double a = 1 / (1 + std::abs(n.z()));
  return {{ Vector_3(1 - a*n.x()*n.x(), -a*n.x()*n.y(), -s*n.x()),
            Vector_3(-a*n.x()*n.y(), 1 - a*n.y()*n.y(), -s*n.y()) }};
}

// the first so many of 1, u, v, u^2, uv, v^2, u^3, and so on
template <int number>
Eigen::Matrix<double, number, 1> monomials(const double u, const double v)
{
  Eigen::Matrix<double, number, 1> m;
  m[0] = 1;
  for(int degree=1, k=1; k<number; ++degree)
  {
    for(int i=0; i<degree; ++i, ++k)
      m[k] = u * m[k - degree];
    m[k] = v * m[k - degree - 1];
    ++k;
  }
  return m;
}

// Fits h(u,v) = g + e u + f v + a u^2 + b uv + c v^2 to points by weighted least squares, in the frame with origin `origin` and third
// axis `axis`, with the weights exp(-|p - origin| / max |p - origin|). Returns h(0,0). If the points do not determine h well,
// the same for the plane h(u,v) = g + e u + f v, and if they do not determine that either, zero.
inline double height_of_fit(const Indexed_triangle_mesh::Point_3& origin,
                            const Indexed_triangle_mesh::Vector_3& axis,
                            const std::vector<Indexed_triangle_mesh::Point_3>& points)
{
  typedef Indexed_triangle_mesh::Point_3 Point_3;
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;
  typedef Eigen::Matrix<double, 6, 6> Matrix;
  typedef Eigen::Matrix<double, 6, 1> Vector;

  double radius = 0;
  for(const Point_3& p : points)
    radius = (std::max)(radius, squared_distance(p, origin));
  radius = std::sqrt(radius);
  if(!(radius > 0))
    return 0;

  // the entries of the normal equations are moments of the points, in units of the radius
  const std::array<Vector_3, 2> tangents = tangent_frame(axis);
  const double scale = 1 / radius;
  double m00=0, m10=0, m01=0, m20=0, m11=0, m02=0, m30=0, m21=0, m12=0, m03=0, m40=0, m31=0, m22=0, m13=0, m04=0;
  Vector rhs = Vector::Zero();
  for(const Point_3& p : points)
  {
    const Vector_3 d = scale * (p - origin);
    const double w = std::exp(-std::sqrt(d.squared_length()));
    const double u = d * tangents[0], v = d * tangents[1], wh = w * (d * axis);
    const double uu = u*u, uv = u*v, vv = v*v;
    const double wuu = w*uu, wuv = w*uv, wvv = w*vv;
    m00 += w;       m10 += w*u;      m01 += w*v;
    m20 += wuu;     m11 += wuv;      m02 += wvv;
    m30 += wuu*u;   m21 += wuu*v;    m12 += wvv*u;    m03 += wvv*v;
    m40 += wuu*uu;  m31 += wuu*uv;   m22 += wuu*vv;   m13 += wuv*vv;  m04 += wvv*vv;
    rhs += wh * (Vector() << uu, uv, vv, u, v, 1).finished();
  }

  // the constant term comes last: the smallest leading block that is singular tells what is not determined
  const auto solve = [radius](const auto& matrix, const auto& rhs, double& height)
  {
    const Eigen::LLT<typename std::decay<decltype(matrix)>::type> llt(matrix);
    // a pivot is the squared distance of a column from the span of those before it
    const bool is_regular = (llt.info() == Eigen::Success)
      && (llt.matrixLLT().diagonal().array().square() > 1e-8 * matrix.diagonal().array()).all();
    if(is_regular)
      height = radius * llt.solve(rhs).eval()[rhs.size() - 1];
    return is_regular;
  };

  double height = 0;
  if(points.size() >= 6)
  {
    Matrix matrix;
    matrix << m40, m31, m22, m30, m21, m20,
              m31, m22, m13, m21, m12, m11,
              m22, m13, m04, m12, m03, m02,
              m30, m21, m12, m20, m11, m10,
              m21, m12, m03, m11, m02, m01,
              m20, m11, m02, m10, m01, m00;
    if(solve(matrix, rhs, height))
      return height;
  }
  Eigen::Matrix3d matrix;
  matrix << m20, m11, m10,
            m11, m02, m01,
            m10, m01, m00;
  solve(matrix, Eigen::Vector3d(rhs.tail<3>()), height);
  return height;
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_SURFACE_FIT_H
