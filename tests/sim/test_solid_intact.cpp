#include <gtest/gtest.h>

#include <limits>

#include "sim/solid/solid_intact.hpp"
#include "solid_runs.hpp"

using namespace reye;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// What is said of a state; empty when nothing is.
std::string said_of(const sim::SolidProblem& problem, const sim::SolidRunState& state) {
  try {
    sim::check_state(problem, state);
    return {};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

/// A state within the last cycle.
sim::SolidRunState within(const sim::SolidProblem& problem) {
  return test::play_and_keep(problem, {}, {}, 8).states.back();
}

}  // namespace

// The state at the start must be taken for one of its problem, and need no equations; one within a run brings them.
TEST(SolidIntact, StatesOfARun) {
  const auto problem = test::rubbed_ball();
  EXPECT_FALSE(sim::check_state(problem, sim::initial_solid_state(problem)));
  const auto state = within(problem);
  const auto assembly = sim::check_state(problem, state);
  ASSERT_TRUE(assembly);
  EXPECT_EQ(assembly->system.points(), state.retained);
}

// A state with anything that cannot be must be refused with what that is.
TEST(SolidIntact, WhatCannotBe) {
  const auto problem = test::rubbed_ball();
  const auto good = within(problem);
  ASSERT_EQ(said_of(problem, good), "");
  using State = sim::SolidRunState;
  const std::pair<void (*)(State&), const char*> changes[] = {
      {[](State& s) { s.touchable.pop_back(); }, "it has another number of bodies"},
      {[](State& s) { s.touchable[0].pop_back(); }, "body flat has a node too many or too few"},
      {[](State& s) { s.touchable[0][0] = 1; }, "body flat is prepared for contact where it has none"},
      {[](State& s) { s.touchable[1].assign(s.touchable[1].size(), 0); }, "is prepared for contact where it has none"},
      {[](State& s) { s.step = 7; }, "it is in a step that the scene lacks"},
      {[](State& s) { s.step = -1; }, "it is in a step that the scene lacks"},
      {[](State& s) { s.step_cycles = 3.0; }, "more cycles than the step has"},
      {[](State& s) { s.jump = no_number; }, "its blocks have no number of cycles"},
      {[](State& s) { s.meshes.pop_back(); }, "it has another number of bodies"},
      {[](State& s) { s.solution.wear[0].slip.pop_back(); }, "slip has a value too many or too few"},
      {[](State& s) { s.solution.wear[0].law_volume = no_number; }, "law_volume is not a number"},
      {[](State& s) { s.block_wear.clear(); }, "a contact too many or too few"},
      {[](State& s) { s.slid[0].pop_back(); }, "it slid at points that it lacks"},
      {[](State& s) { s.solution.turn.pop_back(); }, "it has another number of bodies"},
      {[](State& s) { s.solution.turn[0].w() = 2.0; }, "a body is turned by what is no rotation"},
      {[](State& s) { s.increment = 9; }, "at an increment that the step lacks"},
      {[](State& s) { s.cycle = no_number; }, "its number of cycles is not a number"},
      {[](State& s) { s.factors.erase("slide"); }, "a history is at no factor"},
      {[](State& s) { s.energy_last_cycle_mJ.clear(); }, "the energy of a contact"},
      {[](State& s) { s.widest_stick[0].stick_mm = no_number; }, "the stick zone of a contact"},
      {[](State& s) { s.counts.blocks = -1; }, "its counts are below zero"},
      {[](State& s) { s.retained += 1; }, "it was solved with other points"},
      {[](State& s) { s.solved.reset(); }, "it is under way and has not begun"},
      {[](State& s) { s.solution.traction.clear(); }, "a contact too many or too few"},
      {[](State& s) { s.solution.status[0].pop_back(); }, "contact pad has a value too many or too few"},
      {[](State& s) { s.solution.traction[0][0].x() = no_number; }, "a traction that is not a number"},
      {[](State& s) { s.solution.status[0][0] = static_cast<contact::SkinStatus>(3); },
       "is neither open nor sticks nor slips"},
      {[](State& s) { s.solution.u.conservativeResize(3); }, "its displacements are not those of its meshes"},
      {[](State& s) { s.solved->converged = false; }, "its last increment was not solved"},
      {[](State& s) { s.solved->place[0].Q.resize(1, 1); }, "contact pad has integrals too many or too few"},
      {[](State& s) { s.solved->place[0].Q.coeffs()[0] = no_number; }, "an integral that is not a number"},
      {[](State& s) { s.solved->place[0].frame[0].free = 3; }, "a normal that is none"},
      {[](State& s) { s.solved->nodes[0].pop_back(); }, "contact pad has a value too many or too few"},
      {[](State& s) { s.solved->nodes[0][0].gap = no_number; }, "contact pad has a value that is not a number"},
  };
  for (const auto& [change, sentence] : changes) {
    auto state = good;
    change(state);
    const auto text = said_of(problem, state);
    EXPECT_TRUE(text.starts_with("altered: ") && text.find(sentence) != std::string::npos) << sentence << ": " << text;
  }
}

// More cycles must be no issue; fewer than were begun must be one, under the key that was given.
TEST(SolidIntact, Extended) {
  auto problem = test::rubbed_ball();
  const auto state = within(problem);
  for (const double cycles : {2.0, 5.0}) {
    problem.scene.steps.back().cycles = cycles;
    EXPECT_TRUE(sim::extend(problem, "step[1].cycles", state).empty());
  }
  problem.scene.steps.back().cycles = 1.0;
  const auto issues = sim::extend(problem, "step[1].cycles", state);
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].key, "step[1].cycles");
  EXPECT_EQ(issues[0].rule, "the run has begun 2 cycles of this step already");
}
