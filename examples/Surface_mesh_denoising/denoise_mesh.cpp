#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>

#include "include/mesh_files.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace SMD = CGAL::Surface_mesh_denoising;

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                   Mesh;

struct Options
{
  std::string input, output;
  bool is_help_asked_for = false;
  bool is_parallel = false;
  bool are_parameters_given = false;

  double angle_threshold = 0.5;
  int number_of_iterations = 30;
  int number_of_normal_iterations = 5;
  int neighborhood_size = 40;
  double normal_weight = 200;
  double convergence_threshold = 0.05;
  double relaxation_factor = 0.5;
};

template <typename T>
T parsed(const std::string& name, const std::string& text)
{
  std::istringstream in(text);
  T value;
  if(!(in >> value) || in.peek() != std::istringstream::traits_type::eof())
    throw std::invalid_argument("--" + name + ": '" + text + "' is not "
                                + (std::is_integral<T>::value ? "an integer" : "a number"));
  return value;
}

// an option that sets one parameter: `--name=value` or `--name value`
struct Parameter
{
  std::string name, description;
  std::function<void(const std::string&)> set;
  std::function<void(std::ostream&)> print;
};

template <typename T>
Parameter parameter(const std::string& name, T& variable, const std::string& description)
{
  return Parameter{ name, description,
                    [name, &variable](const std::string& text) { variable = parsed<T>(name, text); },
                    [&variable](std::ostream& out) { out << variable; } };
}

std::vector<Parameter> parameters_of(Options& options)
{
  return {
    parameter("angle-threshold", options.angle_threshold,
              "cosine of the angle from which on normals do not mix, in (0, 1)"),
    parameter("iterations", options.number_of_iterations, "maximal number of iterations"),
    parameter("normal-iterations", options.number_of_normal_iterations,
              "iterations of the normal filter; more for more noise"),
    parameter("neighborhood-size", options.neighborhood_size,
              "faces in a neighborhood; fewer keep finer detail and more noise"),
    parameter("normal-weight", options.normal_weight, "how much neighborhoods avoid edges, positive"),
    parameter("convergence-threshold", options.convergence_threshold,
              "end when nothing moves by more, in mean edge lengths, positive"),
    parameter("relaxation", options.relaxation_factor, "share of a step that is taken, in (0, 1]")
  };
}

void print_help()
{
  Options defaults;
  std::cout << "Usage: denoise_mesh [option...] INPUT OUTPUT\n"
               "Removes noise from a mesh and keeps its edges and corners.\n"
               "Reads and writes files whose names end in .off, .obj, .ply, .stl or .ts.\n\n";
  for(const Parameter& p : parameters_of(defaults))
  {
    std::cout << "  --" << std::left << std::setw(31) << p.name + "=VALUE" << p.description << " (default: ";
    p.print(std::cout);
    std::cout << ")\n";
  }
  std::cout << "  --parallel                       use all cores; the result is the same\n"
               "  --help                           print this\n";
}

Options parse(const std::vector<std::string>& arguments)
{
  Options options;
  const std::vector<Parameter> parameters = parameters_of(options);
  std::vector<std::string> paths;
  bool are_options_over = false;
  for(std::size_t i=0; i<arguments.size(); ++i)
  {
    const std::string& argument = arguments[i];
    if(are_options_over || argument.size() < 2 || argument[0] != '-')
      paths.push_back(argument);
    else if(argument == "--")
      are_options_over = true;
    else if(argument == "--help" || argument == "-h")
      options.is_help_asked_for = true;
    else if(argument == "--parallel")
      options.is_parallel = true;
    else
    {
      const std::size_t equal_sign = argument.find('=');
      const std::string name = argument.substr(0, equal_sign);
      const auto p = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& q) { return "--" + q.name == name; });
      if(p == parameters.end())
        throw std::invalid_argument("unknown option '" + argument + "', see --help");
      if(equal_sign == std::string::npos && i + 1 == arguments.size())
        throw std::invalid_argument(name + ": the value is missing");
      p->set(equal_sign == std::string::npos ? arguments[++i] : argument.substr(equal_sign + 1));
      options.are_parameters_given = true;
    }
  }
  if(options.is_help_asked_for)
    return options;
  if(paths.size() != 2)
    throw std::invalid_argument("two files are expected, INPUT and OUTPUT, see --help");
  options.input = paths[0];
  options.output = paths[1];
  return options;
}

bool is_terminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(fileno(stderr)) != 0;
#endif
}

// draws a progress bar on a terminal
class Progress_bar
{
public:
  explicit Progress_bar(const int number_of_iterations)
    : m_number_of_iterations(number_of_iterations), m_is_visible(is_terminal()) {}

  bool iteration_completed(const std::size_t iteration, const double largest_displacement, const bool has_converged)
  {
    if(!m_is_visible)
      return true;
    const std::size_t width = 40;
    const std::size_t done
      = has_converged ? width : (std::min)(width, width * iteration / std::size_t(m_number_of_iterations));
    std::cerr << "\r[" << std::string(done, '#') << std::string(width - done, ' ') << "] iteration " << iteration
              << ", moved by up to " << std::left << std::setw(12) << largest_displacement << std::flush;
    return true;
  }

  // removes the bar
  void finish() const
  {
    if(m_is_visible)
      std::cerr << "\r" << std::string(90, ' ') << "\r" << std::flush;
  }

private:
  int m_number_of_iterations;
  bool m_is_visible;
};

template <typename ConcurrencyTag>
SMD::Denoising_result denoise(Mesh& mesh, const Options& options, Progress_bar& progress_bar)
{
  const auto visitor = CGAL::parameters::visitor(std::ref(progress_bar));
  // the function has defaults of its own
  if(!options.are_parameters_given)
    return SMD::denoise_anisotropic_fitting<ConcurrencyTag>(mesh, visitor);
  return SMD::denoise_anisotropic_fitting<ConcurrencyTag>(mesh,
    visitor.angle_threshold(options.angle_threshold)
           .number_of_iterations(options.number_of_iterations)
           .number_of_normal_iterations(options.number_of_normal_iterations)
           .neighborhood_size(options.neighborhood_size)
           .normal_weight(options.normal_weight)
           .convergence_threshold(options.convergence_threshold)
           .relaxation_factor(options.relaxation_factor));
}

void run(const Options& options)
{
  Mesh mesh;
  const mesh_files::Reading_report reading = mesh_files::read_triangle_mesh(options.input, mesh);
  mesh_files::check_writable(options.output);
  std::cout << options.input << ": " << mesh.number_of_vertices() << " vertices, " << mesh.number_of_faces() << " faces"
            << (reading.is_repaired ? ", made from a repaired polygon soup" : "")
            << (reading.is_triangulated ? ", triangulated" : "") << std::endl;

  const std::vector<Kernel::Point_3> before(mesh.points().begin(), mesh.points().end());
  Progress_bar progress_bar(options.number_of_iterations);
  const auto start = std::chrono::steady_clock::now();
  SMD::Denoising_result result;
  try
  {
    result = options.is_parallel ? denoise<CGAL::Parallel_if_available_tag>(mesh, options, progress_bar)
                                 : denoise<CGAL::Sequential_tag>(mesh, options, progress_bar);
  }
  catch(...)
  {
    progress_bar.finish();
    throw;
  }
  progress_bar.finish();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  double mean = 0, maximum = 0;
  for(const Mesh::Vertex_index v : mesh.vertices())
  {
    const double displacement = std::sqrt(CGAL::squared_distance(mesh.point(v), before[v]));
    mean += displacement / double(mesh.number_of_vertices());
    maximum = (std::max)(maximum, displacement);
  }
  std::cout << result.number_of_iterations << " iterations, " << (result.has_converged ? "" : "not ") << "converged, "
            << std::setprecision(3) << seconds << " s\n"
            << "vertices moved by " << mean << " on average, by " << maximum << " at most" << std::endl;

  mesh_files::write_triangle_mesh(options.output, mesh);
  std::cout << options.output << ": written" << std::endl;
}

int main(int argc, char* argv[])
{
  try
  {
    const Options options = parse(std::vector<std::string>(argv + 1, argv + argc));
    if(options.is_help_asked_for)
      print_help();
    else
      run(options);
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << "denoise_mesh: " << e.what() << std::endl;
    return 2;
  }
}
