// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_PARALLEL_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_PARALLEL_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// calls `body(first, last)` on subranges that together cover [0, n).
// `body` may write only to what belongs to its own indices: results then do not depend on the partition.
// With threads, a subrange holds at least about half of `grain_size` indices
template <typename ConcurrencyTag, typename Body>
void for_each_block(const std::size_t n, const Body& body, const std::size_t grain_size = 256)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
  {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain_size),
                      [&body](const tbb::blocked_range<std::size_t>& r) { body(r.begin(), r.end()); });
    return;
  }
#else
  static_cast<void>(grain_size);
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "CGAL::Parallel_tag asks for TBB, which is not available.");
#endif
  if(n != 0)
    body(std::size_t(0), n);
}

// calls `body(i)` for each i in [0, n)
template <typename ConcurrencyTag, typename Body>
void for_each_index(const std::size_t n, const Body& body)
{
  for_each_block<ConcurrencyTag>(n, [&body](const std::size_t first, const std::size_t last)
  {
    for(std::size_t i=first; i<last; ++i)
      body(i);
  });
}

// the sum of `summand(i)` over [0, n), added up in an order that depends on n alone
template <typename ConcurrencyTag, typename Summand>
double sum(const std::size_t n, const Summand& summand)
{
  const std::size_t block_size = 4096;
  const std::size_t number_of_blocks = (n + block_size - 1) / block_size;
  std::vector<double> partial_sums(number_of_blocks);
  for_each_index<ConcurrencyTag>(number_of_blocks, [&](const std::size_t b)
  {
    double s = 0;
    for(std::size_t i = b*block_size, end = (std::min)(n, (b+1)*block_size); i<end; ++i)
      s += summand(i);
    partial_sums[b] = s;
  });
  double s = 0;
  for(const double p : partial_sums)
    s += p;
  return s;
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_PARALLEL_H
