#include <gtest/gtest.h>

#include <cstdio>

#include "support/convex_pairs.hpp"

namespace {

// The common area of a million random pairs of facets must be what integration by slabs gives, and no corner must be
// anything but a number.
TEST(solid_clip, area_of_a_million_random_pairs) {
  const auto errors = reye::test::clip_errors(1000000, 11);
  EXPECT_TRUE(errors.valid);
  EXPECT_GT(errors.meeting, 300000);
  EXPECT_LT(errors.of_area, 1e-12);
  EXPECT_LT(errors.of_size, 1e-13);
  std::printf("largest error %.2g of the larger area, %.2g of the size squared\n", errors.of_area, errors.of_size);
}

}  // namespace
