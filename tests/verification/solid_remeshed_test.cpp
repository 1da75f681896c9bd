#include <gtest/gtest.h>

#include "support/solid_remeshed.hpp"

using namespace reye;

TEST(SolidRemeshed, PressureStays) {
  // Both bodies of a worn contact meshed again without wear: volumes to round-off, forces to the slope of the faces,
  // and the pressure of rings within 3 % of its mean at each mesh.
  const auto result = support::remeshed_cap(4);
  for (const double jump : result.jumps) EXPECT_LE(jump, 0.03);
  EXPECT_LE(result.drift, 0.03);
  EXPECT_LE(result.volume_error, 1e-12);
  EXPECT_LE(result.force_error, 5e-4);
}

TEST(SolidRemeshed, ShearStays) {
  // A contact that slides keeps its tangential force, too: what sticks while the state is found again is held to where
  // its tractions put it.
  const auto result = support::remeshed_cap(2, 0.3);
  for (const double jump : result.jumps) EXPECT_LE(jump, 0.03);
  EXPECT_LE(result.shear_error, 0.01);
}
