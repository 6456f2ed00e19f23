// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_DENOISE_NONITERATIVE_H
#define CGAL_SURFACE_MESH_DENOISING_DENOISE_NONITERATIVE_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/internal/named_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Noniterative_step.h>
#include <CGAL/Surface_mesh_denoising/internal/check_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/denoise_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/repeat_step.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief removes noise from a triangle mesh in a single pass, by robust estimation of each vertex from the surface around it \cgalCite{cgal:jdd-nfms-03}.
*
* Each face \f$ q \f$ near the vertex \f$ x \f$ predicts its place: the projection \f$ \Pi_q(x) \f$ onto the plane through the centroid
* \f$ c_q \f$ of the face. The vertex moves to the mean
* \f[ \frac{\sum_q \Pi_q(x) \, a_q \, f(|c_q - x|) \, g(|\Pi_q(x) - x|)}{\sum_q a_q \, f(|c_q - x|) \, g(|\Pi_q(x) - x|)}, \f]
* where \f$ q \f$ runs over the faces whose centroids are within \f$ 2 \sigma_f \f$ of \f$ x \f$ and over those of the vertex, \f$ a_q \f$ is
* the area of a face, and \f$ f \f$ and \f$ g \f$ are Gaussians with the standard deviations \f$ \sigma_f \f$ and \f$ \sigma_g \f$: a plane that
* passes far from the vertex, beyond an edge, does not count. The normals of the planes are those of a mollified mesh, whose vertices are
* the means of the \f$ c_q \f$ with the weights \f$ a_q \f$ and a Gaussian with \f$ \sigma_f / 2 \f$.
*
* What is said at `denoise_anisotropic_fitting()` of the meshes accepted, of concurrency and of exceptions holds here as well.
* A neighborhood that a constrained edge passes ends there; that of a vertex on such an edge lies on all sides of it.
* A vertex is held back where a face would turn over.
* The run time is \f$ O(n k) \f$ and the memory \f$ O(n) \f$, where \f$ n \f$ is the size of the mesh and \f$ k \f$ that of
* a neighborhood. The search for neighbors ends when it has found 512 faces, at the end of a ring, so that \f$ k \f$ does not grow with
* \f$ n \f$.
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
*   \cgalParamNBegin{spatial_sigma}
*     \cgalParamDescription{\f$ \sigma_f \f$, in mean edge lengths: the greater, the smoother}
*     \cgalParamType{double}
*     \cgalParamDefault{`1`}
*     \cgalParamExtra{The range is all positive numbers.}
*   \cgalParamNEnd
*   \cgalParamNBegin{height_sigma}
*     \cgalParamDescription{\f$ \sigma_g \f$, in mean edge lengths: the smaller, the finer are the features that stay}
*     \cgalParamType{double}
*     \cgalParamDefault{`1`}
*     \cgalParamExtra{The range is all positive numbers.}
*   \cgalParamNEnd
*   \cgalParamNBegin{face_normal_map}
*     \cgalParamDescription{a property map that holds, on return, the unit normals of the faces of the denoised mesh}
*     \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor`
*                    as key type and `%Vector_3` as value type}
*     \cgalParamDefault{none}
*   \cgalParamNEnd
*   \cgalParamNBegin{vertex_normal_map}
*     \cgalParamDescription{a property map that holds, on return, the area-weighted normals of the vertices of the
*                           denoised mesh, a null vector where there is none}
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
* @throw std::invalid_argument if a parameter is out of its range, if a face is not a triangle, if a coordinate is not
*        finite, or if an index map does not number the elements from zero without a gap
* @throw std::length_error if the mesh has more than 250 million vertices or faces
*
* \sa `denoise_bilateral()`
* \sa `denoise_with_normals()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename Range, typename TriangleMesh,
          typename NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , internal::Enable_if_not_named_parameters<TriangleMesh> = 0
#endif
          >
void denoise_noniterative(const Range& range, TriangleMesh& tmesh,
                          const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  internal::Noniterative_step<ConcurrencyTag> step(
    internal::checked_positive("spatial_sigma", choose_parameter(get_parameter(np, internal_np::spatial_sigma), 1.)),
    internal::checked_positive("height_sigma", choose_parameter(get_parameter(np, internal_np::height_sigma), 1.)));
  internal::denoise_mesh(range, tmesh, np,
                         [&](Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable, const auto&)
                         {
                           return internal::repeat_step<ConcurrencyTag>(
                             mesh, is_movable, 1, step, [](std::size_t, double, bool) { return true; });
                         },
                         step);
}

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief the same for all vertices of `tmesh`.
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
void denoise_noniterative(TriangleMesh& tmesh, const CGAL_NP_CLASS& np = parameters::default_values())
{
  denoise_noniterative<ConcurrencyTag>(vertices(tmesh), tmesh, np);
}

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_DENOISE_NONITERATIVE_H
