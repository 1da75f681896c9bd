#include <gtest/gtest.h>

#include "support/solid_remeshed.hpp"

using namespace reye;

TEST(SolidRemeshed, PressureStays) {
  // Both bodies of a worn contact meshed again without wear: volumes to round-off, forces to the slope of the faces,
  // and the pressure of rings within 3 % of its mean at each mesh.
  const auto result = support::remeshed_cap(4);
  for (const double jump : result.jumps) std::printf("jump %.5f\n", jump);
  std::printf("drift %.5f force %.2e volume %.2e\n", result.drift, result.force_error, result.volume_error);
  for (const double jump : result.jumps) EXPECT_LE(jump, 0.03);
  EXPECT_LE(result.drift, 0.03);
  EXPECT_LE(result.volume_error, 1e-12);
  EXPECT_LE(result.force_error, 5e-4);
}
