#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "played.hpp"
#include "problem_of.hpp"
#include "sim/march/jump_rule.hpp"
#include "sim/measure/correction.hpp"
#include "sim/study/run.hpp"

using namespace reye;
using test::apart;
using test::recorded;
using test::removed;
using test::sum;
using test::worn_block;

// With blocks of one size a controlled run must be of second order in it, a plain one of first.
TEST(Jump, Orders) {
  const auto exact = removed(recorded(worn_block("{ tolerance = 0.2, first = 400, most = 400 }")));
  std::vector<double> plain, controlled;
  for (const std::string size : {"8000", "4000", "2000"}) {
    plain.push_back(apart(removed(recorded(worn_block(size))), exact));
    controlled.push_back(
        apart(removed(recorded(worn_block("{ tolerance = 0.2, first = " + size + ", most = " + size + " }"))), exact));
  }
  for (int k : {0, 1}) {
    EXPECT_NEAR(std::log2(plain[k] / plain[k + 1]), 1.0, 0.2) << plain[k];
    EXPECT_GT(std::log2(controlled[k] / controlled[k + 1]), 1.7) << controlled[k];
    EXPECT_LT(controlled[k], plain[k]);
  }
}

// The estimated error must be that of the profile, within a factor of three or on the safe side, and below the
// tolerance.
TEST(Jump, EstimateAndTolerance) {
  const auto exact = removed(recorded(worn_block("{ tolerance = 0.2, first = 400, most = 400 }")));
  for (const double tolerance : {0.03, 0.01, 0.003}) {
    const auto r = recorded(worn_block("{ tolerance = " + std::to_string(tolerance) + ", first = 500 }"));
    const double error = apart(removed(r), exact), estimate = r.summary.error_cycle_jump.value();
    EXPECT_LT(error, tolerance);
    EXPECT_LT(estimate, 1.5 * tolerance);
    EXPECT_GT(estimate, error / 3.0);
    EXPECT_LT(r.summary.contacts[0].ledger_relative_error.value(), 1e-12);
    EXPECT_EQ(r.state.step_cycles, 0.0);
    EXPECT_NEAR(r.summary.cycles, 40000.0, 1e-6);
  }
}

// A block too long for the tolerance must be refused and said so, and leave nothing but its count behind; where it was
// the first of a step, the first cycle is played by itself.
TEST(Jump, RefusedBlocksLeaveNothing) {
  const auto r = recorded(worn_block("{ tolerance = 0.001, first = 20000 }"));
  const auto& counts = r.summary.counts;
  EXPECT_GT(counts.refused_blocks, 0);
  EXPECT_NE(std::find_if(r.log.begin(), r.log.end(),
                         [](const auto& l) { return l.find("refused: estimated error") != l.npos; }),
            r.log.end());
  const long blocks = counts.blocks - 2;  // one is the load step, one the first cycle
  // The first block that is tried is played in halves, the first two cycles by themselves, and all others once; short
  // cycles level the end, which is shown.
  const long levelling = counts.cycles_solved - (3 + 1 + blocks + counts.refused_blocks - 1);
  EXPECT_GE(levelling, 3);
  EXPECT_LE(levelling, 8);
  EXPECT_EQ(r.rows.size(), 1 + 8 * static_cast<std::size_t>(1 + blocks + levelling));
  EXPECT_TRUE(
      std::is_sorted(r.rows.begin(), r.rows.end(), [](const auto& a, const auto& b) { return a.cycle < b.cycle; }));
  // Its cycles are not counted either: what wears off is what a run wears off that begins with short blocks.
  EXPECT_LT(apart(removed(r), removed(recorded(worn_block("{ tolerance = 0.001, first = 200 }")))), 0.002);
}

// Resuming from any block's end must change no bit of a controlled run.
TEST(Jump, GoesOnFromAnyBlock) {
  const auto problem = worn_block("{ tolerance = 0.01, first = 500 }");
  std::vector<sim::State> ends;
  sim::Observer observer;
  observer.block = [&](const sim::State& s) { ends.push_back(s); };
  auto whole = sim::initial_state(problem);
  sim::run(problem, whole, observer);
  for (auto state : ends) {
    const auto summary = sim::run(problem, state, {});
    EXPECT_EQ(state.solution.q.high, whole.solution.q.high);
    EXPECT_EQ(state.solution.contacts[0].removed_secondary, whole.solution.contacts[0].removed_secondary);
    EXPECT_EQ(summary.error_cycle_jump, whole.jump_error);
    EXPECT_EQ(summary.counts.cycles_solved, whole.counts.cycles_solved);
  }
}

// A life inside a long block must lie where a run with short ones puts it, within its stated error.
TEST(Jump, LifeInsideABlock) {
  const std::string limit = "[limit.life]\ncontact = \"pad\"\ndepth_mm = 1.0e-4\n";
  const auto fine = recorded(worn_block("{ tolerance = 0.2, first = 400, most = 400 }", limit));
  const double exact = fine.summary.life_cycles.at("life").value();
  ASSERT_LT(exact, 39000.0);
  for (const double tolerance : {0.03, 0.01}) {
    const auto r = recorded(worn_block("{ tolerance = " + std::to_string(tolerance) + ", first = 500 }", limit));
    EXPECT_NEAR(r.summary.life_cycles.at("life").value(), exact, r.summary.life_error.at("life"));
    EXPECT_LT(r.summary.life_error.at("life"), 2.0 * tolerance * exact);
  }
}

// Where cycles end unloaded their ends do not show whether pressures repeat: all eight cycles must level the end.
TEST(Jump, UnloadedEndsAreLevelledThroughout) {
  const auto r = recorded(test::problem_of(
      test::with(
          test::block_scene,
          {{"force_N_per_mm = -20.0", "motion_mm = -0.001"},
           {"press  = [[0.0, 0.0], [1.0, 1.0]]", "press  = [[0.0, 0.0], [0.1, 1.0], [0.9, 1.0], [1.0, 0.0]]"},
           {"[0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]", "[0.1, 0.0], [0.3, 1.0], [0.7, -1.0], [0.9, 0.0], [1.0, 0.0]]"},
           {"[[step]]\nname = \"press\"\nplay = [\"press\"]\nwear = false\n", ""},
           {"play = [\"stroke\"]", "play = [\"press\", \"stroke\"]"},
           {"cycles = 40\njump = 10", "cycles = 4000\njump = { tolerance = 0.2, first = 4000 }"}}) +
      test::few_frames));
  const auto& counts = r.summary.counts;
  for (const auto& lambda : r.state.solution.contacts[0].lambda) EXPECT_EQ(lambda.norm(), 0.0);
  EXPECT_GT(sum(removed(r)), 0.0);
  EXPECT_EQ(counts.refused_blocks, 0);
  EXPECT_EQ(counts.cycles_solved - 3 * counts.blocks, 8);
}

// Pressures that are shown on the way must be those that a step would show which ends there, even where an increment of
// the block wears more than the bodies yield.
TEST(Jump, PressuresOnTheWayAreThoseOfAnEnd) {
  const auto pressure = [](const std::string& cycles) {
    const auto r = recorded(test::problem_of(
        test::with(test::block_scene,
                   {{"cycles = 40\njump = 10",
                     "cycles = " + cycles + "\njump = { tolerance = 0.2, first = 1e7, most = 1e7 }"}}) +
        "[output]\nframes = { every_cycles = 10000000 }\n"));
    double at = 0.0;
    for (const auto& row : r.rows)
      if (row.cycle < 1e7 * (1.0 + 1e-9)) at = row.pressure_max_MPa;
    return at;
  };
  EXPECT_NEAR(pressure("20000000") / pressure("10000000"), 1.0, 0.03);
}

// Where no edge moved, extrapolation must double the correction, keep sums and give no node material back that waits in
// no gap.
TEST(Jump, ExtrapolationKeepsSums) {
  const auto problem = test::problem_of(test::block_scene);
  sim::Cache cache;
  const sim::State fresh = sim::initial_state(problem);
  const auto kept = sim::system_of(problem, fresh, cache);
  const auto& system = *kept;
  sim::State start = fresh;
  start.solution.contacts = {contact::fresh_state(system.contacts[0])};
  auto& before = start.solution.contacts[0];
  for (auto& status : before.status) status = contact::ContactStatus::slip;
  sim::State once = start, halves = start;
  auto middle = start.solution.contacts;
  for (std::size_t j = 0; j < before.removed_secondary.size(); ++j) {
    const double wave = 0.1 * (static_cast<double>(j % 3) - 1.0);
    once.solution.contacts[0].removed_secondary[j] = 2.0 + wave;
    middle[0].removed_secondary[j] = middle[0].energy_secondary[j] = middle[0].slip[j] = 1.0;
    halves.solution.contacts[0].removed_secondary[j] = 2.0 - wave;
    halves.solution.contacts[0].pending_secondary[j] = 0.15;
    for (auto* end : {&once, &halves})
      end->solution.contacts[0].energy_secondary[j] = end->solution.contacts[0].slip[j] = 2.0;
  }
  const double expected =
      2.0 * sum(halves.solution.contacts[0].removed_secondary) - sum(once.solution.contacts[0].removed_secondary);
  sim::extrapolate(system, {start, once, middle}, halves);
  const auto& c = halves.solution.contacts[0];
  EXPECT_NEAR(sum(c.removed_secondary), expected, 1e-13);
  EXPECT_GE(*std::min_element(c.pending_secondary.begin(), c.pending_secondary.end()), 0.0);
  EXPECT_GT(c.removed_secondary[0], 2.2);                  // 2.1 and nearly 0.2 more
  EXPECT_NEAR(c.removed_secondary[2], 1.9 - 0.15, 1e-14);  // no more than waits
}

// Without friction no energy is dissipated, and wear by Archard's law must be extrapolated all the same; what an edge
// that passed leaves of the sum must not be taken from nodes that are three elements away.
TEST(Jump, WhatEdgesLoseTheMiddleKeeps) {
  const auto problem = test::problem_of(test::block_scene);
  sim::Cache cache;
  const sim::State fresh = sim::initial_state(problem);
  const auto kept = sim::system_of(problem, fresh, cache);
  const auto& system = *kept;
  sim::State start = fresh;
  start.solution.contacts = {contact::fresh_state(system.contacts[0])};
  const auto& X = system.contacts[0].secondary.X;
  const auto by_x = [&](auto a, auto b) { return a.x() < b.x(); };
  const auto edge = std::min_element(X.begin(), X.end(), by_x) - X.begin(),
             far = std::max_element(X.begin(), X.end(), by_x) - X.begin();
  for (auto& status : start.solution.contacts[0].status) status = contact::ContactStatus::slip;
  sim::State once = start, halves = start;
  auto middle = start.solution.contacts;
  for (std::size_t j = 0; j < X.size(); ++j) {
    middle[0].removed_secondary[j] = middle[0].slip[j] = 1.0;
    for (auto* end : {&once, &halves}) {
      auto& c = end->solution.contacts[0];
      c.slip[j] = 2.0;
      c.removed_secondary[j] = c.pending_secondary[j] = end == &halves ? 2.0 : 1.9;
    }
  }
  once.solution.contacts[0].removed_secondary[edge] = 2.5;
  middle[0].removed_secondary[edge] = 0.0;  // the edge passed here in the second half
  const double expected =
      2.0 * sum(halves.solution.contacts[0].removed_secondary) - sum(once.solution.contacts[0].removed_secondary);
  sim::extrapolate(system, {start, once, middle}, halves);
  const auto& c = halves.solution.contacts[0];
  EXPECT_NEAR(sum(c.removed_secondary), expected, 1e-13);
  EXPECT_NEAR(c.removed_secondary[far], 2.1, 1e-14);
  EXPECT_LT(c.removed_secondary[edge], 2.0);
}

// The correction must vanish where an edge passed, and rise over three elements from there.
TEST(Jump, TrustRisesOverThreeElements) {
  const auto problem = test::problem_of(test::block_scene);
  sim::Cache cache;
  const auto& surface = sim::system_of(problem, sim::initial_state(problem), cache)->contacts[0].secondary;
  const std::size_t n = surface.X.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return surface.X[a].x() < surface.X[b].x(); });
  std::vector<char> passed(n, 0);
  passed[order[0]] = 1;
  const auto share = sim::trust(surface, passed);
  ASSERT_GT(n, 4U);
  for (std::size_t k = 0; k < n; ++k) EXPECT_DOUBLE_EQ(share[order[k]], std::min(1.0, static_cast<double>(k) / 3.0));
}

// A block heals unevenness only where all that touches slips: one node that carries pressure and stays must count, one
// without pressure must not, nor must a contact that sticks as a whole, which wears nothing.
TEST(Jump, SlipsThroughout) {
  sim::State start;
  contact::ContactState loaded;
  loaded.normal.assign(3, {0.0, 1.0});
  loaded.lambda.assign(3, {0.0, 2.0});
  loaded.slip.assign(3, 4.0);
  start.solution.contacts = {loaded};
  const auto after = [&](double stays, double pressure) {
    auto end = start;
    auto& c = end.solution.contacts[0];
    c.slip = {5.0, 5.0 - stays, 5.0};
    c.lambda[1].y() = pressure;
    return sim::slips_throughout(start, end);
  };
  EXPECT_TRUE(after(0.0, 2.0));
  EXPECT_FALSE(after(1.0, 2.0));
  EXPECT_TRUE(after(1.0, 0.0));
  EXPECT_TRUE(sim::slips_throughout(start, start));
  // Unloaded at its end, a contact that has slipped does not show whether some of it has stuck.
  auto open = start;
  open.solution.contacts[0].slip = {5.0, 4.0, 5.0};
  for (auto& lambda : open.solution.contacts[0].lambda) lambda.setZero();
  EXPECT_FALSE(sim::slips_throughout(start, open));
}

// The error of a block must be the difference of its plays where all slips, and more where some sticks.
TEST(Jump, BlockError) {
  EXPECT_EQ(sim::block_error(0.01, true), 0.01);
  EXPECT_EQ(sim::block_error(0.01, false), 0.0125);
}

// After a cycle that was played by itself a first cycle must not hold the next block back, and a refused block not be
// tried again in more cycles than it had come down to.
TEST(Jump, AfterOneCycle) {
  EXPECT_EQ(sim::after_one_cycle(10.0, true, false), 10.0);
  EXPECT_EQ(sim::after_one_cycle(3.0, true, false), 4.0);
  EXPECT_EQ(sim::after_one_cycle(2.6, false, false), 2.6);
  EXPECT_EQ(sim::after_one_cycle(1.0, false, false), 4.0);
  EXPECT_EQ(sim::after_one_cycle(0.5, false, false), 2.0);
  // Where a cycle can be continued the second one is played by itself, and the next block has two.
  EXPECT_EQ(sim::after_one_cycle(10.0, true, true), 1.0);
  EXPECT_EQ(sim::after_one_cycle(10.0, false, true), 2.0);
}

// Where a tolerance is too tight for blocks of a few cycles, the next cycle must be played by itself instead of shorter
// blocks, each three times.
TEST(Jump, ShortBlocksAreNotTriedOneAfterAnother) {
  const auto r =
      recorded(test::problem_of(test::with(test::block_scene, {{"jump = 10", "jump = { tolerance = 1e-5, first = 5 }"},
                                                               {"3.0e-5", "3.0e-2"},
                                                               {"2.0e-5", "2.0e-2"}}) +
                                test::few_frames));
  std::vector<std::string> refused_at;
  for (const auto& line : r.log)
    if (line.find("refused: estimated error") != line.npos)
      refused_at.push_back(line.substr(0, line.find(", block of")));
  EXPECT_GT(refused_at.size(), 3u);
  EXPECT_EQ(std::adjacent_find(refused_at.begin(), refused_at.end()), refused_at.end());
}

// The next block must grow with what is worn where the error is as aimed at, shrink in proportion to an error above it,
// and never by leaps.
TEST(Jump, NextJump) {
  EXPECT_NEAR(sim::next_jump(100.0, 0.2, 0.0085, 0.01), 125.0, 1e-9);       // a fifth of all wear again
  EXPECT_NEAR(sim::next_jump(100.0, 0.2, 0.017, 0.01), 500.0 / 9.0, 1e-9);  // a tenth
  EXPECT_NEAR(sim::next_jump(100.0, 0.2, 0.0085, 0.01, 0.0085 / 0.25), 100.0 * 0.8 / 0.84,
              1e-9);  // error per share grew by 1.25
  EXPECT_EQ(sim::next_jump(100.0, 0.2, 0.0, 0.01), 400.0);
  EXPECT_EQ(sim::next_jump(100.0, 0.2, 1.0, 0.01), 30.0);
  EXPECT_EQ(sim::next_jump(2.0, 1.0, 1.0, 0.01), 1.0);
  EXPECT_EQ(sim::next_jump(100.0, 0.0, 0.0, 0.01), 400.0);  // nothing wears
}
