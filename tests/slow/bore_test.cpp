#include <gtest/gtest.h>

#include "support/bore.hpp"

using namespace reye;

// A bore worn through its life must give the same to 0.1 % with its seam at four angles.
TEST(Bore, SeamAtFourAngles) {
  const auto reference = support::worn_bush({.seam_deg = 90.0, .size_mm = 0.25, .blocks = 20});
  ASSERT_EQ(reference.status, sim::RunStatus::done) << reference.reason;
  const auto& a = reference.contacts[0];
  for (const double seam : {0.0, 225.0, 270.0, 280.0}) {
    const auto run = support::worn_bush({.seam_deg = seam, .size_mm = 0.25, .blocks = 20});
    ASSERT_EQ(run.status, sim::RunStatus::done) << run.reason;
    const auto& b = run.contacts[0];
    EXPECT_NEAR(b.secondary.max_depth_mm, a.secondary.max_depth_mm, 1e-3 * a.secondary.max_depth_mm) << seam;
    EXPECT_NEAR(b.secondary.worn_area, a.secondary.worn_area, 1e-3 * a.secondary.worn_area) << seam;
    EXPECT_NEAR(*b.contact_half_width_mm, *a.contact_half_width_mm, 1e-3 * *a.contact_half_width_mm) << seam;
    EXPECT_NEAR(b.secondary.scar_width_mm, a.secondary.scar_width_mm, 1e-3 * a.secondary.scar_width_mm) << seam;
  }
}

// A bore drawn as three arcs, two of which meet in the contact must give the same as one drawn in one piece, to 0.5 %.
TEST(Bore, JointInTheContact) {
  const auto reference = support::worn_bush({.seam_deg = 90.0, .size_mm = 0.25, .blocks = 20});
  const auto run = support::worn_bush({.seam_deg = 268.0, .arcs = true, .size_mm = 0.25, .blocks = 20});
  ASSERT_EQ(run.status, sim::RunStatus::done) << run.reason;
  const auto &a = reference.contacts[0], &b = run.contacts[0];
  EXPECT_NEAR(b.secondary.max_depth_mm, a.secondary.max_depth_mm, 5e-3 * a.secondary.max_depth_mm);
  EXPECT_NEAR(*b.contact_half_width_mm, *a.contact_half_width_mm, 5e-3 * *a.contact_half_width_mm);
  EXPECT_NEAR(b.secondary.scar_width_mm, a.secondary.scar_width_mm, 5e-3 * a.secondary.scar_width_mm);
}
