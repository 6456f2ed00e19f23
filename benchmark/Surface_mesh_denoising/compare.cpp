// Copyright (c) 2026  The Surface_mesh_denoising authors.
// All rights reserved.
//
// This file is part of the CGAL-style package Surface_mesh_denoising.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares denoising methods on pairs of a noise-free and a noisy mesh; see --help.

#include "include/child_process.h"
#include "include/denoising_methods.h"
#include "include/generated_models.h"
#include "include/mesh_pairs.h"

#include <CGAL/Surface_mesh_denoising/measure_error.h>
#include <CGAL/version.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <unistd.h>

namespace SMD = CGAL::Surface_mesh_denoising;
namespace fs = std::filesystem;

using denoising_methods::Mesh;
using denoising_methods::Method;
using denoising_methods::Setting;

typedef mesh_pairs::Meshes<Mesh>    Meshes;
typedef mesh_pairs::Pair<Mesh>      Pair;

// ----- options

struct Options
{
  bool is_help_asked_for = false, is_list_asked_for = false;
  bool is_best_asked_for = false;
  std::vector<Method> methods = denoising_methods::all();
  std::vector<Pair> pairs;
  std::string folder;
  double time_out = 600;
};

void print_help()
{
  std::cout <<
    "Usage: compare [option...]\n"
    "Denoises noisy meshes with several methods, one run after the other, and compares the results with the meshes\n"
    "without noise. Prints a table in Markdown.\n\n"
    "  --methods=NAME,...              which methods (default: all)\n"
    "  --pair NAME NOISE_FREE NOISY    compare on two files, .off, .obj, .ply, .stl or .ts, with the same faces;\n"
    "                                  may be repeated\n"
    "  --models=NAME,...               compare on generated models with noise; all: all models\n"
    "                                  (default: twirl, cut_sphere, cad_part, organic_shape if there is no --pair)\n"
    "  --sizes=N,...                   their approximate numbers of vertices (default: 5000)\n"
    "  --triangles=KIND,...            regular, irregular (default: irregular)\n"
    "  --noise-kinds=KIND,...          kinds of noise (default: gaussian)\n"
    "  --noise-levels=X,...            standard deviations in mean edge lengths (default: 0.3)\n"
    "  --seed=N                        of the irregular triangles and the noise (default: 0)\n"
    "  --best                          also search a grid of parameters for the least mean angular error\n"
    "  --time-out=SECONDS              stop a run after this time (default: 600)\n"
    "  --output=FOLDER                 leave there the table, also as CSV, the histograms of the distances, and the\n"
    "                                  meshes that result from the default parameters\n"
    "  --list                          print the methods with their grids, the models and the kinds of noise\n"
    "  --help                          print this\n\n"
    "Columns of the table: E_a: mean angle between the normals of corresponding faces, in degrees; area E_a: the same,\n"
    "weighted by area; E_v: area-weighted L2 distance of the vertices to the noise-free mesh; max: the symmetric\n"
    "Hausdorff distance, both in mean edge lengths; flips: faces whose normal is off by more than 90 degrees; volume:\n"
    "its change; s: seconds on one core; its: iterations; MB: the most memory taken beyond that of the meshes.\n"
    "Methods see the noisy mesh only. 'best' is chosen for each pair by its noise-free mesh.\n";
}

void print_list()
{
  std::cout << "Methods, each with the grid that --best searches in addition to the defaults:\n";
  for(const Method& m : denoising_methods::all())
  {
    std::cout << "  " << m.name << "\n    " << m.description << "\n";
    for(const denoising_methods::Axis& axis : m.grid)
    {
      std::cout << "    " << axis.parameter << ":";
      for(const double value : axis.values)
        std::cout << " " << value;
      std::cout << "\n";
    }
  }
  std::cout << "\nGenerated models:\n";
  for(const generated_models::Generator& g : generated_models::all())
    std::cout << "  " << g.name << "\n";
  std::cout << "\nKinds of noise:\n";
  for(const mesh_pairs::Noise_kind& k : mesh_pairs::noise_kinds())
    std::cout << "  " << std::left << std::setw(12) << k.name << k.description << "\n";
}

template <typename T>
T parsed(const std::string& option, const std::string& text)
{
  std::istringstream in(text);
  T value;
  if(!(in >> value) || in.peek() != std::istringstream::traits_type::eof()
     || (std::is_unsigned<T>::value && text.find('-') != std::string::npos))
    throw std::invalid_argument(option + ": '" + text + "' is not "
                                + (std::is_integral<T>::value ? "a number of that kind" : "a number"));
  return value;
}

std::vector<std::string> split(const std::string& option, const std::string& list)
{
  std::vector<std::string> parts;
  std::istringstream in(list + ",");
  std::string part;
  while(std::getline(in, part, ','))
  {
    if(part.empty())
      throw std::invalid_argument(option + ": an entry of the list is empty");
    parts.push_back(part);
  }
  return parts;
}

// the element of that name
template <typename Range>
const typename Range::value_type& find(const std::string& option, const Range& range, const std::string& name)
{
  for(const auto& element : range)
    if(element.name == name)
      return element;
  throw std::invalid_argument(option + ": there is no '" + name + "', see --list");
}

template <typename T, typename Parse>
std::vector<T> parsed_list(const std::string& option, const std::string& list, const Parse& parse)
{
  std::vector<T> values;
  for(const std::string& part : split(option, list))
    values.push_back(parse(part));
  return values;
}

void check_pair_name(const std::string& name)
{
  const bool is_plain = !name.empty() && name[0] != '.' && std::all_of(name.begin(), name.end(), [](const char c)
  {
    return std::isalnum(static_cast<unsigned char>(c)) || std::strchr("._+-", c);
  });
  if(!is_plain)
    throw std::invalid_argument("--pair: the name '" + name + "' is to be of letters, digits and . _ + - only");
}

Options parse(const std::vector<std::string>& arguments)
{
  typedef generated_models::Triangles Triangles;

  Options options;
  std::vector<std::string> models;
  std::vector<std::size_t> sizes = { 5000 };
  std::vector<Triangles> triangles = { Triangles::IRREGULAR };
  std::vector<mesh_pairs::Noise_kind> kinds = { mesh_pairs::noise_kinds()[0] };
  std::vector<double> levels = { 0.3 };
  unsigned seed = 0;

  for(std::size_t i=0; i<arguments.size(); ++i)
  {
    const std::size_t equal_sign = arguments[i].find('=');
    const std::string option = arguments[i].substr(0, equal_sign);
    const auto value = [&]()
    {
      if(equal_sign != std::string::npos)
        return arguments[i].substr(equal_sign + 1);
      if(i + 1 == arguments.size())
        throw std::invalid_argument(option + ": the value is missing");
      return arguments[++i];
    };
    const auto list = [&](const auto& parse)
    {
      return parsed_list<decltype(parse(std::string()))>(option, value(), parse);
    };

    if(arguments[i] == "--help" || arguments[i] == "-h")
      options.is_help_asked_for = true;
    else if(arguments[i] == "--list")
      options.is_list_asked_for = true;
    else if(arguments[i] == "--best")
      options.is_best_asked_for = true;
    else if(arguments[i] == "--pair")
    {
      if(i + 3 >= arguments.size())
        throw std::invalid_argument("--pair: a name and two files are expected");
      const std::string name = arguments[++i], noise_free = arguments[++i], noisy = arguments[++i];
      check_pair_name(name);
      mesh_files::check_readable(noise_free);
      mesh_files::check_readable(noisy);
      options.pairs.push_back(mesh_pairs::from_files<Mesh>(name, noise_free, noisy));
    }
    else if(option == "--methods")
      options.methods = list([&](const std::string& s) { return find(option, denoising_methods::all(), s); });
    else if(option == "--models")
    {
      const std::string names = value();
      models.clear();
      if(names == "all")
        for(const generated_models::Generator& g : generated_models::all())
          models.push_back(g.name);
      else
        models = parsed_list<std::string>(option, names,
                                          [&](const std::string& s) { return find(option, generated_models::all(), s).name; });
    }
    else if(option == "--sizes")
      sizes = list([&](const std::string& s) { return parsed<std::size_t>(option, s); });
    else if(option == "--triangles")
      triangles = list([&](const std::string& s)
      {
        if(s != "regular" && s != "irregular")
          throw std::invalid_argument(option + ": '" + s + "' is neither regular nor irregular");
        return (s == "regular") ? Triangles::REGULAR : Triangles::IRREGULAR;
      });
    else if(option == "--noise-kinds")
      kinds = list([&](const std::string& s) { return find(option, mesh_pairs::noise_kinds(), s); });
    else if(option == "--noise-levels")
      levels = list([&](const std::string& s) { return parsed<double>(option, s); });
    else if(option == "--seed")
      seed = parsed<unsigned>(option, value());
    else if(option == "--time-out")
      options.time_out = parsed<double>(option, value());
    else if(option == "--output")
      options.folder = value();
    else
      throw std::invalid_argument("unknown option '" + arguments[i] + "', see --help");
  }

  if(!(options.time_out > 0))
    throw std::invalid_argument("--time-out: it must be positive");
  for(const std::size_t size : sizes)
    if(size < 50 || size > 20000000)
      throw std::invalid_argument("--sizes: the range is from 50 to 20000000");
  for(const double level : levels)
    if(!(level >= 0 && level <= 100))
      throw std::invalid_argument("--noise-levels: the range is from 0 to 100");

  if(models.empty() && options.pairs.empty())
    models = { "twirl", "cut_sphere", "cad_part", "organic_shape" };
  for(const std::string& model : models)
    for(const std::size_t size : sizes)
      for(const Triangles t : triangles)
        for(const mesh_pairs::Noise_kind& kind : kinds)
          for(const double level : levels)
            options.pairs.push_back(mesh_pairs::generated<Mesh>(model, size, t, kind, level, seed));

  std::set<std::string> names;
  for(const Pair& pair : options.pairs)
    if(!names.insert(pair.name).second)
      throw std::invalid_argument("there are two pairs of the name " + pair.name);
  names.clear();
  for(const Method& method : options.methods)
    if(!names.insert(method.name).second)
      throw std::invalid_argument("--methods: there is " + method.name + " twice");
  return options;
}

// ----- progress

// draws a progress bar on a terminal
class Progress_bar
{
public:
  explicit Progress_bar(const std::size_t number_of_runs)
    : m_number_of_runs(number_of_runs), m_is_visible(isatty(STDERR_FILENO) != 0) {}

  void start_run(const std::string& what)
  {
    m_what = what;
    m_start = std::chrono::steady_clock::now();
    draw();
  }

  void end_run() { ++m_number_of_ended_runs; }

  void draw() const
  {
    if(!m_is_visible)
      return;
    const std::size_t width = 30, done = width * m_number_of_ended_runs / m_number_of_runs;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
    std::ostringstream line;
    line << "[" << std::string(done, '#') << std::string(width - done, ' ') << "] " << m_number_of_ended_runs + 1 << "/"
         << m_number_of_runs << " " << m_what << ", " << int(seconds) << " s";
    std::cerr << "\r\033[K" << line.str().substr(0, 118) << std::flush;
  }

  void hide() const
  {
    if(m_is_visible)
      std::cerr << "\r\033[K" << std::flush;
  }

private:
  std::size_t m_number_of_runs, m_number_of_ended_runs = 0;
  bool m_is_visible;
  std::string m_what;
  std::chrono::steady_clock::time_point m_start;
};

// ----- runs

// what one run of a method leaves
struct Run
{
  std::string failure; // empty if there is a result
  double seconds = 0;
  double megabytes = 0;
  std::size_t number_of_iterations = 0;
  Mesh mesh;
};

// `mesh` changes in the child process only
Run run(const std::function<std::size_t(Mesh&)>& denoise, Mesh& mesh, const double time_out,
        const Progress_bar& progress_bar)
{
  const child_process::Outcome outcome = child_process::run([&](const auto& finish)
  {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t number_of_iterations = denoise(mesh);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    child_process::Result_stream& stream = finish();
    stream.write(&seconds, sizeof(seconds));
    stream.write(&number_of_iterations, sizeof(number_of_iterations));
    for(const Mesh::Vertex_index v : mesh.vertices())
    {
      const double coordinates[3] = { mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z() };
      stream.write(coordinates, sizeof(coordinates));
    }
  }, time_out, [&]() { progress_bar.draw(); });

  Run run;
  run.failure = outcome.failure;
  run.megabytes = outcome.megabytes;
  if(!run.failure.empty())
    return run;

  const char* bytes = outcome.result.data();
  std::memcpy(&run.seconds, bytes, sizeof(run.seconds));
  bytes += sizeof(run.seconds);
  std::memcpy(&run.number_of_iterations, bytes, sizeof(run.number_of_iterations));
  bytes += sizeof(run.number_of_iterations);
  run.mesh = mesh;
  for(const Mesh::Vertex_index v : run.mesh.vertices())
  {
    double coordinates[3];
    std::memcpy(coordinates, bytes, sizeof(coordinates));
    bytes += sizeof(coordinates);
    run.mesh.point(v) = Mesh::Point(coordinates[0], coordinates[1], coordinates[2]);
  }
  return run;
}

// infinity if there is no result, or none that can be measured
double mean_angular_error(const Run& run, const Mesh& noise_free)
{
  if(!run.failure.empty())
    return std::numeric_limits<double>::infinity();
  try
  {
    return SMD::angular_error(run.mesh, noise_free).mean;
  }
  catch(const std::invalid_argument&)
  {
    return std::numeric_limits<double>::infinity();
  }
}

// ----- tables

struct Row
{
  std::string pair, method;
  std::string search;       // default or best
  std::string parameters;
  std::string failure;      // empty if the errors are known
  SMD::Denoising_error error;
  double seconds, megabytes;
  std::size_t number_of_iterations;
};

// a number of the table, with that many decimals
std::string fixed(const double value, const int decimals)
{
  std::ostringstream out;
  out << std::fixed << std::setprecision(decimals) << value;
  return out.str();
}

class Markdown_table
{
public:
  explicit Markdown_table(std::ostream& out) : m_out(out)
  {
    m_out << "Surface_mesh_denoising, CGAL " << CGAL_VERSION_STR << ", compiler " << __VERSION__
          << ", one core for each run.\n" << std::flush;
  }

  void start_pair(const std::string& name, const Mesh& mesh)
  {
    m_out << "\n## " << name << "\n\n" << mesh.number_of_vertices() << " vertices, " << mesh.number_of_faces()
          << " faces\n\n"
             "| method                          | E_a    | area E_a | E_v   | max   | flips | volume   | s      | its  "
             "| MB    | parameters |\n"
             "| ------------------------------- | -----: | -------: | ----: | ----: | ----: | -------: | -----: | ---: "
             "| ----: | ---------- |\n" << std::flush;
  }

  void add(const Row& row)
  {
    const auto cell = [this](const std::string& text, const int width)
    {
      m_out << " " << std::right << std::setw(width) << text << " |";
    };
    m_out << "| " << std::left << std::setw(31) << row.method + (row.search == "best" ? ", best" : "") << " |";
    if(row.failure.empty())
    {
      const SMD::Vertex_distance_error vertex_distance = row.error.vertex_distance.in_mean_edge_lengths();
      cell(fixed(row.error.angular.mean, 2), 6);
      cell(fixed(row.error.angular.area_weighted_mean, 2), 8);
      cell(fixed(vertex_distance.area_weighted_l2, 3), 5);
      cell(fixed(row.error.symmetric_distance.in_mean_edge_lengths().maximum, 2), 5);
      cell(std::to_string(row.error.angular.number_of_flipped_faces), 5);
      cell(fixed(100 * row.error.relative_volume_change, 2) + " %", 8);
      cell(fixed(row.seconds, 2), 6);
      cell(std::to_string(row.number_of_iterations), 4);
      cell(fixed(row.megabytes, 1), 5);
    }
    else
      for(const int width : { 6, 8, 5, 5, 5, 8, 6, 4, 5 })
        cell("", width);
    m_out << " " << (row.failure.empty() ? row.parameters : row.parameters + ": **" + row.failure + "**") << " |\n"
          << std::flush;
  }

private:
  std::ostream& m_out;
};

// text between quotes
std::string quoted(const std::string& text)
{
  std::ostringstream out;
  out << std::quoted(text, '"', '"');
  return out.str();
}

// the files in the output folder, if there is one
class Output_folder
{
public:
  explicit Output_folder(const std::string& folder) : m_folder(folder)
  {
    if(folder.empty())
      return;
    std::error_code ignored;
    fs::create_directories(m_folder / "meshes", ignored);
    open("comparison.md", m_markdown);
    open("comparison.csv", m_rows);
    open("histograms.csv", m_histograms);
    m_rows << "pair,method,search,parameters,mean_angular_error,area_weighted_mean_angular_error,"
              "mean_square_angular_error,area_weighted_l2_vertex_error,maximum_distance,flipped_faces,"
              "relative_volume_change,seconds,iterations,megabytes,failure\n" << std::flush;
    m_histograms << "pair,method,from,to,share\n" << std::flush;
  }

  bool is_there() const { return !m_folder.empty(); }

  std::ostream& markdown() { return m_markdown; }

  void add(const Row& row)
  {
    if(!is_there())
      return;
    m_rows << row.pair << "," << row.method << "," << row.search << "," << quoted(row.parameters) << ",";
    if(row.failure.empty())
      m_rows << row.error.angular.mean << "," << row.error.angular.area_weighted_mean << ","
             << row.error.angular.mean_square << ","
             << row.error.vertex_distance.in_mean_edge_lengths().area_weighted_l2 << ","
             << row.error.symmetric_distance.in_mean_edge_lengths().maximum << ","
             << row.error.angular.number_of_flipped_faces << "," << row.error.relative_volume_change << ","
             << row.seconds << "," << row.number_of_iterations << "," << row.megabytes << ",";
    else
      m_rows << ",,,,,,,,,,";
    m_rows << quoted(row.failure) << "\n" << std::flush;
  }

  // of a result of default parameters
  void add_histogram(const Row& row)
  {
    if(!is_there() || !row.failure.empty())
      return;
    const SMD::Symmetric_distance distance = row.error.symmetric_distance.in_mean_edge_lengths();
    for(std::size_t i=0; i<distance.histogram.size(); ++i)
      m_histograms << row.pair << "," << row.method << "," << double(i) * distance.bin_width << ","
                   << double(i + 1) * distance.bin_width << "," << distance.histogram[i] << "\n";
    m_histograms << std::flush;
  }

  void add_mesh(const std::string& pair, const std::string& name, const Mesh& mesh) const
  {
    if(!is_there())
      return;
    fs::create_directories(m_folder / "meshes" / pair);
    mesh_files::write_triangle_mesh((m_folder / "meshes" / pair / (name + ".ply")).string(), mesh);
  }

private:
  void open(const std::string& name, std::ofstream& file)
  {
    file.open(m_folder / name);
    if(!file)
      throw std::runtime_error((m_folder / name).string() + ": cannot be written");
  }

  fs::path m_folder;
  std::ofstream m_markdown, m_rows, m_histograms;
};

// ----- the comparison

class Comparison
{
public:
  explicit Comparison(const Options& options)
    : m_options(options), m_folder(options.folder), m_progress_bar(number_of_runs(options))
  {
    m_progress_bar.hide();
    m_tables.emplace_back(std::cout);
    if(m_folder.is_there())
      m_tables.emplace_back(m_folder.markdown());
  }

  void run()
  {
    for(const Pair& pair : m_options.pairs)
    {
      Meshes meshes = pair.load();
      m_progress_bar.hide();
      for(Markdown_table& table : m_tables)
        table.start_pair(pair.name, meshes.noise_free);
      m_folder.add_mesh(pair.name, "noise_free", meshes.noise_free);

      Run noisy;
      noisy.mesh = meshes.noisy;
      add_row(pair.name, "noisy", "default", "", noisy, meshes.noise_free);
      for(const Method& method : m_options.methods)
        compare(pair.name, method, meshes);
    }
    m_progress_bar.hide();
  }

private:
  static std::size_t number_of_runs(const Options& options)
  {
    std::size_t n = 0;
    for(const Method& method : options.methods)
      n += 1 + (options.is_best_asked_for ? settings(method).size() : 0);
    return n * options.pairs.size();
  }

  Run timed_run(const std::string& pair, const Method& method, const std::function<std::size_t(Mesh&)>& denoise,
                Mesh& noisy)
  {
    m_progress_bar.start_run(pair + ", " + method.name);
    const Run result = ::run(denoise, noisy, m_options.time_out, m_progress_bar);
    m_progress_bar.end_run();
    return result;
  }

  void compare(const std::string& pair, const Method& method, Meshes& meshes)
  {
    Run best = timed_run(pair, method, method.denoise_by_default, meshes.noisy);
    std::string best_parameters = "defaults";
    add_row(pair, method.name, "default", best_parameters, best, meshes.noise_free);
    if(!m_options.is_best_asked_for || method.grid.empty())
      return;

    double least_error = mean_angular_error(best, meshes.noise_free);
    for(const Setting& setting : settings(method))
    {
      const auto denoise = [&](Mesh& mesh) { return method.denoise(mesh, setting.values); };
      const Run candidate = timed_run(pair, method, denoise, meshes.noisy);
      const double error = mean_angular_error(candidate, meshes.noise_free);
      if(error < least_error)
      {
        least_error = error;
        best = candidate;
        best_parameters = setting.parameters;
      }
    }
    add_row(pair, method.name, "best", best_parameters, best, meshes.noise_free);
  }

  void add_row(const std::string& pair, const std::string& method, const std::string& search,
               const std::string& parameters, const Run& run, const Mesh& noise_free)
  {
    Row row = { pair, method, search, parameters, run.failure, SMD::Denoising_error(), run.seconds, run.megabytes,
                run.number_of_iterations };
    if(row.failure.empty())
    {
      try
      {
        row.error = SMD::measure_error(run.mesh, noise_free);
      }
      catch(const std::invalid_argument& e) // a coordinate that is not finite
      {
        row.failure = e.what();
      }
    }

    m_progress_bar.hide();
    for(Markdown_table& table : m_tables)
      table.add(row);
    m_folder.add(row);
    if(search == "default" && row.failure.empty())
    {
      m_folder.add_histogram(row);
      m_folder.add_mesh(pair, method, run.mesh);
    }
  }

  const Options& m_options;
  Output_folder m_folder;
  Progress_bar m_progress_bar;
  std::vector<Markdown_table> m_tables;
};

int main(int argc, char* argv[])
{
  try
  {
    const Options options = parse(std::vector<std::string>(argv + 1, argv + argc));
    if(options.is_help_asked_for)
      print_help();
    else if(options.is_list_asked_for)
      print_list();
    else
      Comparison(options).run();
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << "compare: " << e.what() << std::endl;
    return 2;
  }
}
