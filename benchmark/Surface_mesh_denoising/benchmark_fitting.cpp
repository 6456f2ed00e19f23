// The cost of anisotropic surface fitting, on generated noisy meshes: of an iteration beside one of PMP::smooth_shape(),
// with the size of the mesh, of the convergence tests, in memory, and with two threads; then the same of a whole run
// without parameters.
// Each pair of times is taken in turn in the same run: quote the ratios.

#include "generated_models.h"

#include <CGAL/Surface_mesh_denoising/add_noise.h>
#include <CGAL/Surface_mesh_denoising/denoise_anisotropic_fitting.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/smooth_shape.h>
#include <CGAL/Surface_mesh.h>

#include <benchmark/benchmark.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <chrono>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMD = CGAL::Surface_mesh_denoising;

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                   Mesh;

namespace {

// with irregular triangles
Mesh make_mesh(const std::string& model, const std::size_t number_of_vertices)
{
  generated_models::Options options;
  options.number_of_vertices = number_of_vertices;
  options.triangles = generated_models::Triangles::IRREGULAR;
  return generated_models::to_mesh<Mesh>(generated_models::generate(model, options));
}

const Mesh& noisy_part(const std::size_t number_of_vertices)
{
  static std::map<std::size_t, Mesh> meshes;
  const auto inserted = meshes.emplace(number_of_vertices, Mesh());
  Mesh& mesh = inserted.first->second;
  if(inserted.second)
  {
    mesh = make_mesh("cad_part", number_of_vertices);
    SMD::add_noise(mesh, CGAL::parameters::noise_level(0.3));
  }
  return mesh;
}

template <typename Function>
double seconds(const Function& function)
{
  const auto start = std::chrono::steady_clock::now();
  function();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// the time of one iteration is that of several in a row, less that of a call without any
template <typename ConcurrencyTag>
double seconds_per_iteration(const Mesh& noisy, const std::size_t neighborhood_size)
{
  const std::size_t number_of_iterations = 3;
  const auto run = [&](const std::size_t n)
  {
    Mesh mesh = noisy;
    return seconds([&]
    {
      SMD::denoise_anisotropic_fitting<ConcurrencyTag>(
        mesh, CGAL::parameters::number_of_iterations(n).neighborhood_size(neighborhood_size));
    });
  };
  return (run(number_of_iterations) - run(0)) / number_of_iterations;
}

double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(const Mesh::Edge_index e : mesh.edges())
    sum += PMP::edge_length(e, mesh);
  return sum / mesh.number_of_edges();
}

// smooth_shape() is given the mildest flow that smooths at all: its linear system is then the easiest to solve
double seconds_of_smooth_shape(const Mesh& noisy)
{
  const double time = std::pow(mean_edge_length(noisy), 2);
  Mesh mesh = noisy;
  return seconds([&] { PMP::smooth_shape(mesh, time); });
}

template <typename ConcurrencyTag>
double seconds_of_default_run(const Mesh& noisy)
{
  Mesh mesh = noisy;
  return seconds([&] { SMD::denoise_anisotropic_fitting<ConcurrencyTag>(mesh); });
}

void iteration_beside_smooth_shape(benchmark::State& state)
{
  const Mesh& noisy = noisy_part(100000);
  double fitting = 0, smooth_shape = 0;
  for(auto _ : state)
  {
    smooth_shape += seconds_of_smooth_shape(noisy);
    const double t = seconds_per_iteration<CGAL::Sequential_tag>(noisy, 20);
    fitting += t;
    state.SetIterationTime(t);
  }
  state.counters["us/vertex"] = 1e6 * fitting / state.iterations() / noisy.number_of_vertices();
  state.counters["smooth_shape us/vertex"] = 1e6 * smooth_shape / state.iterations() / noisy.number_of_vertices();
  state.counters["ratio"] = fitting / smooth_shape;
}

void iteration_with_size_of_mesh(benchmark::State& state)
{
  const Mesh& noisy = noisy_part(state.range(0));
  const Mesh& small = noisy_part(10000);
  const double number_of_vertices = noisy.number_of_vertices();
  double large_seconds = 0, small_seconds = 0;
  for(auto _ : state)
  {
    small_seconds += seconds_per_iteration<CGAL::Sequential_tag>(small, 20) / small.number_of_vertices();
    const double t = seconds_per_iteration<CGAL::Sequential_tag>(noisy, 20);
    large_seconds += t / number_of_vertices;
    state.SetIterationTime(t);
  }
  state.counters["us/vertex"] = 1e6 * large_seconds / state.iterations();
  state.counters["ratio to 10k"] = large_seconds / small_seconds;
}

// the fit, and the meshes that it was given
template <typename Fit>
struct Recorder
{
  Fit& fit;
  std::vector<std::vector<SMD::Indexed_triangle_mesh::Point_3> > meshes;

  const std::vector<SMD::Indexed_triangle_mesh::Vector_3>& face_normals() const { return fit.face_normals(); }
  const std::vector<SMD::Indexed_triangle_mesh::Vector_3>& vertex_normals() const { return fit.vertex_normals(); }

  void operator()(const SMD::Indexed_triangle_mesh& mesh, const std::vector<bool>& is_movable,
                  std::vector<SMD::Indexed_triangle_mesh::Vector_3>& displacements)
  {
    meshes.push_back(mesh.points());
    fit(mesh, is_movable, displacements);
  }
};

// a whole run, and beside it the time of all its Hausdorff tests as if each iteration asked for one
void convergence_tests(benchmark::State& state)
{
  typedef SMD::internal::Anisotropic_fitting<CGAL::Sequential_tag, SMD::Thresholded_normal_filter> Fit;

  const Mesh& noisy = noisy_part(100000);
  double run_seconds = 0, test_seconds = 0;
  std::size_t number_of_iterations = 0;
  bool has_converged = false;
  for(auto _ : state)
  {
    auto io = SMD::internal::read_mesh(noisy.vertices(), noisy, noisy.points(), CGAL::parameters::default_values());
    SMD::Indexed_triangle_mesh mesh = io.take_mesh();
    const SMD::Thresholded_normal_filter filter;
    Fit fit(filter, 5, 40, 200);
    Recorder<Fit> recorder{fit, {}};
    const double bound = 0.05 * mesh.mean_edge_length();
    const double t = seconds([&]
    {
      const SMD::Denoising_result result
        = SMD::internal::iterate<CGAL::Sequential_tag>(mesh, io.is_movable(), {30, 0.05, 0.5}, recorder,
                                                       [](std::size_t, double, bool) { return true; });
      number_of_iterations = result.number_of_iterations;
      has_converged = result.has_converged;
    });
    recorder.meshes.push_back(mesh.points());
    test_seconds += seconds([&]
    {
      for(std::size_t i=1; i<recorder.meshes.size(); ++i)
        benchmark::DoNotOptimize(SMD::internal::Hausdorff_test<CGAL::Sequential_tag>::is_distance_larger(
          mesh, recorder.meshes[i-1], recorder.meshes[i], bound));
    });
    run_seconds += t;
    state.SetIterationTime(t);
  }
  state.counters["iterations"] = number_of_iterations;
  state.counters["converged"] = has_converged;
  state.counters["share of tests"] = test_seconds / run_seconds;
}

double kilobytes(const char* field)
{
  std::ifstream status("/proc/self/status");
  for(std::string word; status >> word; )
    if(word == field)
    {
      double value = 0;
      status >> value;
      return value;
    }
  return 0;
}

template <typename NamedParameters>
void measure_peak_memory(benchmark::State& state, const NamedParameters& np)
{
  Mesh mesh = noisy_part(state.range(0));
  double bytes_per_vertex = 0;
  for(auto _ : state)
  {
    const double before = kilobytes("VmRSS:");
    std::ofstream("/proc/self/clear_refs") << 5; // resets the peak
    state.SetIterationTime(seconds([&] { SMD::denoise_anisotropic_fitting(mesh, np); }));
    bytes_per_vertex = 1024 * (kilobytes("VmHWM:") - before) / mesh.number_of_vertices();
  }
  state.counters["bytes/vertex"] = bytes_per_vertex;
}

void peak_memory(benchmark::State& state)
{
  measure_peak_memory(state, CGAL::parameters::number_of_iterations(2));
}

void default_run_peak_memory(benchmark::State& state)
{
  measure_peak_memory(state, CGAL::parameters::default_values());
}

// beside ten iterations of smooth_shape()
void measure_default_run(benchmark::State& state, const Mesh& noisy)
{
  double denoising = 0, smooth_shape = 0;
  for(auto _ : state)
  {
    for(int i=0; i<10; ++i)
      smooth_shape += seconds_of_smooth_shape(noisy);
    const double t = seconds_of_default_run<CGAL::Sequential_tag>(noisy);
    denoising += t;
    state.SetIterationTime(t);
  }
  state.counters["us/vertex"] = 1e6 * denoising / state.iterations() / noisy.number_of_vertices();
  state.counters["ratio"] = denoising / smooth_shape;
}

void default_run_beside_smooth_shape(benchmark::State& state) { measure_default_run(state, noisy_part(state.range(0))); }

// Patches are largest on a sphere, and strong noise in all directions takes most steps
void dear_run_beside_smooth_shape(benchmark::State& state)
{
  Mesh mesh = make_mesh("sphere", state.range(0));
  SMD::add_noise(mesh, CGAL::parameters::noise_level(0.8).noise_direction(SMD::Noise_direction::RANDOM));
  measure_default_run(state, mesh);
}

#ifdef CGAL_LINKED_WITH_TBB
template <typename Seconds>
void measure_speedup(benchmark::State& state, const Seconds& seconds_of_run)
{
  const Mesh& noisy = noisy_part(200000);
  double one = 0, two = 0;
  const auto run = [&](const std::size_t number_of_threads)
  {
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, number_of_threads);
    return seconds_of_run(noisy);
  };
  for(auto _ : state)
  {
    one += run(1);
    const double t = run(2);
    two += t;
    state.SetIterationTime(t);
  }
  state.counters["speedup"] = one / two;
}

void two_threads(benchmark::State& state)
{
  measure_speedup(state, [](const Mesh& noisy) { return seconds_per_iteration<CGAL::Parallel_tag>(noisy, 20); });
}

void default_run_two_threads(benchmark::State& state)
{
  measure_speedup(state, &seconds_of_default_run<CGAL::Parallel_tag>);
}
#endif

} // namespace

BENCHMARK(iteration_beside_smooth_shape)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(5);
BENCHMARK(iteration_with_size_of_mesh)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(3)
  ->Arg(100000)->Arg(2000000);
BENCHMARK(convergence_tests)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(peak_memory)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(1)->Arg(1000000);
BENCHMARK(default_run_beside_smooth_shape)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(3)
  ->Arg(1000)->Arg(10000)->Arg(100000);
BENCHMARK(default_run_beside_smooth_shape)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(1)->Arg(1000000);
BENCHMARK(dear_run_beside_smooth_shape)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(3)->Arg(1000)->Arg(10000);
BENCHMARK(default_run_peak_memory)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(1)->Arg(1000000);
#ifdef CGAL_LINKED_WITH_TBB
BENCHMARK(two_threads)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(5);
BENCHMARK(default_run_two_threads)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(3);
#endif

BENCHMARK_MAIN();
