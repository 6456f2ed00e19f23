// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_CHECK_PARAMETERS_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_CHECK_PARAMETERS_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// refuses exact number types
template <typename FT>
struct Require_floating_point
{
  static_assert(std::is_floating_point<FT>::value,
                "Surface_mesh_denoising needs a kernel with the number type float or double: roots and exponentials "
                "have no exact value, and exact numbers would grow with each iteration. "
                "Use for example Exact_predicates_inexact_constructions_kernel.");
  // the message is to be the only one
  typedef typename std::conditional<std::is_floating_point<FT>::value, FT, double>::type type;
};

template <typename T>
[[noreturn]] void throw_out_of_range(const char* name, const T& value, const std::string& range)
{
  std::ostringstream message;
  message.precision(17);
  message << "Surface_mesh_denoising: the parameter " << name << " is " << value << ", but must be " << range;
  throw std::invalid_argument(message.str());
}

// an integer of at least `least`
template <typename Integer>
std::size_t checked_count(const char* name, const Integer value, const std::size_t least)
{
  static_assert(std::is_integral<Integer>::value, "The parameter must be an integer.");
  if(value < Integer(0) || static_cast<std::size_t>(value) < least)
    throw_out_of_range(name, value, "at least " + std::to_string(least));
  return static_cast<std::size_t>(value);
}

// a finite number greater than zero
inline double checked_positive(const char* name, const double value)
{
  if(!(value > 0 && std::isfinite(value)))
    throw_out_of_range(name, value, "positive and finite");
  return value;
}

// a finite number of at least zero
inline double checked_not_negative(const char* name, const double value)
{
  if(!(value >= 0 && std::isfinite(value)))
    throw_out_of_range(name, value, "at least zero and finite");
  return value;
}

// a number in (0, 1)
inline double checked_open_unit_interval(const char* name, const double value)
{
  if(!(value > 0 && value < 1))
    throw_out_of_range(name, value, "in the range (0, 1)");
  return value;
}

// a number in (0, 1]
inline double checked_share(const char* name, const double value)
{
  if(!(value > 0 && value <= 1))
    throw_out_of_range(name, value, "in the range (0, 1]");
  return value;
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_CHECK_PARAMETERS_H
