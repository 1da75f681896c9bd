#include <cmath>

#include "sim/problem/records.hpp"
#include "wear_scene.hpp"

/// Sliding that is imposed with sign and history: what slides forth and back wears as what slides forth alone.
namespace reye::verification {

namespace {

constexpr double M = 2e5 * 0.7 / (1.3 * 0.4), K = M / 10.0, compression = 0.01, k = 1e-7;

const std::string rub = "press = [[0.0, 0.0], [1.0, 1.0]]\nrub = [[0.0, 0.0], [0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]";

/// geo/column slid by 100 mm in each of ten increments of ten, in one play.
Played column(const std::string& sliding) {
  return played(
      scene_text("column", {{"imposed_sliding_mm = 1000.0", "imposed_sliding_mm = " + sliding},
                            {"press = [[0.0, 0.0], [1.0, 1.0]]", rub + "\nhalf = [[0.0, 0.0], [0.5, 1.0], [1.0, 0.0]]"},
                            {"increments = 10\n", "increments = 10\nplay = [\"half\"]\n"}}));
}

/// geo/sliding_block of ordinary steel, all sides free, slid forth and back with the given sign; ten cycles in one
/// block.
Played block(const std::string& value, const std::string& law) {
  return played(
      scene_text("sliding_block",
                 {{"imposed_sliding_mm = 100.0", "imposed_sliding_mm = { value = " + value + ", history = \"rub\" }"},
                  {"E_MPa = 200e6", "E_MPa = 200e3"},
                  {"traction_MPa = [0.0, 3.0]", "traction_MPa = [0.0, 0.0]"},
                  {"traction_MPa = [0.0, -3.0]", "traction_MPa = [0.0, 0.0]"},
                  {"motion_mm = 3.0e-7", "motion_mm = 0.0"},
                  {"far_size_mm = 0.7", "far_size_mm = 0.5"},
                  {"press = [[0.0, 0.0], [1.0, 1.0]]", rub},
                  {"law = \"energy\", secondary_mm3_per_J = 1.0e-4, primary_mm3_per_J = 0.5e-4", law},
                  {"cycles = 10", "cycles = 10\njump = 10\nplay = [\"rub\"]\nincrements = 8"}}));
}

const std::string energy = "law = \"energy\", secondary_mm3_per_J = 1.0e-4, primary_mm3_per_J = 0.5e-4";
const std::string archard = "law = \"archard\", secondary_per_MPa = 0.3e-7, primary_per_MPa = 0.15e-7";

}  // namespace

/// A column that is slid forth and back wears by the same backward Euler values as one that is slid forth alone: p0 /
/// (1 + k K ds)^n.
TEST(SlidingHistory, ForthAndBackAsForthAlone) {
  const double p = K * compression / std::pow(1.0 + k * K * 100.0, 10.0);
  int newton = 0;
  for (const char* sliding :
       {"1000.0", "{ value = 500.0, history = \"half\" }", "{ value = -500.0, history = \"half\" }",
        "[{ value = 200.0, history = \"half\" }, { value = 300.0, history = \"half\" }]"}) {
    const Played run = column(sliding);
    EXPECT_LT(worst(run.surface(sim::Side::secondary).pressure_MPa, p), 1e-9) << sliding;
    EXPECT_LT(worst(run.surface(sim::Side::secondary).wear_depth_mm, compression - p / K), 1e-9) << sliding;
    int own = 0;
    for (const auto& row : run.records) own += row.newton;
    if (newton == 0) newton = own;
    EXPECT_EQ(own, newton) << sliding << " takes as many solves";
  }
}

/// By either law the volume is exact, the two ways of rubbing wear mirror images with as many solves, and no
/// reversal costs smaller increments.
TEST(SlidingHistory, EitherSignWearsTheMirrorImage) {
  for (const auto& law : {energy, archard}) {
    const Played forth = block("25.0", law), back = block("-25.0", law);
    for (const auto* run : {&forth, &back}) {
      EXPECT_NEAR(run->contact().secondary.worn_area / 3e-3, 1.0,
                  2e-5);  // alpha mu P s, s = 4 x 25 mm x 10 cycles; the surfaces lean
      EXPECT_NEAR(run->contact().primary.worn_area / 1.5e-3, 1.0, 2e-5);
      EXPECT_NEAR(run->contact().dissipated_energy / 30000.0, 1.0, 2e-5);
    }
    EXPECT_NEAR(back.contact().secondary.worn_area, forth.contact().secondary.worn_area, 1e-9);
    ASSERT_EQ(back.records.size(), forth.records.size());
    EXPECT_EQ(forth.summary.counts.cutbacks + back.summary.counts.cutbacks, 0)
        << "a reversal costs no smaller increments";
    for (std::size_t i = 0; i < forth.records.size(); ++i) {
      EXPECT_NEAR(back.records[i].newton, forth.records[i].newton, 1) << i;  // which end opens first is rounding
      EXPECT_NEAR(back.records[i].support_forces[0].x(), -forth.records[i].support_forces[0].x(), 1e-6) << i;
    }
    const auto& right = forth.surface(sim::Side::secondary).wear_depth_mm;
    const auto& left = back.surface(sim::Side::secondary).wear_depth_mm;
    for (std::size_t i = 0; i < right.size(); ++i) EXPECT_NEAR(left[left.size() - 1 - i], right[i], 1e-9) << i;
  }
}

/// Shear follows the direction of sliding through its reversals, and what rests keeps its own.
TEST(SlidingHistory, FrictionPointsTheWayThatIsSlid) {
  const Played run = block("25.0", energy);
  for (const auto& row : run.records) {
    const bool forth = row.step == "press" || row.progress <= 0.25 || row.progress > 0.75;
    EXPECT_NEAR(std::abs(row.support_forces[0].x()), 30.0, 1e-2) << row.progress;  // the surfaces lean by 1e-4
    EXPECT_EQ(row.support_forces[0].x() * run.records.front().support_forces[0].x() > 0.0, forth) << row.progress;
  }
}

}  // namespace reye::verification
