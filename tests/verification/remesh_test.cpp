#include <cmath>

#include "adapt/transfer/gauss_points.hpp"
#include "sim/march/block.hpp"
#include "sim/measure/measure.hpp"
#include "sim/measure/surfaces.hpp"
#include "sim/reshape/remesh.hpp"
#include "sim/reshape/shape.hpp"
#include "verification/contact_scene.hpp"

using namespace reye;
using namespace reye::verification;

namespace {

/// A scene played step by step, its bodies remeshed on request.
struct Bench {
  sim::Problem problem;
  sim::Cache cache;
  sim::State state;
  std::vector<sim::RemeshRecord> records;

  explicit Bench(const std::string& text) : problem(prepared(text)), state(sim::initial_state(problem)) {
    sim::begin_state(problem, state, cache);
  }

  sim::BlockSpan span(int step) const {
    const auto& s = problem.scene.steps.at(step);
    return {&s, s.cycles > 0.0 ? s.jump : 1.0, s.cycles > 0.0};
  }

  void play(int step) {
    auto outcome = sim::play_increments(problem, state, cache, span(step), {});
    ASSERT_TRUE(outcome.failure.empty()) << outcome.failure;
    state = std::move(outcome.state);
  }

  void renew(int step, const std::vector<sim::RemeshReason>& asked) {
    sim::Observer watch;
    watch.remesh = [&](const sim::RemeshRecord& r) { records.push_back(r); };
    auto outcome = sim::evolve_shape(problem, state, cache, span(step), watch, asked);
    ASSERT_TRUE(outcome.failure.empty()) << outcome.failure;
    state = std::move(outcome.state);
  }

  /// The wishes of all fine zones changed: the next division has other facets.
  void scale_zones(double factor) {
    for (auto& shape : state.shapes) {
      auto drawing = *shape->drawing;
      for (auto& zone : drawing.zones) zone.size_mm *= factor;
      auto next = *shape;
      next.drawing = std::make_shared<const cad::Drawing>(std::move(drawing));
      shape = std::make_shared<const body::Shape>(std::move(next));
    }
  }

  sim::SurfaceRecord secondary() {
    const auto kept = sim::system_of(problem, state, cache);
    const auto& system = *kept;
    return sim::surface_records(system.contacts[0], state.solution.contacts[0], state.shapes, problem.contacts[0])[0];
  }
};

/// Root of the integral of the squared difference over the root of that of the first, both linear between nodes.
double profile_change(const sim::SurfaceRecord& before, const sim::SurfaceRecord& after,
                      const std::vector<double>& old_values, const std::vector<double>& new_values) {
  const auto at = [](const sim::SurfaceRecord& s, const std::vector<double>& v, double x) {
    std::size_t k = 1;
    while (k + 1 < s.x_mm.size() && s.x_mm[k] < x) ++k;
    const double t = (x - s.x_mm[k - 1]) / (s.x_mm[k] - s.x_mm[k - 1]);
    return v[k - 1] + t * (v[k] - v[k - 1]);
  };
  double difference = 0.0, all = 0.0;
  for (int i = 0; i <= 4000; ++i) {
    const double x = -0.2 + 0.4 * i / 4000.0, p = at(before, old_values, x), d = at(after, new_values, x) - p;
    difference += d * d;
    all += p * p;
  }
  return std::sqrt(difference / all);
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double most = 0.0;
  for (std::size_t j = 0; j < a.size(); ++j) most = std::max(most, std::abs(a[j] - b[j]));
  return most;
}

/// Integral over all bodies of the accumulated plastic strain.
double plastic_strain(const Bench& bench) {
  double sum = 0.0;
  for (std::size_t b = 0; b < bench.state.shapes.size(); ++b) {
    const auto points = adapt::gauss_points(bench.state.shapes[b]->mesh, bench.problem.scene.analysis);
    const auto& history = bench.state.solution.interiors[b].history;
    for (std::size_t i = 0; i < history.size(); ++i) sum += points.volume[i] * history[i].accumulated;
  }
  return sum;
}

const std::vector<sim::RemeshReason> both{{"asked for", true}, {"asked for", true}};
const std::vector<sim::RemeshReason> both_kept{{"asked for", false}, {"asked for", false}};

}  // namespace

// Without wear, a hundred fresh meshes in a row, each second one with facets a tenth longer, must leave the pressure of
// a line contact where it was.
TEST(Remesh, PressureDoesNotDrift) {
  Bench bench(
      scene_text("hertz", {{"size_mm = 0.0045", "size_mm = 0.009"}, {"far_size_mm = 0.8", "far_size_mm = 1.5"}}));
  bench.play(0);
  const auto before = bench.secondary();
  for (int n = 0; n < 100; ++n) {
    bench.scale_zones(n % 2 == 0 ? 1.1 : 1.0 / 1.1);
    bench.renew(0, both);
  }
  const auto after = bench.secondary();
  EXPECT_EQ(bench.state.counts.remeshes, 200);
  EXPECT_LT(profile_change(before, after, before.pressure_MPa, after.pressure_MPa), 0.01);
}

// Stopped at full tangential load, a contact in partial slip that is remeshed twenty times must keep its shear,
// within 2 % of mu p0, and its stick width.
TEST(Remesh, ShearIsHistory) {
  Bench bench(scene_text("cattaneo_mindlin"));
  bench.play(0);
  bench.play(1);
  const auto before = bench.secondary();
  for (int n = 0; n < 20; ++n) bench.renew(1, both_kept);
  const auto after = bench.secondary();
  EXPECT_LT(largest_difference(before.shear_MPa, after.shear_MPa), 0.02 * Hertz::mu * Hertz::p0);
  const double width = sim::stick_half_width(before, Hertz::mu).value();
  EXPECT_NEAR(sim::stick_half_width(after, Hertz::mu).value(), width, 0.01 * width);
}

// Divided into other facets and back, it must keep its shear as well as facets can resolve: next to stick and contact
// edge it has an infinite slope, and a node half an element off reads another value; elsewhere within 1 % of mu p0.
TEST(Remesh, ShearOnOtherFacets) {
  constexpr double stick = 0.0645843, h = 0.0045;  // references B2
  Bench bench(scene_text("cattaneo_mindlin"));
  bench.play(0);
  bench.play(1);
  const auto before = bench.secondary();
  for (double factor : {1.1, 1.0 / 1.1}) {
    bench.scale_zones(factor);
    bench.renew(1, both);
  }
  const auto after = bench.secondary();
  EXPECT_LT(profile_change(before, after, before.shear_MPa, after.shear_MPa), 0.02);
  for (std::size_t j = 0; j < before.x_mm.size(); ++j)
    if (std::abs(std::abs(before.x_mm[j]) - stick) > 3.0 * h && std::abs(before.x_mm[j]) < 0.08) {
      EXPECT_NEAR(before.shear_MPa[j], after.shear_MPa[j], 0.01 * Hertz::mu * Hertz::p0) << before.x_mm[j];
    }
}

namespace {

/// Two bodies pressed far beyond yield.
struct Indented {
  Bench bench;
  double change = 0.0;  ///< of the integral of their plastic strain, over what it was

  explicit Indented(const Replacements& words) : bench(scene_text("plastic_fretting", all(words))) { bench.play(0); }

  /// Remeshed ten times, with other elements each time.
  void renew() {
    const double start = plastic_strain(bench);
    for (double factor : {1.13, 0.91 / 1.13, 1.06 / 0.91, 0.95 / 1.06, 1.0 / 0.95, 1.1, 0.9 / 1.1, 1.13 / 0.9,
                          0.91 / 1.13, 1.06 / 0.91}) {
      const auto shape = bench.state.shapes[1];
      bench.scale_zones(factor);
      bench.renew(0, both_kept);
      EXPECT_NE(bench.state.shapes[1]->mesh.X, shape->mesh.X);
    }
    change = plastic_strain(bench) / start - 1.0;
  }

  /// One increment to 1.05 of the way. Returns the integral of the plastic strain.
  double press_farther() {
    bench.problem.scene.histories.at("press") = {{0.0, 1.0}, {1.0, 1.05}};
    bench.problem.scene.steps.front().increments = 1;
    bench.play(0);
    return plastic_strain(bench);
  }

  static Replacements all(Replacements words) {
    words.push_back({"half_width_mm = 0.4, depth_mm = 0.15, size_mm = 0.012",
                     "half_width_mm = 0.8, depth_mm = 0.3, size_mm = 0.04"});
    return words;
  }
};

void expect_quiet(const std::vector<sim::RemeshRecord>& records) {
  for (const auto& record : records) {
    EXPECT_LT(record.pressure_jump, 0.03);
    EXPECT_LT(record.energy_jump, 0.03);
    EXPECT_GT(record.energy_jump, 0.0);
  }
}

}  // namespace

// Bodies held where they have indented each other, at the yield surface throughout, must keep the integral of their
// plastic strain to round-off of the transfer, at small and at finite strain; and pressed farther, must flow as far as
// those never remeshed, within 1 % of the whole: what was kept is no flow put off.
TEST(Remesh, PlasticStrainHeld) {
  for (const std::string kinematics : {"small", "finite"}) {
    const Replacements words{{"kinematics = \"small\"", "kinematics = \"" + kinematics + "\""},
                             {"force_N_per_mm = -120.0", "motion_mm = -0.03"}};
    Indented bodies(words), untouched(words);
    bodies.renew();
    EXPECT_LT(std::abs(bodies.change), 1e-4) << kinematics;
    EXPECT_NEAR(bodies.press_farther() / untouched.press_farther(), 1.0, 0.01) << kinematics;
    expect_quiet(bodies.bench.records);
  }
}

// Released to a fifth of the force that indented them, they must keep it to round-off of the transfer: nothing yields.
TEST(Remesh, PlasticStrainReleased) {
  Indented bodies(
      {{"-120.0", "-600.0"}, {"press  = [[0.0, 0.0], [1.0, 1.0]]", "press  = [[0.0, 0.0], [0.5, 1.0], [1.0, 0.2]]"}});
  bodies.renew();
  EXPECT_LT(std::abs(bodies.change), 1e-4);
  expect_quiet(bodies.bench.records);
}

// A body remeshed leaves the other one its mesh.
TEST(Remesh, OneBodyAlone) {
  Bench bench(scene_text("hertz"));
  bench.play(0);
  const auto shapes = bench.state.shapes;
  bench.renew(0, {{}, {"asked for", true}});
  EXPECT_EQ(bench.state.shapes[0], shapes[0]);
  EXPECT_NE(bench.state.shapes[1], shapes[1]);
  ASSERT_EQ(bench.records.size(), 1U);
  EXPECT_LT(bench.records[0].force_jump, 1e-3);
}

// Without wear a fine zone is the user's: a contact that fills it is no reason for another mesh.
TEST(Remesh, NoneWithoutWear) {
  const auto p = played(scene_text(
      "hertz", {{"half_width_mm = 0.13", "half_width_mm = 0.095"}, {"size_mm = 0.0045", "size_mm = 0.009"}}));
  EXPECT_EQ(p.summary.counts.remeshes, 0);
}
