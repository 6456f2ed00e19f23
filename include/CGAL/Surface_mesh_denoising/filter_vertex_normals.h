// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_FILTER_VERTEX_NORMALS_H
#define CGAL_SURFACE_MESH_DENOISING_FILTER_VERTEX_NORMALS_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/internal/named_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/bilateral_vertex_normals.h>
#include <CGAL/Surface_mesh_denoising/internal/check_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Mesh_io.h>
#include <CGAL/Surface_mesh_denoising/internal/normals.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief computes vertex normals and removes noise from them by bilateral filtering \cgalCite{cgal:wy-fpmd-12}.
*
* The normal of a vertex starts as the area-weighted mean of the unit normals of the faces incident to it. Each iteration
* replaces \f$ n_i \f$ by the unit vector along
* \f[ n_i + \frac{\sum_j W_c(|v_j - v_i|) \, W_s(|n_j - n_i|) \, (n_j - n_i)}{\sum_j W_c(|v_j - v_i|) \, W_s(|n_j - n_i|)}, \f]
* where \f$ j \f$ runs over the adjacent vertices, \f$ W_c(x) = \exp(-x^2 / 2 \sigma_c^2) \f$ and
* \f$ W_s(x) = \exp(-x^2 / 2 \sigma_s^2) \f$.
* The mesh does not change.
*
* The run time of an iteration is linear in the size of the mesh.
*
* @tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag` (the
*         default), `Parallel_tag` and `Parallel_if_available_tag`.
* @tparam Range a model of `ConstRange` whose value type is the vertex descriptor or the face descriptor of `TriangleMesh`
* @tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`. The number type of its
*         geometric traits is `float` or `double`.
* @tparam VertexNormalMap a model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
*         as key type and `%Vector_3` as value type
* @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
*
* @param range the vertices whose normals are filtered. If it holds faces, these are the vertices that have no faces
*        but those in `range`.
* @param tmesh a triangle mesh
* @param vertex_normals holds the normals of all vertices on return: unit vectors, or a null vector at a vertex without faces
* @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
*
* \cgalNamedParamsBegin
*   \cgalParamNBegin{number_of_iterations}
*     \cgalParamDescription{the number of iterations}
*     \cgalParamType{unsigned int}
*     \cgalParamDefault{`3`}
*   \cgalParamNEnd
*   \cgalParamNBegin{spatial_sigma}
*     \cgalParamDescription{\f$ \sigma_c \f$, in mean edge lengths}
*     \cgalParamType{double}
*     \cgalParamDefault{`1`}
*     \cgalParamExtra{The range is all positive numbers.}
*   \cgalParamNEnd
*   \cgalParamNBegin{normal_sigma}
*     \cgalParamDescription{\f$ \sigma_s \f$, which compares unit vectors and has no unit}
*     \cgalParamType{double}
*     \cgalParamDefault{`0.6`}
*     \cgalParamExtra{The range is all positive numbers.}
*   \cgalParamNEnd
*   \cgalParamNBegin{vertex_is_constrained_map}
*     \cgalParamDescription{a property map with the constrained-or-not status of each vertex of `tmesh`. The normal of
*                           a constrained vertex is not filtered.}
*     \cgalParamType{a class model of `ReadablePropertyMap` with
*                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `bool` as value type}
*     \cgalParamDefault{a default property map where no vertex is constrained}
*   \cgalParamNEnd
*   \cgalParamNBegin{vertex_point_map}
*     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
*     \cgalParamType{a class model of `ReadablePropertyMap` with
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
* \sa `denoise_isotropic_fitting()`
* \sa `CGAL::Polygon_mesh_processing::compute_vertex_normals()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename Range, typename TriangleMesh, typename VertexNormalMap,
          typename NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , internal::Enable_if_not_named_parameters<VertexNormalMap> = 0
#endif
          >
void filter_vertex_normals(const Range& range, const TriangleMesh& tmesh, VertexNormalMap vertex_normals,
                           const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const std::size_t number_of_iterations
    = internal::checked_count("number_of_iterations",
                              choose_parameter(get_parameter(np, internal_np::number_of_iterations), 3), 0);
  const double spatial_sigma
    = internal::checked_positive("spatial_sigma",
                                 choose_parameter(get_parameter(np, internal_np::spatial_sigma), 1.));
  const double normal_sigma
    = internal::checked_positive("normal_sigma", choose_parameter(get_parameter(np, internal_np::normal_sigma), 0.6));

  auto io = internal::read_mesh(range, tmesh, choose_parameter(get_parameter(np, internal_np::vertex_point),
                                                               get_const_property_map(CGAL::vertex_point, tmesh)),
                                np);
  const Indexed_triangle_mesh mesh = io.take_mesh();
  std::vector<Indexed_triangle_mesh::Vector_3> normals;
  internal::compute_vertex_normals<ConcurrencyTag>(mesh, normals);
  internal::filter_vertex_normals<ConcurrencyTag>(mesh, io.is_movable(),
                                                  spatial_sigma * mesh.mean_edge_length<ConcurrencyTag>(),
                                                  normal_sigma, number_of_iterations, normals);
  io.write_vertex_normals(normals, vertex_normals);
}

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief the same for all vertices of `tmesh`.
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename VertexNormalMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
void filter_vertex_normals(const TriangleMesh& tmesh, VertexNormalMap vertex_normals,
                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  filter_vertex_normals<ConcurrencyTag>(vertices(tmesh), tmesh, vertex_normals, np);
}

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_FILTER_VERTEX_NORMALS_H
