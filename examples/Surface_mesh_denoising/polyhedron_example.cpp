#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh_denoising/anisotropic_neighborhood.h>
#include <CGAL/Surface_mesh_denoising/denoise_isotropic_fitting.h>
#include <CGAL/Surface_mesh_denoising/filter_vertex_normals.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace SMD = CGAL::Surface_mesh_denoising;

typedef CGAL::Exact_predicates_inexact_constructions_kernel             Kernel;
typedef CGAL::Polyhedron_3<Kernel>                                      Polyhedron;
typedef boost::graph_traits<Polyhedron>::vertex_descriptor              vertex_descriptor;
typedef boost::graph_traits<Polyhedron>::face_descriptor                face_descriptor;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/noisy_part.off";

  Polyhedron mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  std::map<vertex_descriptor, Kernel::Vector_3> normals;
  SMD::filter_vertex_normals(mesh, boost::make_assoc_property_map(normals));
  std::cout << "filtered normal of the first vertex: " << normals[*vertices(mesh).begin()] << std::endl;

  std::vector<face_descriptor> neighborhood;
  std::map<face_descriptor, double> distances;
  SMD::anisotropic_neighborhood(*faces(mesh).begin(), mesh, std::back_inserter(neighborhood),
                                CGAL::parameters::neighborhood_size(10)
                                                 .distance_map(boost::make_assoc_property_map(distances)));
  std::cout << "distances of the faces nearest to the first face:";
  for(const face_descriptor f : neighborhood)
    std::cout << ' ' << distances[f];
  std::cout << std::endl;

  SMD::denoise_isotropic_fitting(mesh, CGAL::parameters::number_of_iterations(5));

  CGAL::IO::write_polygon_mesh("smoothed.off", mesh);
  return EXIT_SUCCESS;
}
