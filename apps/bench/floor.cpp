#include <benchmark/benchmark.h>

#include <sys/resource.h>

#include <ctime>

#include "algebra/factor.hpp"
#include "factorisations.hpp"
#include "scene/read.hpp"
#include "sim/block.hpp"

/// What a wear cycle costs in plain factorisations of the stiffness of its bodies: the floor that no method goes below
/// which factorises at all. Both measured in turn in one run, CPU time.
namespace {

using namespace reye;

double cpu() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The stiffness of a body, rigid motions held, with the dofs of its contact nodes last.
base::SparseMatrix ordered_stiffness(const sim::Problem& problem, const sim::State& state, int body, int& retained) {
  const auto K = bench::held_stiffness(problem, state, body);
  const auto& mesh = state.shapes[body]->mesh;
  std::vector<char> last(mesh.X.size(), 0);
  for (const auto& name : problem.inputs[body].contact_boundaries)
    for (int node : mesh::nodes_of(mesh.boundaries.at(name))) last[static_cast<std::size_t>(node)] = 1;
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> to(K.rows());
  int place = 0;
  for (char wanted : {0, 1}) {
    retained = static_cast<int>(K.rows()) - place;
    for (std::size_t i = 0; i < last.size(); ++i)
      for (int c = 0; last[i] == wanted && c < 2; ++c) to.indices()[2 * static_cast<int>(i) + c] = place++;
  }
  base::SparseMatrix ordered;
  ordered = K.twistedBy(to);
  return ordered;
}

struct Costs {
  double plain = 0.0, condensed = 0.0;  ///< seconds
  long dofs = 0, retained = 0;
};

/// Factorising each body once, plainly and down to its contact nodes; ordering included in both.
Costs factorisation(const sim::Problem& problem, const sim::State& state) {
  Costs costs;
  for (int b = 0; b < problem.body_count(); ++b) {
    int retained = 0;
    const auto K = ordered_stiffness(problem, state, b, retained);
    costs.dofs += K.rows();
    costs.retained += retained / 2;
    double start = cpu();
    const algebra::Cholesky plain(K);
    benchmark::DoNotOptimize(plain);
    costs.plain += cpu() - start;
    start = cpu();
    const algebra::SchurFactor condensed(K, retained);
    benchmark::DoNotOptimize(condensed);
    costs.condensed += cpu() - start;
  }
  return costs;
}

/// geo/fretting_mccoll as it is (range 0), or with a fine zone of 5 um elements, range / 100 mm deep: pressed, run in, worn for one block, then
/// measured over the next: both sides wear, the shape moves, the block is closed.
void floor_of_a_cycle(benchmark::State& run) {
  auto scene = scene::read(std::string(REYE_SOURCE_DIR) + "/geo/fretting_mccoll/scene.toml");
  for (auto& zone : scene.geometry.fine_zones) {
    if (run.range(0) == 0) continue;
    zone.size_mm = 0.005;
    zone.depth_mm = 0.01 * static_cast<double>(run.range(0));
  }
  const auto problem = sim::prepare(scene);
  sim::Cache cache;
  auto state = sim::initial_state(problem);
  sim::begin_state(problem, state, cache);
  const auto& steps = problem.scene.steps;
  const auto block = [&](const scene::Step& step) {
    const sim::BlockSpan span{&step, step.cycles > 0.0 ? step.jump : 1.0, step.cycles > 0.0};
    auto outcome = sim::play_block(problem, state, cache, span, {});
    if (!outcome.failure.empty()) run.SkipWithError(outcome.failure.c_str());
    state = std::move(outcome.state);
  };
  for (const auto& step : steps) block(step);
  std::vector<double> cycles;
  std::vector<Costs> costs;
  for (auto _ : run) {
    const double start = cpu();
    block(steps.back());
    cycles.push_back(cpu() - start);
    costs.push_back(factorisation(problem, state));
  }
  std::vector<double> plain, condensed;
  for (const auto& c : costs) {
    plain.push_back(c.plain);
    condensed.push_back(c.condensed);
  }
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  run.counters["dofs"] = static_cast<double>(costs.front().dofs);
  run.counters["contact_nodes"] = static_cast<double>(costs.front().retained);
  run.counters["factorisation_s"] = bench::median(plain);
  run.counters["condensing_in_factorisations"] = bench::median(condensed) / bench::median(plain);
  run.counters["cycle_s"] = bench::median(cycles);
  run.counters["cycle_in_factorisations"] = bench::median(cycles) / bench::median(plain);
  run.counters["peak_kB_per_dof"] = static_cast<double>(used.ru_maxrss) / static_cast<double>(costs.front().dofs);
}

BENCHMARK(floor_of_a_cycle)->Name("floor")->Arg(0)->Arg(10)->Arg(60)->Iterations(5)->Unit(benchmark::kSecond);

}  // namespace
