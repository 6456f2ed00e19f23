// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_VECTOR_PAIR_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_VECTOR_PAIR_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>

#include <Eigen/Core>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Two numbers, and two vectors, that go through the same computation: Eigen then uses the vector instructions that any
// machine has. Templates take vectors and pairs of them alike.
typedef Eigen::Array2d Number_pair;

struct Vector_pair
{
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;

  Number_pair x, y, z;

  Vector_pair() {}
  Vector_pair(const Number_pair& x, const Number_pair& y, const Number_pair& z) : x(x), y(y), z(z) {}
  Vector_pair(const Vector_3& a, const Vector_3& b) : x(a.x(), b.x()), y(a.y(), b.y()), z(a.z(), b.z()) {}

  Vector_3 first() const { return Vector_3(x[0], y[0], z[0]); }
  Vector_3 second() const { return Vector_3(x[1], y[1], z[1]); }

  Number_pair squared_length() const { return x*x + y*y + z*z; }

  Vector_pair& operator+=(const Vector_pair& v)
  {
    x += v.x;
    y += v.y;
    z += v.z;
    return *this;
  }
};

inline Vector_pair operator+(const Vector_pair& v, const Vector_pair& w)
{ return Vector_pair(v.x + w.x, v.y + w.y, v.z + w.z); }
inline Vector_pair operator-(const Vector_pair& v, const Vector_pair& w)
{ return Vector_pair(v.x - w.x, v.y - w.y, v.z - w.z); }
inline Vector_pair operator*(const Number_pair& s, const Vector_pair& v)
{ return Vector_pair(s * v.x, s * v.y, s * v.z); }
inline Vector_pair operator*(const double s, const Vector_pair& v) { return Vector_pair(s * v.x, s * v.y, s * v.z); }
inline Vector_pair operator/(const Vector_pair& v, const double s) { return (1 / s) * v; }
inline Number_pair operator*(const Vector_pair& v, const Vector_pair& w) { return v.x*w.x + v.y*w.y + v.z*w.z; }

inline Vector_pair normalized_or(const Vector_pair& v, const Vector_pair& otherwise)
{
  const Number_pair squared_length = v.squared_length();
  if(squared_length[0] > 0 && squared_length[1] > 0)
    return squared_length.sqrt().inverse() * v;
  return Vector_pair(normalized_or(v.first(), otherwise.first()), normalized_or(v.second(), otherwise.second()));
}

inline const Indexed_triangle_mesh::Vector_3& to_vector(const Indexed_triangle_mesh::Vector_3& v) { return v; }
inline const Vector_pair& to_vector(const Vector_pair& v) { return v; }
inline Indexed_triangle_mesh::Vector_3 to_vector(const Indexed_triangle_mesh::Point_3& p) { return p - ORIGIN; }

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_VECTOR_PAIR_H
