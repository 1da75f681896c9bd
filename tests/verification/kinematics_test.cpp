#include <algorithm>
#include <cmath>

#include "fem/finite.hpp"
#include "sim/measure/small_strain.hpp"
#include "sim/place/place.hpp"
#include "sim/study/kinematics.hpp"
#include "verification/wear_scene.hpp"

using namespace reye;
using namespace reye::verification;

namespace {

/// A scene of geo/ whose deformable bodies are made of one elastic law, under loads times `share`.
struct Case {
  const char* name;
  std::string text;
};

std::string strained(const std::string& text, const std::string& kinematics) {
  return replaced(text, {{"KINEMATICS", "kinematics = \"" + kinematics + "\""}});
}

/// A soft half disc on a stiff block, under force.
Case disc_case(double share) {
  return {"disc", scene_text("hertz_block", {{"E_MPa = 200.0", "law = \"hencky\"\nE_MPa = 200.0"},
                                             {"material = \"soft\"", "material = \"soft\"\nKINEMATICS"},
                                             {"-0.625", number(-0.625 * share)}})};
}

/// A rubber pin pressed on a rigid plate and drawn to one side.
Case pin_case(double share) {
  return {"pin",
          scene_text("rubber_pin_wear", {{"kinematics = \"finite\"", "KINEMATICS"},
                                         {"= -0.4", "= " + number(-0.4 * share)},
                                         {"= 1.5,", "= " + number(1.5 * share) + ","},
                                         {"[0.25, 1.0], [0.75, -1.0], [1.0, 0.0]", "[1.0, 1.0]"},
                                         {"increments = 40\ncycles = 200\njump = 10", "increments = 10\nwear = false"},
                                         {"every_cycles = 10", "every_increment = true"}})};
}

/// A block pressed on a wider one and drawn along it.
Case blocks_case(double share) {
  return {"blocks", scene_text("two_blocks_finite", {{"kinematics = \"finite\"", "KINEMATICS"},
                                                     {"= -0.15", "= " + number(-0.15 * share)},
                                                     {"= 1.2", "= " + number(1.2 * share)}})};
}

/// A ring pressed between dies, which turns more than it is strained.
Case ring_case(double share) {
  auto text = scene_text("pressed_ring_plastic", {{"kinematics = \"finite\"", "KINEMATICS"},
                                                  {"hencky_j2", "hencky"},
                                                  {"= -4.0", "= " + number(-4.0 * share)},
                                                  {"[0.005, 0.005], ", ""},
                                                  {"increments = 40", "increments = 8"}});
  const auto at = text.find("hardening");
  return {"ring", text.erase(at, text.find('\n', at) - at)};
}

/// A slender column pressed on a base by its head, which is then moved to one side.
Case column_case(double share) {
  return {"column", "geometry = [\"" + std::string(REYE_SOURCE_DIR) + R"(/geo/column/column.geo"]
[material.soft]
law   = "hencky"
E_MPa = 1000.0
nu    = 0.3
[body.column]
material = "soft"
KINEMATICS
mesh     = { far_size_mm = 0.1 }
[body.base]
rigid = true
[contact.pad]
secondary = "column_bottom"
primary   = ["base_top"]
friction  = 0.5
[support.base]
edge     = "base_bottom"
x        = "fixed"
y        = "fixed"
rotation = "fixed"
[support.head]
edge     = "column_top"
rotation = "fixed"
x        = { motion_mm = )" +
                        number(0.5 * share) + R"(, history = "side" }
y        = { motion_mm = )" +
                        number(-0.3 * share) + R"(, history = "press" }
[history]
side  = [[0.0, 0.0], [1.0, 1.0]]
press = [[0.0, 0.0], [1.0, 1.0]]
[[step]]
play = ["press"]
increments = 4
[[step]]
play = ["side"]
increments = 6
)"};
}

double peak(const Played& p) {
  const auto& pressure = p.surface(sim::Side::secondary).pressure_MPa;
  return *std::max_element(pressure.begin(), pressure.end());
}

double strain_energy(const Played& p) {
  double energy = 0.0;
  for (int b = 0; b < p.problem.body_count(); ++b) {
    if (p.problem.rigid[b]) continue;
    const auto& input = p.problem.inputs[b];
    const auto& body = p.frame.bodies[b];
    base::Vector u(2 * static_cast<Eigen::Index>(body.u.size()));
    for (std::size_t i = 0; i < body.u.size(); ++i) u.segment<2>(2 * static_cast<Eigen::Index>(i)) = body.u[i];
    energy += fem::strain_energy(*body.mesh, {input.material, input.analysis, input.kinematics, input.b_bar}, u, {});
  }
  return energy;
}

/// Largest relative difference in peak pressure, contact width, normal force and strain energy.
double difference_of_figures(const Played& a, const Played& b) {
  const auto difference = [](double x, double y) { return std::abs(x / y - 1.0); };
  double largest = std::max({difference(peak(a), peak(b)), difference(strain_energy(a), strain_energy(b)),
                             difference(a.contact().normal_force, b.contact().normal_force)});
  if (a.contact().contact_half_width_mm && b.contact().contact_half_width_mm)
    largest = std::max(largest, difference(*a.contact().contact_half_width_mm, *b.contact().contact_half_width_mm));
  return largest;
}

void expect_same_run(const Played& a, const Played& b, const char* name) {
  EXPECT_EQ(a.state.solution.q.high, b.state.solution.q.high) << name;
  ASSERT_EQ(a.state.solution.contacts.size(), b.state.solution.contacts.size());
  for (std::size_t c = 0; c < a.state.solution.contacts.size(); ++c)
    EXPECT_EQ(a.state.solution.contacts[c].lambda, b.state.solution.contacts[c].lambda) << name;
  EXPECT_EQ(a.summary.counts.newton_iterations, b.summary.counts.newton_iterations) << name;
}

}  // namespace

// Below the bound `auto` must play the small-strain run, bit by bit, and report the estimate that it used.
TEST(Kinematics, AutoIsSmallWhereThatIsEnough) {
  for (const Case& c : {disc_case(0.1), pin_case(0.01), ring_case(0.01), column_case(0.05)}) {
    const auto chosen = played(strained(c.text, "auto")), small = played(strained(c.text, "small"));
    expect_same_run(chosen, small, c.name);
    ASSERT_TRUE(chosen.summary.error_small_strain) << c.name;
    EXPECT_GT(*chosen.summary.error_small_strain, 0.0) << c.name;
    EXPECT_LE(*chosen.summary.error_small_strain, sim::small_strain_bound) << c.name;
    EXPECT_FALSE(small.summary.error_small_strain) << c.name;
  }
}

// Beyond the bound it must play the finite-strain run, bit by bit.
TEST(Kinematics, AutoIsFiniteWhereThatIsNeeded) {
  for (const Case& c : {disc_case(1.0), pin_case(0.1), ring_case(0.06), column_case(0.3)}) {
    const auto chosen = played(strained(c.text, "auto")), finite = played(strained(c.text, "finite"));
    expect_same_run(chosen, finite, c.name);
    EXPECT_FALSE(chosen.summary.error_small_strain) << c.name;
  }
}

// The problem must follow from its scene: what the trial decided stands there, and placed again it is the same problem.
TEST(Kinematics, DecisionsStandInTheScene) {
  for (const Case& c : {disc_case(0.1), pin_case(0.1)}) {
    const auto decided = played(strained(c.text, "auto")).problem;
    sim::Cache cache;
    const auto again = sim::place(decided.scene, cache);
    for (int b = 0; b < decided.body_count(); ++b) {
      if (decided.rigid[b]) continue;
      EXPECT_TRUE(decided.scene.body_material.at(decided.inputs[b].name).kinematics) << c.name;
      EXPECT_EQ(again.inputs[b].kinematics, decided.inputs[b].kinematics) << c.name;
      EXPECT_EQ(again.inputs[b].material.index(), decided.inputs[b].material.index()) << c.name;
      EXPECT_FALSE(again.kinematics[b]) << c.name;
    }
  }
}

// Near the bound the estimate must cover the error of small strain, and not be more than eight times as large.
TEST(Kinematics, EstimateIsOfTheSizeOfTheError) {
  for (const Case& c : {disc_case(0.15), pin_case(0.018), blocks_case(0.04), ring_case(0.013), column_case(0.06)}) {
    const auto small = played(strained(c.text, "small")), finite = played(strained(c.text, "finite"));
    auto told = small.problem;
    for (std::size_t b = 0; b < told.kinematics.size(); ++b)
      if (!told.rigid[b]) told.kinematics[b].emplace();
    sim::Cache cache;
    const double estimate =
        sim::small_strain_error(told, small.state, *sim::system_of(told, small.state, cache)).value();
    const double error = difference_of_figures(small, finite);
    EXPECT_GT(estimate, 0.5 * sim::small_strain_bound) << c.name;
    EXPECT_LT(estimate, 2.0 * sim::small_strain_bound) << c.name;
    EXPECT_GT(estimate, error) << c.name;
    EXPECT_LT(estimate, 8.0 * error) << c.name;
  }
}

// A linear elastic body that needs finite strain must get the Hencky law of the same constants, and the plan say so;
// one whose small strain is good enough must stay as it is.
TEST(Kinematics, LinearElasticBecomesHencky) {
  const auto linear = replaced(strained(disc_case(1.0).text, "auto"), {{"law = \"hencky\"\n", ""}});
  const auto problem = prepared(linear);
  ASSERT_TRUE(std::holds_alternative<material::Hencky>(problem.inputs[0].material));
  EXPECT_EQ(std::get<material::Hencky>(problem.inputs[0].material).E_MPa, 200.0);
  EXPECT_NE(problem.plan.lines[0].find("Hencky, finite strain"), std::string::npos) << problem.plan.lines[0];
  EXPECT_EQ(problem.plan.lines[1].find("  kinematics auto: finite strain, for the estimated error of small strain is "),
            0U)
      << problem.plan.lines[1];
  const auto weak = prepared(replaced(linear, {{"-0.625", "-0.03"}}));
  EXPECT_TRUE(std::holds_alternative<material::LinearElastic>(weak.inputs[0].material));
  EXPECT_EQ(weak.plan.lines[1].find("  kinematics auto: small strain, for the estimated error of small strain is "), 0U)
      << weak.plan.lines[1];
}

// A run whose small strain turns out not to be good enough, for what comes is more than the trial met, must say so once
// and report the larger estimate.
TEST(Kinematics, RunWarnsWhenTheEstimatePassesTheBound) {
  auto problem = prepared(replaced(strained(disc_case(0.1).text, "auto"),
                                   {{"increments = 10", "increments = 2\ncycles = 3\nwear = false"}}));
  problem.scene.histories.at("press").back()[1] = 10.0;
  auto state = sim::initial_state(problem);
  const double trial = state.small_strain_error.value();
  std::vector<std::string> log;
  sim::Observer watch;
  watch.log = [&](const std::string& line) { log.push_back(line); };
  const auto summary = sim::run(problem, state, watch);
  EXPECT_EQ(summary.counts.blocks, 3);
  EXPECT_LT(trial, sim::small_strain_bound);
  EXPECT_GT(summary.error_small_strain.value(), sim::small_strain_bound);
  ASSERT_EQ(log.size(), 1U);
  EXPECT_NE(log[0].find("small strain was chosen, but its estimated error is"), std::string::npos) << log[0];
}
