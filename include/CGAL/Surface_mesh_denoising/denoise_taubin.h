// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_DENOISE_TAUBIN_H
#define CGAL_SURFACE_MESH_DENOISING_DENOISE_TAUBIN_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/internal/named_parameters.h>
#include <CGAL/Surface_mesh_denoising/Denoising_result.h>
#include <CGAL/Surface_mesh_denoising/internal/Taubin_step.h>
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
* \brief removes noise from a triangle mesh by Laplacian smoothing \cgalCite{cgal:f-lsdt-88}, or by its counterpart without shrinkage, Taubin's lambda-mu smoothing \cgalCite{cgal:t-spafs-95}.
*
* In each iteration all vertices \f$ x \f$ first move by \f$ \lambda \, \Delta x \f$, then by \f$ \mu \, \Delta x \f$, where \f$ \Delta x \f$ is the
* vector from \f$ x \f$ to the mean of the vertices that share an edge with it. The second step, with a negative \f$ \mu \f$, undoes
* the shrinkage of the first one. With \f$ \mu = 0 \f$ this is Laplacian smoothing. Either rounds sharp edges.
*
* On the border and on constrained edges \f$ \Delta x \f$ leads to the mean of the two neighbors along the border or along the edges.
* Where such curves end or branch the vertex does not move.
*
* What is said at `denoise_anisotropic_fitting()` of the meshes accepted, of concurrency and of exceptions holds here as well.
* The run time of an iteration is linear in the size of the mesh, and so is the memory.
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
*     \cgalParamDescription{the number of iterations. They end early when no vertex moves any more.}
*     \cgalParamType{unsigned int}
*     \cgalParamDefault{`20`}
*   \cgalParamNEnd
*   \cgalParamNBegin{lambda}
*     \cgalParamDescription{\f$ \lambda \f$, the share of the way to the mean of its neighbors that a vertex goes in the first step}
*     \cgalParamType{double}
*     \cgalParamDefault{`0.5`}
*     \cgalParamExtra{The range is `(0, 1]`.}
*   \cgalParamNEnd
*   \cgalParamNBegin{mu}
*     \cgalParamDescription{\f$ \mu \f$, the share in the second step; with zero there is none}
*     \cgalParamType{double}
*     \cgalParamDefault{`-0.53`}
*     \cgalParamExtra{At most zero, with \f$ 1/\lambda + 1/\mu < 1 \f$ and \f$ (1 - 2\lambda)(1 - 2\mu) \geq -1 \f$, or noise would grow.}
*   \cgalParamNEnd
*   \cgalParamNBegin{visitor}
*     \cgalParamDescription{a visitor that is told of each iteration and can end the run}
*     \cgalParamType{a model of `DenoisingVisitor`, or a `std::reference_wrapper` of one}
*     \cgalParamDefault{a visitor that lets the run go on}
*     \cgalParamExtra{If the visitor ends the run, the mesh holds the result of the last iteration completed.}
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
* @return the number of iterations, and whether the last one moved no vertex
*
* @throw std::invalid_argument if a parameter is out of its range, if a face is not a triangle, if a coordinate is not
*        finite, or if an index map does not number the elements from zero without a gap
* @throw std::length_error if the mesh has more than 250 million vertices or faces
*
* \sa `denoise_isotropic_fitting()`
* \sa `CGAL::Polygon_mesh_processing::smooth_shape()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename Range, typename TriangleMesh,
          typename NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , internal::Enable_if_not_named_parameters<TriangleMesh> = 0
#endif
          >
Denoising_result denoise_taubin(const Range& range, TriangleMesh& tmesh,
                                const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const std::size_t number_of_iterations
    = internal::checked_count("number_of_iterations",
                              choose_parameter(get_parameter(np, internal_np::number_of_iterations), 20), 0);
  const double lambda
    = internal::checked_share("lambda", choose_parameter(get_parameter(np, internal_np::lambda), 0.5));
  const double mu = choose_parameter(get_parameter(np, internal_np::mu), -0.53);
  // the factor by which an iteration multiplies the component of frequency k is (1 - lambda k) (1 - mu k)
  if(!(mu == 0 || (mu < 0 && 1/lambda + 1/mu < 1 && (1 - 2*lambda) * (1 - 2*mu) >= -1)))
    internal::throw_out_of_range("mu", mu, "at most zero, with 1/lambda + 1/mu < 1 and "
                                           "(1 - 2 lambda) (1 - 2 mu) >= -1");

  internal::Taubin_step<ConcurrencyTag> step(lambda, mu);
  return internal::denoise_mesh(range, tmesh, np,
                                [&](Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable, const auto& report)
                                {
                                  return internal::repeat_step<ConcurrencyTag>(mesh, is_movable, number_of_iterations,
                                                                               step, report);
                                },
                                step);
}

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief the same for all vertices of `tmesh`.
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Denoising_result denoise_taubin(TriangleMesh& tmesh, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return denoise_taubin<ConcurrencyTag>(vertices(tmesh), tmesh, np);
}

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_DENOISE_TAUBIN_H
