#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMD = CGAL::Surface_mesh_denoising;

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                   Mesh;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/noisy_part.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // a first run makes the sharp edges clear enough to be found by their angle
  SMD::denoise_anisotropic_fitting(mesh);
  auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  PMP::detect_sharp_edges(mesh, 40, is_sharp);

  // a second run, on the left half of the mesh only, does not mix what lies on different sides of them
  const CGAL::Bbox_3 bbox = PMP::bbox(mesh);
  std::vector<Mesh::Vertex_index> left;
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(mesh.point(v).x() < 0.5 * (bbox.xmin() + bbox.xmax()))
      left.push_back(v);
  SMD::denoise_anisotropic_fitting(left, mesh, CGAL::parameters::edge_is_constrained_map(is_sharp));

  std::cout << left.size() << " of " << mesh.number_of_vertices() << " vertices were free to move" << std::endl;
  CGAL::IO::write_polygon_mesh("denoised_left.off", mesh);
  return EXIT_SUCCESS;
}
