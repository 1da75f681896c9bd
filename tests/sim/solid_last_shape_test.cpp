#include <gtest/gtest.h>

#include "sim/solid/solid_measure.hpp"
#include "sim/solid/solid_player.hpp"
#include "solid_runs.hpp"
#include "support/solid_worn.hpp"

using namespace reye;

namespace {

sim::SolidProblem worn_ball() {
  auto problem = test::rubbed_ball();
  problem.contacts[0].options.wear = support::archard(1e-6, 2e-6);
  for (auto& step : problem.scene.steps) step.wear = true;
  problem.scene.frames.paraview = true;
  return problem;
}

double apart(const base::Points3& a, const base::Points3& b) {
  double most = 0.0, largest = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    most = std::max(most, (a[n] - b[n]).norm());
    largest = std::max(largest, b[n].norm());
  }
  return most / largest;
}

}  // namespace

// On its last shape a run solves nothing: what it shows there must be what the bodies factorised in it would show, and
// their factors are not made.
TEST(SolidLastShape, IsShownWithoutFactorsOfIt) {
  const auto problem = worn_ball();
  const auto run = test::play_and_keep(problem);
  ASSERT_EQ(run.played.summary.status, sim::RunStatus::done) << run.played.summary.reason;
  auto state = run.states.back();
  ASSERT_TRUE(sim::at_end(problem, state));
  EXPECT_NE(state.meshes[0], problem.inputs[0].mesh);
  EXPECT_NE(state.meshes[1], problem.inputs[1].mesh);
  EXPECT_FALSE(state.fitted);
  sim::SolidPlayer player(problem, state, {});
  EXPECT_TRUE(state.fitted) << "a run that resumes begins on gaps of these shapes";
  const auto exact = sim::solid_frame(problem, player.assembly(), state, "", {state.cycle, 1.0});
  const auto& shown = run.played.frames.back();
  ASSERT_EQ(shown.bodies.size(), 2u);
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_EQ(shown.bodies[b].mesh, state.meshes[b]);
    EXPECT_LT(apart(shown.bodies[b].u, exact.bodies[b].u), 1e-9);
    double most = 0.0, largest = 0.0;
    for (std::size_t n = 0; n < shown.bodies[b].stress_MPa.size(); ++n)
      for (std::size_t k = 0; k < 6; ++k) {
        const double stress = exact.bodies[b].stress_MPa[n][k];
        most = std::max(most, std::abs(shown.bodies[b].stress_MPa[n][k] - stress));
        largest = std::max(largest, std::abs(stress));
      }
    EXPECT_LT(most, 1e-8 * largest);
  }
  for (std::size_t side = 0; side < 2; ++side) {
    EXPECT_EQ(shown.surfaces[side].wear_depth_mm, exact.surfaces[side].wear_depth_mm);
    EXPECT_EQ(shown.surfaces[side].pressure_MPa, exact.surfaces[side].pressure_MPa);
    ASSERT_EQ(shown.surfaces[side].x_mm.size(), exact.surfaces[side].x_mm.size());
    EXPECT_EQ(apart(shown.surfaces[side].x_mm, exact.surfaces[side].x_mm), 0.0);
  }
}

// A run whose cycles are extended must continue from gaps of the shape that it had ended on, as one does that was asked
// for all cycles at once.
TEST(SolidLastShape, ALongerRunContinuesFromIt) {
  auto problem = worn_ball();
  problem.scene.frames.paraview = false;
  const auto shorter = test::play_and_keep(problem);
  ASSERT_EQ(shorter.played.summary.status, sim::RunStatus::done) << shorter.played.summary.reason;
  problem.scene.steps.back().cycles = 3;
  const auto rest = test::play_and_keep(problem, shorter.states.back());
  const auto whole = test::play_and_keep(problem);
  ASSERT_EQ(rest.played.summary.status, sim::RunStatus::done) << rest.played.summary.reason;
  const auto &a = rest.played.summary.contacts[0], &b = whole.played.summary.contacts[0];
  // The whole run left the little that the second cycle wore in the gaps.
  EXPECT_NEAR(a.peak_pressure_MPa.value(), b.peak_pressure_MPa.value(), 1e-4 * b.peak_pressure_MPa.value());
  EXPECT_NEAR(a.dissipated_energy_mJ, b.dissipated_energy_mJ, 1e-5 * b.dissipated_energy_mJ);
}
