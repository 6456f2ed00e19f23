// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_ESTIMATE_NOISE_LEVEL_H
#define CGAL_SURFACE_MESH_DENOISING_ESTIMATE_NOISE_LEVEL_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/internal/named_parameters.h>
#include <CGAL/Surface_mesh_denoising/Indexed_triangle_mesh.h>
#include <CGAL/Surface_mesh_denoising/internal/Mesh_io.h>
#include <CGAL/Surface_mesh_denoising/internal/Vertex_neighbors.h>
#include <CGAL/Surface_mesh_denoising/internal/noise_level.h>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief estimates how noisy a triangle mesh is.
*
* A quadratic surface is fitted to the vertices up to two edges away from each vertex, without the vertex itself. How far vertices
* stand out from these surfaces is noise where the shape is smooth. Medians keep edges and corners out, and differences between
* neighbors what is left of the shape. Strong noise is measured above a smoothed mesh, which follows a few percent of it: these are
* added.
*
* Where triangles are few and long, as in many CAD models, these surfaces cross edges of the shape nearly everywhere. Most edges
* between two triangles do not: in the median, how far their four vertices are from one plane bounds the noise. This counts where it
* tells less than 0.15 mean edge lengths, and less than half of what the surfaces tell; the level is then 1.4 times what it tells.
*
* Fine detail of the shape stands out like noise, but not everywhere alike, and neighbors stand out together. What is less than 0.045
* mean edge lengths, and far less in some parts of the mesh than in others, counts as detail, and the level is zero. So it is up to
* 0.2 mean edge lengths if neighbors stand out together even in the smoothest third of the mesh, where those of noise alone tend to
* opposite sides; above 0.15 they have to do so the more clearly. Unless it is noise beside cubic surfaces, which leave less of a
* smooth shape: about as strong everywhere, and as independent from vertex to vertex as nothing else, if about three hundred vertices
* or more can tell and it is between 0.0125 and 0.13 mean edge lengths. A coarse mesh full of detail may still pass for a noisy one,
* and weak noise on such a mesh, or on one with edges, up to about 0.05 mean edge lengths, for detail.
* `denoise_anisotropic_fitting()` knows more of it in the end. Fewer than 50 vertices tell too little, and fewer than 300 have no
* noise if each belongs to a face that lies in one plane with a neighbor: the level is zero.
*
* The noise is taken to be as strong everywhere: that of less than half of the mesh goes unnoticed, as the medians do not see it.
* `denoise_anisotropic_fitting()` looks for places like that.
*
* The noise is taken to be independent from vertex to vertex. That of a scanner need not be: noise that neighboring vertices have
* in common looks like shape, and the level comes out too low. Impulses that spare most vertices go unnoticed as well.
*
* @tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag` (the
*         default), `Parallel_tag` and `Parallel_if_available_tag`. The result is the same.
* @tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`. The number type of its
*         geometric traits is `float` or `double`.
* @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
*
* @param tmesh a triangle mesh
* @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
*
* \cgalNamedParamsBegin
*   \cgalParamNBegin{vertex_is_constrained_map}
*     \cgalParamDescription{a property map with the constrained-or-not status of each vertex of `tmesh`. Constrained vertices are taken
*                           to be free of noise and do not count.}
*     \cgalParamType{a class model of `ReadablePropertyMap` with
*                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `bool` as value type}
*     \cgalParamDefault{a default property map where no vertex is constrained}
*   \cgalParamNEnd
*   \cgalParamNBegin{edge_is_constrained_map}
*     \cgalParamDescription{a property map with the constrained-or-not status of each edge of `tmesh`. Vertices at constrained edges, like
*                           those on the border, do not count.}
*     \cgalParamType{a class model of `ReadablePropertyMap` with
*                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type}
*     \cgalParamDefault{a default property map where no edge is constrained}
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
* @return the standard deviation of the noise along the normals, in mean edge lengths of the surface without the noise, as in
*         `add_noise()`. That mean is the one of `tmesh`, less what the noise adds to it. Zero if nothing tells of noise.
*
* @throw std::invalid_argument if a face is not a triangle, if a coordinate is not finite, or if an index map does not
*        number the elements from zero without a gap
* @throw std::length_error if the mesh has more than 250 million vertices or faces
*
* \sa `denoise_anisotropic_fitting()`
* \sa `add_noise()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh,
          typename NamedParameters = parameters::Default_named_parameters>
double estimate_noise_level(const TriangleMesh& tmesh, const NamedParameters& np = parameters::default_values())
{
  auto io = internal::read_mesh(vertices(tmesh), tmesh,
                                parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                             get_const_property_map(CGAL::vertex_point, tmesh)), np);
  Indexed_triangle_mesh mesh = io.take_mesh();
  const double mean_edge_length = mesh.mean_edge_length<ConcurrencyTag>();
  if(!(mean_edge_length > 0))
    return 0;
  const internal::Noise_estimate noise
    = internal::estimate_noise<ConcurrencyTag>(mesh, mean_edge_length, internal::Vertex_neighbors(mesh), io.is_movable(),
                                               false);
  return noise.may_be_shape ? 0 : internal::in_smooth_edge_lengths(noise.level / mean_edge_length);
}

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_ESTIMATE_NOISE_LEVEL_H
