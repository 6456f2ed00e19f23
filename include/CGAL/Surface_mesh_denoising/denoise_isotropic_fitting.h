// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_DENOISE_ISOTROPIC_FITTING_H
#define CGAL_SURFACE_MESH_DENOISING_DENOISE_ISOTROPIC_FITTING_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/internal/named_parameters.h>
#include <CGAL/Surface_mesh_denoising/Denoising_result.h>
#include <CGAL/Surface_mesh_denoising/internal/check_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/denoise_by_fitting.h>
#include <CGAL/Surface_mesh_denoising/internal/Isotropic_fitting.h>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief removes noise from a triangle mesh without edges, by isotropic surface fitting \cgalCite{cgal:wy-fpmd-12}.
*
* Each iteration filters the vertex normals (see `filter_vertex_normals()`), fits a quadratic surface to the vertices around each
* vertex, in all directions alike, and moves the vertex towards its projection onto that surface, along the
* filtered normal. Gently curved features stay, edges are rounded: `denoise_anisotropic_fitting()` keeps them.
*
* What is said there of the meshes accepted, of concurrency, of exceptions and of the end of the iterations holds here as well.
* The run time of an iteration is linear in the size of the mesh, and so is its memory.
*
* @tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag` (the
*         default), `Parallel_tag` and `Parallel_if_available_tag`.
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
*   \cgalParamNBegin{number_of_iterations}
*     \cgalParamDescription{the maximal number of iterations}
*     \cgalParamType{unsigned int}
*     \cgalParamDefault{`30`}
*   \cgalParamNEnd
*   \cgalParamNBegin{convergence_threshold}
*     \cgalParamDescription{The iterations end when the Hausdorff distance between two successive meshes is at most this, in
*                           mean edge lengths, and the root mean square of the vertices' displacements at most a
*                           fifteenth of this.}
*     \cgalParamType{double}
*     \cgalParamDefault{`0.05`}
*     \cgalParamExtra{The range is all positive numbers.}
*   \cgalParamNEnd
*   \cgalParamNBegin{neighborhood_ring_size}
*     \cgalParamDescription{The neighborhood of a vertex holds the vertices up to this number of edges away.}
*     \cgalParamType{unsigned int}
*     \cgalParamDefault{`2`}
*     \cgalParamExtra{at least `1`}
*   \cgalParamNEnd
*   \cgalParamNBegin{number_of_normal_iterations}
*     \cgalParamDescription{the number of iterations of the vertex normal filter in each iteration}
*     \cgalParamType{unsigned int}
*     \cgalParamDefault{`3`}
*   \cgalParamNEnd
*   \cgalParamNBegin{spatial_sigma}
*     \cgalParamDescription{the standard deviation of the vertex normal filter's spatial Gaussian, in mean edge lengths}
*     \cgalParamType{double}
*     \cgalParamDefault{`1`}
*     \cgalParamExtra{The range is all positive numbers.}
*   \cgalParamNEnd
*   \cgalParamNBegin{normal_sigma}
*     \cgalParamDescription{the standard deviation of the vertex normal filter's Gaussian of the distance between two
*                           unit normals}
*     \cgalParamType{double}
*     \cgalParamDefault{`0.6`}
*     \cgalParamExtra{The range is all positive numbers.}
*   \cgalParamNEnd
*   \cgalParamNBegin{relaxation_factor}
*     \cgalParamDescription{The share of the way to its projection that a vertex goes in one iteration. It is halved for a vertex that
*                           turns back after a long step.}
*     \cgalParamType{double}
*     \cgalParamDefault{`0.5`}
*     \cgalParamExtra{The range is `(0, 1]`.}
*   \cgalParamNEnd
*   \cgalParamNBegin{visitor}
*     \cgalParamDescription{a visitor that is told of each iteration and can end the run}
*     \cgalParamType{a model of `DenoisingVisitor`, or a `std::reference_wrapper` of one}
*     \cgalParamDefault{a visitor that lets the run go on}
*     \cgalParamExtra{If the visitor ends the run, the mesh holds the result of the last iteration completed.}
*   \cgalParamNEnd
*   \cgalParamNBegin{face_normal_map}
*     \cgalParamDescription{a property map that holds, on return, the filtered unit normals of the faces of the denoised mesh}
*     \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor`
*                    as key type and `%Vector_3` as value type}
*     \cgalParamDefault{none}
*   \cgalParamNEnd
*   \cgalParamNBegin{vertex_normal_map}
*     \cgalParamDescription{a property map that holds, on return, the vertex normals that belong to the filtered face normals, a null vector where there is none}
*     \cgalParamType{a class model of `WritablePropertyMap` with
*                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Vector_3` as value type}
*     \cgalParamDefault{none}
*   \cgalParamNEnd
*   \cgalParamNBegin{vertex_is_constrained_map}
*     \cgalParamDescription{a property map with the constrained-or-not status of each vertex of `tmesh`. A constrained vertex does not
*                           move.}
*     \cgalParamType{a class model of `ReadablePropertyMap` with
*                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `bool` as value type}
*     \cgalParamDefault{a default property map where no vertex is constrained}
*   \cgalParamNEnd
*   \cgalParamNBegin{edge_is_constrained_map}
*     \cgalParamDescription{a property map with the constrained-or-not status of each edge of `tmesh`. No neighborhood
*                           crosses a constrained edge.}
*     \cgalParamType{a class model of `ReadablePropertyMap` with
*                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type}
*     \cgalParamDefault{a default property map where no edge is constrained}
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
* @return the number of iterations, and whether they converged
*
* @throw std::invalid_argument if a parameter is out of its range, if a face is not a triangle, if a coordinate is not
*        finite, or if an index map does not number the elements from zero without a gap
* @throw std::length_error if the mesh has more than 250 million vertices or faces
*
* \sa `denoise_anisotropic_fitting()`
* \sa `filter_vertex_normals()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename Range, typename TriangleMesh,
          typename NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , internal::Enable_if_not_named_parameters<TriangleMesh> = 0
#endif
          >
Denoising_result denoise_isotropic_fitting(const Range& range, TriangleMesh& tmesh,
                                           const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  internal::Isotropic_fitting<ConcurrencyTag> fit(
    internal::checked_count("number_of_normal_iterations",
                            choose_parameter(get_parameter(np, internal_np::number_of_normal_iterations), 3), 0),
    internal::checked_positive("spatial_sigma", choose_parameter(get_parameter(np, internal_np::spatial_sigma), 1.)),
    internal::checked_positive("normal_sigma", choose_parameter(get_parameter(np, internal_np::normal_sigma), 0.6)),
    internal::checked_count("neighborhood_ring_size",
                            choose_parameter(get_parameter(np, internal_np::neighborhood_ring_size), 2), 1));
  return internal::denoise_by_fitting<ConcurrencyTag>(range, tmesh, np, 30, fit);
}

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief the same for all vertices of `tmesh`.
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Denoising_result denoise_isotropic_fitting(TriangleMesh& tmesh,
                                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  return denoise_isotropic_fitting<ConcurrencyTag>(vertices(tmesh), tmesh, np);
}

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_DENOISE_ISOTROPIC_FITTING_H
