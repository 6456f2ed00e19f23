// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Costs, in operations counted rather than seconds, and what the shortcut of the convergence test may not get wrong.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_denoising/anisotropic_neighborhood.h>
#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/internal/Hausdorff_test.h>
#include <CGAL/Surface_mesh_denoising/internal/Mesh_io.h>

#include <CGAL/Polygon_mesh_processing/distance.h>

#include <gtest/gtest.h>

#include <iterator>
#include <new>
#include <cstdlib>

// all that is allocated with new, in bytes
static std::size_t allocated_bytes = 0;

// inlined, compilers would take the calls below them for a mismatch
[[gnu::noinline]] void* operator new(const std::size_t size)
{
  allocated_bytes += size;
  if(void* p = std::malloc(size))
    return p;
  throw std::bad_alloc();
}

[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

// the points of a mesh; counts how often they are read
struct Counting_point_map
{
  typedef Vertex                           key_type;
  typedef Point                            value_type;
  typedef const Point&                     reference;
  typedef boost::readable_property_map_tag category;

  const Mesh* mesh;
  std::size_t* number_of_reads;

  friend const Point& get(const Counting_point_map& map, const Vertex v)
  {
    ++*map.number_of_reads;
    return map.mesh->point(v);
  }
};

// a square grid in the plane, and the seed in its middle
struct Plane
{
  Mesh mesh;
  Face seed;

  explicit Plane(const unsigned int number_of_cells)
  {
    std::vector<std::vector<Vertex> > rows(number_of_cells + 1);
    for(unsigned int j=0; j<=number_of_cells; ++j)
      for(unsigned int i=0; i<=number_of_cells; ++i)
        rows[j].push_back(mesh.add_vertex(Point(double(i) - number_of_cells / 2, double(j) - number_of_cells / 2, 0)));
    for(unsigned int j=0; j<number_of_cells; ++j)
      for(unsigned int i=0; i<number_of_cells; ++i)
      {
        const Face f = mesh.add_face(rows[j][i], rows[j][i+1], rows[j+1][i+1]);
        mesh.add_face(rows[j][i], rows[j+1][i+1], rows[j+1][i]);
        if(i == number_of_cells / 2 && j == number_of_cells / 2)
          seed = f;
      }
  }
};

TEST(Cost, A_neighborhood_costs_the_same_in_a_mesh_of_any_size)
{
  struct Cost
  {
    std::size_t reads, bytes;
  };
  const auto cost_of_neighborhood = [](const unsigned int number_of_cells, const std::size_t size)
  {
    const Plane plane(number_of_cells);
    std::vector<Face> found;
    found.reserve(size);
    Cost cost = { 0, allocated_bytes };
    SMD::anisotropic_neighborhood(plane.seed, plane.mesh, std::back_inserter(found),
                                  params::neighborhood_size(size)
                                         .vertex_point_map(Counting_point_map{&plane.mesh, &cost.reads}));
    cost.bytes = allocated_bytes - cost.bytes;
    EXPECT_EQ(found.size(), size);
    return cost;
  };
  for(const std::size_t size : { 10, 40, 160 })
  {
    const Cost small = cost_of_neighborhood(32, size); // 1 thousand vertices
    EXPECT_GT(small.reads, size);
    for(const unsigned int number_of_cells : { 100, 316 }) // 10 and 100 thousand
    {
      const Cost large = cost_of_neighborhood(number_of_cells, size);
      EXPECT_EQ(large.reads, small.reads);
      EXPECT_EQ(large.bytes, small.bytes);
    }
    // proportional to the size of the neighborhood
    EXPECT_LT(small.reads, 150 * size);
    EXPECT_LT(small.bytes, 1000 * (size + 10));
  }
}

// an indexed mesh, as the functions see it
SMD::Indexed_triangle_mesh indexed(const Mesh& mesh)
{
  return SMD::internal::read_mesh(vertices(mesh), mesh, get(CGAL::vertex_point, mesh),
                                  params::default_values()).take_mesh();
}

std::vector<Vector> unit_normals(const Mesh& mesh)
{
  std::vector<Vector> normals;
  for(const Face f : faces(mesh))
    normals.push_back(normal_of(mesh, f));
  return normals;
}

TEST(Cost, A_search_meets_at_most_two_new_faces_for_each_that_it_settles)
{
  const Mesh noisy = noisy_mesh(generated_models::cylinder, 1000, 0.3);
  const SMD::Indexed_triangle_mesh mesh = indexed(noisy);
  const std::vector<Vector> normals = unit_normals(noisy);
  std::vector<std::array<SMD::internal::Dual_edge, 3> > edges;
  const SMD::internal::Indexed_dual_graph dual(mesh, normals, 200, edges, CGAL::Sequential_tag());
  SMD::internal::Neighborhood_search<SMD::internal::Indexed_dual_graph> search(dual);
  for(const std::size_t n : { 1, 2, 10, 40, 100 })
    for(std::size_t seed=0; seed<num_faces(noisy); seed += 7)
    {
      EXPECT_EQ(search(SMD::Indexed_triangle_mesh::Index(seed), n).size(), n);
      EXPECT_LE(search.number_of_met_faces(), 2*n + 2);
      EXPECT_GE(search.number_of_met_faces(), n);
    }
}

TEST(Cost, Memory_is_linear_in_the_size_of_the_mesh)
{
  const auto bytes_per_vertex = [](const std::size_t number_of_vertices)
  {
    Mesh mesh = noisy_mesh(generated_models::sphere, number_of_vertices, 0.2);
    const std::size_t before = allocated_bytes;
    SMD::denoise_anisotropic_fitting(mesh, params::number_of_iterations(2));
    return double(allocated_bytes - before) / double(num_vertices(mesh));
  };
  const double small = bytes_per_vertex(1000), large = bytes_per_vertex(20000);
  EXPECT_LT(large, 1.1 * small);
}

// a vertex with very many faces: to look at all pairs of these would not end
TEST(Cost, Faces_around_faces_are_linear_in_the_size_of_the_mesh)
{
  const unsigned int n = 100000;
  std::vector<Point> points(1, Point(0, 0, 1));
  for(unsigned int i=0; i<n; ++i)
  {
    const double angle = 2 * generated_models::pi * i / n;
    points.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  typedef SMD::Indexed_triangle_mesh::Index Index;
  std::vector<std::array<Index, 3> > triangles, neighbors;
  const Index none = SMD::Indexed_triangle_mesh::null_index();
  for(Index i=0; i<n; ++i)
  {
    triangles.push_back({{ 0, 1 + i, 1 + (i+1) % n }});
    neighbors.push_back({{ (i + n - 1) % n, none, (i+1) % n }});
  }
  const SMD::Indexed_triangle_mesh fan(points, triangles, neighbors);
  for(Index f=0; f<n; ++f)
    ASSERT_LT(fan.faces_around_face(f).size(), 40u);
}

// ---- the convergence test

// PMP's distance of the meshes as a whole
bool is_larger(const Mesh& a, const Mesh& b, const double bound)
{
  typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Exact_mesh;
  const auto copy = [](const Mesh& mesh)
  {
    Exact_mesh result;
    for(const Vertex v : vertices(mesh))
      result.add_vertex(Exact_mesh::Point(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()));
    for(const Face f : faces(mesh))
    {
      const std::array<Vertex, 3> t = vertices_of(mesh, f);
      result.add_face(Exact_mesh::Vertex_index(t[0]), Exact_mesh::Vertex_index(t[1]), Exact_mesh::Vertex_index(t[2]));
    }
    return result;
  };
  const Exact_mesh c = copy(a), d = copy(b);
  return CGAL::Polygon_mesh_processing::bounded_error_symmetric_Hausdorff_distance<CGAL::Sequential_tag>(
           c, d, 0.01 * bound) > bound;
}

TEST(Convergence_test, Agrees_with_the_distance_of_the_whole_meshes)
{
  int number_of_answers[2] = { 0, 0 };
  for(const auto generate : { generated_models::cube, generated_models::sphere })
  {
    const Mesh before = irregular_mesh(generate, 300);
    const SMD::Indexed_triangle_mesh mesh = indexed(before);
    // in the coordinates of the indexed mesh
    Mesh normalized = before;
    for(const Vertex v : vertices(before))
      normalized.point(v) = mesh.point(v);
    const double length = mean_edge_length(normalized), bound = 0.05 * length;

    for(unsigned int i=0; i<8; ++i)
    {
      // a vertex moves, in its surface or out of it, by more than the bound
      Mesh after = normalized;
      const Vertex v(20 * i + 3);
      const bool along_the_surface = (i % 2 == 0);
      const Face f = after.face(after.halfedge(v));
      const Vector n = normal_of(after, f);
      const std::array<Vertex, 3> t = vertices_of(after, f);
      const Vector tangent = (after.point(t[1]) - after.point(t[0])) / distance(after.point(t[1]), after.point(t[0]));
      after.point(v) = after.point(v) + 3 * bound * (along_the_surface ? tangent : n);

      const bool expected = is_larger(normalized, after, bound);
      EXPECT_EQ(SMD::internal::Hausdorff_test<CGAL::Sequential_tag>::is_distance_larger(mesh, points_of(normalized), points_of(after), bound),
                expected);
      ++number_of_answers[expected];
    }
  }
  // the test has seen both
  EXPECT_GT(number_of_answers[false], 0);
  EXPECT_GT(number_of_answers[true], 0);
}

TEST(Convergence_test, A_mesh_of_which_much_moves_has_not_converged)
{
  const Mesh before = irregular_mesh(generated_models::sphere, 300);
  const SMD::Indexed_triangle_mesh mesh = indexed(before);
  std::vector<Point> after;
  for(const Point& p : mesh.points())
    after.push_back(p + Vector(1, 0, 0));
  EXPECT_TRUE(SMD::internal::Hausdorff_test<CGAL::Sequential_tag>::is_distance_larger(mesh, mesh.points(), after, 0.1));
  EXPECT_FALSE(SMD::internal::Hausdorff_test<CGAL::Sequential_tag>::is_distance_larger(mesh, mesh.points(), mesh.points(), 0.1));
}
