#include <cmath>

#include "confined_column.hpp"
#include "sim/problem/records.hpp"
#include "wear_scene.hpp"

/// Rates that depend on pressure, speed and history: the block of references B5 and the column of B6 with closed forms.
namespace reye::verification {

namespace {

using sim::Side;

struct SlidBlock {
  static constexpr double p = 10.0, mu = 0.3;  ///< p in MPa
  static constexpr double alpha = 1e-7;        ///< of the slider [mm^2/N]; the base wears by half of it
};
const std::string base_coefficient = "primary_mm3_per_J = 0.5e-4";
const std::string ten_cycles = "cycles = 10";

Played block_with_law(const std::string& law, const std::string& step) {
  return played(scene_text("sliding_block", {{base_coefficient, base_coefficient + law}, {ten_cycles, step}}));
}

/// Uniform depths on both sides, half as deep on the base, and the ledger of both.
void expect_depth(const Played& run, double depth) {
  EXPECT_LT(worst(run.surface(Side::secondary).wear_depth_mm, depth), 1e-10);
  EXPECT_LT(worst(run.surface(Side::primary).wear_depth_mm, 0.5 * depth), 1e-10);
  EXPECT_NEAR(run.contact().secondary.worn_area / (10.0 * depth), 1.0, 1e-10);
  EXPECT_LT(run.contact().ledger_relative_error.value(), 1e-12);
}

/// Root of f, which rises, between low and high.
template <class F>
double root_of(F f, double low, double high) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) > 0.0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

/// The column, its rate times (p / 50)^m (v / 500)^n, v = 1000 mm in 4 s.
Played column_with_exponents(double m, double n) {
  std::ostringstream law;
  law << "secondary_per_MPa = 1.0e-7, pressure_exponent = " << m << ", pressure_ref_MPa = 50, speed_exponent = " << n
      << ", speed_ref_mm_per_s = 500";
  return played(scene_text(
      "column", {{"secondary_per_MPa = 1.0e-7", law.str()}, {"increments = 10", "increments = 10\nperiod_s = 4.0"}}));
}

}  // namespace

/// Depth = alpha mu p s (p / p_ref)^m (v / v_ref)^n under uniform pressure.
TEST(WearLaw, BlockWithExponents) {
  const Played run =
      block_with_law(", pressure_exponent = 0.4, pressure_ref_MPa = 5, speed_exponent = -0.3, speed_ref_mm_per_s = 20",
                     ten_cycles + "\nperiod_s = 2.0");
  expect_depth(run, SlidBlock::alpha * SlidBlock::mu * SlidBlock::p * 1000.0 * std::pow(SlidBlock::p / 5.0, 0.4) *
                        std::pow(50.0 / 20.0, -0.3));
  EXPECT_NEAR(run.contact().dissipated_energy / 30000.0, 1.0, 1e-10);
}

/// Exponents of zero leave every bit of the run as it is.
TEST(WearLaw, ExponentsOfZeroChangeNoBit) {
  const Played with = block_with_law(
      ", pressure_exponent = 0, pressure_ref_MPa = 5, speed_exponent = 0, threshold_mJ_per_mm2 = 0", ten_cycles);
  const Played without = block_with_law("", ten_cycles);
  for (const auto side : {Side::secondary, Side::primary}) {
    EXPECT_EQ(with.surface(side).wear_depth_mm, without.surface(side).wear_depth_mm);
    EXPECT_EQ(with.surface(side).pressure_MPa, without.surface(side).pressure_MPa);
  }
}

/// Ten implicit steps solve p_n = p_n-1 - K k s (p_n / p_ref)^m p_n (v / v_ref)^n, rates rising and falling with
/// pressure.
TEST(WearLaw, ColumnWithExponents) {
  for (const double m : {0.7, -0.6}) {
    constexpr double n = 0.5;
    double pressure = Column::K * Column::compression;
    for (int i = 0; i < 10; ++i) {
      const double before = pressure;
      const auto excess = [&](double q) {
        return q + Column::K * Column::k * 100.0 * q * std::pow(q / 50.0, m) * std::pow(250.0 / 500.0, n) - before;
      };
      pressure = root_of(excess, 0.0, before);
    }
    const Played run = column_with_exponents(m, n);
    EXPECT_LT(worst(run.surface(Side::secondary).pressure_MPa, pressure), 1e-9) << m;
    EXPECT_LT(worst(run.surface(Side::secondary).wear_depth_mm, Column::compression - pressure / Column::K), 1e-9) << m;
    EXPECT_LT(run.contact().ledger_relative_error.value(), 1e-12);
    EXPECT_EQ(run.summary.counts.cutbacks, 0);
  }
}

/// Nothing wears before 1000 mJ/mm^2, coefficient x (energy - threshold x area) after, jumps across it included.
TEST(WearLaw, Threshold) {
  const std::string law = ", threshold_mJ_per_mm2 = 1000.0";  // a cycle gives 300
  EXPECT_EQ(block_with_law(law, "cycles = 3").contact().secondary.worn_area, 0.0);
  expect_depth(block_with_law(law, "cycles = 4"), SlidBlock::alpha * (1200.0 - 1000.0));
  expect_depth(block_with_law(law, "cycles = 10\njump = 5"), SlidBlock::alpha * (3000.0 - 1000.0));
}

/// Threshold and exponents together: the factors act on what lies beyond the threshold.
TEST(WearLaw, ThresholdWithExponent) {
  const Played run =
      block_with_law(", threshold_mJ_per_mm2 = 1000.0, pressure_exponent = -0.5, pressure_ref_MPa = 40", ten_cycles);
  expect_depth(run, SlidBlock::alpha * 2000.0 * 2.0);
}

/// Energy and shear follow friction's table, each block by the cycle it begins with.
/// Where the shear beside the contact is not that within, the surface leans by up to 3 MPa / E = 1.5e-8, and takes
/// mu times that of the normal force.
TEST(WearLaw, FrictionOverCycles) {
  const Played run = played(
      scene_text("sliding_block", {{"friction  = 0.3", "friction = { cycles = [0, 4, 8], value = [0.1, 0.5, 0.3] }"},
                                   {ten_cycles, "cycles = 10\njump = 2"}}));
  const double sum = 2.0 * (0.1 + 0.3 + 0.5 + 0.4 + 0.3);
  EXPECT_NEAR(run.contact().dissipated_energy / (sum * 100.0 * 100.0), 1.0, 0.5 * 1.5e-8);
  EXPECT_NEAR(run.contact().secondary.worn_area / (SlidBlock::alpha * sum * 100.0 * 100.0), 1.0, 0.5 * 1.5e-8);
  EXPECT_NEAR(std::abs(run.contact().tangential_force) / (0.3 * 100.0), 1.0, 1e-9);
  EXPECT_LT(run.contact().ledger_relative_error.value(), 1e-9);
}

/// A line contact, whose pressure falls to zero at its ends, wears by either sign of the exponent without cut-backs.
TEST(WearLaw, LineContactWithExponents) {
  const std::string text =
      scene_text("line_contact_gross_slip", {{"half_width_mm = 0.1, depth_mm = 0.05, size_mm = 0.0018",
                                              "half_width_mm = 0.06, depth_mm = 0.05, size_mm = 0.0036"}});
  const std::string short_run = text.substr(0, text.find("[[step]]\nname = \"to S = 1\""));
  const auto depth = [&](const std::string& exponent) {
    const Played run = played(
        replaced(short_run, {{"primary_per_MPa = 1.0e-8",
                              "primary_per_MPa = 1.0e-8, pressure_ref_MPa = 300, pressure_exponent = " + exponent}}));
    EXPECT_LT(run.contact().ledger_relative_error.value(), 1e-9) << exponent;
    EXPECT_EQ(run.summary.counts.cutbacks, 0) << exponent;
    return run.contact().secondary.max_depth_mm;
  };
  const double plain = depth("0"), rising = depth("0.05"), falling = depth("-0.05");
  EXPECT_NEAR(0.5 * (rising + falling) / plain, 1.0, 0.002);  // what is even in the exponent is of second order
  EXPECT_GT(rising / falling, 1.001);                         // the pressure in the middle lies above 300 MPa
  EXPECT_GT(depth("1.0"), 0.9 * plain);
  EXPECT_GT(depth("-0.5"), 0.9 * plain);
}

}  // namespace reye::verification
