// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_LOCAL_NUMBERING_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_LOCAL_NUMBERING_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// gives the elements of a small set indices from 0 on, in the order in which they come. Emptied in constant time
template <typename Element>
class Local_numbering
{
public:
  typedef std::uint32_t Local_index;

  std::size_t size() const { return m_size; }

  void clear()
  {
    m_size = 0;
    if(++m_generation == 0)
    {
      m_table.assign(m_table.size(), Entry());
      m_generation = 1;
    }
  }

  // the index of the element, and whether it is new
  std::pair<Local_index, bool> insert(const Element& element)
  {
    if(2 * (m_size + 1) > m_table.size())
      rehash(m_table.empty() ? 16 : 2 * m_table.size());

    Entry& entry = find(element);
    const bool is_new = (entry.generation != m_generation);
    if(is_new)
      entry = Entry{element, Local_index(m_size++), m_generation};
    return std::make_pair(entry.index, is_new);
  }

private:
  struct Entry
  {
    Element element;
    Local_index index;
    std::uint32_t generation = 0; // the entry counts if this is the current one
    Entry() {}
    Entry(const Element& element, const Local_index index, const std::uint32_t generation)
      : element(element), index(index), generation(generation) {}
  };

  Entry& find(const Element& element)
  {
    const std::size_t mask = m_table.size() - 1;
    // the standard library hashes an integer to itself, a pointer to an aligned address
    std::size_t i = std::size_t((std::uint64_t(std::hash<Element>()(element)) * 0x9E3779B97F4A7C15u) >> 32) & mask;
    while(m_table[i].generation == m_generation && !(m_table[i].element == element))
      i = (i + 1) & mask;
    return m_table[i];
  }

  void rehash(const std::size_t table_size)
  {
    std::vector<Entry> old(table_size);
    old.swap(m_table);
    for(const Entry& entry : old)
      if(entry.generation == m_generation)
        find(entry.element) = entry;
  }

  std::vector<Entry> m_table;
  std::size_t m_size = 0;
  std::uint32_t m_generation = 1;
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_LOCAL_NUMBERING_H
