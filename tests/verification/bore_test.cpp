#include <gtest/gtest.h>

#include "support/bore.hpp"

using namespace reye;

// Where a file begins a bore must not change its wear, contact width or scar, in the contact or elsewhere.
TEST(Bore, TheSeamMayLieInTheContact) {
  const auto away = support::worn_bush({.seam_deg = 90.0}), inside = support::worn_bush({.seam_deg = 270.0});
  ASSERT_EQ(away.status, sim::RunStatus::done) << away.reason;
  ASSERT_EQ(inside.status, sim::RunStatus::done) << inside.reason;
  const auto &a = away.contacts[0], &b = inside.contacts[0];
  EXPECT_GT(away.counts.remeshes, 0);
  EXPECT_NEAR(b.secondary.max_depth_mm, a.secondary.max_depth_mm, 1e-3 * a.secondary.max_depth_mm);
  EXPECT_NEAR(b.secondary.worn_area, a.secondary.worn_area, 1e-3 * a.secondary.worn_area);
  EXPECT_NEAR(b.contact_half_width_mm.value(), a.contact_half_width_mm.value(), 1e-3 * *a.contact_half_width_mm);
  EXPECT_NEAR(b.secondary.scar_width_mm, a.secondary.scar_width_mm, 1e-3 * a.secondary.scar_width_mm);
  EXPECT_LT(a.secondary.scar_width_mm, 31.0);  // not all of its 62.8 mm
}
