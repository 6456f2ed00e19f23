// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

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
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace SMD = CGAL::Surface_mesh_denoising;
namespace models = generated_models;
namespace params = CGAL::parameters;

typedef CGAL::Simple_cartesian<double>          Kernel;
typedef Kernel::Point_3                         Point;
typedef Kernel::Vector_3                        Vector;
typedef CGAL::Surface_mesh<Point>               Mesh;
typedef Mesh::Vertex_index                      Vertex;
typedef SMD::internal::Random_numbers           Random_numbers;

namespace {

// the standard deviation of a mean of n numbers is 1/sqrt(n) of theirs: bounds of five of them never fail by chance,
// and the seeds are fixed
const double deviations = 5;

// ----- random numbers

// the first numbers of each kind: equal to the last bit on all platforms
TEST(Random_numbers, are_the_same_everywhere)
{
  const std::vector<double> uniform = { 0.31749613579856173, 0.65435726912118419, 0.48459684478509735 };
  const std::vector<double> gaussian = { -0.99413703976332557, 0.3080821365574683, 1.168197865583763,
                                         -0.0758685203802133, -0.0094659652664651484, -0.085298164086311412 };
  const std::vector<double> directions = { -0.18387227520671637, -0.81208049225578027, -0.55381970036097028,
                                           -0.025084950124286572, -0.93929980188801887, -0.34217923293267011 };

  Random_numbers random(2026);
  for(const double expected : uniform)
    EXPECT_EQ(random.uniform(), expected);
  for(const double expected : gaussian)
    EXPECT_EQ(random.gaussian(), expected);
  for(std::size_t i=0; i<directions.size(); i+=3)
  {
    const std::array<double, 3> d = random.direction();
    for(int k=0; k<3; ++k)
      EXPECT_EQ(d[k], directions[i+k]);
  }
}

// a sum over many numbers: no rare branch of the algorithms may differ either
TEST(Random_numbers, have_the_same_checksum_everywhere)
{
  Random_numbers random(5489);
  std::uint64_t checksum = 0;
  for(int i=0; i<100000; ++i)
    checksum = 6364136223846793005u * checksum + std::uint64_t(std::int64_t(std::ldexp(random.gaussian(), 40)));
  EXPECT_EQ(checksum, 3725764529933737613u);
}

TEST(Random_numbers, gaussian_numbers_are_normally_distributed)
{
  const int n = 400000;
  Random_numbers random(1);
  double moments[5] = { 0, 0, 0, 0, 0 };
  const double limits[4] = { 0, 1, 2, 3 };
  int number_above[4] = { 0, 0, 0, 0 };
  for(int i=0; i<n; ++i)
  {
    const double g = random.gaussian();
    for(int k=1; k<=4; ++k)
      moments[k] += std::pow(g, k) / n;
    for(int k=0; k<4; ++k)
      number_above[k] += (g > limits[k]);
  }
  const double bound = deviations / std::sqrt(double(n));
  EXPECT_NEAR(moments[1], 0, bound);
  EXPECT_NEAR(moments[2], 1, bound * std::sqrt(2.));
  EXPECT_NEAR(moments[3], 0, bound * std::sqrt(15.));
  EXPECT_NEAR(moments[4], 3, bound * std::sqrt(96.));
  for(int k=0; k<4; ++k)
  {
    const double p = 0.5 * std::erfc(limits[k] / std::sqrt(2.));
    EXPECT_NEAR(double(number_above[k]) / n, p, bound * std::sqrt(p * (1-p)));
  }
}

TEST(Random_numbers, centered_uniform_numbers_have_standard_deviation_one)
{
  const int n = 100000;
  Random_numbers random(1);
  double mean = 0, mean_square = 0, maximum = 0;
  for(int i=0; i<n; ++i)
  {
    const double u = random.centered_uniform();
    mean += u / n;
    mean_square += u * u / n;
    maximum = (std::max)(maximum, std::abs(u));
  }
  const double bound = deviations / std::sqrt(double(n));
  EXPECT_NEAR(mean, 0, bound);
  EXPECT_NEAR(mean_square, 1, bound * std::sqrt(0.8));
  EXPECT_LE(maximum, std::sqrt(3.));
  EXPECT_GT(maximum, 0.999 * std::sqrt(3.));
}

TEST(Random_numbers, directions_are_isotropic_unit_vectors)
{
  const int n = 100000;
  Random_numbers random(1);
  double mean[3] = { 0, 0, 0 }, mean_square[3] = { 0, 0, 0 };
  for(int i=0; i<n; ++i)
  {
    const std::array<double, 3> d = random.direction();
    ASSERT_NEAR(d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 1, 1e-15);
    for(int k=0; k<3; ++k)
    {
      mean[k] += d[k] / n;
      mean_square[k] += d[k] * d[k] / n;
    }
  }
  const double bound = deviations / std::sqrt(double(n));
  for(int k=0; k<3; ++k)
  {
    EXPECT_NEAR(mean[k], 0, bound * std::sqrt(1/3.));
    EXPECT_NEAR(mean_square[k], 1/3., bound * std::sqrt(4/45.));
  }
}

// ----- noise

Mesh make_model(const std::string& name, const std::size_t number_of_vertices = 10000)
{
  models::Options options;
  options.number_of_vertices = number_of_vertices;
  return models::to_mesh<Mesh>(models::generate(name, options));
}

double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(const auto e : mesh.edges())
  {
    const auto h = mesh.halfedge(e);
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
  }
  return sum / double(mesh.number_of_edges());
}

// the displacements in mean edge lengths
std::vector<Vector> displacements(const Mesh& before, const Mesh& after)
{
  const double unit = mean_edge_length(before);
  std::vector<Vector> result;
  for(const Vertex v : before.vertices())
    result.push_back((after.point(v) - before.point(v)) / unit);
  return result;
}

template <typename NamedParameters>
std::vector<Vector> noise_on(const Mesh& mesh, const NamedParameters& np)
{
  Mesh noisy(mesh);
  SMD::add_noise(noisy, np);
  return displacements(mesh, noisy);
}

double root_mean_square(const std::vector<Vector>& vectors)
{
  double sum = 0;
  for(const Vector& v : vectors)
    sum += v.squared_length();
  return std::sqrt(sum / double(vectors.size()));
}

TEST(Add_noise, has_the_standard_deviation_asked_for)
{
  const Mesh sphere = make_model("sphere");
  const double relative_bound = deviations * std::sqrt(0.5 / double(sphere.number_of_vertices()));
  for(const double level : { 0.05, 0.3, 0.8 })
    for(const auto direction : { SMD::Noise_direction::NORMAL, SMD::Noise_direction::RANDOM })
      for(const auto distribution : { SMD::Noise_distribution::GAUSSIAN, SMD::Noise_distribution::UNIFORM })
      {
        const std::vector<Vector> d
          = noise_on(sphere, params::noise_level(level).noise_direction(direction).noise_distribution(distribution));
        EXPECT_NEAR(root_mean_square(d), level, level * relative_bound);
      }
}

TEST(Add_noise, is_gaussian_along_normals_with_level_0_3_by_default)
{
  const Mesh sphere = make_model("sphere", 1000);
  EXPECT_EQ(noise_on(sphere, params::default_values()),
            noise_on(sphere, params::noise_level(0.3).noise_share(1).random_seed(0)
                                    .noise_direction(SMD::Noise_direction::NORMAL)
                                    .noise_distribution(SMD::Noise_distribution::GAUSSIAN)));
}

TEST(Add_noise, along_normals_has_no_tangential_part_on_a_plane)
{
  Mesh plane;
  CGAL::make_grid(20, 20, plane, true);
  for(const Vector& d : noise_on(plane, params::noise_level(0.5)))
  {
    EXPECT_NEAR(d.x(), 0, 1e-13);
    EXPECT_NEAR(d.y(), 0, 1e-13);
    EXPECT_NE(d.z(), 0);
  }
}

TEST(Add_noise, along_normals_is_radial_on_a_regular_sphere)
{
  Mesh sphere;
  CGAL::make_icosahedron(sphere, Point(0, 0, 0), 1);
  const std::vector<Vector> noise = noise_on(sphere, params::noise_level(0.2));
  for(const Vertex v : sphere.vertices())
  {
    const Vector tangential = CGAL::cross_product(noise[v], sphere.point(v) - CGAL::ORIGIN);
    EXPECT_NEAR(std::sqrt(tangential.squared_length()), 0, 1e-14);
    EXPECT_GT(noise[v].squared_length(), 0);
  }
}

TEST(Add_noise, in_random_directions_is_isotropic)
{
  Mesh plane;
  CGAL::make_grid(100, 100, plane, true);
  const std::vector<Vector> noise
    = noise_on(plane, params::noise_direction(SMD::Noise_direction::RANDOM).noise_level(1));
  double mean_square[3] = { 0, 0, 0 };
  for(const Vector& d : noise)
    for(int k=0; k<3; ++k)
      mean_square[k] += d[k] * d[k] / double(noise.size());
  // the fourth moment of a coordinate is 3/5, the square of the second one 1/9
  const double bound = deviations * std::sqrt((3/5. - 1/9.) / double(noise.size()));
  for(int k=0; k<3; ++k)
    EXPECT_NEAR(mean_square[k], 1/3., bound);
}

TEST(Add_noise, uniform_noise_is_bounded)
{
  const std::vector<Vector> noise
    = noise_on(make_model("sphere"), params::noise_level(0.4).noise_distribution(SMD::Noise_distribution::UNIFORM));
  double maximum = 0;
  for(const Vector& d : noise)
    maximum = (std::max)(maximum, std::sqrt(d.squared_length()));
  EXPECT_LE(maximum, 0.4 * std::sqrt(3.) * (1 + 1e-12));
  EXPECT_GT(maximum, 0.39 * std::sqrt(3.));
}

TEST(Add_noise, impulsive_noise_hits_the_share_asked_for_with_the_same_noise)
{
  const Mesh sphere = make_model("sphere");
  const std::vector<Vector> full = noise_on(sphere, params::random_seed(3));
  const std::vector<Vector> tenth = noise_on(sphere, params::random_seed(3).noise_share(0.1));
  const std::vector<Vector> half = noise_on(sphere, params::random_seed(3).noise_share(0.5));
  double number_of_tenth = 0, number_of_half = 0;
  for(std::size_t i=0; i<full.size(); ++i)
  {
    if(half[i] != Vector(0, 0, 0))
    {
      EXPECT_EQ(half[i], full[i]);
      ++number_of_half;
    }
    if(tenth[i] != Vector(0, 0, 0))
    {
      EXPECT_EQ(tenth[i], half[i]);
      ++number_of_tenth;
    }
  }
  const double n = double(full.size());
  EXPECT_NEAR(number_of_tenth / n, 0.1, deviations * std::sqrt(0.1 * 0.9 / n));
  EXPECT_NEAR(number_of_half / n, 0.5, deviations * std::sqrt(0.5 * 0.5 / n));
}

TEST(Add_noise, depends_on_the_seed)
{
  const Mesh cube = make_model("cube", 1000);
  EXPECT_EQ(noise_on(cube, params::random_seed(1)), noise_on(cube, params::random_seed(1)));
  EXPECT_NE(noise_on(cube, params::random_seed(1)), noise_on(cube, params::random_seed(2)));
}

TEST(Add_noise, of_level_zero_changes_nothing)
{
  const Mesh cube = make_model("cube", 1000);
  EXPECT_EQ(root_mean_square(noise_on(cube, params::noise_level(0))), 0);
}

TEST(Add_noise, constrained_vertices_stay_and_the_others_have_the_same_noise)
{
  const Mesh cube = make_model("cube", 1000);
  Mesh noisy(cube), constrained(cube);
  SMD::add_noise(noisy);
  auto is_constrained = constrained.add_property_map<Vertex, bool>("v:constrained", false).first;
  for(const Vertex v : constrained.vertices())
    is_constrained[v] = (v % 3 == 0);
  SMD::add_noise(constrained, params::vertex_is_constrained_map(is_constrained));
  for(const Vertex v : cube.vertices())
    EXPECT_EQ(constrained.point(v), is_constrained[v] ? cube.point(v) : noisy.point(v));
}

TEST(Add_noise, range_of_vertices_has_the_noise_of_the_whole_mesh)
{
  const Mesh cube = make_model("cube", 1000);
  Mesh noisy(cube), partly_noisy(cube);
  SMD::add_noise(noisy);
  const std::vector<Vertex> range = { Vertex(700), Vertex(2), Vertex(33) };
  SMD::add_noise(range, partly_noisy);
  for(const Vertex v : cube.vertices())
  {
    const bool is_in_range = std::find(range.begin(), range.end(), v) != range.end();
    EXPECT_EQ(partly_noisy.point(v), is_in_range ? noisy.point(v) : cube.point(v));
    EXPECT_NE(noisy.point(v), cube.point(v));
  }
}

TEST(Add_noise, scales_and_moves_with_the_mesh)
{
  const Mesh cube = make_model("cube", 1000);
  Mesh noisy(cube), moved(cube);
  const auto move = [](const Point& p) { return Point(1000 * p.y() + 3e4, -1000 * p.x() - 2e4, 1000 * p.z() + 1e4); };
  for(const Vertex v : moved.vertices())
    moved.point(v) = move(moved.point(v));
  SMD::add_noise(noisy);
  SMD::add_noise(moved);
  for(const Vertex v : cube.vertices())
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(moved.point(v), move(noisy.point(v)))), 0, 1e-9);
}

TEST(Add_noise, leaves_isolated_vertices_and_accepts_degenerate_faces)
{
  Mesh mesh;
  const Vertex a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(1, 0, 0));
  const Vertex c = mesh.add_vertex(Point(2, 0, 0)), d = mesh.add_vertex(Point(0, 1, 0));
  const Vertex isolated = mesh.add_vertex(Point(5, 5, 5));
  mesh.add_face(a, b, c); // degenerate
  mesh.add_face(a, c, d);
  SMD::add_noise(mesh);
  EXPECT_EQ(mesh.point(isolated), Point(5, 5, 5));
  for(const Vertex v : mesh.vertices())
    EXPECT_TRUE(std::isfinite(mesh.point(v).z()));
  EXPECT_NE(mesh.point(d), Point(0, 1, 0));
}

// ----- bad input

template <typename Call>
std::string message_of(const Call& call)
{
  try
  {
    call();
  }
  catch(const std::invalid_argument& e)
  {
    return e.what();
  }
  return "nothing was thrown";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Add_noise, refuses_parameters_out_of_range_and_names_them)
{
  const Mesh cube = make_model("cube", 100);
  for(const double level : { -0.1, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
  {
    Mesh mesh(cube);
    EXPECT_TRUE(contains(message_of([&]() { SMD::add_noise(mesh, params::noise_level(level)); }), "noise_level"));
    EXPECT_EQ(root_mean_square(displacements(cube, mesh)), 0);
  }
  for(const double share : { -0.1, 0., 1.1, std::numeric_limits<double>::quiet_NaN() })
  {
    Mesh mesh(cube);
    const std::string message = message_of([&]() { SMD::add_noise(mesh, params::noise_share(share)); });
    EXPECT_TRUE(contains(message, "noise_share")) << message;
    EXPECT_TRUE(contains(message, "(0, 1]")) << message;
  }
  Mesh mesh(cube);
  EXPECT_TRUE(contains(message_of([&]() { SMD::add_noise(mesh, params::noise_level(-0.25)); }), "-0.25"));
}

TEST(Add_noise, refuses_meshes_that_are_not_of_triangles_or_not_finite)
{
  Mesh quads;
  CGAL::make_grid(3, 3, quads);
  EXPECT_THROW(SMD::add_noise(quads), std::invalid_argument);

  Mesh cube = make_model("cube", 100);
  cube.point(Vertex(17)) = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  const Point neighbor = cube.point(Vertex(16));
  EXPECT_TRUE(contains(message_of([&]() { SMD::add_noise(cube); }), "vertex 17"));
  EXPECT_EQ(cube.point(Vertex(16)), neighbor);
}

TEST(Add_noise, accepts_an_empty_mesh)
{
  Mesh empty;
  SMD::add_noise(empty);
  EXPECT_EQ(empty.number_of_vertices(), 0u);
}

// ----- any mesh, any kernel

template <typename TriangleMesh>
class Add_noise_to : public testing::Test {};

typedef testing::Types<CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>,
                       CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>,
                       CGAL::Polyhedron_3<Kernel>,
                       CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3> > Other_meshes;
TYPED_TEST_SUITE(Add_noise_to, Other_meshes, );

TYPED_TEST(Add_noise_to, any_mesh_gives_the_same_noise)
{
  models::Options options;
  options.number_of_vertices = 1000;
  const models::Model model = models::cut_sphere(options);
  Mesh expected = models::to_mesh<Mesh>(model);
  TypeParam mesh = models::to_mesh<TypeParam>(model);
  SMD::add_noise(expected);
  SMD::add_noise(mesh);

  const auto point_map = get(CGAL::vertex_point, mesh);
  auto v = expected.vertices().begin();
  for(const auto w : vertices(mesh))
  {
    const auto& p = get(point_map, w);
    const Point q(p.x(), p.y(), p.z());
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(q, expected.point(*v++))), 0, 1e-6);
  }
}

} // namespace
