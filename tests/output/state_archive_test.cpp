#include "output/run/state_archive.hpp"

#include <gtest/gtest.h>

using namespace reye;

// Where the increments of a cycle led must come back bit by bit: the next play of each starts there.
TEST(StateArchive, RecallReadsBack) {
  sim::State state;
  state.recall.step = 2;
  state.recall.played[{0.25, 0.5}] = {base::Vector::LinSpaced(3, 0.1, 1.0 / 3.0),
                                      {},
                                      {{{0.1, -0.2}, {0.3, 1.0 / 3.0}}, {}},
                                      {{contact::ContactStatus::slip, contact::ContactStatus::inactive}, {}}};
  const auto again = output::state_from_bytes(output::state_to_bytes(state)).recall;
  EXPECT_EQ(again.step, 2);
  ASSERT_EQ(again.played.size(), 1u);
  const auto &guess = again.played.at({0.25, 0.5}), &kept = state.recall.played.at({0.25, 0.5});
  EXPECT_EQ(guess.dq, kept.dq);
  EXPECT_EQ(guess.lambda, kept.lambda);
  EXPECT_EQ(guess.status, kept.status);
}

// Where a run stands in the blocks of a step must come back from a checkpoint, or its next block would be another one.
TEST(StateArchive, BlocksReadBack) {
  sim::State state;
  state.step_cycles = 12.0;
  state.step_blocks = 5;
  state.jump = 20.0;
  state.jump_rate = 1.0 / 3.0;
  state.block_cycles = 4.0;
  state.flow = 0.1 / 3.0;
  state.levels_at_once = false;
  const auto back = output::state_from_bytes(output::state_to_bytes(state));
  EXPECT_EQ(back.step_cycles, 12.0);
  EXPECT_EQ(back.step_blocks, 5);
  EXPECT_EQ(back.jump, 20.0);
  EXPECT_EQ(back.jump_rate, 1.0 / 3.0);
  EXPECT_EQ(back.block_cycles, 4.0);
  EXPECT_EQ(back.flow, 0.1 / 3.0);
  EXPECT_FALSE(back.levels_at_once);
}

// What the Gauss points of a nonlinear body know must come back from a checkpoint bit by bit.
TEST(StateArchive, InteriorsReadBack) {
  sim::State state;
  body::Interior interior;
  interior.y = {base::Vector::LinSpaced(5, 0.1, 0.9), 1e-17 * base::Vector::LinSpaced(5, 0.3, -0.2)};
  interior.history = {{{0.1, -0.2, 1.0 / 3.0, 0.1}, 0.25}};
  interior.F0 = {{1.1, 0.2, -0.3, 0.9, 1.0 / 3.0}};
  state.solution.interiors = {interior, {}};
  const auto again = output::state_from_bytes(output::state_to_bytes(state)).solution.interiors;
  ASSERT_EQ(again.size(), 2u);
  EXPECT_EQ(again[0].y.high, interior.y.high);
  EXPECT_EQ(again[0].y.low, interior.y.low);
  ASSERT_EQ(again[0].history.size(), 1u);
  EXPECT_EQ(again[0].history[0].strain, interior.history[0].strain);
  EXPECT_EQ(again[0].history[0].accumulated, 0.25);
  EXPECT_EQ(again[0].F0, interior.F0);
  EXPECT_TRUE(again[1].F0.empty());
}

// What a run has seen of its contacts, and warned of, must come back from a checkpoint, or a resumed run would warn
// otherwise.
TEST(StateArchive, KeepsWhatWasSeen) {
  sim::State state;
  state.warnings = {{"resolution", "contact pad", "2 elements touch.", 4.0}};
  state.watch = {{12.5, {0.12, 0.18, 0.005}, 3, {10.0, 0.1, 6.5, 0.4, 0.02, true, "face", 2.5, 1e-4}}};
  const auto back = output::state_from_bytes(output::state_to_bytes(state));
  ASSERT_EQ(back.warnings.size(), 1u);
  EXPECT_EQ(back.warnings[0].kind, "resolution");
  EXPECT_EQ(back.warnings[0].severity, 4.0);
  ASSERT_EQ(back.watch.size(), 1u);
  const auto& [force_most, widest, slipped_most, pressed] = back.watch[0];
  EXPECT_EQ(force_most, 12.5);
  EXPECT_EQ(widest.stick_mm, 0.12);
  EXPECT_EQ(widest.contact_mm, 0.18);
  EXPECT_EQ(widest.element_mm, 0.005);
  EXPECT_EQ(slipped_most, 3);
  EXPECT_EQ(pressed.across, 6.5);
  EXPECT_EQ(pressed.length_mm, 0.4);
  EXPECT_TRUE(pressed.bounded);
  EXPECT_EQ(pressed.cut, "face");
  EXPECT_EQ(pressed.facets_mm, 1e-4);
}
