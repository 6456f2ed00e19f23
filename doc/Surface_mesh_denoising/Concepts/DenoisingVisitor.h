/*!
\ingroup PkgSurfaceMeshDenoisingConcepts
\cgalConcept

The concept `DenoisingVisitor` describes an object that an iterative denoising function tells of its progress, and that can end the run.

\sa `CGAL::Surface_mesh_denoising::denoise_anisotropic_fitting()`
\sa `CGAL::Surface_mesh_denoising::denoise_isotropic_fitting()`
*/
class DenoisingVisitor
{
public:
  /*!
  is called after each iteration, by the thread that called the denoising function.

  \param iteration the number of iterations completed
  \param largest_displacement the largest displacement of a vertex in this iteration, in the unit of the coordinates
  \param has_converged whether this iteration is the last one since the mesh hardly changes any more
  \return whether to go on. If not, the mesh holds the result of this iteration. If an exception is thrown, the mesh is as it was
          before the call.
  */
  bool iteration_completed(std::size_t iteration, double largest_displacement, bool has_converged);
};
