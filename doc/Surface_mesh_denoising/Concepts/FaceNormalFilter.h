/*!
\ingroup PkgSurfaceMeshDenoisingConcepts
\cgalConcept

The concept `FaceNormalFilter` describes a function object that removes noise from the face normals of a mesh. It is the first of the
two stages of denoising: the functions that take one move the vertices to agree with the normals that it returns.

\cgalHasModel `CGAL::Surface_mesh_denoising::Thresholded_normal_filter`
\cgalHasModel `CGAL::Surface_mesh_denoising::Bilateral_normal_filter`
\cgalHasModel `CGAL::Surface_mesh_denoising::Guided_normal_filter`
\cgalHasModel `CGAL::Surface_mesh_denoising::Mean_normal_filter`
\cgalHasModel `CGAL::Surface_mesh_denoising::Median_normal_filter`
\cgalHasModel `CGAL::Surface_mesh_denoising::Alpha_trimmed_normal_filter`
\cgalHasModel `CGAL::Surface_mesh_denoising::Adaptive_gaussian_normal_filter`

\sa `CGAL::Surface_mesh_denoising::denoise_anisotropic_fitting()`
\sa `CGAL::Surface_mesh_denoising::denoise_with_normals()`
*/
class FaceNormalFilter
{
public:
  /*!
  replaces `normals[f]` by the filtered normal of face `f`, for each face of `mesh`.

  On entry `normals` holds the unit normals of the faces of `mesh`. The normal of a degenerate face is that of the faces around it, or a
  null vector if there is none. On exit the normals have unit length, or are null.

  The result must be the same, bit for bit, for all values of `ConcurrencyTag`, and must not depend on the order of
  the faces but for rounding. Faces on either side of a constrained edge are no neighbors in `mesh`: a filter that goes through
  `mesh.neighbors()` and `mesh.faces_around_face()` respects them.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`
  \param mesh the mesh
  \param normals the normals of the faces
  \param number_of_iterations how many times the filter is applied
  */
  template <typename ConcurrencyTag>
  void operator()(const CGAL::Surface_mesh_denoising::Indexed_triangle_mesh& mesh,
                  std::vector<CGAL::Surface_mesh_denoising::Indexed_triangle_mesh::Vector_3>& normals,
                  std::size_t number_of_iterations,
                  ConcurrencyTag) const;
};
