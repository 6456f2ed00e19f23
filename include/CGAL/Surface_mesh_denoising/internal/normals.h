// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_INTERNAL_NORMALS_H
#define CGAL_SURFACE_MESH_DENOISING_INTERNAL_NORMALS_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {
namespace internal {

// `v` with length one, or `otherwise` if `v` is null
inline Indexed_triangle_mesh::Vector_3 normalized_or(const Indexed_triangle_mesh::Vector_3& v,
                                                     const Indexed_triangle_mesh::Vector_3& otherwise)
{
  const double length = std::sqrt(v.squared_length());
  return (length > 0) ? v / length : otherwise;
}

// `v` with length one, or the null vector if `v` is null
inline Indexed_triangle_mesh::Vector_3 normalized_or_null(const Indexed_triangle_mesh::Vector_3& v)
{
  return normalized_or(v, Indexed_triangle_mesh::Vector_3(0, 0, 0));
}

inline bool is_null(const Indexed_triangle_mesh::Vector_3& v)
{
  return v.x() == 0 && v.y() == 0 && v.z() == 0;
}

// the part of `v` across the unit normal `n`
inline Indexed_triangle_mesh::Vector_3 along_surface(const Indexed_triangle_mesh::Vector_3& v,
                                                     const Indexed_triangle_mesh::Vector_3& n)
{
  return v - (v * n) * n;
}

// the normals and areas of the faces. A degenerate face has the area zero, and the normal of the faces around it
template <typename ConcurrencyTag>
void compute_face_normals(const Indexed_triangle_mesh& mesh,
                          std::vector<Indexed_triangle_mesh::Vector_3>& normals,
                          std::vector<double>& areas)
{
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;

  normals.resize(mesh.number_of_faces());
  areas.resize(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(mesh.number_of_faces(), [&](const std::size_t f)
  {
    const Vector_3 n = mesh.area_vector(f);
    const double length = std::sqrt(n.squared_length());
    const double longest_edge = mesh.longest_edge_length(f);
    // below this the cross product consists of rounding errors
    const bool is_degenerate = !(length > 1e-14 * longest_edge * (longest_edge + 1e-2));
    areas[f] = is_degenerate ? 0 : 0.5 * length;
    normals[f] = is_degenerate ? Vector_3(0, 0, 0) : n / length;
  });

  std::vector<Indexed_triangle_mesh::Index> unknown;
  for(std::size_t f=0; f<normals.size(); ++f)
    if(is_null(normals[f]))
      unknown.push_back(Indexed_triangle_mesh::Index(f));

  // from the known into the unknown, a ring of faces at a time
  const int max_number_of_rings = 8;
  std::vector<Vector_3> found;
  for(int ring=0; ring<max_number_of_rings && !unknown.empty(); ++ring)
  {
    found.clear();
    for(const Indexed_triangle_mesh::Index f : unknown)
    {
      Vector_3 n(0, 0, 0);
      for(const Indexed_triangle_mesh::Index g : mesh.faces_around_face(f))
        n += (areas[g] > 0 ? areas[g] : 1e-100) * normals[g];
      found.push_back(normalized_or_null(n));
    }
    std::size_t number_of_unknown = 0;
    for(std::size_t i=0; i<unknown.size(); ++i)
    {
      normals[unknown[i]] = found[i];
      if(is_null(found[i]))
        unknown[number_of_unknown++] = unknown[i];
    }
    unknown.resize(number_of_unknown);
  }
}

// the area-weighted mean of the normals of the faces incident to each vertex, null where it has no direction
template <typename ConcurrencyTag>
void compute_vertex_normals(const Indexed_triangle_mesh& mesh,
                            const std::vector<Indexed_triangle_mesh::Vector_3>& face_normals,
                            const std::vector<double>& areas,
                            std::vector<Indexed_triangle_mesh::Vector_3>& normals)
{
  normals.resize(mesh.number_of_vertices());
  for_each_index<ConcurrencyTag>(mesh.number_of_vertices(), [&](const std::size_t v)
  {
    Indexed_triangle_mesh::Vector_3 n(0, 0, 0);
    for(const Indexed_triangle_mesh::Index f : mesh.faces_around_vertex(v))
      n += areas[f] * face_normals[f];
    normals[v] = normalized_or_null(n);
  });
}

// the area-weighted vertex normals of the mesh as it is
template <typename ConcurrencyTag>
void compute_vertex_normals(const Indexed_triangle_mesh& mesh, std::vector<Indexed_triangle_mesh::Vector_3>& normals)
{
  std::vector<Indexed_triangle_mesh::Vector_3> face_normals;
  std::vector<double> areas;
  compute_face_normals<ConcurrencyTag>(mesh, face_normals, areas);
  compute_vertex_normals<ConcurrencyTag>(mesh, face_normals, areas, normals);
}

// that of face `f`, as `Indexed_triangle_mesh::area_vector()`, with the vertices at `points`
inline Indexed_triangle_mesh::Vector_3 area_vector(const Indexed_triangle_mesh& mesh, const std::size_t f,
                                                   const std::vector<Indexed_triangle_mesh::Point_3>& points)
{
  const std::array<Indexed_triangle_mesh::Index, 3>& t = mesh.vertices(f);
  return cross_product(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
}

// The area vectors of the faces around a face, without its own, summed up, and their areas
struct Surroundings
{
  Indexed_triangle_mesh::Vector_3 area_vector;
  double area;

  Surroundings& operator+=(const Surroundings& other)
  {
    area_vector += other.area_vector;
    area += other.area;
    return *this;
  }

  // whether that sum is as long as this share of the area: less than that, as at an edge, tells no side of the surface
  bool agree(const double share) const { return area_vector.squared_length() > share * share * area * area; }
};

inline Surroundings surroundings(const Indexed_triangle_mesh& mesh, const std::size_t f,
                                 const std::vector<Indexed_triangle_mesh::Vector_3>& normals,
                                 const std::vector<double>& areas)
{
  Surroundings s = { Indexed_triangle_mesh::Vector_3(0, 0, 0), 0 };
  for(const Indexed_triangle_mesh::Index g : mesh.faces_around_face(f))
  {
    s.area_vector += areas[g] * normals[g];
    s.area += areas[g];
  }
  return s;
}

// gives faces that face against their surroundings the normal of these
template <typename ConcurrencyTag>
void replace_turned_normals(const Indexed_triangle_mesh& mesh, const std::vector<double>& areas,
                            const double agreement, std::vector<Indexed_triangle_mesh::Vector_3>& normals)
{
  std::vector<Indexed_triangle_mesh::Vector_3> replaced(normals.size());
  for_each_index<ConcurrencyTag>(normals.size(), [&](const std::size_t f)
  {
    const Surroundings around = surroundings(mesh, f, normals, areas);
    replaced[f] = (normals[f] * around.area_vector < 0 && around.agree(agreement))
                ? normalized_or(around.area_vector, normals[f]) : normals[f];
  });
  normals.swap(replaced);
}

// the distance of the longest edge of face `f` from the vertex opposite to it
inline double height_of_face(const Indexed_triangle_mesh& mesh, const std::size_t f, const std::vector<double>& areas)
{
  const double longest_edge = mesh.longest_edge_length(f);
  return (longest_edge > 0) ? 2 * areas[f] / longest_edge : 0;
}

// the mean height of these faces over their longest edges, zero if there are none; `area(f)` is the area of a face
template <typename Faces, typename Area>
double mean_height_of_faces(const Indexed_triangle_mesh& mesh, const Faces& faces, const Area& area)
{
  double sum_of_areas = 0, sum_of_lengths = 0;
  for(const auto f : faces)
  {
    sum_of_areas += area(f);
    sum_of_lengths += mesh.longest_edge_length(f);
  }
  return (sum_of_lengths > 0) ? 2 * sum_of_areas / sum_of_lengths : 0;
}

// Points that are off by `error` turn a face the further, the lower it is. So a face takes the normal of the faces across its
// edges, but for a share of its own that grows with its height, and is almost all where that is twice the error. More averages
// reach through rows of low faces
template <typename ConcurrencyTag>
void steady_normals_of_low_faces(const Indexed_triangle_mesh& mesh, const std::vector<double>& areas, const double error,
                                 const std::size_t number_of_averages,
                                 std::vector<Indexed_triangle_mesh::Vector_3>& normals)
{
  typedef Indexed_triangle_mesh::Index      Index;
  typedef Indexed_triangle_mesh::Vector_3   Vector_3;

  std::vector<double> shares(normals.size());
  for_each_index<ConcurrencyTag>(shares.size(), [&](const std::size_t f)
  {
    const double height = height_of_face(mesh, f, areas);
    shares[f] = (height > 0) ? 1 / (1 + std::pow(error / height, 4)) : 0;
  });
  const std::vector<Vector_3> own = normals;
  std::vector<Vector_3> averaged(normals.size());
  for(std::size_t k=0; k<number_of_averages; ++k)
  {
    for_each_index<ConcurrencyTag>(normals.size(), [&](const std::size_t f)
    {
      Vector_3 sum(0, 0, 0);
      for(int i=0; i<3; ++i)
      {
        const Index g = mesh.neighbors(f)[i];
        if(g == Indexed_triangle_mesh::null_index())
          continue;
        // those of low faces are their own until they have been averaged
        sum += (k == 0 ? shares[g] : 1.) * mesh.edge_length(f, i) * normals[g];
      }
      const Vector_3 around = normalized_or(sum, normals[f]);
      averaged[f] = normalized_or(shares[f] * own[f] + (1 - shares[f]) * around, normals[f]);
    });
    normals.swap(averaged);
  }
}

// for each face the mean of the normals of its vertices
template <typename ConcurrencyTag>
void average_vertex_normals(const Indexed_triangle_mesh& mesh,
                            const std::vector<Indexed_triangle_mesh::Vector_3>& vertex_normals,
                            std::vector<Indexed_triangle_mesh::Vector_3>& face_normals)
{
  face_normals.resize(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(mesh.number_of_faces(), [&](const std::size_t f)
  {
    const std::array<Indexed_triangle_mesh::Index, 3>& t = mesh.vertices(f);
    face_normals[f] = normalized_or_null(vertex_normals[t[0]] + vertex_normals[t[1]] + vertex_normals[t[2]]);
  });
}

// the face incident to vertex `v` whose normal is closest to `normal`, or null if there is none
inline Indexed_triangle_mesh::Index closest_normal(const Indexed_triangle_mesh& mesh,
                                                   const std::vector<Indexed_triangle_mesh::Vector_3>& face_normals,
                                                   const std::size_t v,
                                                   const Indexed_triangle_mesh::Vector_3& normal)
{
  // faces with the same surroundings come to have the same normal but for rounding: the largest of them counts
  double largest_cosine = -2;
  for(const Indexed_triangle_mesh::Index f : mesh.faces_around_vertex(v))
    largest_cosine = (std::max)(largest_cosine, face_normals[f] * normal);
  Indexed_triangle_mesh::Index closest = Indexed_triangle_mesh::null_index();
  double largest_area = -1;
  for(const Indexed_triangle_mesh::Index f : mesh.faces_around_vertex(v))
  {
    if(face_normals[f] * normal < largest_cosine - 1e-6)
      continue;
    const double squared_area = mesh.area_vector(f).squared_length();
    if(squared_area > largest_area)
    {
      largest_area = squared_area;
      closest = f;
    }
  }
  return closest;
}

} // namespace internal
} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_INTERNAL_NORMALS_H
