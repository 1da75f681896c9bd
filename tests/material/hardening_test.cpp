#include "material/hardening.hpp"

#include "material/laws.hpp"

namespace {

using namespace reye;
using namespace reye::material;
using namespace reye::material::test;

// Each hardening law must be its formula.
TEST(hardening, values) {
  EXPECT_DOUBLE_EQ(yield_stress(Hardening(LinearHardening{300, 1000}), 0.1), 400);
  EXPECT_DOUBLE_EQ(yield_stress(Hardening(VoceHardening{300, 500, 16, 130}), 0.1), 313 + 200 * (1 - std::exp(-1.6)));
  EXPECT_NEAR(yield_stress(Hardening(SwiftHardening{700, 2e-3, 0.2}), 0.1), 700 * std::pow(0.102, 0.2), 1e-11);
  EXPECT_EQ(yield_stress(Hardening(SwiftHardening{700, 0.0, 0.2}), 0.0), 0.0);
  const Hardening table = TableHardening{{{0.0, 300}, {0.1, 400}, {0.3, 420}}};
  EXPECT_DOUBLE_EQ(yield_stress(table, 0.0), 300);
  EXPECT_DOUBLE_EQ(yield_stress(table, 0.05), 350);
  EXPECT_DOUBLE_EQ(yield_stress(table, 0.2), 410);
  EXPECT_DOUBLE_EQ(yield_stress(table, 0.3), 420);
  EXPECT_DOUBLE_EQ(yield_stress(table, 7.0), 420);
}

// The slope must be the derivative of the yield stress; at a corner of a table that of loading.
TEST(hardening, slopes) {
  for (const auto& [name, material] : plastic_laws()) {
    const auto& hardening = std::get<HenckyJ2>(material).hardening;
    const double p = 0.05, h = 1e-5;
    const double slope = yield_stress(hardening, base::Dual<1>::variable(p, 0)).d[0];
    EXPECT_NEAR(slope, (yield_stress(hardening, p + h) - yield_stress(hardening, p - h)) / (2 * h), 1e-4 * slope)
        << name;
  }
  const Hardening table = TableHardening{{{0.0, 300}, {0.1, 400}, {0.3, 420}}};
  EXPECT_NEAR(yield_stress(table, base::Dual<1>::variable(0.1, 0)).d[0], 100, 1e-10);
  EXPECT_EQ(yield_stress(table, base::Dual<1>::variable(0.3, 0)).d[0], 0.0);
}

}  // namespace
