// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Surface_mesh_denoising/measure_error.h>

#include <CGAL/Surface_mesh_denoising/add_noise.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "generated_models.h"

#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace SMD = CGAL::Surface_mesh_denoising;
namespace models = generated_models;
namespace params = CGAL::parameters;

typedef CGAL::Simple_cartesian<double>          Kernel;
typedef Kernel::Point_3                         Point;
typedef CGAL::Surface_mesh<Point>               Mesh;
typedef Mesh::Vertex_index                      Vertex;

namespace {

const double pi = models::pi;

Mesh make_model(const std::string& name, const std::size_t number_of_vertices = 2000)
{
  models::Options options;
  options.number_of_vertices = number_of_vertices;
  return models::to_mesh<Mesh>(models::generate(name, options));
}

// n times n squares of side 1, each in two triangles, in the plane z = 0
Mesh make_plane(const std::size_t n = 10)
{
  Mesh mesh;
  CGAL::make_grid(n, n, mesh, true);
  return mesh;
}

template <typename Map>
Mesh transformed(const Mesh& mesh, const Map& map)
{
  Mesh result(mesh);
  for(const Vertex v : result.vertices())
    result.point(v) = map(result.point(v));
  return result;
}

Mesh translated(const Mesh& mesh, const double x, const double y, const double z)
{
  return transformed(mesh, [=](const Point& p) { return Point(p.x() + x, p.y() + y, p.z() + z); });
}

Mesh scaled(const Mesh& mesh, const double factor)
{
  return transformed(mesh, [=](const Point& p) { return Point(factor * p.x(), factor * p.y(), factor * p.z()); });
}

Mesh tilted(const Mesh& mesh, const double degrees)
{
  const double c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180);
  return transformed(mesh, [=](const Point& p) { return Point(p.x(), c * p.y() - s * p.z(), s * p.y() + c * p.z()); });
}

Mesh noisy(const Mesh& mesh)
{
  Mesh result(mesh);
  SMD::add_noise(result, params::noise_level(0.3));
  return result;
}

// ----- angles

TEST(Angular_error, of_a_tilted_plane_is_the_angle_of_tilt)
{
  const Mesh plane = make_plane();
  for(const double angle : { 1e-6, 10., 89., 91., 170. })
  {
    const SMD::Angular_error e = SMD::angular_error(tilted(plane, angle), plane);
    EXPECT_NEAR(e.mean, angle, 1e-12 * angle + 1e-13);
    EXPECT_NEAR(e.area_weighted_mean, angle, 1e-12 * angle + 1e-13);
    EXPECT_NEAR(e.maximum, angle, 1e-12 * angle + 1e-13);
    EXPECT_NEAR(e.mean_square, angle * angle, 1e-11 * angle * angle);
    EXPECT_NEAR(e.area_weighted_mean_square, angle * angle, 1e-11 * angle * angle);
    EXPECT_EQ(e.number_of_flipped_faces, angle > 90 ? 200u : 0u);
    EXPECT_EQ(e.number_of_unknown_faces, 0u);
  }
}

TEST(Angular_error, weights_by_the_areas_of_the_denoised_mesh)
{
  // two triangles with a common edge, the areas 1/2 and 3/2; the large one is turned by 90 degrees around the edge
  Mesh flat;
  const Vertex a = flat.add_vertex(Point(0, 0, 0)), b = flat.add_vertex(Point(1, 0, 0));
  flat.add_face(a, b, flat.add_vertex(Point(0, 1, 0)));
  const Vertex moved = flat.add_vertex(Point(0, -3, 0));
  flat.add_face(b, a, moved);
  Mesh bent(flat);
  bent.point(moved) = Point(0, 0, 3);

  const SMD::Angular_error e = SMD::angular_error(bent, flat);
  EXPECT_DOUBLE_EQ(e.mean, 45);
  EXPECT_DOUBLE_EQ(e.mean_square, 90 * 90 / 2.);
  EXPECT_DOUBLE_EQ(e.area_weighted_mean, 90 * 3 / 4.);
  EXPECT_DOUBLE_EQ(e.area_weighted_mean_square, 90 * 90 * 3 / 4.);
  EXPECT_DOUBLE_EQ(e.maximum, 90);
}

TEST(Angular_error, counts_a_face_whose_vertex_is_mirrored_as_flipped)
{
  const Mesh plane = make_plane();
  // the corner vertex that has one face only
  Mesh mirrored(plane);
  const auto corner = std::find_if(plane.vertices().begin(), plane.vertices().end(),
                                   [&](const Vertex v) { return plane.degree(v) == 2; });
  ASSERT_NE(corner, plane.vertices().end());
  const auto h = plane.halfedge(*corner);
  const auto inner = plane.is_border(h) ? plane.opposite(plane.next(h)) : h;
  const Point p = plane.point(plane.source(inner)), q = plane.point(plane.target(plane.next(inner)));
  mirrored.point(*corner) = p + (q - plane.point(*corner));

  EXPECT_EQ(SMD::number_of_flipped_faces(mirrored, plane), 1u);
  EXPECT_EQ(SMD::number_of_flipped_faces(plane, plane), 0u);
}

TEST(Angular_error, leaves_degenerate_faces_out_and_counts_them)
{
  const Mesh plane = tilted(make_plane(), 10);
  Mesh collapsed = make_plane();
  // the faces at the middle vertex that also have the neighbor to which it moves
  const auto h = collapsed.halfedge(collapsed.vertices().begin()[60]);
  collapsed.point(collapsed.target(h)) = collapsed.point(collapsed.source(h));

  for(const bool is_first : { true, false })
  {
    const SMD::Angular_error e = is_first ? SMD::angular_error(collapsed, plane) : SMD::angular_error(plane, collapsed);
    EXPECT_EQ(e.number_of_unknown_faces, 2u);
    EXPECT_NEAR(e.mean, 10, 1e-10);
    EXPECT_NEAR(e.area_weighted_mean, 10, 1e-10);
  }
  EXPECT_EQ(SMD::number_of_degenerate_faces(collapsed), 2u);
  EXPECT_EQ(SMD::number_of_degenerate_faces(plane), 0u);
}

TEST(Angular_error, is_not_a_number_if_no_face_has_a_normal)
{
  const Mesh plane = make_plane(2);
  const Mesh point = scaled(plane, 0);
  const SMD::Angular_error e = SMD::angular_error(point, plane);
  EXPECT_EQ(e.number_of_unknown_faces, 8u);
  for(const double value : { e.mean, e.mean_square, e.area_weighted_mean, e.area_weighted_mean_square, e.maximum })
    EXPECT_TRUE(std::isnan(value));
}

TEST(Angular_error, needs_corresponding_faces)
{
  EXPECT_THROW(SMD::angular_error(make_plane(3), make_plane(4)), std::invalid_argument);
}

// ----- distances from vertices

TEST(Vertex_distance_error, of_a_shifted_plane_is_the_shift)
{
  const Mesh plane = make_plane();
  const double mean_edge_length = (220 + 100 * std::sqrt(2.)) / 320;
  for(const double shift : { 1e-7, 0.25, 3. })
  {
    const SMD::Vertex_distance_error e = SMD::vertex_distance_error(translated(plane, 0, 0, shift), plane);
    for(const double value : { e.mean, e.root_mean_square, e.area_weighted_l2, e.maximum })
      EXPECT_NEAR(value, shift, 1e-12);
    EXPECT_NEAR(e.mean_edge_length, mean_edge_length, 1e-12);

    const SMD::Vertex_distance_error relative = e.in_mean_edge_lengths();
    for(const double value : { relative.mean, relative.root_mean_square, relative.area_weighted_l2, relative.maximum })
      EXPECT_NEAR(value, shift / mean_edge_length, 1e-12);
    EXPECT_NEAR(relative.mean_edge_length, 1, 1e-12);
  }
}

TEST(Vertex_distance_error, within_the_plane_is_zero)
{
  const Mesh plane = make_plane();
  const Mesh shrunk = transformed(plane, [](const Point& p) { return Point(0.9 * p.x() + 0.3, 0.8 * p.y() + 1, 0); });
  EXPECT_NEAR(SMD::vertex_distance_error(shrunk, plane).maximum, 0, 1e-14);
}

TEST(Vertex_distance_error, weights_a_vertex_by_the_areas_of_its_faces)
{
  // at the distance 1, one vertex of a single triangle has a third of the weight; a vertex without a face has none
  Mesh triangle;
  const Vertex moved = triangle.add_vertex(Point(0, 0, 0));
  triangle.add_face(moved, triangle.add_vertex(Point(4, 0, 0)), triangle.add_vertex(Point(0, 4, 0)));
  Mesh bent(triangle);
  bent.point(moved) = Point(0, 0, 1);
  bent.add_vertex(Point(100, 0, 0));

  const SMD::Vertex_distance_error e = SMD::vertex_distance_error(bent, triangle);
  EXPECT_DOUBLE_EQ(e.mean, 1 / 3.);
  EXPECT_DOUBLE_EQ(e.root_mean_square, std::sqrt(1 / 3.));
  EXPECT_DOUBLE_EQ(e.area_weighted_l2, std::sqrt(1 / 3.));
  EXPECT_DOUBLE_EQ(e.maximum, 1);

  // a second, flat triangle of the area of the first one: the weight of the vertex at the distance 1 is a sixth
  for(Mesh* m : { &triangle, &bent })
    m->add_face(m->add_vertex(Point(9, 0, 0)), m->add_vertex(Point(13, 0, 0)), m->add_vertex(Point(9, 4, 0)));
  const double bent_area = std::sqrt(72.), flat_area = 8;
  EXPECT_DOUBLE_EQ(SMD::vertex_distance_error(bent, triangle).area_weighted_l2,
                   std::sqrt(bent_area / (3 * (bent_area + flat_area))));
}

TEST(Vertex_distance_error, is_that_between_two_spheres_of_any_connectivity)
{
  const Mesh fine = make_model("sphere", 20000);
  for(const std::size_t n : { std::size_t(500), std::size_t(20000) })
  {
    const SMD::Vertex_distance_error e = SMD::vertex_distance_error(scaled(make_model("sphere", n), 1.1), fine);
    EXPECT_NEAR(e.mean, 0.1, 1e-3);
    EXPECT_NEAR(e.maximum, 0.1, 1e-3);
  }
}

TEST(Vertex_distance_error, ignores_degenerate_faces_of_the_ground_truth)
{
  const Mesh plane = make_plane();
  Mesh with_sliver(plane);
  with_sliver.add_face(with_sliver.add_vertex(Point(-5, 3, 1)), with_sliver.add_vertex(Point(5, 3, 1)),
                       with_sliver.add_vertex(Point(0, 3, 1)));
  EXPECT_NEAR(SMD::vertex_distance_error(translated(plane, 0, 0, 1), with_sliver).maximum, 1, 1e-14);
  EXPECT_THROW(SMD::vertex_distance_error(plane, scaled(plane, 0)), std::invalid_argument);
  EXPECT_THROW(SMD::vertex_distance_error(plane, Mesh()), std::invalid_argument);
}

// ----- distances between surfaces

TEST(Symmetric_distance, of_concentric_spheres_is_the_difference_of_the_radii)
{
  const Mesh sphere = make_model("sphere", 3000);
  const SMD::Symmetric_distance d = SMD::symmetric_distance(scaled(sphere, 1.1), sphere);
  EXPECT_NEAR(d.maximum, 0.1, 1e-3);
  EXPECT_NEAR(d.mean, 0.1, 1e-3);
  EXPECT_NEAR(d.root_mean_square, 0.1, 1e-3);
}

TEST(Symmetric_distance, of_shifted_spheres_is_the_shift_in_either_order)
{
  const Mesh sphere = make_model("sphere", 3000), shifted = translated(sphere, 0.3, 0, 0);
  for(const SMD::Symmetric_distance& d : { SMD::symmetric_distance(sphere, shifted),
                                           SMD::symmetric_distance(shifted, sphere) })
  {
    EXPECT_NEAR(d.maximum, 0.3, 1e-3);
    // for a small shift s it would be the mean of |s cos(angle)| over the sphere, s/2
    EXPECT_NEAR(d.mean, 0.15, 0.01);
  }
}

TEST(Symmetric_distance, sees_what_one_side_misses)
{
  // all of the small square lies on the large one, but not the other way around
  const Mesh large = make_plane(10);
  const Mesh small = transformed(large, [](const Point& p) { return Point(p.x() / 2, p.y() / 2, 0); });
  EXPECT_NEAR(SMD::vertex_distance_error(small, large).maximum, 0, 1e-14);
  EXPECT_NEAR(SMD::symmetric_distance(small, large).maximum, std::sqrt(50.), 1e-13);
  EXPECT_NEAR(SMD::symmetric_distance(large, small).maximum, std::sqrt(50.), 1e-13);
}

TEST(Symmetric_distance, has_a_histogram_of_shares)
{
  const Mesh plane = make_plane();
  const double unit = SMD::vertex_distance_error(plane, plane).mean_edge_length;

  // every distance is 0.35 units: the bin from 0.3 on
  SMD::Symmetric_distance d = SMD::symmetric_distance(translated(plane, 0, 0, 0.35 * unit), plane,
                                                      params::number_of_bins(5).bin_width(0.1));
  EXPECT_EQ(d.histogram, (std::vector<double>{ 0, 0, 0, 1, 0 }));
  EXPECT_NEAR(d.bin_width, 0.1 * unit, 1e-14);
  EXPECT_NEAR(d.in_mean_edge_lengths().bin_width, 0.1, 1e-14);

  // beyond the last bin
  d = SMD::symmetric_distance(translated(plane, 0, 0, 9), plane, params::number_of_bins(5).bin_width(0.1));
  EXPECT_EQ(d.histogram, (std::vector<double>{ 0, 0, 0, 0, 1 }));

  // the default: 50 bins of 0.02 mean edge lengths
  d = SMD::symmetric_distance(plane, plane);
  EXPECT_EQ(d.histogram.size(), 50u);
  EXPECT_EQ(d.histogram[0], 1);
  EXPECT_NEAR(d.bin_width, 0.02 * unit, 1e-14);
}

TEST(Symmetric_distance, samples_areas_evenly)
{
  // a plane that is hinged at a corner: the distance at x is proportional to x, and all bins are equal
  const double slope = 1e-3;
  const Mesh plane = make_plane(10);
  const Mesh hinged = transformed(plane, [=](const Point& p) { return Point(p.x(), p.y(), slope * p.x()); });
  const double unit = SMD::vertex_distance_error(plane, plane).mean_edge_length;
  const SMD::Symmetric_distance d
    = SMD::symmetric_distance(hinged, plane, params::number_of_points_on_faces(20000).number_of_bins(10)
                                                   .bin_width(slope / unit),
                              params::number_of_points_on_faces(20000));
  EXPECT_NEAR(d.mean, slope * 5, slope * 0.02);
  for(const double share : d.histogram)
    EXPECT_NEAR(share, 0.1, 0.005);
}

TEST(Symmetric_distance, depends_on_the_seed_only_in_its_samples)
{
  const Mesh sphere = make_model("sphere"), other = noisy(sphere);
  const SMD::Symmetric_distance a = SMD::symmetric_distance(other, sphere, params::random_seed(1)),
                                b = SMD::symmetric_distance(other, sphere, params::random_seed(1)),
                                c = SMD::symmetric_distance(other, sphere, params::random_seed(2));
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_NE(a.mean, c.mean);
  EXPECT_NEAR(a.mean / c.mean, 1, 0.02);
}

TEST(Symmetric_distance, refuses_parameters_out_of_range_and_names_them)
{
  const Mesh plane = make_plane(2);
  const auto expect_refusal = [&](const auto& np1, const auto& np2, const std::string& name)
  {
    try
    {
      SMD::symmetric_distance(plane, plane, np1, np2);
      ADD_FAILURE() << name << " was accepted";
    }
    catch(const std::invalid_argument& e)
    {
      EXPECT_NE(std::string(e.what()).find(name), std::string::npos) << e.what();
    }
  };
  const auto none = params::default_values();
  expect_refusal(params::number_of_bins(0), none, "number_of_bins");
  expect_refusal(params::number_of_bins(-3), none, "number_of_bins");
  expect_refusal(params::bin_width(0.), none, "bin_width");
  expect_refusal(params::bin_width(std::numeric_limits<double>::quiet_NaN()), none, "bin_width");
  expect_refusal(params::number_of_points_on_faces(0), none, "number_of_points_on_faces");
  expect_refusal(none, params::number_of_points_on_faces(0), "number_of_points_on_faces");
}

// ----- volumes

TEST(Relative_volume_change, of_a_scaled_mesh_is_the_cube_of_the_factor)
{
  for(const std::string name : { "cube", "cut_sphere", "torus" })
  {
    const Mesh mesh = translated(make_model(name), 5, -7, 9);
    EXPECT_NEAR(SMD::relative_volume_change(scaled(mesh, 1.1), mesh), 1.1 * 1.1 * 1.1 - 1, 1e-12);
    EXPECT_NEAR(SMD::relative_volume_change(scaled(mesh, 0.5), mesh), 0.125 - 1, 1e-12);
  }
}

TEST(Relative_volume_change, closes_borders_by_triangles_to_their_centroids)
{
  // a box without its lid: closed by its plane, it has the volume of the box; stretching it by a tenth adds a tenth
  Mesh open = make_model("cube");
  for(const auto f : open.faces())
  {
    const auto h = open.halfedge(f);
    const bool is_lid = open.point(open.source(h)).z() == 1 && open.point(open.target(h)).z() == 1
      && open.point(open.target(open.next(h))).z() == 1;
    if(is_lid)
      CGAL::Euler::remove_face(h, open);
  }
  open.collect_garbage();
  ASSERT_FALSE(CGAL::is_closed(open));

  EXPECT_NEAR(SMD::relative_volume_change(open, make_model("cube")), 0, 1e-12);
  const Mesh stretched = transformed(open, [](const Point& p) { return Point(p.x(), p.y(), 1.1 * p.z()); });
  EXPECT_NEAR(SMD::relative_volume_change(stretched, open), 0.1, 1e-12);
  EXPECT_NEAR(SMD::relative_volume_change(translated(open, 10, 20, 30), open), 0, 1e-12);
}

// ----- everything at once

bool are_equal(const SMD::Denoising_error& a, const SMD::Denoising_error& b)
{
  return a.angular.mean == b.angular.mean && a.angular.mean_square == b.angular.mean_square
      && a.angular.area_weighted_mean == b.angular.area_weighted_mean
      && a.angular.area_weighted_mean_square == b.angular.area_weighted_mean_square
      && a.angular.maximum == b.angular.maximum
      && a.angular.number_of_flipped_faces == b.angular.number_of_flipped_faces
      && a.angular.number_of_unknown_faces == b.angular.number_of_unknown_faces
      && a.vertex_distance.mean == b.vertex_distance.mean
      && a.vertex_distance.root_mean_square == b.vertex_distance.root_mean_square
      && a.vertex_distance.area_weighted_l2 == b.vertex_distance.area_weighted_l2
      && a.vertex_distance.maximum == b.vertex_distance.maximum
      && a.symmetric_distance.maximum == b.symmetric_distance.maximum
      && a.symmetric_distance.mean == b.symmetric_distance.mean
      && a.symmetric_distance.root_mean_square == b.symmetric_distance.root_mean_square
      && a.symmetric_distance.histogram == b.symmetric_distance.histogram
      && a.relative_volume_change == b.relative_volume_change
      && a.number_of_degenerate_faces == b.number_of_degenerate_faces;
}

TEST(Measure_error, is_made_of_the_single_measures)
{
  const Mesh mesh = make_model("cut_sphere"), other = noisy(mesh);
  SMD::Denoising_error e;
  e.angular = SMD::angular_error(other, mesh);
  e.vertex_distance = SMD::vertex_distance_error(other, mesh);
  e.symmetric_distance = SMD::symmetric_distance(other, mesh);
  e.relative_volume_change = SMD::relative_volume_change(other, mesh);
  e.number_of_degenerate_faces = SMD::number_of_degenerate_faces(other);
  EXPECT_TRUE(are_equal(SMD::measure_error(other, mesh), e));
  EXPECT_EQ(SMD::number_of_flipped_faces(other, mesh), e.angular.number_of_flipped_faces);
}

TEST(Measure_error, of_a_mesh_against_itself_is_zero)
{
  const Mesh mesh = translated(make_model("cad_part"), 100, 200, -50);
  const SMD::Denoising_error e = SMD::measure_error(mesh, mesh);
  EXPECT_EQ(e.angular.maximum, 0);
  EXPECT_NEAR(e.vertex_distance.maximum, 0, 1e-13);
  EXPECT_NEAR(e.symmetric_distance.maximum, 0, 1e-13);
  EXPECT_EQ(e.relative_volume_change, 0);
  EXPECT_EQ(e.number_of_degenerate_faces, 0u);
}

TEST(Measure_error, is_the_same_in_parallel)
{
  const Mesh mesh = make_model("cut_sphere", 10000), other = noisy(mesh);
  EXPECT_TRUE(are_equal(SMD::measure_error(other, mesh),
                        SMD::measure_error<CGAL::Parallel_if_available_tag>(other, mesh)));
}

TEST(Measure_error, is_invariant_under_rigid_motions_and_scale)
{
  const Mesh mesh = make_model("cut_sphere"), other = noisy(mesh);
  const auto move = [](const Mesh& m) { return translated(scaled(tilted(m, 33), 1e4), 3e5, -2e5, 7e4); };
  const SMD::Denoising_error a = SMD::measure_error(other, mesh), b = SMD::measure_error(move(other), move(mesh));
  EXPECT_NEAR(b.angular.mean, a.angular.mean, 1e-8);
  EXPECT_EQ(b.angular.number_of_flipped_faces, a.angular.number_of_flipped_faces);
  EXPECT_NEAR(b.vertex_distance.mean, 1e4 * a.vertex_distance.mean, 1e-8);
  EXPECT_NEAR(b.vertex_distance.in_mean_edge_lengths().area_weighted_l2,
              a.vertex_distance.in_mean_edge_lengths().area_weighted_l2, 1e-10);
  EXPECT_NEAR(b.symmetric_distance.maximum, 1e4 * a.symmetric_distance.maximum, 1e-7);
  EXPECT_NEAR(b.relative_volume_change, a.relative_volume_change, 1e-10);
}

TEST(Measure_error, takes_coordinates_of_any_size)
{
  const Mesh mesh = make_model("cut_sphere"), other = noisy(mesh);
  const double expected = SMD::measure_error(other, mesh).vertex_distance.in_mean_edge_lengths().mean;
  for(const double size : { 1e-200, 1e200 })
  {
    const SMD::Denoising_error e = SMD::measure_error(scaled(other, size), scaled(mesh, size));
    EXPECT_NEAR(e.vertex_distance.in_mean_edge_lengths().mean, expected, 1e-12);
    EXPECT_EQ(e.number_of_degenerate_faces, 0u);
  }
}

TEST(Measure_error, refuses_bad_meshes)
{
  const Mesh plane = make_plane(2);
  Mesh quads;
  CGAL::make_grid(2, 2, quads);
  EXPECT_THROW(SMD::measure_error(quads, plane), std::invalid_argument);
  Mesh not_finite(plane);
  not_finite.point(Vertex(0)) = Point(std::numeric_limits<double>::infinity(), 0, 0);
  EXPECT_THROW(SMD::measure_error(plane, not_finite), std::invalid_argument);
}

TEST(Measure_error, takes_point_maps_over_one_mesh)
{
  Mesh mesh = make_model("cut_sphere");
  const Mesh other = noisy(mesh);
  auto noisy_points = mesh.add_property_map<Vertex, Point>("v:noisy").first;
  for(const Vertex v : mesh.vertices())
    noisy_points[v] = other.point(v);
  EXPECT_TRUE(are_equal(SMD::measure_error(mesh, mesh, params::vertex_point_map(noisy_points)),
                        SMD::measure_error(other, mesh)));
}

// ----- any mesh, any kernel

template <typename TriangleMesh>
class Measure_error_of : public testing::Test {};

typedef testing::Types<CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>,
                       CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>,
                       CGAL::Polyhedron_3<Kernel>,
                       CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3> > Other_meshes;
TYPED_TEST_SUITE(Measure_error_of, Other_meshes);

TYPED_TEST(Measure_error_of, any_mesh_is_the_same)
{
  models::Options options;
  options.number_of_vertices = 1000;
  const models::Model model = models::cut_sphere(options);
  const Mesh mesh = models::to_mesh<Mesh>(model), other = noisy(mesh);
  const TypeParam mesh_of_type = models::to_mesh<TypeParam>(model);
  TypeParam other_of_type(mesh_of_type);
  SMD::add_noise(other_of_type, params::noise_level(0.3));

  const SMD::Denoising_error expected = SMD::measure_error(other, mesh);
  for(const SMD::Denoising_error& e : { SMD::measure_error(other_of_type, mesh_of_type),
                                        SMD::measure_error(other_of_type, mesh) })
  {
    EXPECT_NEAR(e.angular.mean, expected.angular.mean, 1e-3);
    EXPECT_NEAR(e.vertex_distance.mean, expected.vertex_distance.mean, 1e-6);
    EXPECT_NEAR(e.symmetric_distance.maximum, expected.symmetric_distance.maximum, 1e-6);
    EXPECT_NEAR(e.relative_volume_change, expected.relative_volume_change, 1e-5);
  }
}

} // namespace
