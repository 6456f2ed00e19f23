// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_ANISOTROPIC_NEIGHBORHOOD_H
#define CGAL_SURFACE_MESH_DENOISING_ANISOTROPIC_NEIGHBORHOOD_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/internal/named_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/check_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/Mesh_dual_graph.h>
#include <CGAL/Surface_mesh_denoising/internal/Neighborhood_search.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief finds the faces nearest to a seed face in a distance to which differences of normals add, so that they come to lie on
* the same side of an edge as the seed.
*
* The normal-weighted distance \cgalCite{cgal:obs-mssan-02} from the seed \f$ i \f$ is the length of a shortest path of adjacent faces, where the
* step from face \f$ j \f$ to face \f$ k \f$ counts
* \f[ \delta_{jk} \left( 1 + \omega \left( \frac{|n_j - n_k|^2}{6} + \frac{|n_i - n_j|^2}{2} + \frac{|n_i - n_k|^2}{2} \right) \right). \f]
* \f$ \delta_{jk} \f$ is the length of the way from centroid to centroid through the midpoint of the common edge, \f$ n \f$ is a unit normal.
*
* The run time is \f$ O(k \log k) \f$ and the memory \f$ O(k) \f$ for \f$ k \f$ faces, whatever the size of the mesh.
*
* @tparam TriangleMesh a model of `FaceGraph`. The number type of its geometric traits is `float` or `double`.
* @tparam FaceOutputIterator a model of `OutputIterator` that holds
*         `boost::graph_traits<TriangleMesh>::%face_descriptor`
* @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
*
* @param seed the face from which distances are measured
* @param tmesh a triangle mesh
* @param faces receives the faces in order of increasing distance, `seed` first
* @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
*
* \cgalNamedParamsBegin
*   \cgalParamNBegin{neighborhood_size}
*     \cgalParamDescription{the maximal number of faces, with the seed}
*     \cgalParamType{unsigned int}
*     \cgalParamDefault{`40`}
*     \cgalParamExtra{at least `1`}
*   \cgalParamNEnd
*   \cgalParamNBegin{normal_weight}
*     \cgalParamDescription{\f$ \omega \f$, the weight of differences of normals}
*     \cgalParamType{double}
*     \cgalParamDefault{`200`}
*     \cgalParamExtra{The range is all positive numbers.}
*   \cgalParamNEnd
*   \cgalParamNBegin{face_normal_map}
*     \cgalParamDescription{a property map with the unit normals of the faces, for example filtered ones}
*     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor`
*                    as key type and `%Vector_3` as value type}
*     \cgalParamDefault{the normals of the triangles}
*   \cgalParamNEnd
*   \cgalParamNBegin{distance_map}
*     \cgalParamDescription{a property map that holds, on return, the distances of the faces written to `faces`}
*     \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor`
*                    as key type and a number type as value type}
*     \cgalParamDefault{none}
*   \cgalParamNEnd
*   \cgalParamNBegin{edge_is_constrained_map}
*     \cgalParamDescription{a property map with the constrained-or-not status of each edge of `tmesh`. No path
*                           crosses a constrained edge.}
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
*   \cgalParamNBegin{geom_traits}
*     \cgalParamDescription{an instance of a geometric traits class}
*     \cgalParamType{a class model of `Kernel` whose number type is `float` or `double`}
*     \cgalParamDefault{a \cgal Kernel deduced from the point type, using `CGAL::Kernel_traits`}
*   \cgalParamNEnd
* \cgalNamedParamsEnd
*
* @return the output iterator behind the last face
*
* @throw std::invalid_argument if a parameter is out of its range or a face that the search meets is not a triangle
*
* \sa `denoise_anisotropic_fitting()`
*/
template <typename TriangleMesh, typename FaceOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
FaceOutputIterator
anisotropic_neighborhood(const typename boost::graph_traits<TriangleMesh>::face_descriptor seed,
                         const TriangleMesh& tmesh, FaceOutputIterator faces,
                         const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  typedef typename internal::Require_floating_point<
    typename GetGeomTraits<TriangleMesh, NamedParameters>::type::FT>::type FT;

  std::size_t neighborhood_size
    = internal::checked_count("neighborhood_size",
                              choose_parameter(get_parameter(np, internal_np::neighborhood_size), 40), 1);
  if(neighborhood_size > 1000) // counting the faces takes time in some meshes
    neighborhood_size = (std::min)(neighborhood_size, std::size_t(num_faces(tmesh)));
  const double normal_weight
    = internal::checked_positive("normal_weight",
                                 choose_parameter(get_parameter(np, internal_np::normal_weight), 200.));
  const auto vertex_points = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                              get_const_property_map(CGAL::vertex_point, tmesh));
  const auto face_normals = get_parameter(np, internal_np::face_normal);
  const auto is_constrained = choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                               Static_boolean_property_map<edge_descriptor, false>());

  typedef internal::Mesh_dual_graph<TriangleMesh,
                                    typename std::decay<decltype(vertex_points)>::type,
                                    typename std::decay<decltype(face_normals)>::type,
                                    typename std::decay<decltype(is_constrained)>::type> Dual_graph;
  const Dual_graph dual(tmesh, seed, normal_weight, vertex_points, face_normals, is_constrained);
  internal::Neighborhood_search<Dual_graph> search(dual);
  for(const auto& neighbor : search(seed, neighborhood_size))
  {
    if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::distance_map_t>::value)
      put(get_parameter(np, internal_np::distance_map), neighbor.face, FT(neighbor.distance * dual.unit()));
    *faces++ = neighbor.face;
  }
  return faces;
}

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_ANISOTROPIC_NEIGHBORHOOD_H
