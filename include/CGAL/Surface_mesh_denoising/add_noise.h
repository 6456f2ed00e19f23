// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_ADD_NOISE_H
#define CGAL_SURFACE_MESH_DENOISING_ADD_NOISE_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/internal/named_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Mesh_io.h>
#include <CGAL/Surface_mesh_denoising/internal/Random_numbers.h>
#include <CGAL/Surface_mesh_denoising/internal/check_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingRef
*
* The enumeration `Noise_distribution` names the distributions of the length by which `add_noise()` moves
* a vertex. Their mean is zero and their standard deviation is the same.
*/
enum class Noise_distribution
{
  GAUSSIAN, ///< normal distribution
  UNIFORM   ///< uniform distribution: no vertex moves by more than \f$ \sqrt{3} \f$ standard deviations
};

/*!
* \ingroup PkgSurfaceMeshDenoisingRef
*
* The enumeration `Noise_direction` names the directions in which `add_noise()` moves a vertex.
*/
enum class Noise_direction
{
  NORMAL, ///< along the area-weighted vertex normal of the mesh without the noise
  RANDOM  ///< in a random direction, all directions being equally likely
};

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief moves the vertices of a triangle mesh at random, for experiments with denoising.
*
* The displacement of a vertex is a random number times a unit vector. It depends on the seed, on the mesh and on the
* index of the vertex: neither the range nor the constraints change the noise of the vertices that move.
* The random numbers are the same on each platform and with each standard library. So is the mesh, unless the compiler
* fuses multiplications with additions, which changes last digits.
* Along normals, isolated vertices and vertices without a normal do not move.
*
* The run time and the memory are linear in the size of the mesh.
*
* If an exception is thrown, the points of the mesh are as before the call.
*
* @tparam Range a model of `ConstRange` whose value type is the vertex descriptor or the face descriptor of `TriangleMesh`
* @tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`, with an internal or given
*         vertex point map that is read-write. The number type of its geometric traits is `float` or `double`.
* @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
*
* @param range the vertices that may move. If it holds faces, these are the vertices that have no faces but those in
*        `range`.
* @param tmesh a triangle mesh
* @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
*
* \cgalNamedParamsBegin
*   \cgalParamNBegin{noise_level}
*     \cgalParamDescription{the standard deviation of the length of a displacement, in mean edge lengths of `tmesh`}
*     \cgalParamType{double}
*     \cgalParamDefault{`0.3`}
*     \cgalParamExtra{The range is all numbers that are not negative.}
*   \cgalParamNEnd
*   \cgalParamNBegin{noise_distribution}
*     \cgalParamDescription{the distribution of the length of a displacement}
*     \cgalParamType{`Noise_distribution`}
*     \cgalParamDefault{`Noise_distribution::GAUSSIAN`}
*   \cgalParamNEnd
*   \cgalParamNBegin{noise_direction}
*     \cgalParamDescription{the direction of a displacement}
*     \cgalParamType{`Noise_direction`}
*     \cgalParamDefault{`Noise_direction::NORMAL`}
*   \cgalParamNEnd
*   \cgalParamNBegin{noise_share}
*     \cgalParamDescription{the probability with which a vertex gets noise: impulsive noise if it is below 1}
*     \cgalParamType{double}
*     \cgalParamDefault{`1`}
*     \cgalParamExtra{The range is `(0, 1]`.}
*   \cgalParamNEnd
*   \cgalParamNBegin{random_seed}
*     \cgalParamDescription{the seed of the random numbers}
*     \cgalParamType{unsigned int}
*     \cgalParamDefault{`0`}
*   \cgalParamNEnd
*   \cgalParamNBegin{vertex_is_constrained_map}
*     \cgalParamDescription{a property map with the constrained-or-not status of each vertex of `tmesh`. A constrained
*                           vertex does not move.}
*     \cgalParamType{a class model of `ReadablePropertyMap` with
*                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `bool` as value type}
*     \cgalParamDefault{a default property map where no vertex is constrained}
*   \cgalParamNEnd
*   \cgalParamNBegin{vertex_point_map}
*     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
*     \cgalParamType{a class model of `ReadWritePropertyMap` with
*                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
*     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
*   \cgalParamNEnd
*   \cgalParamNBegin{vertex_index_map}
*     \cgalParamDescription{a property map associating to each vertex of `tmesh` a unique index between `0` and
*                           `num_vertices(tmesh) - 1`}
*     \cgalParamType{a class model of `ReadablePropertyMap` with
*                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and an integer as value type}
*     \cgalParamDefault{the order of the vertices in `tmesh`}
*   \cgalParamNEnd
*   \cgalParamNBegin{face_index_map}
*     \cgalParamDescription{a property map associating to each face of `tmesh` a unique index between `0` and
*                           `num_faces(tmesh) - 1`}
*     \cgalParamType{a class model of `ReadablePropertyMap` with
*                    `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer as value type}
*     \cgalParamDefault{the order of the faces in `tmesh`}
*   \cgalParamNEnd
*   \cgalParamNBegin{geom_traits}
*     \cgalParamDescription{an instance of a geometric traits class}
*     \cgalParamType{a class model of `Kernel` whose number type is `float` or `double`}
*     \cgalParamDefault{a \cgal Kernel deduced from the point type, using `CGAL::Kernel_traits`}
*   \cgalParamNEnd
* \cgalNamedParamsEnd
*
* @throw std::invalid_argument if a parameter is out of its range, if a face is not a triangle, if a coordinate is not
*        finite, or if an index map does not number the elements from zero without a gap
*
* \sa `measure_error()`
* \sa `CGAL::Polygon_mesh_processing::random_perturbation()`
*/
template <typename Range, typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , internal::Enable_if_not_named_parameters<TriangleMesh> = 0
#endif
          >
void add_noise(const Range& range, TriangleMesh& tmesh, const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const double level = internal::checked_not_negative("noise_level",
    choose_parameter(get_parameter(np, internal_np::noise_level), 0.3));
  const double share = internal::checked_share("noise_share",
    choose_parameter(get_parameter(np, internal_np::noise_share), 1.));
  const Noise_distribution distribution = choose_parameter(get_parameter(np, internal_np::noise_distribution),
                                                           Noise_distribution::GAUSSIAN);
  const Noise_direction direction = choose_parameter(get_parameter(np, internal_np::noise_direction),
                                                     Noise_direction::NORMAL);
  const std::uint64_t seed = choose_parameter(get_parameter(np, internal_np::random_seed), 0u);

  auto io = internal::read_mesh(range, tmesh, choose_parameter(get_parameter(np, internal_np::vertex_point),
                                                               get_property_map(CGAL::vertex_point, tmesh)), np);
  const Indexed_triangle_mesh mesh = io.take_mesh();

  std::vector<internal::Vector_3> normals;
  if(direction == Noise_direction::NORMAL)
    internal::compute_vertex_normals<Sequential_tag>(mesh, normals);

  const double deviation = level * mesh.mean_edge_length();
  internal::Random_numbers random(seed);
  std::vector<internal::Point_3> points = mesh.points();
  for(std::size_t v=0; v<points.size(); ++v)
  {
    // all numbers are drawn for each vertex, needed or not: the noise of a vertex depends on no other vertex
    const bool is_hit = random.uniform() < share;
    const double length = (distribution == Noise_distribution::GAUSSIAN) ? random.gaussian()
                                                                         : random.centered_uniform();
    internal::Vector_3 unit;
    if(direction == Noise_direction::NORMAL)
      unit = normals[v];
    else
    {
      const std::array<double, 3> d = random.direction();
      unit = internal::Vector_3(d[0], d[1], d[2]);
    }

    if(is_hit && io.is_movable()[v])
      points[v] = points[v] + (deviation * length) * unit;
  }

  io.write_points(mesh.points(), points);
}

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief the same for all vertices of `tmesh`.
*/
template <typename TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
void add_noise(TriangleMesh& tmesh, const CGAL_NP_CLASS& np = parameters::default_values())
{
  add_noise(vertices(tmesh), tmesh, np);
}

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_ADD_NOISE_H
