// Reads triangle meshes from files and writes them, for programs whose user names the files.
// What goes wrong is told by a std::runtime_error, in one line.

#ifndef SURFACE_MESH_DENOISING_EXAMPLES_MESH_FILES_H
#define SURFACE_MESH_DENOISING_EXAMPLES_MESH_FILES_H

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <fstream>
#include <initializer_list>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace mesh_files {

// keeps the messages of the readers and writers from the terminal as long as it lives
class Silence
{
public:
  Silence() : m_cerr(std::cerr.rdbuf(nullptr)) {}
  ~Silence()
  {
    std::cerr.rdbuf(m_cerr);
    std::cerr.clear();
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  std::streambuf* m_cerr;
};

inline std::string extension(const std::string& path)
{
  const std::size_t dot = path.find_last_of("./\\");
  std::string e = (dot == std::string::npos || path[dot] != '.') ? "" : path.substr(dot + 1);
  std::transform(e.begin(), e.end(), e.begin(), [](const unsigned char c) { return char(std::tolower(c)); });
  return e;
}

inline void check_extension(const std::string& path, const std::initializer_list<const char*> known)
{
  const std::string e = extension(path);
  if(std::find(known.begin(), known.end(), e) != known.end())
    return;
  std::string list;
  for(const char* k : known)
    list += std::string(list.empty() ? "." : ", .") + k;
  throw std::runtime_error(path + ": the file name must end in one of " + list);
}

inline void check_readable(const std::string& path)
{
  check_extension(path, { "off", "obj", "ply", "stl", "ts" });
  std::ifstream file(path, std::ios::binary);
  if(!file || file.peek() == std::ifstream::traits_type::eof())
    throw std::runtime_error(path + ": cannot be read");
}

inline void check_writable(const std::string& path)
{
  check_extension(path, { "off", "obj", "ply", "stl", "ts" });
  const bool is_new = !std::ifstream(path);
  // opened for appending: a file that is there stays as it is
  if(!std::ofstream(path, std::ios::app))
    throw std::runtime_error(path + ": cannot be written");
  if(is_new)
    std::remove(path.c_str());
}

// what was done to the faces in the file to make them a triangle mesh
struct Reading_report
{
  bool is_repaired = false;
  bool is_triangulated = false;
};

template <typename Mesh, typename Point>
bool read_and_repair_soup(const std::string& path, Mesh& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > polygons;
  if(!CGAL::IO::read_polygon_soup(path, points, polygons))
    return false;
  PMP::repair_polygon_soup(points, polygons);
  PMP::orient_polygon_soup(points, polygons);
  if(!PMP::is_polygon_soup_a_polygon_mesh(polygons))
    return false;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  return true;
}

template <typename Mesh>
Reading_report read_triangle_mesh(const std::string& path, Mesh& mesh)
{
  check_readable(path);

  Reading_report report;
  bool is_read = false;
  try
  {
    Silence silence;
    // a file of the format STL has each triangle with points of its own
    is_read = extension(path) != "stl" && CGAL::IO::read_polygon_mesh(path, mesh) && !is_empty(mesh);
    if(!is_read)
    {
      clear(mesh);
      is_read = read_and_repair_soup<Mesh, typename Mesh::Point>(path, mesh);
      report.is_repaired = is_read;
    }
    if(is_read && !is_triangle_mesh(mesh))
    {
      is_read = CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
      report.is_triangulated = is_read;
    }
  }
  catch(const std::exception&)
  {
    is_read = false;
  }
  if(!is_read || faces(mesh).empty())
    throw std::runtime_error(path + ": holds no mesh that can be read");
  return report;
}

template <typename Mesh>
void write_triangle_mesh(const std::string& path, const Mesh& mesh)
{
  check_writable(path);
  bool is_written = false;
  try
  {
    Silence silence;
    is_written = CGAL::IO::write_polygon_mesh(path, mesh, CGAL::parameters::stream_precision(17));
  }
  catch(const std::exception&)
  {}
  if(!is_written)
    throw std::runtime_error(path + ": cannot be written");
}

} // namespace mesh_files

#endif // SURFACE_MESH_DENOISING_EXAMPLES_MESH_FILES_H
