#include "sim/march/fixed_jump.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "played.hpp"
#include "problem_of.hpp"
#include "sim/march/work.hpp"

using namespace reye;

namespace {

/// Two blocks that fret over 100 cycles in blocks of 40, of a metal with this yield stress.
sim::Problem fretting_block(const std::string& yield_MPa, const std::string& more = "") {
  return test::problem_of(test::with(
      test::block_scene, {{"E_MPa = 200e3", "law = \"hencky_j2\"\nhardening = { law = \"linear\", yield_MPa = " +
                                                yield_MPa + ", modulus_MPa = 2000.0 }\nE_MPa = 200e3"},
                          {"cycles = 40\njump = 10", "cycles = 100\njump = 40\n" + more}}));
}

/// The cycles at the ends of all blocks of a run, and the work that it said was left at the start of each.
struct Blocks {
  std::vector<double> ends, left;
};

Blocks blocks_of(const sim::Problem& problem) {
  Blocks blocks;
  sim::Observer observer;
  observer.block = [&](const sim::State& state) {
    if (state.cycle > 0.0) blocks.ends.push_back(state.cycle);
    blocks.left.push_back(sim::work_left(problem, state).blocks);
  };
  test::played(problem, observer);
  return blocks;
}

}  // namespace

// While a body yields the first block of a fixed jump must be played in parts, none of more cycles than were played
// before it, and later blocks end where they would without it; a body that could yield and does not costs one cycle.
TEST(FixedJump, BodiesShakeDownInPartsOfTheFirstBlock) {
  using Cycles = std::vector<double>;
  EXPECT_EQ(blocks_of(fretting_block("5.0")).ends, (Cycles{1, 2, 4, 8, 16, 32, 40, 80, 100}));
  EXPECT_EQ(blocks_of(fretting_block("500.0")).ends, (Cycles{1, 40, 80, 100}));
  EXPECT_EQ(blocks_of(test::problem_of(test::block_scene)).ends, (Cycles{10, 20, 30, 40}));
}

// Once hardly anything flows the rest of a first block must be played at once, in a later step after one cycle.
TEST(FixedJump, ABodyShakesDownOnce) {
  const auto again = "[[step]]\nname = \"again\"\nplay = [\"stroke\"]\nincrements = 8\ncycles = 100\njump = 40\n";
  const auto ends = blocks_of(fretting_block("12.0", again)).ends;
  EXPECT_EQ(ends, (std::vector<double>{1, 2, 4, 40, 80, 100, 101, 140, 180, 200}));
}

// The blocks that are left must be counted with the parts of the first one.
TEST(FixedJump, PartsAreWork) {
  using Counts = std::vector<double>;
  EXPECT_EQ(blocks_of(fretting_block("5.0")).left, (Counts{9, 8, 7, 6, 5, 4, 3, 2, 1, 0}));
  EXPECT_EQ(blocks_of(fretting_block("500.0")).left, (Counts{9, 3, 2, 1, 0}));
}

// Parts must be sought only where a step wears, and a block that was shortened after a failure keeps its length.
TEST(FixedJump, NextBlock) {
  const auto yields = fretting_block("5.0"), elastic = test::problem_of(test::block_scene);
  const auto& step = yields.scene.steps.back();
  EXPECT_EQ(sim::next_fixed(elastic, elastic.scene.steps.back(), 10.0, 0.0, 0.0), 10.0);
  EXPECT_EQ(sim::next_fixed(yields, step, 40.0, 0.0, 0.0), 1.0);
  EXPECT_EQ(sim::next_fixed(yields, step, 2.5, 2.0, 1.0), 0.5);
  EXPECT_EQ(sim::next_fixed(yields, step, 40.0, 1.0, 1e-4), 39.0);
  EXPECT_EQ(sim::next_fixed(yields, step, 5.0, 8.0, 1.0), 5.0);
  auto no_wear = step;
  no_wear.wear = false;
  EXPECT_EQ(sim::next_fixed(yields, no_wear, 40.0, 0.0, 1.0), 40.0);
}
