#include "sim/problem/two_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "played.hpp"
#include "problem_of.hpp"
#include "sim/measure/intact.hpp"
#include "sim/measure/side_correction.hpp"

using namespace reye;
using test::apart;
using test::recorded;
using test::removed;
using test::worn_block;

namespace {

std::string blocks_of(int cycles) {
  return "{ tolerance = 0.2, first = " + std::to_string(cycles) + ", most = " + std::to_string(cycles) + " }";
}

contact::ContactState worn(double secondary, double primary, double slip) {
  contact::ContactState s;
  s.removed_secondary = s.pending_secondary = {secondary};
  s.removed_primary = s.pending_primary = {primary};
  s.slip = {slip};
  s.energy_secondary = {2.0 * secondary};
  s.worn_work = 3.0 * secondary;
  s.friction = 0.5;
  return s;
}

}  // namespace

// The formula must be exact where what is worn grows with the square of the cycles, whatever the blocks before.
TEST(TwoStep, ExactForParabolas) {
  const auto x = [](double t) { return 1.0 + 2.0 * t + 3.0 * t * t; };
  const auto rate = [](double t) { return 2.0 + 6.0 * t; };
  const double t = 5.0, h = 0.7;
  for (const double ratio : {0.2, 1.0, 1.5, 2.0}) {
    const sim::TwoStep formula{ratio};
    const double begun = x(t) + formula.start() * (x(t) - x(t - h / ratio));
    EXPECT_NEAR(begun + formula.played() * h * rate(t + h), x(t + h), 1e-12 * x(t + h)) << ratio;
    // Halves of the Euler formula would differ from the whole by h^2 x'' / 4.
    EXPECT_NEAR(formula.two_halves_apart(x(t) - x(t - h / ratio), x(t + h) - x(t)), 0.25 * h * h * 6.0, 1e-12);
    EXPECT_NEAR(sim::half_way(x(t - h / ratio), x(t), x(t + h), h / ratio, h), x(t + 0.5 * h), 1e-12 * x(t));
  }
}

// What is uneven must be worn level within a block, however fast, and not come back in the next ones.
TEST(TwoStep, DampsStiffModes) {
  for (const double ratio : {0.5, 1.0, 1.5}) {
    double before = 1.0, now = 1.0, h = 1.0;
    for (int k = 0; k < 6; ++k) {
      const sim::TwoStep formula{ratio};
      const double next = (now + formula.start() * (now - before)) / (1.0 + 1e6 * formula.played() * h);
      before = now;
      now = next;
      h *= ratio;
      EXPECT_LT(std::abs(now), 1e-5) << ratio << ' ' << k;
    }
  }
}

// Without a block before, or after one that is far too short, the formula must not be offered.
TEST(TwoStep, WhereItServes) {
  EXPECT_FALSE(sim::two_step(10.0, 0.0));
  EXPECT_FALSE(sim::two_step(23.0, 10.0));
  ASSERT_TRUE(sim::two_step(15.0, 10.0));
  EXPECT_DOUBLE_EQ(sim::two_step(15.0, 10.0)->ratio, 1.5);
  struct Contact {
    contact::ContactOptions options;
  };
  Contact plain;
  plain.options.wear = {.kind = wear::LawKind::energy, .secondary = 1.0};
  Contact explicitly = plain, late = plain;
  explicitly.options.implicit_wear = false;
  Contact rubs;
  rubs.options.friction_formula = wear::Formula("0.3 + 0.1 * exp(-path_mm)");
  EXPECT_FALSE(sim::may_continue(std::vector{plain, rubs}));
  late.options.wear.threshold = 1.0;
  EXPECT_TRUE(sim::may_continue(std::vector{plain, Contact{}}));
  EXPECT_FALSE(sim::may_continue(std::vector{plain, explicitly}));
  EXPECT_FALSE(sim::may_continue(std::vector{late}));
}

// Every quantity that wears must get the same share of its growth, what waits that of what was removed, and nothing
// else must change; a place that would hold less than nothing must be reported.
TEST(TwoStep, Shares) {
  const std::vector<contact::ContactState> before{worn(1.0, 2.0, 5.0)};
  std::vector<contact::ContactState> after{worn(3.0, 2.5, 6.0)}, growth;
  after[0].pending_secondary = {0.0};  // a shape has moved by it
  sim::add_growth(growth, before, after);
  EXPECT_TRUE(sim::add_share(after, growth, 0.5));
  EXPECT_EQ(after[0].removed_secondary[0], 4.0);
  EXPECT_EQ(after[0].pending_secondary[0], 1.0);
  EXPECT_EQ(after[0].removed_primary[0], 2.75);
  EXPECT_EQ(after[0].slip[0], 6.5);
  EXPECT_EQ(after[0].energy_secondary[0], 8.0);
  EXPECT_EQ(after[0].worn_work, 12.0);
  EXPECT_EQ(after[0].friction, 0.5);
  growth[0].pending_secondary = {-4.0};
  EXPECT_FALSE(sim::add_share(after, growth, 0.5));
}

// A point that no longer slips must keep the path that it had.
TEST(TwoStep, StandingPointsKeepTheirPath) {
  const std::vector<contact::ContactState> start{worn(1.0, 1.0, 5.0), worn(1.0, 1.0, 5.0)};
  const std::vector<contact::ContactState> begun{worn(1.0, 1.0, 5.5), worn(1.0, 1.0, 5.5)};
  std::vector<contact::ContactState> end{worn(1.0, 1.0, 5.5), worn(1.0, 1.0, 7.0)};
  sim::keep_still(start, begun, end);
  EXPECT_EQ(end[0].slip[0], 5.0);
  EXPECT_EQ(end[1].slip[0], 7.0);
}

// What a play has still to wear must be read off the one before, between increments by interpolation.
TEST(TwoStep, CourseOfWear) {
  sim::CourseOfWear course{.cycles = 10.0, .until = {}};
  const sim::Volumes at_start{{std::vector{1.0}, std::vector{0.0}}};
  course.note(0.25, {{std::vector{2.0}, std::vector{0.0}}}, at_start);
  course.note(1.0, {{std::vector{5.0}, std::vector{2.0}}}, at_start);
  EXPECT_DOUBLE_EQ(course.after(0.25, 1.0)[0][0][0], 3.0);
  EXPECT_DOUBLE_EQ(course.after(0.125, 2.0)[0][0][0], 7.0);
  EXPECT_DOUBLE_EQ(course.after(0.625, 1.0)[0][1][0], 1.0);
  EXPECT_DOUBLE_EQ(course.after(1.0, 1.0)[0][0][0], 0.0);
}

// Where wear begins in a block all of it must count as error, elsewhere what two halves would differ by.
TEST(TwoStep, ErrorWhereWearBegins) {
  const sim::TwoStep formula{1.0};
  const sim::ContinuedSide side(formula, {0.0, 4.0, 4.0, 0.0}, {0.0, 8.0, 8.0, 0.0}, {1.0, 14.0, 17.0, 0.0});
  EXPECT_EQ(side.once, (std::vector<double>{0.0, 13.5, 15.75, 0.0}));
  EXPECT_EQ(side.passed, (std::vector<char>{1, 0, 1, 0}));
}

// Where a notable part of a side stops to wear, or all of it begins, the formula must not serve, and what a point has
// got that stopped must count as error.
TEST(TwoStep, WhereWearStopsOrBegins) {
  const sim::TwoStep formula{1.0};
  const double share = 4.0 * formula.start();
  const sim::ContinuedSide stops(formula, {4.0, 4.0}, {8.0, 8.0}, {8.0 + share, 12.0});
  EXPECT_FALSE(stops.serves);
  EXPECT_DOUBLE_EQ(stops.once[0], 8.0);
  EXPECT_EQ(stops.passed, (std::vector<char>{1, 0}));
  const sim::ContinuedSide at_the_rim(formula, {0.1, 4.0}, {8.0, 8.0}, {8.0 + 0.1 * formula.start(), 12.0});
  EXPECT_TRUE(at_the_rim.serves);
  EXPECT_FALSE(sim::ContinuedSide(formula, {0.0, 0.0}, {0.0, 0.0}, {1.0, 1.0}).serves);
  EXPECT_TRUE(sim::ContinuedSide(formula, {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}).serves);
}

// With friction that changes over the cycles blocks that continue must be as exact: laws are read at their ends. Read
// at their starts they would err by a tenth here.
TEST(TwoStep, LawsOverCycles) {
  const auto rising = [](int cycles) {
    return removed(recorded(test::problem_of(
        test::with(test::block_scene, {{"friction  = 0.3", "friction = { cycles = [0, 48000], value = [0.2, 0.6] }"},
                                       {"cycles = 40\njump = 10", "cycles = 48000\njump = " + blocks_of(cycles)}}) +
        test::few_frames)));
  };
  const auto exact = rising(500);
  EXPECT_LT(apart(rising(8000), exact), 0.002);
  EXPECT_LT(apart(rising(4000), exact), 0.0006);
}

// Where outlines move in every block, and halves between, volume must be coefficient x work all the same.
TEST(TwoStep, LedgerWhereOutlinesMove) {
  const auto r = recorded(worn_block("{ tolerance = 0.05, first = 4000 }", "[remesh]\nevery_blocks = 1000\n"));
  EXPECT_LT(r.summary.contacts[0].ledger_relative_error.value(), 1e-12);
  EXPECT_LT(r.summary.counts.cycles_solved, 3 * r.summary.counts.blocks);
}

// What a block has worn belongs to the state, and one that cannot be must be refused.
TEST(TwoStep, AlteredWearIsRefused) {
  const auto problem = worn_block("{ tolerance = 0.05, first = 4000 }");
  std::vector<sim::State> states;
  sim::Observer observer;
  observer.block = [&](const sim::State& at) { states.push_back(at); };
  test::played(problem, observer);
  ASSERT_GT(states.size(), 4u);
  const sim::State good = states[3];
  ASSERT_GT(good.last_wear.cycles, 0.0);
  ASSERT_FALSE(good.last_wear.course.until.empty());
  using Change = void (*)(sim::State&);
  for (const Change change : std::vector<Change>{
           [](sim::State& s) { s.last_wear.cycles = -1.0; }, [](sim::State& s) { s.last_wear.contacts.clear(); },
           [](sim::State& s) { s.last_wear.contacts[0].slip.pop_back(); },
           [](sim::State& s) { s.last_wear.contacts[0].law_volume = std::nan(""); },
           [](sim::State& s) { s.last_wear.course.until[0].progress = 2.0; },
           [](sim::State& s) { s.last_wear.course.until[0].volumes.clear(); }}) {
    sim::State bad = good;
    change(bad);
    sim::Cache cache;
    EXPECT_THROW(sim::check_state(problem, bad, cache), std::runtime_error);
  }
  sim::Cache cache;
  EXPECT_NO_THROW(sim::check_state(problem, good, cache));
}
