// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_DENOISE_ANISOTROPIC_FITTING_H
#define CGAL_SURFACE_MESH_DENOISING_DENOISE_ANISOTROPIC_FITTING_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <CGAL/Surface_mesh_denoising/internal/named_parameters.h>
#include <CGAL/Surface_mesh_denoising/Denoising_result.h>
#include <CGAL/Surface_mesh_denoising/Thresholded_normal_filter.h>
#include <CGAL/Surface_mesh_denoising/internal/Adaptive_fitting.h>
#include <CGAL/Surface_mesh_denoising/internal/Anisotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/internal/check_parameters.h>
#include <CGAL/Surface_mesh_denoising/internal/denoise_by_fitting.h>
#include <CGAL/Surface_mesh_denoising/internal/denoise_mesh.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {

namespace internal {

// whether one of the parameters of the iterative method is given
template <typename NamedParameters>
constexpr bool asks_for_iterative_fitting()
{
  using parameters::is_default_parameter;
  return !(is_default_parameter<NamedParameters, internal_np::number_of_iterations_t>::value
           && is_default_parameter<NamedParameters, internal_np::convergence_threshold_t>::value
           && is_default_parameter<NamedParameters, internal_np::neighborhood_size_t>::value
           && is_default_parameter<NamedParameters, internal_np::normal_weight_t>::value
           && is_default_parameter<NamedParameters, internal_np::face_normal_filter_t>::value
           && is_default_parameter<NamedParameters, internal_np::angle_threshold_t>::value
           && is_default_parameter<NamedParameters, internal_np::normal_exponent_t>::value
           && is_default_parameter<NamedParameters, internal_np::number_of_normal_iterations_t>::value
           && is_default_parameter<NamedParameters, internal_np::relaxation_factor_t>::value);
}

template <typename ConcurrencyTag, typename Range, typename TriangleMesh, typename NamedParameters>
Denoising_result denoise_by_iterative_fitting(const Range& range, TriangleMesh& tmesh, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const std::size_t number_of_normal_iterations
    = checked_count("number_of_normal_iterations",
                    choose_parameter(get_parameter(np, internal_np::number_of_normal_iterations), 5), 0);
  const std::size_t neighborhood_size
    = checked_count("neighborhood_size",
                    choose_parameter(get_parameter(np, internal_np::neighborhood_size), 40), 1);
  const double normal_weight
    = checked_positive("normal_weight",
                       choose_parameter(get_parameter(np, internal_np::normal_weight), 200.));
  const Thresholded_normal_filter default_filter(
    choose_parameter(get_parameter(np, internal_np::angle_threshold), 0.5),
    choose_parameter(get_parameter(np, internal_np::normal_exponent), 4));
  const auto filter = choose_parameter(get_parameter(np, internal_np::face_normal_filter), default_filter);

  Anisotropic_fitting<ConcurrencyTag, typename std::decay<decltype(filter)>::type>
    fit(filter, number_of_normal_iterations, neighborhood_size, normal_weight);
  return denoise_by_fitting<ConcurrencyTag>(range, tmesh, np, 30, fit);
}

template <typename ConcurrencyTag, typename Range, typename TriangleMesh, typename NamedParameters>
Denoising_result denoise_by_adaptive_fitting(const Range& range, TriangleMesh& tmesh, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  Adaptive_parameters adaptive;
  adaptive.use_adaptive_neighborhoods
    = choose_parameter(get_parameter(np, internal_np::use_adaptive_neighborhoods), true);
  adaptive.use_adaptive_degree = choose_parameter(get_parameter(np, internal_np::use_adaptive_degree), true);
  adaptive.use_round_patches = choose_parameter(get_parameter(np, internal_np::use_round_patches), true);
  adaptive.refit_patches = choose_parameter(get_parameter(np, internal_np::refit_patches), true);
  adaptive.use_gentle_path = choose_parameter(get_parameter(np, internal_np::use_gentle_path), true);
  adaptive.use_linear_path = choose_parameter(get_parameter(np, internal_np::use_linear_path), true);
  adaptive.use_quadric_path = choose_parameter(get_parameter(np, internal_np::use_quadric_path), true);
  adaptive.remove_tangential_noise
    = choose_parameter(get_parameter(np, internal_np::remove_tangential_noise), true);
  adaptive.remove_impulses = choose_parameter(get_parameter(np, internal_np::remove_impulses), true);
  adaptive.locate_noise = choose_parameter(get_parameter(np, internal_np::locate_noise), true);
  adaptive.refine_noise_level = choose_parameter(get_parameter(np, internal_np::refine_noise_level), true);
  adaptive.reassign_faces = choose_parameter(get_parameter(np, internal_np::reassign_faces), true);
  adaptive.unfold_faces = choose_parameter(get_parameter(np, internal_np::unfold_faces), true);
  adaptive.preserve_volume = choose_parameter(get_parameter(np, internal_np::preserve_volume), true);

  double noise_level = -1;
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::noise_level_t>::value)
    noise_level = checked_not_negative("noise_level", get_parameter(np, internal_np::noise_level));

  Adaptive_fitting<ConcurrencyTag> fit(adaptive, noise_level);
  return denoise_mesh(range, tmesh, np,
                      [&](Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable, const auto& report)
                      { return fit.run(mesh, is_movable, report); },
                      fit);
}

} // namespace internal

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief removes noise from a triangle mesh and keeps its edges and corners, by anisotropic surface fitting
* \cgalCite{cgal:wy-fpmd-12}.
*
* Without any of the parameters of the iterative method below, the function adapts to the mesh. It needs no parameter at all:
* - The <em>noise level</em> is estimated, see `estimate_noise_level()`.
* - A <em>pilot</em>, a first result, shows the edges: in many small steps, face normals are filtered bilaterally with a range that
*   starts from the noise level and shrinks, and vertices moved to agree with them.
* - <em>Patches</em> are fitted to the points as they were given. The neighborhood of a patch, see
*   `anisotropic_neighborhood()`, grows over the pilot as long as that promises to lower the error of the fit; so does the
*   choice between a plane, a quadratic surface, and one that bends as circles do. Patches overlap, and each vertex goes where
*   those over it agree best. They are <em>fitted again</em>, with the first ones in place of the pilot.
* - A <em>gentle path</em>, many small steps with wide ranges, makes a second result that spares small detail, a <em>linear
*   path</em>, Taubin's smoothing \cgalCite{cgal:t-spafs-95}, a third one that needs no normals, for where triangles are smaller than the
*   noise, and a <em>quadric path</em>, means of the planes around \cgalCite{cgal:jdd-nfms-03}, a fourth one for weak noise on smooth
*   shapes that bend within few triangles. Stein's unbiased risk estimate tells, from the noisy mesh alone, how much of what a path
*   took away was shape, and which result is closer to the true surface in each part of the mesh. They are mixed accordingly.
* - Faces at edges are <em>reassigned</em>: they take over the plane on the other side where that explains the given points better.
*   Noise that turns no faces over is along the normals, which tells the sides better.
* - <em>Tangential noise</em> turns faces over or, where it is weak, moves vertices of even triangles off the centers of their neighbors at
*   random, by which it is told from noise along the normals. Where it does, vertices slide, before patches are fitted, to where
*   triangles are even; and faces that face against the faces around them are <em>unfolded</em> in the end. The few that a mesh has
*   turned by itself stay.
* - <em>Impulses</em> are told by tails of the distances between the given points and the patches that are too heavy for the most of
*   them. They are cut off, and pilot and patches made anew. That happens, too, where the <em>noise level</em> that these distances
*   tell is much lower than the first estimate, which takes edges and small detail for noise. While most of them are detail, since
*   large ones lie together and others are small, the level is lowered further; if that does not end, there is no noise. Where all
*   seemed to be shape from the beginning, there is noise only if these distances are smaller than it seemed, and look like noise.
* - The surface is offset towards the <em>volume</em> that it enclosed before, which noise leaves as it is, on average; what
*   chance explains of the difference remains.
* A mesh without noise comes back as it is, and so does one where fewer than 50 vertices may move, which tell too little of noise.
*
* If any of the parameters of the iterative method is given, that method runs, with its other parameters at their defaults: each
* iteration filters the face normals; finds for each vertex the faces around it that lie on the same side of the
* edges, by a distance to which differences of normals add (see `anisotropic_neighborhood()`); fits a quadratic surface to the
* vertices of these faces; and moves the vertex towards its projection onto that surface, along the filtered vertex
* normal. The iterations end when the mesh hardly changes any more. These parameters are `number_of_iterations`,
* `convergence_threshold`, `neighborhood_size`, `normal_weight`, `face_normal_filter`, `angle_threshold`, `normal_exponent`,
* `number_of_normal_iterations` and `relaxation_factor`. The parameters of the adaptive method have then no effect.
*
* Connectivity does not change. Any triangle mesh is accepted, with borders, several connected components, degenerate faces, isolated or
* non-manifold vertices, self-intersections. A vertex stays where it is if the faces around it determine neither a quadratic surface
* nor a plane.
*
* The result does not depend on the order of vertices and faces, nor on position, orientation and unit, but for rounding.
* Coordinates are converted to `double` and back. A run with `Parallel_tag` gives the same result, to the last bit,
* as one with `Sequential_tag`.
*
* The run time and the memory of the adaptive method are \f$ O(n) \f$, where \f$ n \f$ is the size of the mesh.
* The run time of an iteration of the iterative method is \f$ O(n k \log k) \f$ and its memory \f$ O(n) \f$, where
* \f$ k \f$ is the size of a neighborhood: the cost of one neighborhood does not depend on \f$ n \f$.
*
* If an exception is thrown, by this function or by a map or the visitor, the points of the mesh are as before the call.
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
*   \cgalParamNBegin{noise_level}
*     \cgalParamDescription{Adaptive method: the standard deviation of the noise along the normals, in mean edge lengths of the surface
*                           without the noise. A larger one than is true smooths more.}
*     \cgalParamType{double}
*     \cgalParamDefault{`estimate_noise_level(tmesh)`, corrected for impulses, for detail of the shape and for places where noise is stronger}
*     \cgalParamExtra{The range is all numbers of at least zero.}
*   \cgalParamNEnd
*   \cgalParamNBegin{use_adaptive_neighborhoods}
*     \cgalParamDescription{Adaptive method: whether patches have sizes of their own. If not, all have 40 faces.}
*     \cgalParamType{Boolean}
*     \cgalParamDefault{`true`}
*   \cgalParamNEnd
*   \cgalParamNBegin{use_adaptive_degree}
*     \cgalParamDescription{Adaptive method: whether a patch is a plane or a parabolic cylinder where that fits as well as a quadratic
*                           surface, and a cubic surface where only that fits. If not, all are quadratic surfaces where the
*                           points determine one.}
*     \cgalParamType{Boolean}
*     \cgalParamDefault{`true`}
*   \cgalParamNEnd
*   \cgalParamNBegin{use_round_patches}
*     \cgalParamDescription{Adaptive method: whether a patch that bends may go on to bend as circles do, where that fits better. If not,
*                           it does so as parabolas do.}
*     \cgalParamType{Boolean}
*     \cgalParamDefault{`true`}
*   \cgalParamNEnd
*   \cgalParamNBegin{refit_patches}
*     \cgalParamDescription{Adaptive method: whether patches are fitted a second time, to the same points, with the first ones in place of the
*                           pilot. Only these may be cubic surfaces, and give faces the normals that triangles on them have.}
*     \cgalParamType{Boolean}
*     \cgalParamDefault{`true`}
*   \cgalParamNEnd
*   \cgalParamNBegin{use_gentle_path}
*     \cgalParamDescription{Adaptive method: whether the result of the patches is mixed with that of the gentle path.}
*     \cgalParamType{Boolean}
*     \cgalParamDefault{`true`}
*     \cgalParamExtra{Without it, the run takes about two thirds of the time, and organic shapes lose detail.}
*   \cgalParamNEnd
*   \cgalParamNBegin{use_linear_path}
*     \cgalParamDescription{Adaptive method: whether the result so far is mixed with that of the linear path.}
*     \cgalParamType{Boolean}
*     \cgalParamDefault{`true`}
*     \cgalParamExtra{It matters where triangles are smaller than the noise, as in meshes with triangles of very different sizes.}
*   \cgalParamNEnd
*   \cgalParamNBegin{use_quadric_path}
*     \cgalParamDescription{Adaptive method: whether the result so far is mixed with that of the quadric path. That is not made where the
*                           noise is more than about a third of the heights of the triangles, or there are impulses.}
*     \cgalParamType{Boolean}
*     \cgalParamDefault{`true`}
*     \cgalParamExtra{It matters where noise is weak and a smooth surface bends within few triangles. There, the run takes
*                     up to a fifth longer.}
*   \cgalParamNEnd
*   \cgalParamNBegin{remove_tangential_noise}
*     \cgalParamDescription{Adaptive method: whether vertices slide along the surface to where triangles are even, if turned faces, or triangles
*                           that are even but for random ways of their vertices, show that there is noise along the surface, too.}
*     \cgalParamType{Boolean}
*     \cgalParamDefault{`true`}
*   \cgalParamNEnd
*   \cgalParamNBegin{remove_impulses}
*     \cgalParamDescription{Adaptive method: whether impulses, noise that is much stronger at some vertices than at most, are cut off the
*                           points, and the noise level is corrected accordingly.}
*     \cgalParamType{Boolean}
*     \cgalParamDefault{`true`}
*     \cgalParamExtra{It has no effect if `noise_level` is given. Where there are impulses, the run takes about a third longer.}
*   \cgalParamNEnd
*   \cgalParamNBegin{locate_noise}
*     \cgalParamDescription{Adaptive method: whether noise may be stronger in some parts of the mesh than in others. Else one level is
*                           taken to hold everywhere.}
*     \cgalParamType{Boolean}
*     \cgalParamDefault{`true`}
*     \cgalParamExtra{It has no effect if `noise_level` is given, and hardly any where noise is as strong everywhere. Where it differs, the
*                     run takes up to a third longer, and up to a half longer on meshes of some thousand vertices.}
*   \cgalParamNEnd
*   \cgalParamNBegin{refine_noise_level}
*     \cgalParamDescription{Adaptive method: whether a noise level is lowered that is about 30 percent higher, or more, than the
*                           distances between the given points and the patches tell, but for what neighbors have in common
*                           of them, and noise looked for where all seems to be shape. Distances that are less than twice what
*                           the triangles leave of the shape, as those of vertices on chords, are no noise, unless they are more than
*                           one and a half times that and noise as strong everywhere shows beside cubic surfaces.}
*     \cgalParamType{Boolean}
*     \cgalParamDefault{`true`}
*     \cgalParamExtra{It has no effect if `noise_level` is given. It matters where noise is weak and the surface full of edges or detail;
*                     there, the run takes about a fifth longer, and up to a half longer on meshes full of detail. A mesh
*                     without noise comes back without it sooner, before a pilot is made.}
*   \cgalParamNEnd
*   \cgalParamNBegin{reassign_faces}
*     \cgalParamDescription{Adaptive method: whether faces at edges change sides where that explains the given points better.}
*     \cgalParamType{Boolean}
*     \cgalParamDefault{`true`}
*   \cgalParamNEnd
*   \cgalParamNBegin{unfold_faces}
*     \cgalParamDescription{Adaptive method: whether vertices slide along the surface where noise has turned faces against the faces around them.}
*     \cgalParamType{Boolean}
*     \cgalParamDefault{`true`}
*   \cgalParamNEnd
*   \cgalParamNBegin{preserve_volume}
*     \cgalParamDescription{Adaptive method: whether the surface is offset in the end to keep the volume, up to what chance explains.}
*     \cgalParamType{Boolean}
*     \cgalParamDefault{`true`}
*   \cgalParamNEnd
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
*   \cgalParamNBegin{neighborhood_size}
*     \cgalParamDescription{the maximal number of faces in the neighborhood of a vertex. Smaller neighborhoods keep finer detail and more noise.}
*     \cgalParamType{unsigned int}
*     \cgalParamDefault{`40`}
*     \cgalParamExtra{At least `1`. A quadratic surface takes at least 4 faces.}
*   \cgalParamNEnd
*   \cgalParamNBegin{normal_weight}
*     \cgalParamDescription{the weight \f$ \omega \f$ of differences of normals in the normal-weighted distance. The
*                           larger, the more neighborhoods avoid edges.}
*     \cgalParamType{double}
*     \cgalParamDefault{`200`}
*     \cgalParamExtra{The range is all positive numbers.}
*   \cgalParamNEnd
*   \cgalParamNBegin{face_normal_filter}
*     \cgalParamDescription{the filter of the face normals}
*     \cgalParamType{a model of `FaceNormalFilter`}
*     \cgalParamDefault{a `Thresholded_normal_filter` with the two following parameters}
*   \cgalParamNEnd
*   \cgalParamNBegin{angle_threshold}
*     \cgalParamDescription{\f$ T \f$, the cosine of the angle at which two normals begin to play a part in each other's mean. It applies
*                           to the default of `face_normal_filter`.}
*     \cgalParamType{double}
*     \cgalParamDefault{`0.5`}
*     \cgalParamExtra{The range is `(0, 1)`.}
*   \cgalParamNEnd
*   \cgalParamNBegin{normal_exponent}
*     \cgalParamDescription{the power of the weights in the default of `face_normal_filter`}
*     \cgalParamType{int}
*     \cgalParamDefault{`4`}
*     \cgalParamExtra{`2` or `4`}
*   \cgalParamNEnd
*   \cgalParamNBegin{number_of_normal_iterations}
*     \cgalParamDescription{the number of iterations of the face normal filter in each iteration. The more noise, the
*                           more.}
*     \cgalParamType{unsigned int}
*     \cgalParamDefault{`5`}
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
*     \cgalParamExtra{If the visitor ends the run, the mesh holds the result of the last iteration completed. An iteration of the
*                     adaptive method is a step of the pilot, or all that comes after the pilot, which is the last one.}
*   \cgalParamNEnd
*   \cgalParamNBegin{face_normal_map}
*     \cgalParamDescription{a property map that holds, on return, the unit normals with which the faces of the denoised mesh are
*                           made to agree: filtered normals, or those of the patches}
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
* \sa `estimate_noise_level()`
* \sa `denoise_isotropic_fitting()`
* \sa `anisotropic_neighborhood()`
* \sa `CGAL::Polygon_mesh_processing::smooth_shape()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename Range, typename TriangleMesh,
          typename NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , internal::Enable_if_not_named_parameters<TriangleMesh> = 0
#endif
          >
Denoising_result denoise_anisotropic_fitting(const Range& range, TriangleMesh& tmesh,
                                             const NamedParameters& np = parameters::default_values())
{
  if constexpr (internal::asks_for_iterative_fitting<NamedParameters>())
    return internal::denoise_by_iterative_fitting<ConcurrencyTag>(range, tmesh, np);
  else
    return internal::denoise_by_adaptive_fitting<ConcurrencyTag>(range, tmesh, np);
}

/*!
* \ingroup PkgSurfaceMeshDenoisingFunctions
*
* \brief the same for all vertices of `tmesh`.
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Denoising_result denoise_anisotropic_fitting(TriangleMesh& tmesh,
                                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  return denoise_anisotropic_fitting<ConcurrencyTag>(vertices(tmesh), tmesh, np);
}

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_DENOISE_ANISOTROPIC_FITTING_H
