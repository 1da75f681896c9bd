#include <gtest/gtest.h>

#include "sim/solid/solid_intact.hpp"
#include "solid_runs.hpp"

using namespace reye;

namespace {

/// All numbers of a row, in its order.
std::vector<double> numbers(const sim::SolidIncrement& row) {
  std::vector<double> all{row.cycle, row.progress, static_cast<double>(row.newton)};
  const auto add = [&](const base::Vec3& v) { all.insert(all.end(), v.begin(), v.end()); };
  for (const auto& c : row.contacts) {
    for (const double value :
         {c.pressure_max_MPa, c.area_mm2, c.stick_area_mm2, c.normal_force_N, c.tangential_force_N, c.energy_mJ})
      all.push_back(value);
    add(c.force_N);
  }
  for (const auto& s : row.supports) add(s.force_N), add(s.moment_N_mm);
  return all;
}

void expect_same_summary(const sim::SolidSummary& a, const sim::SolidSummary& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.cycles, b.cycles);
  EXPECT_EQ(a.balance, b.balance);
  EXPECT_EQ(a.size.retained, b.size.retained);
  EXPECT_EQ(a.counts.increments, b.counts.increments);
  EXPECT_EQ(a.counts.newton_iterations, b.counts.newton_iterations);
  EXPECT_EQ(a.counts.factorisations, b.counts.factorisations);
  EXPECT_EQ(a.counts.blocks, b.counts.blocks);
  EXPECT_EQ(a.warnings.size(), b.warnings.size());
  ASSERT_EQ(a.contacts.size(), b.contacts.size());
  for (std::size_t c = 0; c < a.contacts.size(); ++c) {
    EXPECT_EQ(a.contacts[c].peak_pressure_MPa, b.contacts[c].peak_pressure_MPa);
    EXPECT_EQ(a.contacts[c].equivalent_radius_mm, b.contacts[c].equivalent_radius_mm);
    EXPECT_EQ(a.contacts[c].half_widths_mm, b.contacts[c].half_widths_mm);
    EXPECT_EQ(a.contacts[c].energy_last_cycle_mJ, b.contacts[c].energy_last_cycle_mJ);
  }
}

}  // namespace

// From the state at any end of an increment, the first and the last ones, too, a run must continue to the rows, frames
// and summary of the unbroken one, bit by bit, across a change of the nodes that are kept.
TEST(SolidResume, FromEveryIncrement) {
  const auto problem = test::rubbed_ball();
  const auto whole = test::play_and_keep(problem);
  ASSERT_EQ(whole.played.summary.status, sim::RunStatus::done) << whole.played.summary.reason;
  ASSERT_EQ(whole.states.size(), 10u);
  ASSERT_GT(whole.played.summary.counts.factorisations, 1) << "contact was to outrun its nodes";
  EXPECT_TRUE(sim::at_end(problem, whole.states.back()));
  for (std::size_t k = 0; k < whole.states.size(); ++k) {
    EXPECT_EQ(sim::at_end(problem, whole.states[k]), k == 9);
    const auto rest = test::play_and_keep(problem, whole.states[k], sim::check_state(problem, whole.states[k]));
    const auto &rows = whole.played.rows, &later = rest.played.rows;
    ASSERT_EQ(whole.rows[k] + later.size(), rows.size()) << k;
    for (std::size_t i = 0; i < later.size(); ++i)
      EXPECT_EQ(numbers(later[i]), numbers(rows[whole.rows[k] + i])) << "from " << k << ", row " << i;
    ASSERT_EQ(whole.frames[k] + rest.played.frames.size(), whole.played.frames.size()) << k;
    for (std::size_t i = 0; i < rest.played.frames.size(); ++i)
      EXPECT_EQ(rest.played.frames[i].surfaces[0].pressure_MPa,
                whole.played.frames[whole.frames[k] + i].surfaces[0].pressure_MPa);
    expect_same_summary(rest.played.summary, whole.played.summary);
  }
}

// A run that is asked to end must show its frame and keep its state first, and resume from there; one that is asked at
// its very end must be done.
TEST(SolidResume, Interrupted) {
  const auto problem = test::rubbed_ball();
  const auto first = test::play_and_keep(problem, {}, {}, 8);
  EXPECT_EQ(first.played.summary.status, sim::RunStatus::interrupted);
  EXPECT_EQ(first.states.size(), 8u);
  EXPECT_EQ(first.states.back().increment, 2);
  EXPECT_EQ(first.played.frames.size(), first.frames.back());
  EXPECT_EQ(first.played.frames.size(), 2u + 2u) << "the step before, and two of the last cycle";
  const auto rest =
      test::play_and_keep(problem, first.states.back(), sim::check_state(problem, first.states.back()), 2);
  EXPECT_EQ(rest.states.size(), 2u);
  EXPECT_EQ(rest.played.summary.status, sim::RunStatus::done);
}
