#include <gtest/gtest.h>

#include <cmath>

#include "played.hpp"
#include "problem_of.hpp"
#include "sim/problem/drive.hpp"
#include "sim/study/run.hpp"

using namespace reye;
using test::recorded;

namespace {

const std::string preload = "y        = { force_N_per_mm = -20.0, history = \"press\" }";
const std::string preload_and_vibration =
    "y        = [{ force_N_per_mm = -20.0, history = \"press\" }, { force_N_per_mm = 5.0, history = \"stroke\" }]";

}  // namespace

// Parts of a force must add up, each with the history of its own: a preload that stays and a vibration about it.
TEST(Parts, PreloadAndVibration) {
  const auto problem = test::problem_of(
      test::with(test::block_scene, {{preload, preload_and_vibration}, {"cycles = 40\njump = 10", "cycles = 1"}}));
  const auto rows = recorded(problem).rows;
  ASSERT_EQ(rows.size(), 9U);
  const auto& stroke = problem.scene.histories.at("stroke");
  for (const auto& row : rows) {
    const double expected = row.step == "press" ? -20.0 : -20.0 + 5.0 * sim::factor_at(stroke, row.progress);
    EXPECT_NEAR(row.support_forces[0].y(), expected, 1e-7) << row.progress;
    EXPECT_NEAR(row.support_forces[1].y(), -expected, 1e-7) << row.progress;
  }
}

// Parts of one history must act as one part with the sum of their values.
TEST(Parts, OfOneHistoryAreOne) {
  const auto one = recorded(test::problem_of(test::block_scene)).rows;
  const auto two =
      recorded(test::problem_of(test::with(test::block_scene, {{preload,
                                                                "y = [{ force_N_per_mm = -15.0, history = \"press\" }, "
                                                                "{ force_N_per_mm = -5.0, history = \"press\" }]"}})))
          .rows;
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_NEAR(two[i].pressure_max_MPa, one[i].pressure_max_MPa, 1e-7 * one[i].pressure_max_MPa);
    EXPECT_NEAR(two[i].energy_mJ, one[i].energy_mJ, 1e-7 * one.back().energy_mJ);
  }
}

// Turns in parts must add up, and a step be divided by what the parts it plays turn together.
TEST(Parts, SpinAndSwing) {
  scene::Scene scene;
  scene.histories["spin"] = {{0.0, 0.0}, {1.0, 1.0}};
  scene.histories["swing"] = {{0.0, 0.0}, {0.5, 1.0}, {1.0, 0.0}};
  body::Support shaft;
  shaft.rotation = {body::Drive::moved, {{0.5, "spin"}, {0.25, "swing"}}};
  scene.supports = {shaft};
  scene::Step step;
  step.play = {"swing"};
  EXPECT_EQ(sim::increment_ends(scene, step), (std::vector{0.5, 1.0}));
  step.play = {"spin", "swing"};
  EXPECT_EQ(sim::increment_ends(scene, step), (std::vector{0.25, 0.5, 1.0}));  // 0.5 there, 0 back
}

// A load in parts must do what as many loads do.
TEST(Parts, OfALoad) {
  const auto loaded = [](const std::string& loads) {
    return recorded(test::problem_of(test::with(test::block_scene, {{"[history]", loads + "[history]"},
                                                                    {"cycles = 40\njump = 10", "cycles = 1"}})))
        .rows;
  };
  const auto parts = loaded(
      "[load.a]\nedge = \"slider_top\"\nparts = [{ pressure_MPa = 3.0, history = \"press\" }, { traction_MPa = [0.0, "
      "1.0], history = \"stroke\" }]\n");
  const auto loads = loaded(
      "[load.a]\nedge = \"slider_top\"\npressure_MPa = 3.0\nhistory = \"press\"\n[load.b]\nedge = \"slider_top\"\n"
      "traction_MPa = [0.0, 1.0]\nhistory = \"stroke\"\n");
  ASSERT_EQ(parts.size(), loads.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(parts[i].pressure_max_MPa, loads[i].pressure_max_MPa);
    EXPECT_EQ(parts[i].energy_mJ, loads[i].energy_mJ);
  }
  EXPECT_NEAR(parts[2].support_forces[1].y(), 20.0 + 2.0 * (3.0 - 1.0), 1e-7);  // the stroke's first corner
}
