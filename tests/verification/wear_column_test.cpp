#include <cmath>

#include "confined_column.hpp"
#include "sim/problem/records.hpp"
#include "wear_scene.hpp"

/// References B6: a confined column under fixed compression, K = M / H, wear kept in the gap.
namespace reye::verification {

namespace {

Played column(const Replacements& replacements = {}) { return played(scene_text("column", replacements)); }

std::string shown(double v) {
  std::ostringstream s;
  s.precision(17);
  s << v;
  return s.str();
}

/// One wear increment of kappa = k K ds: p = p0 / (1 + kappa), whatever the complementarity factor.
void expect_one_step(double kappa, const std::string& c0) {
  const Played run =
      column({{"increments = 10", "increments = 1"},
              {"imposed_sliding_mm = 1000.0",
               "imposed_sliding_mm = " + shown(kappa / (Column::k * Column::K)) + "\nc_normal = " + c0}});
  const double p = Column::K * Column::compression / (1.0 + kappa);
  EXPECT_LT(worst(run.surface(sim::Side::secondary).pressure_MPa, p), 1e-9) << "kappa " << kappa << ", c0 " << c0;
  EXPECT_LT(worst(run.surface(sim::Side::secondary).wear_depth_mm, kappa * p / Column::K), 1e-9);
  EXPECT_LE(run.records.back().newton, 4);
  EXPECT_EQ(run.summary.counts.cutbacks, 0);
}

/// Cycle at which half of the compression is worn away, jumps of `jump` cycles of 1 mm.
double half_life(const std::string& jump) {
  const Played run = column({{"increments = 10\ncycles = 1",
                              "cycles = 1000\njump = " + jump + "\n[limit.half]\ncontact = \"foot\"\ndepth_mm = 0.005"},
                             {"imposed_sliding_mm = 1000.0", "imposed_sliding_mm = 1.0"}});
  return run.summary.life_cycles.at("half").value();
}

}  // namespace

/// Ten implicit steps give the backward Euler values to solver tolerance.
TEST(WearColumn, BackwardEuler) {
  const Played run = column();
  const double p = Column::K * Column::compression / std::pow(1.0 + Column::k * Column::K * 100.0, 10.0);
  EXPECT_NEAR(p, 24.815257, 1e-6);
  EXPECT_LT(worst(run.surface(sim::Side::secondary).pressure_MPa, p), 1e-9);
  EXPECT_LT(worst(run.surface(sim::Side::secondary).wear_depth_mm, Column::compression - p / Column::K), 1e-9);
  EXPECT_NEAR(run.contact().secondary.max_depth_mm, 9.0782905e-3, 1e-9);
  EXPECT_LT(run.contact().ledger_relative_error.value(), 1e-12);
}

TEST(WearColumn, OneStepMild) {
  for (const auto* c0 : {"0.1", "1.0", "10.0"}) expect_one_step(0.27, c0);
}

TEST(WearColumn, OneStepStrong) {
  for (const auto* c0 : {"0.1", "1.0", "10.0"}) expect_one_step(2.7, c0);
}

TEST(WearColumn, OneStepFierce) {
  for (const auto* c0 : {"0.1", "1.0", "10.0"}) expect_one_step(2.7e3, c0);
}

/// The life is the exact one, ln 2 / (k K) mm, up to the first order of the jump.
TEST(WearColumn, LifeFallsToTheExactOneWithTheJump) {
  const double exact = std::log(2.0) / (Column::k * Column::K);
  const double e100 = half_life("100") - exact, e50 = half_life("50") - exact, e25 = half_life("25") - exact;
  EXPECT_LT(std::abs(e25), 0.05 * exact);
  EXPECT_GT(std::log2(std::abs(e100 / e50)), 0.8);
  EXPECT_GT(std::log2(std::abs(e50 / e25)), 0.8);
  EXPECT_LT(std::log2(std::abs(e50 / e25)), 1.3);
}

/// A limit that is never reached has no number.
TEST(WearColumn, LimitOutOfReach) {
  const Played run = column({{"[[step]]\nname = \"press\"",
                              "[limit.all]\ncontact = \"foot\"\ndepth_mm = 0.0101\n\n[[step]]\nname = \"press\""}});
  EXPECT_FALSE(run.summary.life_cycles.at("all").has_value());
}

}  // namespace reye::verification
