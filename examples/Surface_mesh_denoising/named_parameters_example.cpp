#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

namespace SMD = CGAL::Surface_mesh_denoising;

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                   Mesh;
typedef Mesh::Vertex_index                                    Vertex_index;
typedef Mesh::Edge_index                                      Edge_index;
typedef Mesh::Face_index                                      Face_index;

// prints the progress, and ends the run when the vertices move by less than a given length
struct Progress
{
  double small_displacement;

  bool iteration_completed(std::size_t iteration, double largest_displacement, bool has_converged) const
  {
    std::cout << "iteration " << iteration << ": vertices moved by up to " << largest_displacement
              << (has_converged ? ", converged" : "") << std::endl;
    return largest_displacement > small_displacement;
  }
};

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/noisy_part.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto face_normals = mesh.add_property_map<Face_index, Kernel::Vector_3>("f:normal").first;
  auto vertex_normals = mesh.add_property_map<Vertex_index, Kernel::Vector_3>("v:normal").first;
  auto is_fixed = mesh.add_property_map<Vertex_index, bool>("v:is_fixed", false).first;
  auto is_feature = mesh.add_property_map<Edge_index, bool>("e:is_feature", false).first;

  const SMD::Denoising_result result = SMD::denoise_anisotropic_fitting<CGAL::Parallel_if_available_tag>(
    mesh, CGAL::parameters::number_of_iterations(20)          // of fitting, at most
                           .convergence_threshold(0.05)       // in mean edge lengths
                           .neighborhood_size(40)             // faces around a vertex
                           .normal_weight(200.)               // keeps neighborhoods off edges
                           .face_normal_filter(SMD::Thresholded_normal_filter(0.4, 2))
                           .number_of_normal_iterations(10)   // of the filter in each iteration
                           .relaxation_factor(0.5)            // share of the way to the fitted surface
                           .visitor(Progress{1e-4})
                           .face_normal_map(face_normals)     // filtered normals, on return
                           .vertex_normal_map(vertex_normals)
                           .vertex_is_constrained_map(is_fixed)
                           .edge_is_constrained_map(is_feature)
                           .vertex_point_map(mesh.points())
                           .vertex_index_map(get(boost::vertex_index, mesh))
                           .face_index_map(get(boost::face_index, mesh))
                           .geom_traits(Kernel()));

  std::cout << result.number_of_iterations << " iterations, "
            << (result.has_converged ? "converged" : "not converged") << std::endl;
  std::cout << "normal of the first face: " << face_normals[*mesh.faces().begin()] << std::endl;

  // the default filter takes its parameters directly
  SMD::denoise_anisotropic_fitting(mesh, CGAL::parameters::angle_threshold(0.6).normal_exponent(4));

  // without any of these, the function adapts to the mesh: what it takes for noise, and its stages
  SMD::denoise_anisotropic_fitting(mesh, CGAL::parameters::noise_level(0.05) // in mean edge lengths
                                                          .use_adaptive_neighborhoods(true)
                                                          .use_adaptive_degree(true)
                                                          .use_round_patches(true)
                                                          .refit_patches(true)
                                                          .use_gentle_path(true)
                                                          .use_linear_path(true)
                                                          .use_quadric_path(true)
                                                          .remove_tangential_noise(true)
                                                          .remove_impulses(true)
                                                          .locate_noise(true)
                                                          .refine_noise_level(true)
                                                          .reassign_faces(true)
                                                          .unfold_faces(true)
                                                          .preserve_volume(true));
  return EXIT_SUCCESS;
}
