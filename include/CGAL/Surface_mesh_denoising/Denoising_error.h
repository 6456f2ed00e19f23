// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_DENOISING_DENOISING_ERROR_H
#define CGAL_SURFACE_MESH_DENOISING_DENOISING_ERROR_H

#include <CGAL/license/Surface_mesh_denoising.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_denoising {

/*!
* \ingroup PkgSurfaceMeshDenoisingRef
*
* The struct `Angular_error` holds the angles between the normals of corresponding faces of two meshes, in degrees.
* `angular_error()` returns it.
*
* The areas that weight are those of the faces of the denoised mesh.
* Degenerate faces are left out; where no face remains, the members are not a number.
*/
struct Angular_error
{
  double mean = 0;                              ///< mean over the faces
  double mean_square = 0;                       ///< mean of the squares over the faces, in square degrees
  double area_weighted_mean = 0;                ///< area-weighted mean
  double area_weighted_mean_square = 0;         ///< area-weighted mean of the squares, in square degrees
  double maximum = 0;                           ///< greatest angle
  std::size_t number_of_flipped_faces = 0;      ///< faces with an angle above 90 degrees
  std::size_t number_of_unknown_faces = 0;      ///< faces that are degenerate in one of the meshes
};

/*!
* \ingroup PkgSurfaceMeshDenoisingRef
*
* The struct `Vertex_distance_error` holds the distances from the vertices of a denoised mesh to the surface of another
* mesh, the ground truth, as lengths. `vertex_distance_error()` returns it.
*/
struct Vertex_distance_error
{
  double mean = 0;                              ///< mean over the vertices
  double root_mean_square = 0;                  ///< root of the mean square over the vertices
  /// \f$ \left( \sum_v \sum_{f \in F(v)} A_f \, d(v)^2 / (3 \sum_f A_f) \right)^{1/2} \f$, where \f$ d(v) \f$ is
  /// the distance of the vertex \f$ v \f$, \f$ F(v) \f$ are its faces, and \f$ A_f \f$ is the area of the face
  /// \f$ f \f$ of the denoised mesh
  double area_weighted_l2 = 0;
  double maximum = 0;                           ///< greatest distance of a vertex
  double mean_edge_length = 0;                  ///< mean edge length of the ground truth

  /// returns the same distances in mean edge lengths of the ground truth.
  Vertex_distance_error in_mean_edge_lengths() const
  {
    Vertex_distance_error e = *this;
    for(double* length : { &e.mean, &e.root_mean_square, &e.area_weighted_l2, &e.maximum, &e.mean_edge_length })
      *length /= mean_edge_length;
    return e;
  }
};

/*!
* \ingroup PkgSurfaceMeshDenoisingRef
*
* The struct `Symmetric_distance` holds the distances between two surfaces, in both directions, as lengths.
* `symmetric_distance()` returns it.
*/
struct Symmetric_distance
{
  double maximum = 0;                           ///< greatest distance: the symmetric Hausdorff distance, from below
  double mean = 0;                              ///< mean over both surfaces
  double root_mean_square = 0;                  ///< root of the mean square over both surfaces
  double mean_edge_length = 0;                  ///< mean edge length of the ground truth

  double bin_width = 0;                         ///< width of a bin of the histogram
  /// the share of the two surfaces whose distance falls into bin `i`, from `i * bin_width` on.
  /// The last bin holds all greater distances, too. The sum is one.
  std::vector<double> histogram;

  /// returns the same distances in mean edge lengths of the ground truth.
  Symmetric_distance in_mean_edge_lengths() const
  {
    Symmetric_distance d = *this;
    for(double* length : { &d.maximum, &d.mean, &d.root_mean_square, &d.mean_edge_length, &d.bin_width })
      *length /= mean_edge_length;
    return d;
  }
};

/*!
* \ingroup PkgSurfaceMeshDenoisingRef
*
* The struct `Denoising_error` holds every measure of the error of a denoised mesh. `measure_error()` returns it.
*/
struct Denoising_error
{
  Angular_error angular;                        ///< see `angular_error()`
  Vertex_distance_error vertex_distance;        ///< see `vertex_distance_error()`
  Symmetric_distance symmetric_distance;        ///< see `symmetric_distance()`
  double relative_volume_change = 0;            ///< see `relative_volume_change()`
  std::size_t number_of_degenerate_faces = 0;   ///< of the denoised mesh, see `number_of_degenerate_faces()`
};

} // namespace Surface_mesh_denoising
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_DENOISING_DENOISING_ERROR_H
