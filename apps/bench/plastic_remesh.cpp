#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "adapt/transfer/gauss_points.hpp"
#include "material/hardening.hpp"
#include "material/parameters.hpp"
#include "scene/read.hpp"
#include "sim/march/block.hpp"
#include "sim/reshape/shape.hpp"
#include "sim/study/prepare.hpp"

/// Plastic bodies are pressed together and remeshed many times: their plastic strain against that of equal bodies
/// pressed alike on their first mesh.
namespace {

using namespace reye;

constexpr std::array transfers{"nearest", "patch", "l2"};
constexpr std::array factors{1.13, 0.91, 1.06, 0.95,
                             1.0,  1.1,  0.9};  ///< on the element size: never twice the same mesh

/// The motion after indentation: held at the approach that indented them; released to a fifth of such a force; pressed
/// farther after each fresh mesh; or swung a little back and forth.
enum Play { held, released, pressed, swung };

/// geo/plastic_fretting pressed far beyond yield.
scene::Scene scene_of(Play play, adapt::GaussTransfer how) {
  auto scene = scene::read(std::string(REYE_SOURCE_DIR) + "/geo/plastic_fretting/scene.toml");
  for (auto& zone : scene.geometry.fine_zones) {
    zone.half_width_mm = 0.8;
    zone.depth_mm = 0.4;
    zone.size_mm = 0.03;
  }
  for (auto& support : scene.supports)
    if (auto& y = support.y; y.drive == body::Drive::loaded) {
      y.drive = play == released ? body::Drive::loaded : body::Drive::moved;
      y.parts.at(0).value = play == released ? -600.0 : -0.03;
    }
  if (play == released) scene.histories.at("press") = {{0.0, 0.0}, {0.5, 1.0}, {1.0, 0.2}};
  scene.remesh.state_transfer = how;
  return scene;
}

/// sqrt(3/2) of the deviator of 2 mu eps_e, over the yield stress at p.
double yielding(const material::HenckyJ2& law, const material::ElasticState& state) {
  const auto& e = state.strain;
  const double mean = (e[0] + e[1] + e[3]) / 3.0;
  double square = 2.0 * e[2] * e[2];
  for (int i : {0, 1, 3}) square += std::pow(e[i] - mean, 2);
  const double stress = 2.0 * material::shear_modulus(law) * std::sqrt(1.5 * square);
  return stress / material::yield_stress(law.hardening, state.accumulated);
}

struct PlasticStrain {
  double integral = 0.0, peak = 0.0;  ///< of p over both bodies
};

/// Two bodies that have indented each other, and the motion after that.
struct Indented {
  sim::Problem problem;
  sim::Cache cache;
  sim::State state;

  explicit Indented(const scene::Scene& scene) : problem(sim::prepare(scene)), state(sim::initial_state(problem)) {
    sim::begin_state(problem, state, cache);
    play();
  }

  sim::BlockSpan span() const { return {&problem.scene.steps.front(), 1.0, false, true}; }

  void play() { state = sim::play_increments(problem, std::move(state), cache, span(), {}).state; }

  /// One increment between each two corners of the press.
  void press(scene::History history) {
    problem.scene.histories.at("press") = std::move(history);
    problem.scene.steps.front().increments = 1;
    play();
  }

  /// Fine zones with elements of `factor` times the size that the problem was prepared with. Returns why this fails, or
  /// nothing.
  std::string renew(double factor) {
    for (std::size_t b = 0; b < state.shapes.size(); ++b) {
      auto drawing = *state.shapes[b]->drawing;
      for (std::size_t k = 0; k < drawing.zones.size(); ++k)
        drawing.zones[k].size_mm = factor * problem.shapes[b]->drawing->zones[k].size_mm;
      auto shape = *state.shapes[b];
      shape.drawing = std::make_shared<const cad::Drawing>(std::move(drawing));
      state.shapes[b] = std::make_shared<const body::Shape>(std::move(shape));
    }
    auto outcome = sim::evolve_shape(problem, state, cache, span(), {}, {state.shapes.size(), {"asked for", false}});
    if (outcome.failure.empty()) state = std::move(outcome.state);
    return outcome.failure;
  }

  PlasticStrain plastic_strain() const {
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

  /// Largest stress over the yield stress at its point, less one.
  double beyond_yield() {
    const auto kept = sim::system_of(problem, state, cache);
    const auto& system = *kept;
    double most = 0.0;
    for (int b = 0; b < problem.body_count(); ++b)
      for (const auto& e : std::get<body::NonlinearBody>(system.bodies[b])
                               .elastic_states(state.solution.interiors[b], system.part(state.solution.q.high, b)))
        most = std::max(most, yielding(std::get<material::HenckyJ2>(problem.inputs[b].material), e) - 1.0);
    return most;
  }
};

/// range: the choice; the play; how many meshes.
void plastic_remesh(benchmark::State& run) {
  const auto play = static_cast<Play>(run.range(1));
  const auto scene = scene_of(play, static_cast<adapt::GaussTransfer>(run.range(0)));
  for (auto _ : run) {
    Indented bodies(scene), untouched(scene);
    double way = 1.0, beyond = 0.0;
    const auto press_both = [&](const scene::History& history) {
      bodies.press(history);
      untouched.press(history);
      way = history.back()[1];
    };
    const auto count = [&](const std::string& name) {
      const auto now = bodies.plastic_strain(), there = untouched.plastic_strain();
      run.counters["integral" + name] = now.integral / there.integral;
      run.counters["peak" + name] = now.peak / there.peak;
    };
    for (int n = 1; n <= run.range(2); ++n) {
      const auto failure = bodies.renew(factors[static_cast<std::size_t>(n) % factors.size()]);
      if (!failure.empty()) return run.SkipWithError(failure.c_str());
      beyond = std::max(beyond, bodies.beyond_yield());
      if (play == pressed) press_both({{0.0, way}, {1.0, way + 0.01}});
      if (play == swung) press_both({{0.0, way}, {0.5, way - 0.02}, {1.0, way}});
      count("_" + std::to_string(n));
    }
    run.counters["beyond_yield"] = beyond;
    if (play == released) continue;
    for (int i = 0; i < 5; ++i) press_both({{0.0, way}, {1.0, way + 0.01}});
    count("_farther");
  }
  run.SetLabel(transfers[run.range(0)]);
}

BENCHMARK(plastic_remesh)
    ->ArgsProduct({{0, 1, 2}, {held, released}, {100}})
    ->ArgsProduct({{2}, {pressed, swung}, {20}})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
