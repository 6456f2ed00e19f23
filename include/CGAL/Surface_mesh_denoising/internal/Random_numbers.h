// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_RANDOM_NUMBERS_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_RANDOM_NUMBERS_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Random numbers that depend on the seed alone. The standard fixes the output of its engines, but not that of its
// distributions, and the logarithms and cosines of the usual transformations differ between mathematical libraries.
// Hence only comparisons, correctly rounded operations and integers here.
class Random_numbers
{
  typedef std::int64_t Integer;

public:
  explicit Random_numbers(const std::uint64_t seed) : m_engine(seed) {}

  // uniform in [0, 1)
  double uniform() { return double(m_engine() >> 11) / double(Integer(1) << 53); }

  // uniform in (-sqrt(3), sqrt(3)): mean 0, standard deviation 1
  double centered_uniform() { return std::sqrt(3.) * (2 * uniform() - 1); }

  // normal with mean 0 and standard deviation 1: C. F. F. Karney, Sampling exactly from the normal distribution,
  // ACM Transactions on Mathematical Software 42(1), 2016, algorithm N, on uniform numbers of 53 bits
  double gaussian()
  {
    for(;;)
    {
      int k = 0;
      while(bernoulli_exp_minus_half())
        ++k;
      if(!all_of(k * (k-1), [this]() { return bernoulli_exp_minus_half(); }))
        continue;

      const double x = uniform();
      const double q = (2*k + x) / (2*k + 2);
      if(!all_of(k + 1, [this, x, q]() { return bernoulli_exp_minus(x, q); }))
        continue;

      return (m_engine() & 1) ? -(k + x) : k + x;
    }
  }

  // uniform on the unit sphere
  std::array<double, 3> direction()
  {
    // odd integers in (-2^21, 2^21): symmetric, and never zero
    const Integer radius = Integer(1) << 21;
    for(;;)
    {
      const std::uint64_t bits = m_engine();
      std::array<Integer, 3> v;
      Integer squared_length = 0;
      for(int i=0; i<3; ++i)
      {
        v[i] = 2 * Integer((bits >> (21 * i)) & std::uint64_t(radius - 1)) + 1 - radius;
        squared_length += v[i] * v[i];
      }
      if(squared_length <= radius * radius)
      {
        const double length = std::sqrt(double(squared_length));
        return {{ double(v[0]) / length, double(v[1]) / length, double(v[2]) / length }};
      }
    }
  }

private:
  // true with probability exp(-x q): J. von Neumann's way, the parity of the length of a run
  bool bernoulli_exp_minus(const double x, const double q)
  {
    bool is_even = true;
    for(double last = x;;)
    {
      const double u = uniform();
      if(u >= last || uniform() >= q)
        return is_even;
      last = u;
      is_even = !is_even;
    }
  }

  bool bernoulli_exp_minus_half() { return bernoulli_exp_minus(0.5, 1); }

  template <typename Trial>
  static bool all_of(const int n, const Trial& trial)
  {
    for(int i=0; i<n; ++i)
      if(!trial())
        return false;
    return true;
  }

  std::mt19937_64 m_engine;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_RANDOM_NUMBERS_H
