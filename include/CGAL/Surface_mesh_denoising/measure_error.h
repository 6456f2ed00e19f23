// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_MEASURE_ERROR_H
#define CGAL_SURFACE_MESH_DENOISING_MEASURE_ERROR_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/internal/named_parameters.h>
#include <CGAL/Surface_mesh_denoising/Denoising_error.h>
#include <CGAL/Surface_mesh_denoising/internal/Mesh_comparison.h>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief measures the angles between the normals of the corresponding faces of two triangle meshes.
*
* The `i`-th face of the one mesh corresponds to the `i`-th face of the other one.
* Faces that are degenerate in one of the meshes have no normal: they are not in the means, and are counted as unknown.
*
* The time is linear in the number of faces.
*
* @tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag` (the
*         default), `Parallel_tag` and `Parallel_if_available_tag`. The result does not depend on it.
* @tparam TriangleMesh1 a model of `FaceListGraph`
* @tparam TriangleMesh2 a model of `FaceListGraph`
* @tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
* @tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
*
* @param denoised the mesh to be measured
* @param ground_truth the mesh without noise
* @param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters" for `denoised`,
*        among the ones listed below
* @param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters" for `ground_truth`,
*        among the ones listed below
*
* \cgalNamedParamsBegin
*   \cgalParamNBegin{vertex_point_map}
*     \cgalParamDescription{a property map associating points to the vertices of the mesh}
*     \cgalParamType{a class model of `ReadablePropertyMap` with
*                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
*     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
*   \cgalParamNEnd
*   \cgalParamNBegin{vertex_index_map}
*     \cgalParamDescription{a property map associating to each vertex of the mesh a unique index between `0` and
*                           `num_vertices(mesh) - 1`}
*     \cgalParamType{a class model of `ReadablePropertyMap` with
*                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and an integer as value type}
*     \cgalParamDefault{the order of the vertices in the mesh}
*   \cgalParamNEnd
*   \cgalParamNBegin{face_index_map}
*     \cgalParamDescription{a property map associating to each face of the mesh a unique index between `0` and
*                           `num_faces(mesh) - 1`}
*     \cgalParamType{a class model of `ReadablePropertyMap` with
*                    `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer as value type}
*     \cgalParamDefault{the order of the faces in the mesh}
*   \cgalParamNEnd
*   \cgalParamNBegin{geom_traits}
*     \cgalParamDescription{an instance of a geometric traits class}
*     \cgalParamType{a class model of `Kernel` whose number type is `float` or `double`}
*     \cgalParamDefault{a \cgal Kernel deduced from the point type, using `CGAL::Kernel_traits`}
*   \cgalParamNEnd
* \cgalNamedParamsEnd
*
* @return the angles
*
* @throw std::invalid_argument if the meshes have different numbers of faces, if a face is not a triangle, if a
*        coordinate is not finite, or if an index map does not number the elements from zero without a gap
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh1, typename TriangleMesh2,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters>
Angular_error angular_error(const TriangleMesh1& denoised,
                            const TriangleMesh2& ground_truth,
                            const NamedParameters1& np1 = parameters::default_values(),
                            const NamedParameters2& np2 = parameters::default_values())
{
  return internal::Mesh_comparison<ConcurrencyTag>(denoised, ground_truth, np1, np2).angular_error();
}

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief returns the number of faces whose normals in the two meshes are more than 90 degrees apart.
* This is `Angular_error::number_of_flipped_faces`; for template parameters, parameters and exceptions see
* `angular_error()`.
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh1, typename TriangleMesh2,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters>
std::size_t number_of_flipped_faces(const TriangleMesh1& denoised,
                                    const TriangleMesh2& ground_truth,
                                    const NamedParameters1& np1 = parameters::default_values(),
                                    const NamedParameters2& np2 = parameters::default_values())
{
  return angular_error<ConcurrencyTag>(denoised, ground_truth, np1, np2).number_of_flipped_faces;
}

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief returns the number of faces of a triangle mesh that have no normal: up to rounding errors, their area is zero.
*
* The time is linear in the number of faces.
*
* @tparam TriangleMesh a model of `FaceListGraph`
* @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
*
* @param tmesh the triangle mesh
* @param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map` and `geom_traits`,
*        as of `angular_error()`
*
* @throw std::invalid_argument if a face is not a triangle, or if a coordinate is not finite
*/
template <typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
std::size_t number_of_degenerate_faces(const TriangleMesh& tmesh,
                                       const NamedParameters& np = parameters::default_values())
{
  return internal::Measured_mesh<Sequential_tag>(tmesh, np).number_of_degenerate_faces();
}

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief measures the distances from the vertices of a triangle mesh to the surface of another one.
*
* The meshes need not have the same connectivity; if they have, the queries are quicker.
* Vertices without a face are left out, and so are degenerate faces of `ground_truth`.
*
* With \f$ n \f$ vertices, the time is about \f$ O(n \log n) \f$.
*
* For the template parameters and the parameters see `angular_error()`.
*
* @throw std::invalid_argument if the area of `ground_truth` is zero, if a face is not a triangle, or if a coordinate is
*        not finite
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh1, typename TriangleMesh2,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters>
Vertex_distance_error vertex_distance_error(const TriangleMesh1& denoised,
                                            const TriangleMesh2& ground_truth,
                                            const NamedParameters1& np1 = parameters::default_values(),
                                            const NamedParameters2& np2 = parameters::default_values())
{
  return internal::Mesh_comparison<ConcurrencyTag>(denoised, ground_truth, np1, np2).vertex_distance_error();
}

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief measures the distances from either of two triangle meshes to the other one, over their whole surfaces.
*
* The surfaces are sampled, with the same density everywhere on a surface. The mean, the root mean square and the
* histogram are those of all samples of both surfaces. The maximum is that of the samples and all vertices; as the number
* of samples grows, it approaches the symmetric Hausdorff distance from below.
* The meshes need not have the same connectivity; if they have, the queries are quicker.
*
* With \f$ n \f$ samples and faces, the time is about \f$ O(n \log n) \f$.
*
* @tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag` (the
*         default), `Parallel_tag` and `Parallel_if_available_tag`. The result does not depend on it.
* @tparam TriangleMesh1 a model of `FaceListGraph`
* @tparam TriangleMesh2 a model of `FaceListGraph`
* @tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
* @tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
*
* @param denoised the first mesh
* @param ground_truth the second mesh. Its mean edge length is the unit of `bin_width`.
* @param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters" for `denoised`,
*        among those of `angular_error()` and the ones listed below
* @param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters" for `ground_truth`,
*        among those of `angular_error()` and `number_of_points_on_faces`
*
* \cgalNamedParamsBegin
*   \cgalParamNBegin{number_of_points_on_faces}
*     \cgalParamDescription{the number of samples on the faces of the mesh}
*     \cgalParamType{unsigned int}
*     \cgalParamDefault{four times the number of faces}
*     \cgalParamExtra{At least `1`.}
*   \cgalParamNEnd
*   \cgalParamNBegin{random_seed}
*     \cgalParamDescription{the seed of the random numbers that place the samples on both meshes. The same seed gives
*                           the same samples on each platform.}
*     \cgalParamType{unsigned int}
*     \cgalParamDefault{`0`}
*   \cgalParamNEnd
*   \cgalParamNBegin{number_of_bins}
*     \cgalParamDescription{the number of bins of the histogram. The last one takes all greater distances, too.}
*     \cgalParamType{unsigned int}
*     \cgalParamDefault{`50`}
*     \cgalParamExtra{At least `1`.}
*   \cgalParamNEnd
*   \cgalParamNBegin{bin_width}
*     \cgalParamDescription{the width of a bin of the histogram, in mean edge lengths of `ground_truth`}
*     \cgalParamType{double}
*     \cgalParamDefault{`0.02`}
*     \cgalParamExtra{The range is all positive numbers.}
*   \cgalParamNEnd
* \cgalNamedParamsEnd
*
* @throw std::invalid_argument if a parameter is out of its range, if the area of a mesh is zero, if a face is not a
*        triangle, or if a coordinate is not finite
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh1, typename TriangleMesh2,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters>
Symmetric_distance symmetric_distance(const TriangleMesh1& denoised,
                                      const TriangleMesh2& ground_truth,
                                      const NamedParameters1& np1 = parameters::default_values(),
                                      const NamedParameters2& np2 = parameters::default_values())
{
  const internal::Sampling_parameters sampling(np1, np2);
  return internal::Mesh_comparison<ConcurrencyTag>(denoised, ground_truth, np1, np2).symmetric_distance(sampling);
}

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief returns the difference of the volumes that two triangle meshes enclose, as a share of the volume of the second
* one: positive if `denoised` is larger.
* A mesh with borders counts as closed by triangles from the edges of each border to the centroid of its vertices.
*
* The time is linear in the number of faces, and quasilinear in the number of border edges.
* For the template parameters and the parameters see `angular_error()`.
*
* @throw std::invalid_argument if a face is not a triangle, or if a coordinate is not finite
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh1, typename TriangleMesh2,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters>
double relative_volume_change(const TriangleMesh1& denoised,
                              const TriangleMesh2& ground_truth,
                              const NamedParameters1& np1 = parameters::default_values(),
                              const NamedParameters2& np2 = parameters::default_values())
{
  return internal::Mesh_comparison<ConcurrencyTag>(denoised, ground_truth, np1, np2).relative_volume_change();
}

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief measures the error of a denoised mesh by everything that this header offers, and computes nothing twice.
*
* For template parameters, parameters and exceptions see `angular_error()` and `symmetric_distance()`.
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh1, typename TriangleMesh2,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters>
Denoising_error measure_error(const TriangleMesh1& denoised,
                              const TriangleMesh2& ground_truth,
                              const NamedParameters1& np1 = parameters::default_values(),
                              const NamedParameters2& np2 = parameters::default_values())
{
  const internal::Sampling_parameters sampling(np1, np2);
  internal::Mesh_comparison<ConcurrencyTag> comparison(denoised, ground_truth, np1, np2);

  Denoising_error error;
  error.angular = comparison.angular_error();
  error.vertex_distance = comparison.vertex_distance_error();
  error.symmetric_distance = comparison.symmetric_distance(sampling);
  error.relative_volume_change = comparison.relative_volume_change();
  error.number_of_degenerate_faces = comparison.number_of_degenerate_faces();
  return error;
}

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_MEASURE_ERROR_H
