#include "sim/problem/rules.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "problem_of.hpp"
#include "sim/study/run.hpp"

using namespace reye;

namespace {

struct Written {
  std::vector<double> frames;  ///< cycles
  std::vector<double> rows;    ///< cycles
  sim::Summary summary;
};

Written written(const sim::Problem& problem) {
  Written w;
  sim::Observer observer;
  observer.frame = [&](const sim::Frame& f) { w.frames.push_back(f.cycle); };
  observer.increment = [&](const sim::IncrementRecord& r) { w.rows.push_back(r.cycle); };
  auto state = sim::initial_state(problem);
  w.summary = sim::run(problem, state, observer);
  return w;
}

/// The block scene: one load increment, then `cycles` in blocks of 10, eight increments each.
Written with_output(const std::string& output, const std::string& cycles = "40") {
  const auto text = test::with(test::block_scene, {{"cycles = 40", "cycles = " + cycles}});
  return written(test::problem_of("shape = \"off\"\n" + text + "[output]\n" + output));
}

/// Ends of single cycles from 1 to `cycles` that get a frame.
std::vector<double> due(const scene::FrameRules& rules, int cycles) {
  std::vector<double> all;
  for (int k = 1; k <= cycles; ++k)
    if (sim::frame_due(rules, {k - 1.0, static_cast<double>(k), k})) all.push_back(k);
  return all;
}

}  // namespace

// Log-spaced frames must come n per factor of ten, powers of ten themselves included, whatever the length of the life.
TEST(FrameRules, PerDecade) {
  EXPECT_EQ(due({.per_decade = 1}, 100000), (std::vector<double>{1, 10, 100, 1000, 10000, 100000}));
  EXPECT_EQ(due({.per_decade = 3}, 1000), (std::vector<double>{1, 3, 5, 10, 22, 47, 100, 216, 465, 1000}));
  EXPECT_EQ(due({.per_decade = 20}, 1000000).size() - due({.per_decade = 20}, 1000).size(), 60u);
}

// Blocks longer than the rule's spacing must get one frame each, never more, and load steps none by themselves.
TEST(FrameRules, AtMostOnePerBlock) {
  EXPECT_TRUE(sim::frame_due({.per_decade = 5}, {0.0, 1e4, 1}));
  EXPECT_TRUE(sim::frame_due({.per_decade = 5}, {1e4, 2e4, 2}));
  EXPECT_FALSE(sim::frame_due({.per_decade = 5}, {2e4, 2.1e4, 3}));
  EXPECT_FALSE(sim::frame_due({.every_cycles = 1.0, .every_blocks = 2, .per_decade = 5}, {0.0, 0.0, 1}));
}

// Rules must add up, and each by itself ask for what it says.
TEST(FrameRules, Combined) {
  EXPECT_EQ(due({.every_cycles = 4.0}, 10), (std::vector<double>{4, 8}));
  EXPECT_EQ(due({.every_blocks = 5}, 10), (std::vector<double>{5, 10}));
  EXPECT_EQ(due({.every_cycles = 4.0, .every_blocks = 5, .per_decade = 1}, 10), (std::vector<double>{1, 4, 5, 8, 10}));
  EXPECT_EQ(due({}, 10), std::vector<double>{});
  EXPECT_TRUE(sim::frame_due({}, {3.0, 4.0, 4, true}));
  EXPECT_TRUE(sim::frame_due({.at_remeshes = true}, {3.0, 4.0, 4, false, true}));
  EXPECT_FALSE(sim::frame_due({}, {3.0, 4.0, 4, false, true}));
}

// A run must show its start, the ends of its steps and what the rule asks for.
TEST(FrameRules, OfARun) {
  EXPECT_EQ(with_output("frames.per_step = 0").frames, (std::vector{0.0, 0.0, 40.0}));
  EXPECT_EQ(with_output("frames = { every_blocks = 2 }", "50").frames, (std::vector{0.0, 0.0, 20.0, 40.0, 50.0}));
  EXPECT_EQ(with_output("frames = { per_decade = 2 }").frames, (std::vector{0.0, 0.0, 10.0, 40.0}));
}

// Without any rule a step that counts cycles has five frames, evenly spaced; none of them where the scene asks for
// none.
TEST(FrameRules, PerStep) {
  EXPECT_EQ(with_output("frames.paraview = false", "100").frames, (std::vector<double>{0, 0, 20, 40, 60, 80, 100}));
  EXPECT_EQ(with_output("frames.per_step = 2", "100").frames, (std::vector<double>{0, 0, 50, 100}));
  EXPECT_EQ(with_output("frames.per_step = 0", "100").frames, (std::vector<double>{0, 0, 100}));
  EXPECT_EQ(with_output("frames.every_cycles = 50", "100").frames, (std::vector<double>{0, 0, 50, 100}));
}

// However many rules want it, no state may be shown twice: a frame per increment and one of the start are all there is.
TEST(FrameRules, NoFrameTwice) {
  const auto w = with_output(
      "frames = { every_increment = true, last_block = true, every_blocks = 1, every_cycles = 5, per_decade = 9 }");
  EXPECT_EQ(w.frames.size(), 1u + 1u + 4u * 8u);
  for (std::size_t k = 2; k < w.frames.size(); ++k)
    EXPECT_DOUBLE_EQ(w.frames[k], 10.0 * static_cast<double>(k - 1) / 8.0);
}

// A body remeshed must be seen on its new mesh at the end of that block, and only then.
TEST(FrameRules, AtRemeshes) {
  const auto text =
      std::string(test::block_scene) + "[remesh]\nevery_blocks = 2\n[output]\nframes = { at_remeshes = true }\n";
  const auto w = written(test::problem_of(text));
  ASSERT_EQ(w.summary.status, sim::RunStatus::done) << w.summary.reason;
  EXPECT_EQ(w.frames, (std::vector{0.0, 0.0, 10.0, 30.0, 40.0}));  // the press step is the first block
}

// Under a tolerance a block must end at a cycle that wants a frame where it is long against the distance of frames.
TEST(FrameRules, BlocksUnderATolerance) {
  const double every = 400.0, end = 40000.0;
  const auto problem = test::problem_of(
      test::with(test::block_scene,
                 {{"cycles = 40\njump = 10", "cycles = 40000\njump = { tolerance = 0.01, first = 500 }"}}) +
      "[output]\nframes = { every_cycles = 400 }\n");
  std::vector<double> ends{0.0};
  sim::Observer observer;
  observer.block = [&](const sim::State& state) { ends.push_back(state.cycle); };
  auto state = sim::initial_state(problem);
  ASSERT_EQ(sim::run(problem, state, observer).status, sim::RunStatus::done);
  int long_ones = 0;
  for (std::size_t b = 1; b < ends.size(); ++b) {
    if (ends[b] - ends[b - 1] < 4.0 * every || ends[b] > end - 1e-6) continue;
    ++long_ones;
    EXPECT_NEAR(std::remainder(ends[b], every), 0.0, 1e-6) << ends[b];
  }
  EXPECT_GE(long_ones, 2);
}

// The history must hold all rows of each n-th block, of the first and the last, and no others.
TEST(HistoryRule, EveryBlocks) {
  EXPECT_EQ(with_output("", "70").rows.size(), 1u + 7u * 8u);
  const auto rows = with_output("history = { every_blocks = 3 }", "70").rows;
  ASSERT_EQ(rows.size(), 1u + 4u * 8u);
  for (std::size_t b = 0; b < 4; ++b) EXPECT_DOUBLE_EQ(rows[8 * (b + 1)], (std::vector{10.0, 30.0, 60.0, 70.0}[b]));
}
