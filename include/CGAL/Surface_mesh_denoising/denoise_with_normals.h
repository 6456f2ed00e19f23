// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_DENOISE_WITH_NORMALS_H
#define CGAL_SURFACE_MESH_DENOISING_DENOISE_WITH_NORMALS_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/internal/named_parameters.h>
#include <CGAL/Surface_mesh_denoising/Denoising_result.h>
#include <CGAL/Surface_mesh_denoising/Thresholded_normal_filter.h>
#include <CGAL/Surface_mesh_denoising/internal/check_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/denoise_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Normal_driven_update.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief removes noise from a triangle mesh in two stages: it filters the face normals, then moves the vertices to agree with them.
*
* The first stage is any model of `FaceNormalFilter`. The second one \cgalCite{cgal:srml-fefmd-07} is that of Sun et al.: in each
* iteration the vertex \f$ x \f$ moves by
* \f[ \frac{1}{|F|} \sum_{f \in F} n_f \, (n_f \cdot (c_f - x)), \f]
* where \f$ F \f$ is the set of its faces, \f$ c_f \f$ the centroid of face \f$ f \f$ and \f$ n_f \f$ its filtered normal, which stays
* the same from iteration to iteration.
* Sun et al. filter and move once. Several rounds of both stages, in which the first one starts from the normals of the mesh that the
* round before left, are the way of Zhang et al. \cgalCite{cgal:zdzbl-gmnf-15} (see `Guided_normal_filter`).
*
* What is said at `denoise_anisotropic_fitting()` of the meshes accepted, of concurrency and of exceptions holds here as well.
* Borders move like the rest of the mesh: constrain their vertices to keep them.
* The run time of an iteration is linear in the size of the mesh if that of the filter is, and so is the memory.
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
*   \cgalParamNBegin{face_normal_filter}
*     \cgalParamDescription{the filter of the face normals}
*     \cgalParamType{a model of `FaceNormalFilter`}
*     \cgalParamDefault{`Thresholded_normal_filter(0.5, 2)`}
*   \cgalParamNEnd
*   \cgalParamNBegin{number_of_normal_iterations}
*     \cgalParamDescription{the number of iterations of the filter in each round}
*     \cgalParamType{unsigned int}
*     \cgalParamDefault{`20`}
*   \cgalParamNEnd
*   \cgalParamNBegin{number_of_iterations}
*     \cgalParamDescription{the maximal number of iterations in which the vertices move, in each round. The iterations end early when no vertex moves any more.}
*     \cgalParamType{unsigned int}
*     \cgalParamDefault{`10`}
*   \cgalParamNEnd
*   \cgalParamNBegin{number_of_rounds}
*     \cgalParamDescription{how many times the two stages follow each other}
*     \cgalParamType{unsigned int}
*     \cgalParamDefault{`1`}
*     \cgalParamExtra{at least `1`}
*   \cgalParamNEnd
*   \cgalParamNBegin{visitor}
*     \cgalParamDescription{a visitor that is told of each iteration in which the vertices moved and can end the run}
*     \cgalParamType{a model of `DenoisingVisitor`, or a `std::reference_wrapper` of one}
*     \cgalParamDefault{a visitor that lets the run go on}
*     \cgalParamExtra{If the visitor ends the run, the mesh holds the result of the last iteration completed.}
*   \cgalParamNEnd
*   \cgalParamNBegin{face_normal_map}
*     \cgalParamDescription{a property map that holds, on return, the filtered unit normals of the last round, with which the denoised mesh is to agree}
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
* @return the number of iterations in which the vertices moved, of all rounds together, and whether the last one moved no vertex
*
* @throw std::invalid_argument if a parameter is out of its range, if a face is not a triangle, if a coordinate is not
*        finite, or if an index map does not number the elements from zero without a gap
* @throw std::length_error if the mesh has more than 250 million vertices or faces
*
* \sa `FaceNormalFilter`
* \sa `denoise_anisotropic_fitting()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename Range, typename TriangleMesh,
          typename NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , internal::Enable_if_not_named_parameters<TriangleMesh> = 0
#endif
          >
Denoising_result denoise_with_normals(const Range& range, TriangleMesh& tmesh,
                                      const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const std::size_t number_of_rounds
    = internal::checked_count("number_of_rounds",
                              choose_parameter(get_parameter(np, internal_np::number_of_rounds), 1), 1);
  const std::size_t number_of_normal_iterations
    = internal::checked_count("number_of_normal_iterations",
                              choose_parameter(get_parameter(np, internal_np::number_of_normal_iterations), 20), 0);
  const std::size_t number_of_iterations
    = internal::checked_count("number_of_iterations",
                              choose_parameter(get_parameter(np, internal_np::number_of_iterations), 10), 0);
  const auto filter
    = choose_parameter(get_parameter(np, internal_np::face_normal_filter), Thresholded_normal_filter(0.5, 2));

  internal::Normal_driven_update<ConcurrencyTag, typename std::decay<decltype(filter)>::type>
    update(filter, number_of_rounds, number_of_normal_iterations, number_of_iterations);
  return internal::denoise_mesh(range, tmesh, np,
                                [&](Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable, const auto& report)
                                { return update.run(mesh, is_movable, report); },
                                update);
}

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief the same for all vertices of `tmesh`.
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Denoising_result denoise_with_normals(TriangleMesh& tmesh,
                                      const CGAL_NP_CLASS& np = parameters::default_values())
{
  return denoise_with_normals<ConcurrencyTag>(vertices(tmesh), tmesh, np);
}

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_DENOISE_WITH_NORMALS_H
