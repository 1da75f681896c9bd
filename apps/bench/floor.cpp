#include <benchmark/benchmark.h>

#include <sys/resource.h>

#include <ctime>
#include <stdexcept>

#include "algebra/factor.hpp"
#include "cores.hpp"
#include "factorisations.hpp"
#include "scene/read.hpp"
#include "sim/march/block.hpp"
#include "sim/study/prepare.hpp"

/// The cost of a wear cycle in plain factorisations of the stiffness of its bodies, the lower bound of any method that
/// factorises, both measured in turn in one run; and how it grows with the bodies. CPU time.
namespace {

using namespace reye;

double cpu() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The stiffness of a body, rigid motions held, with the dofs of its contact nodes last.
base::SparseMatrix ordered_stiffness(const sim::Problem& problem, const sim::State& state, int body, int& retained) {
  const auto K = bench::held_stiffness(problem, state, body);
  const auto& mesh = state.shapes[body]->mesh;
  std::vector<bool> last(mesh.X.size(), false);
  for (const auto& name : problem.inputs[body].contact_boundaries)
    for (int node : mesh::nodes_of(mesh.boundaries.at(name))) last[static_cast<std::size_t>(node)] = true;
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> to(K.rows());
  int place = 0;
  for (const bool wanted : {false, true}) {
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

/// geo/fretting_mccoll as it is (depth 0), or with a fine zone of 5 um elements, depth / 100 mm deep.
scene::Scene fretting(long depth) {
  auto scene = scene::read(std::string(REYE_SOURCE_DIR) + "/geo/fretting_mccoll/scene.toml");
  if (depth == 0) return scene;
  for (auto& zone : scene.geometry.fine_zones) {
    zone.size_mm = 0.005;
    zone.depth_mm = 0.01 * static_cast<double>(depth);
  }
  return scene;
}

/// The fretting scene with the steel of geo/plastic_fretting at small strain, in fewer increments and worn from the
/// press on: every iteration linearises and condenses both bodies.
scene::Scene plastic_fretting(long depth) {
  auto scene = fretting(depth);
  scene.materials.at("steel") = material::HenckyJ2{200e3, 0.3, material::LinearHardening{280.0, 2000.0}};
  for (auto& [name, body] : scene.body_material) body.kinematics = base::Kinematics::small;
  scene.steps = {scene.steps.front(), scene.steps.back()};
  scene.steps.back().increments = 8;
  return scene;
}

/// A scene whose steps but the last have been played. That one wears: both sides wear, the shape moves, the block is
/// closed.
class Fretting {
 public:
  explicit Fretting(const scene::Scene& scene)
      : problem(sim::prepare(scene, &cache_)), state(sim::initial_state(problem)) {
    sim::begin_state(problem, state, cache_);
    for (std::size_t i = 0; i + 1 < problem.scene.steps.size(); ++i) play(problem.scene.steps[i]);
  }

  /// CPU seconds of one more wear block.
  double cycle() {
    const double start = cpu();
    play(problem.scene.steps.back());
    return cpu() - start;
  }

 private:
  void play(const scene::Step& step) {
    const sim::BlockSpan span{
        .step = &step,
        .jump = step.cycles > 0.0 ? step.jump : 1.0,
        .cycles = step.cycles > 0.0,
        .moves = true};  // of several blocks that wait for one shape step no two would cost the same
    auto outcome = sim::play_block(problem, state, cache_, span, {});
    if (!outcome.failure.empty()) throw std::runtime_error(outcome.failure);
    state = std::move(outcome.state);
  }

  sim::Cache cache_;

 public:
  const sim::Problem problem;
  sim::State state;
};

void floor_of_a_cycle(benchmark::State& run) {
  Fretting played(fretting(run.range(0)));
  played.cycle();
  std::vector<double> cycles, plain, condensed;
  Costs costs;
  for (auto _ : run) {
    cycles.push_back(played.cycle());
    costs = factorisation(played.problem, played.state);
    plain.push_back(costs.plain);
    condensed.push_back(costs.condensed);
  }
  run.counters["dofs"] = static_cast<double>(costs.dofs);
  run.counters["contact_nodes"] = static_cast<double>(costs.retained);
  run.counters["factorisation_s"] = bench::median(plain);
  run.counters["condensing_in_factorisations"] = bench::median(condensed) / bench::median(plain);
  run.counters["cycle_s"] = bench::median(cycles);
  run.counters["cycle_in_factorisations"] = bench::median(cycles) / bench::median(plain);
}

/// A run that fails is not a measurement: reported, and the other benchmarks continue.
template <void (*measure)(benchmark::State&)>
void told(benchmark::State& run) {
  try {
    measure(run);
  } catch (const std::exception& error) {
    run.SkipWithError(error.what());
  }
}

BENCHMARK(told<floor_of_a_cycle>)->Name("floor")->Arg(0)->Arg(10)->Arg(60)->Iterations(5)->Unit(benchmark::kSecond);

double dofs_of(const Fretting& played) {
  double dofs = 0.0;
  for (const auto& shape : played.state.shapes) dofs += 2.0 * static_cast<double>(shape->mesh.X.size());
  return dofs;
}

/// Time of a block and memory over the number of dofs, at some 240 contact nodes a side: the largest resident memory of
/// this program so far, meshing included.
void scaling_of_a_block(benchmark::State& run, Fretting& played) {
  std::vector<double> cycles;
  for (auto _ : run) cycles.push_back(played.cycle());
  const double dofs = dofs_of(played);
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  run.counters["dofs"] = dofs;
  run.counters["block_s"] = bench::median(cycles);
  run.counters["peak_kB_per_dof"] = static_cast<double>(used.ru_maxrss) / dofs;
}

void scaling_linear(benchmark::State& run) {
  Fretting played(fretting(run.range(0)));
  played.cycle();
  scaling_of_a_block(run, played);
}

void scaling_plastic(benchmark::State& run) {
  Fretting played(plastic_fretting(run.range(0)));
  scaling_of_a_block(run, played);
}

/// Wall time of wear blocks of linear bodies, which cost the same one after another, on one core and on two.
void cores_linear(benchmark::State& run) {
  Fretting played(fretting(run.range(0)));
  played.cycle();
  std::vector<double> one, two;
  for (auto _ : run) {
    one.push_back(bench::wall_on(1, [&] { played.cycle(); }));
    two.push_back(bench::wall_on(2, [&] { played.cycle(); }));
  }
  run.counters["dofs"] = dofs_of(played);
  bench::tell_cores(run, one, two);
}

/// Wall times of bodies that yield, whose blocks differ: each time of the first one after the press.
void cores_plastic(benchmark::State& run) {
  std::vector<double> one, two;
  for (auto _ : run)
    for (const int count : {1, 2}) {
      Fretting played(plastic_fretting(run.range(0)));
      (count == 1 ? one : two).push_back(bench::wall_on(count, [&] { played.cycle(); }));
      run.counters["dofs"] = dofs_of(played);
    }
  bench::tell_cores(run, one, two);
}

BENCHMARK(told<cores_linear>)->Name("cores_block")->Arg(200)->Iterations(3)->Unit(benchmark::kSecond);
BENCHMARK(told<cores_plastic>)->Name("cores_plastic")->Arg(4)->Iterations(1)->Unit(benchmark::kSecond);

BENCHMARK(told<scaling_linear>)
    ->Name("scaling")
    ->Arg(4)
    ->Arg(20)
    ->Arg(60)
    ->Arg(200)
    ->Iterations(3)
    ->Unit(benchmark::kSecond);
BENCHMARK(told<scaling_plastic>)
    ->Name("scaling_plastic")
    ->Arg(4)
    ->Arg(20)
    ->Arg(60)
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
