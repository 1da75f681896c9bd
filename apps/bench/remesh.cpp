#include <benchmark/benchmark.h>

#include <chrono>
#include <filesystem>

#include "algebra/factor.hpp"
#include "factorisations.hpp"
#include "scene/read.hpp"
#include "sim/march/block.hpp"
#include "sim/reshape/remesh.hpp"
#include "sim/reshape/shape.hpp"
#include "sim/study/prepare.hpp"

/// The cost of a remesh beyond gmsh, in plain factorisations of the stiffness of the bodies that are remeshed; both
/// measured in turn in one run.
namespace {

using namespace reye;
using clock_type = std::chrono::steady_clock;

double since(clock_type::time_point start) { return std::chrono::duration<double>(clock_type::now() - start).count(); }

/// Seconds of assembling nothing and factorising once, ordering included, both bodies.
double factorisation(const sim::Problem& problem, const sim::State& state, long& dofs) {
  double seconds = 0.0;
  dofs = 0;
  for (int b = 0; b < problem.body_count(); ++b) {
    const auto K = bench::held_stiffness(problem, state, b);
    dofs += K.rows();
    const auto start = clock_type::now();
    const algebra::Cholesky factor(K);
    benchmark::DoNotOptimize(factor);
    seconds += since(start);
  }
  return seconds;
}

/// The Hertz contact of geo/hertz, its far size and fine zone scaled by 1 / range.
void remesh(benchmark::State& run) {
  auto scene = scene::read(std::string(REYE_SOURCE_DIR) + "/geo/hertz/scene.toml");
  const double scale = 1.0 / static_cast<double>(run.range(0));
  for (auto& body : scene.geometry.bodies) body.mesh.far_size_mm *= scale;
  for (auto& zone : scene.geometry.fine_zones) zone.size_mm *= scale;
  const auto problem = sim::prepare(scene);
  sim::Cache cache;
  auto state = sim::initial_state(problem);
  sim::begin_state(problem, state, cache);
  const sim::BlockSpan span{&problem.scene.steps.front(), 1.0, false, true};
  state = sim::play_increments(problem, std::move(state), cache, span, {}).state;
  const std::vector<sim::RemeshReason> asked(static_cast<std::size_t>(problem.body_count()), {"asked for", false});
  std::vector<double> own, gmsh, factor;
  long dofs = 0;
  for (auto _ : run) {
    double meshing = 0.0;
    sim::Observer watch;
    watch.remesh = [&](const sim::RemeshRecord& r) { meshing += r.mesh_seconds; };
    const auto start = clock_type::now();
    auto outcome = sim::evolve_shape(problem, state, cache, span, watch, asked);
    if (!outcome.failure.empty()) run.SkipWithError(outcome.failure.c_str());
    own.push_back(since(start) - meshing);
    gmsh.push_back(meshing);
    state = std::move(outcome.state);
    factor.push_back(factorisation(problem, state, dofs));
  }
  run.counters["dofs"] = static_cast<double>(dofs);
  run.counters["gmsh_s"] = bench::median(gmsh);
  run.counters["own_s"] = bench::median(own);
  run.counters["factorisation_s"] = bench::median(factor);
  run.counters["own_in_factorisations"] = bench::median(own) / bench::median(factor);
}

BENCHMARK(remesh)->Arg(1)->Arg(2)->Arg(4)->Iterations(5)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
