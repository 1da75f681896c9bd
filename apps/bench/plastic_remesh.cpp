#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

#include "adapt/gauss_points.hpp"
#include "scene/read.hpp"
#include "sim/block.hpp"

/// Plastic bodies pressed together, held there, and meshed anew a hundred times: what is left of their plastic strain.
namespace {

using namespace reye;

constexpr std::array names{"nearest", "patch", "l2"};
constexpr std::array factors{1.13, 0.91, 1.06, 0.95, 1.0, 1.1, 0.9};  ///< on the element size: never twice the same mesh

/// geo/plastic_fretting pressed far beyond yield, then held at that approach, or released to a fifth of that force.
scene::Scene scene_of(bool released, adapt::GaussTransfer how) {
  auto scene = scene::read(std::string(REYE_SOURCE_DIR) + "/geo/plastic_fretting/scene.toml");
  for (auto& zone : scene.geometry.fine_zones) {
    zone.half_width_mm = 0.8;
    zone.depth_mm = 0.4;
    zone.size_mm = 0.03;
  }
  for (auto& support : scene.supports)
    if (support.y.drive == body::Drive::loaded) support.y = {released ? body::Drive::loaded : body::Drive::moved,
                                                             released ? -600.0 : -0.03, support.y.history};
  if (released) scene.histories.at("press") = {{0.0, 0.0}, {0.5, 1.0}, {1.0, 0.2}};
  scene.remesh.state_transfer = how;
  return scene;
}

/// Fine zones of the drawings at `factor` times the size that the problem was prepared with.
void wish_size(const sim::Problem& problem, sim::State& state, double factor) {
  for (std::size_t b = 0; b < state.shapes.size(); ++b) {
    auto drawing = *state.shapes[b]->drawing;
    for (std::size_t k = 0; k < drawing.zones.size(); ++k)
      drawing.zones[k].size_mm = factor * problem.shapes[b]->drawing->zones[k].size_mm;
    auto shape = *state.shapes[b];
    shape.drawing = std::make_shared<const cad::Drawing>(std::move(drawing));
    state.shapes[b] = std::make_shared<const body::Shape>(std::move(shape));
  }
}

struct PlasticStrain {
  double integral = 0.0, peak = 0.0;  ///< of p over both bodies
};

PlasticStrain plastic_strain(const sim::Problem& problem, const sim::State& state) {
  PlasticStrain sum;
  for (std::size_t b = 0; b < state.shapes.size(); ++b) {
    const auto points = adapt::gauss_points(state.shapes[b]->mesh, problem.scene.analysis);
    const auto& history = state.solution.interiors[b].history;
    for (std::size_t i = 0; i < history.size(); ++i) {
      sum.integral += points.volume[i] * history[i].accumulated;
      sum.peak = std::max(sum.peak, history[i].accumulated);
    }
  }
  return sum;
}

/// range: the choice; 1: released.
void plastic_remesh(benchmark::State& run) {
  const auto problem = sim::prepare(scene_of(run.range(1) == 1, static_cast<adapt::GaussTransfer>(run.range(0))));
  const sim::BlockSpan span{&problem.scene.steps.front(), 1.0, false, true};
  const std::vector<sim::RemeshReason> asked(static_cast<std::size_t>(problem.body_count()), {"asked for", false});
  for (auto _ : run) {
    sim::Cache cache;
    auto state = sim::initial_state(problem);
    sim::begin_state(problem, state, cache);
    state = sim::play_increments(problem, std::move(state), cache, span, {}).state;
    const auto start = plastic_strain(problem, state);
    run.counters["start_peak"] = start.peak;
    for (int n = 1; n <= 100; ++n) {
      wish_size(problem, state, factors[static_cast<std::size_t>(n) % factors.size()]);
      auto outcome = sim::evolve_shape(problem, state, cache, span, {}, asked);
      if (!outcome.failure.empty()) return run.SkipWithError(outcome.failure.c_str());
      state = std::move(outcome.state);
      const auto now = plastic_strain(problem, state);
      run.counters["integral_" + std::to_string(n)] = now.integral / start.integral;
      run.counters["peak_" + std::to_string(n)] = now.peak / start.peak;
    }
  }
  run.SetLabel(names[run.range(0)]);
}

BENCHMARK(plastic_remesh)->ArgsProduct({{0, 1, 2}, {0, 1}})->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
