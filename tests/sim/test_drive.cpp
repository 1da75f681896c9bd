#include <gtest/gtest.h>

#include "problem_of.hpp"
#include "sim/problem/drive.hpp"
#include "sim/problem/system.hpp"

using namespace reye;

namespace {

const scene::History to_and_fro{{0.0, 0.0}, {0.25, 1.0}, {0.75, -1.0}, {1.0, 0.0}};

scene::Scene with_histories() {
  scene::Scene scene;
  scene.histories = {
      {"stroke", to_and_fro}, {"press", {{0.0, 0.0}, {0.1, 1.0}, {1.0, 1.0}}}, {"other", {{0.0, 5.0}, {1.0, 7.0}}}};
  return scene;
}

/// What is imposed on a motion (0 x, 1 y, 2 rotation) of a support, as a position or as a force.
std::optional<double> imposed(const sim::Problem& p, const solver::System& system,
                              const std::vector<std::pair<int, double>>& list, const std::string& support, int motion) {
  for (int b = 0; b < p.body_count(); ++b)
    for (const auto& column : std::visit([](const auto& o) { return o.support_columns(); }, system.bodies[b]))
      if (p.inputs[b].supports[column.support].name == support && column.motion == motion)
        for (const auto& [global, value] : list)
          if (global == system.offset[b] + column.column) return value;
  return {};
}

}  // namespace

// The factor of a history must be its corners, straight between them, and its ends outside.
TEST(Drive, FactorAt) {
  for (const auto& [progress, factor] : to_and_fro) EXPECT_EQ(sim::factor_at(to_and_fro, progress), factor);
  EXPECT_DOUBLE_EQ(sim::factor_at(to_and_fro, 0.125), 0.5);
  EXPECT_DOUBLE_EQ(sim::factor_at(to_and_fro, 0.5), 0.0);
  EXPECT_DOUBLE_EQ(sim::factor_at(to_and_fro, 0.9), -0.4);
  EXPECT_EQ(sim::factor_at({{0.2, 3.0}, {0.8, 4.0}}, 0.1), 3.0);
  EXPECT_EQ(sim::factor_at({{0.2, 3.0}, {0.8, 4.0}}, 0.9), 4.0);
}

// Increments must end at equal parts and at every corner of a history that the step plays, each once, the last at 1.
TEST(Drive, IncrementEnds) {
  auto scene = with_histories();
  scene::Step step{.name = "s", .play = {"stroke"}, .increments = 3};
  EXPECT_EQ(sim::increment_ends(scene, step), (std::vector{0.25, 1.0 / 3.0, 2.0 / 3.0, 0.75, 1.0}));
  step.increments = 40;
  const auto ends = sim::increment_ends(scene, step);
  EXPECT_EQ(ends.size(), 40U);
  EXPECT_EQ(ends.back(), 1.0);
  step.play = {"stroke", "press"};
  step.increments = 1;
  EXPECT_EQ(sim::increment_ends(scene, step), (std::vector{0.1, 0.25, 0.75, 1.0}));
  step.play = {};
  EXPECT_EQ(sim::increment_ends(scene, step), (std::vector{1.0}));
}

// A step in which a support turns its body far must be divided until no increment turns it by more than 0.3 rad.
TEST(Drive, FarTurnsAreDivided) {
  scene::Scene scene;
  scene.histories["turn"] = {{0.0, 0.0}, {0.5, 1.0}, {1.0, 1.0}};
  scene.histories["press"] = {{0.0, 0.0}, {1.0, 1.0}};
  body::Support shaft;
  shaft.rotation = {body::Drive::moved, {{1.2, "turn"}}};
  scene.supports = {shaft};
  scene::Step step;
  step.increments = 2;
  step.play = {"turn"};
  EXPECT_EQ(sim::increment_ends(scene, step), (std::vector{0.125, 0.25, 0.375, 0.5, 1.0}));
  step.play = {"press"};
  EXPECT_EQ(sim::increment_ends(scene, step), (std::vector{0.5, 1.0}));
}

// A step must move the factors it plays and hold all others where they were.
TEST(Drive, FactorsHold) {
  const auto scene = with_histories();
  const scene::Step step{.name = "s", .play = {"stroke"}};
  const std::map<std::string, double> held{{"stroke", 0.7}, {"press", 0.3}, {"other", 7.0}};
  const auto factors = sim::factors_at(scene.histories, step, 0.25, held);
  EXPECT_EQ(factors, (std::map<std::string, double>{{"stroke", 1.0}, {"press", 0.3}, {"other", 7.0}}));
}

// Fixed and moved motions must be prescribed, loaded ones be forces, all times their factor; free ones neither.
TEST(Drive, Controls) {
  const auto p =
      test::problem_of(test::with(test::block_scene, {{"x        = \"fixed\"\n", "x = { motion_mm = 0.5 }\n"}}));
  sim::Cache cache;
  const auto kept = sim::system_of(p, sim::initial_state(p), cache);
  const auto& system = *kept;
  const std::map<std::string, double> factors{{"press", 0.25}, {"stroke", -0.5}};
  const auto c = sim::controls_at(p, system, factors, p.scene.steps[1], 0.25, 0.75, 10.0);
  EXPECT_DOUBLE_EQ(imposed(p, system, c.prescribed, "holder", 0).value(), -0.005);
  EXPECT_DOUBLE_EQ(imposed(p, system, c.forces, "holder", 1).value(), -5.0);
  EXPECT_EQ(imposed(p, system, c.prescribed, "holder", 2).value(), 0.0);
  EXPECT_DOUBLE_EQ(imposed(p, system, c.prescribed, "floor", 0).value(), 0.5);  // without a history: full
  EXPECT_FALSE(imposed(p, system, c.prescribed, "holder", 1));
  EXPECT_TRUE(c.contacts[0].wear);
  EXPECT_EQ(c.contacts[0].jump, 10.0);
  EXPECT_EQ(c.contacts[0].imposed_slip, 0.0);
  EXPECT_FALSE(sim::controls_at(p, system, factors, p.scene.steps[0], 0.0, 1.0, 1.0).contacts[0].wear);
}

// An increment must last its part of the step's period.
TEST(Drive, Duration) {
  const auto p = test::problem_of(test::with(test::block_scene, {{"cycles = 40", "period_s = 2.0\ncycles = 40"}}));
  sim::Cache cache;
  const auto kept = sim::system_of(p, sim::initial_state(p), cache);
  const auto& system = *kept;
  const std::map<std::string, double> factors{{"press", 1.0}, {"stroke", 0.0}};
  EXPECT_DOUBLE_EQ(sim::controls_at(p, system, factors, p.scene.steps[1], 0.25, 0.75, 10.0).contacts[0].duration_s,
                   1.0);
}

// Friction over cycles must be taken from its table, straight between its rows and constant outside.
TEST(Drive, FrictionOverCycles) {
  const auto p = test::problem_of(test::with(
      test::block_scene, {{"friction  = 0.3", "friction = { cycles = [10, 20, 40], value = [0.3, 0.5, 0.4] }"}}));
  EXPECT_EQ(p.contacts[0].options.friction, 0.5);
  solver::Controls controls;
  controls.contacts.resize(1);
  for (const auto& [cycle, mu] :
       {std::pair{0.0, 0.3}, {10.0, 0.3}, {15.0, 0.4}, {20.0, 0.5}, {30.0, 0.45}, {50.0, 0.4}}) {
    sim::set_cycle(controls, p, cycle);
    EXPECT_DOUBLE_EQ(controls.contacts[0].friction.value(), mu) << cycle;
  }
  const auto constant = test::problem_of(test::block_scene);
  controls.contacts[0].friction.reset();
  sim::set_cycle(controls, constant, 15.0);
  EXPECT_FALSE(controls.contacts[0].friction);
}

// Imposed sliding must be shared among the increments by their part of the play, and rest while a step does not wear.
TEST(Drive, ImposedSliding) {
  const auto p = test::problem_of(
      test::with(test::block_scene, {{"friction  = 0.3", "friction = 0.3\nimposed_sliding_mm = 100.0"}}));
  sim::Cache cache;
  const auto kept = sim::system_of(p, sim::initial_state(p), cache);
  const auto& system = *kept;
  const std::map<std::string, double> factors{{"press", 1.0}, {"stroke", 0.0}};
  EXPECT_DOUBLE_EQ(sim::controls_at(p, system, factors, p.scene.steps[1], 0.25, 0.75, 10.0).contacts[0].imposed_slip,
                   50.0);
  EXPECT_EQ(sim::controls_at(p, system, factors, p.scene.steps[0], 0.0, 1.0, 1.0).contacts[0].imposed_slip, 0.0);
}
