// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The same geometry gives the same result, whatever holds it.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_denoising/anisotropic_neighborhood.h>
#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/denoise_isotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/filter_vertex_normals.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;

struct Double_traits : OpenMesh::DefaultTraits
{
  typedef OpenMesh::Vec3d Point;
  typedef OpenMesh::Vec3d Normal;
};

// a noisy cube, its vertices in the order of their indices
const generated_models::Model& noisy_model()
{
  static const generated_models::Model model = []()
  {
    generated_models::Model m;
    const Mesh mesh = noisy_mesh(generated_models::cube, 400, 0.2);
    m.points = points_of(mesh);
    for(const Face f : faces(mesh))
    {
      const std::array<Vertex, 3> t = vertices_of(mesh, f);
      m.triangles.push_back({{ t[0], t[1], t[2] }});
    }
    return m;
  }();
  return model;
}

// few iterations, for rounding not to grow
Anisotropic_parameters few_iterations()
{
  Anisotropic_parameters parameters;
  parameters.number_of_iterations = 3;
  return parameters;
}

struct Expected
{
  std::vector<Point> anisotropic, isotropic;
  std::vector<Vector> normals;
  double length;
};

const Expected& expected()
{
  static const Expected result = []()
  {
    const Mesh noisy = generated_models::to_mesh<Mesh>(noisy_model());
    Expected r;
    Mesh mesh = noisy;
    SMD::denoise_anisotropic_fitting(mesh, few_iterations().named());
    r.anisotropic = points_of(mesh);
    mesh = noisy;
    SMD::denoise_isotropic_fitting(mesh, params::number_of_iterations(3));
    r.isotropic = points_of(mesh);
    mesh = noisy;
    auto normals = mesh.add_property_map<Vertex, Vector>("v:normal").first;
    SMD::filter_vertex_normals(mesh, normals);
    r.normals.assign(normals.begin(), normals.end());
    r.length = mean_edge_length(noisy);
    return r;
  }();
  return result;
}

template <typename TriangleMesh>
struct Mesh_type : testing::Test {};

// CGAL's adaptor sets the points of an OpenMesh through float
template <typename TriangleMesh>
constexpr bool is_openmesh = std::is_base_of<OpenMesh::BaseKernel, TriangleMesh>::value;

typedef testing::Types<CGAL::Surface_mesh<Epick::Point_3>,
                       CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>,
                       CGAL::Polyhedron_3<Kernel>,
                       CGAL::Polyhedron_3<Epick, CGAL::Polyhedron_items_with_id_3>,
                       OpenMesh::PolyMesh_ArrayKernelT<Double_traits>,
                       OpenMesh::TriMesh_ArrayKernelT<Double_traits> > Mesh_types;
TYPED_TEST_SUITE(Mesh_type, Mesh_types, );

TYPED_TEST(Mesh_type, Gives_the_same_result)
{
  typedef TypeParam TriangleMesh;
  typedef typename boost::property_traits<typename CGAL::GetVertexPointMap<TriangleMesh>::type>::value_type Mesh_point;
  typedef typename CGAL::Kernel_traits<Mesh_point>::Kernel Mesh_kernel;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  const bool is_float = std::is_same<typename Mesh_kernel::FT, float>::value || is_openmesh<TriangleMesh>;
  const double tolerance = (is_float ? 1e-4 : 1e-9) * expected().length;

  TriangleMesh mesh = generated_models::to_mesh<TriangleMesh>(noisy_model());
  ASSERT_EQ(num_vertices(mesh), noisy_model().points.size());
  const auto result = SMD::denoise_anisotropic_fitting(mesh, few_iterations().named());
  EXPECT_EQ(result.number_of_iterations, 3u);
  EXPECT_LT(largest_distance(points_of(mesh), expected().anisotropic), tolerance);

  mesh = generated_models::to_mesh<TriangleMesh>(noisy_model());
  SMD::denoise_isotropic_fitting(vertices(mesh), mesh, params::number_of_iterations(3));
  EXPECT_LT(largest_distance(points_of(mesh), expected().isotropic), tolerance);

  // normals go into a map, and the mesh may be constant
  const TriangleMesh constant = generated_models::to_mesh<TriangleMesh>(noisy_model());
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  std::map<vertex_descriptor, typename Mesh_kernel::Vector_3> normals;
  SMD::filter_vertex_normals(constant, boost::make_assoc_property_map(normals));
  std::size_t i = 0;
  for(const auto v : vertices(constant))
    ASSERT_LT(distance(normals[v], expected().normals[i++]), tolerance);

  std::vector<face_descriptor> found;
  SMD::anisotropic_neighborhood(*faces(constant).begin(), constant, std::back_inserter(found),
                                params::neighborhood_size(15));
  EXPECT_EQ(found.size(), 15u);
}

// the default type of OpenMesh holds numbers of another type than the points that CGAL sees
TEST(Mesh_types, OpenMesh_with_its_default_traits)
{
  typedef OpenMesh::PolyMesh_ArrayKernelT<> Float_mesh;
  Float_mesh mesh = generated_models::to_mesh<Float_mesh>(noisy_model());
  SMD::denoise_anisotropic_fitting(mesh, few_iterations().named());
  EXPECT_LT(largest_distance(points_of(mesh), expected().anisotropic), 1e-4 * expected().length);
}

TEST(Mesh_types, Surface_mesh_with_removed_elements)
{
  // elements of the one are removed before, of the other behind those that stay
  Mesh mesh = generated_models::to_mesh<Mesh>(noisy_model());
  const std::size_t n = num_vertices(mesh), m = num_faces(mesh);
  Mesh with_garbage = irregular_mesh(generated_models::sphere, 100);
  const std::size_t first = num_vertices(with_garbage), first_face = num_faces(with_garbage);
  with_garbage.join(mesh);
  with_garbage.join(irregular_mesh(generated_models::sphere, 100));
  const auto is_garbage = [](const std::size_t i, const std::size_t begin, const std::size_t size)
  {
    return i < begin || i >= begin + size;
  };
  for(const Face f : faces(with_garbage))
    if(is_garbage(f, first_face, m))
    {
      const Halfedge h = with_garbage.halfedge(f);
      for(const Halfedge side : { h, with_garbage.next(h), with_garbage.prev(h) })
        if(!with_garbage.is_removed(with_garbage.edge(side)))
          with_garbage.remove_edge(with_garbage.edge(side));
      with_garbage.remove_face(f);
    }
  for(const Vertex v : vertices(with_garbage))
    if(is_garbage(v, first, n))
      with_garbage.remove_vertex(v);
  ASSERT_TRUE(with_garbage.has_garbage());
  ASSERT_TRUE(with_garbage.is_valid());
  ASSERT_EQ(with_garbage.number_of_vertices(), n);
  ASSERT_EQ(with_garbage.number_of_faces(), m);

  SMD::denoise_anisotropic_fitting(mesh);
  SMD::denoise_anisotropic_fitting(with_garbage);
  EXPECT_EQ(points_of(with_garbage), points_of(mesh));
}

TEST(Mesh_types, Index_maps_of_the_user)
{
  typedef CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3> Polyhedron;
  Polyhedron polyhedron = generated_models::to_mesh<Polyhedron>(noisy_model());
  CGAL::set_halfedgeds_items_id(polyhedron);
  SMD::denoise_anisotropic_fitting(polyhedron, few_iterations().named()
                                                 .vertex_index_map(get(boost::vertex_index, polyhedron))
                                                 .face_index_map(get(boost::face_index, polyhedron)));
  EXPECT_LT(largest_distance(points_of(polyhedron), expected().anisotropic), 1e-9 * expected().length);

  // any order will do
  Mesh mesh = generated_models::to_mesh<Mesh>(noisy_model());
  const std::size_t n = num_vertices(mesh), m = num_faces(mesh);
  const auto backwards = boost::make_function_property_map<Vertex>([n](const Vertex v) { return n - 1 - v; });
  const auto rotated = boost::make_function_property_map<Face>([m](const Face f) { return (f + 100) % m; });
  SMD::denoise_anisotropic_fitting(mesh, few_iterations().named().vertex_index_map(backwards).face_index_map(rotated));
  EXPECT_LT(largest_distance(points_of(mesh), expected().anisotropic), 1e-9 * expected().length);
}

TEST(Mesh_types, Index_maps_that_are_wrong)
{
  const Mesh noisy = generated_models::to_mesh<Mesh>(noisy_model());
  Mesh mesh = noisy;
  const auto expect_refused = [&](const auto& np, const std::string& name)
  {
    try
    {
      SMD::denoise_anisotropic_fitting(mesh, np);
      ADD_FAILURE() << name;
    }
    catch(const std::invalid_argument& e)
    {
      EXPECT_NE(std::string(e.what()).find(name), std::string::npos) << e.what();
    }
    EXPECT_EQ(points_of(mesh), points_of(noisy));
  };
  // from one on; the last one missing; all the same; less than zero
  for(const int wrong : { 0, 1, 2, 3 })
  {
    const auto index = [wrong](const int i) { return (wrong == 0) ? i + 1 : (wrong == 1) ? i / 2
                                                   : (wrong == 2) ? 0 : -i; };
    expect_refused(params::vertex_index_map(boost::make_function_property_map<Vertex>(
                     [index](const Vertex v) { return index(int(v)); })), "vertex_index_map");
    expect_refused(params::face_index_map(boost::make_function_property_map<Face>(
                     [index](const Face f) { return index(int(f)); })), "face_index_map");
  }
}

TEST(Mesh_types, A_vertex_point_map_of_the_user)
{
  // points of one type outside, while those inside the mesh are of another type, and useless
  typedef CGAL::Simple_cartesian<float>::Point_3 Float_point;
  typedef CGAL::Surface_mesh<Float_point> Float_mesh;
  typedef Float_mesh::Vertex_index Float_vertex;
  Float_mesh mesh = generated_models::to_mesh<Float_mesh>(noisy_model());
  std::vector<Point> outside = noisy_model().points;
  for(const Float_vertex v : vertices(mesh))
    mesh.point(v) = Float_point(std::numeric_limits<float>::quiet_NaN(), 0, 0);

  const auto points = boost::make_iterator_property_map(outside.begin(), get(boost::vertex_index, mesh));
  SMD::denoise_anisotropic_fitting(mesh, few_iterations().named().vertex_point_map(points).geom_traits(Kernel()));
  EXPECT_LT(largest_distance(outside, expected().anisotropic), 1e-12 * expected().length);
  for(const Float_vertex v : vertices(mesh))
    ASSERT_TRUE(std::isnan(mesh.point(v).x()) && mesh.point(v).y() == 0 && mesh.point(v).z() == 0);
}
