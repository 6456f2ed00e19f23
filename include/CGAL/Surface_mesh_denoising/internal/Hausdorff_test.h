// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_HAUSDORFF_TEST_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_HAUSDORFF_TEST_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// Whether the Hausdorff distance between the mesh with the points `before` and with the points `after` is larger than `bound`. Where it
// cannot tell at a small cost the answer is yes.
//
// The connectivity is the same and faces are interpolated linearly: only the faces at vertices that moved further than `bound`
// can lie further than `bound` from the other mesh. For these, and the faces of two rings around them, PMP's routine decides.
//
// A template, so that only programs that call it pay for its compilation.
template <typename ConcurrencyTag>
class Hausdorff_test
{
  typedef Indexed_triangle_mesh::Index                      Index;
  typedef Indexed_triangle_mesh::Point_3                    Point_3;
  typedef Exact_predicates_inexact_constructions_kernel     Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3>               Patch;

public:
  static bool is_distance_larger(const Indexed_triangle_mesh& mesh,
                                 const std::vector<Point_3>& before, const std::vector<Point_3>& after,
                                 const double bound)
  {
    std::vector<std::pair<double, Index> > movers;
    for(std::size_t v=0; v<before.size(); ++v)
    {
      const double squared_displacement = squared_distance(before[v], after[v]);
      if(squared_displacement > bound * bound)
        movers.emplace_back(squared_displacement, Index(v));
    }

    // a mesh of which so much moves has not come to rest, whatever the direction
    const std::size_t max_number_of_movers = 16 + before.size() / 1000;
    if(movers.size() > max_number_of_movers)
      return true;

    // the one that moved furthest is the likeliest to decide
    std::sort(movers.begin(), movers.end(), std::greater<std::pair<double, Index> >());
    return std::any_of(movers.begin(), movers.end(), [&](const std::pair<double, Index>& mover)
    {
      std::vector<Index> surroundings(mesh.faces_around_vertex(mover.second).begin(),
                                      mesh.faces_around_vertex(mover.second).end());
      const std::vector<Index> star = surroundings;
      for(int ring=0; ring<2; ++ring)
        add_ring(mesh, surroundings);
      return is_one_sided_distance_larger(mesh, star, after, surroundings, before, bound)
          || is_one_sided_distance_larger(mesh, star, before, surroundings, after, bound);
    });
  }

private:
  static void add_ring(const Indexed_triangle_mesh& mesh, std::vector<Index>& faces)
  {
    const std::vector<Index> inner = faces;
    for(const Index f : inner)
      faces.insert(faces.end(), mesh.faces_around_face(f).begin(), mesh.faces_around_face(f).end());
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  }

  static bool is_one_sided_distance_larger(const Indexed_triangle_mesh& mesh,
                                           const std::vector<Index>& from, const std::vector<Point_3>& from_points,
                                           const std::vector<Index>& to, const std::vector<Point_3>& to_points,
                                           const double bound)
  {
    // is_Hausdorff_distance_larger() asserts an accuracy that it need not reach before it knows the answer
    return Polygon_mesh_processing::bounded_error_Hausdorff_distance<Sequential_tag>(
      make_patch(mesh, from, from_points), make_patch(mesh, to, to_points), 0.01 * bound) > bound;
  }

  // each face with vertices of its own: any set of faces makes a valid mesh
  static Patch make_patch(const Indexed_triangle_mesh& mesh, const std::vector<Index>& faces,
                          const std::vector<Point_3>& points)
  {
    Patch patch;
    for(const Index f : faces)
    {
      std::array<Patch::Vertex_index, 3> t;
      for(int i=0; i<3; ++i)
      {
        const Point_3& p = points[mesh.vertices(f)[i]];
        t[i] = patch.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
      }
      patch.add_face(t[0], t[1], t[2]);
    }
    return patch;
  }
};

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_HAUSDORFF_TEST_H
