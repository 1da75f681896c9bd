#include <gtest/gtest.h>

#include "base/two_part.hpp"

using namespace reye::base;

// A sum must come with exactly what rounding took from it.
TEST(two_part, sum_and_rest_are_exact) {
  const auto [sum, rest] = exact_sum(1.0, 1e-20);
  EXPECT_EQ(sum, 1.0);
  EXPECT_EQ(rest, 1e-20);
  const auto turned = exact_sum(1e-20, -1.0);
  EXPECT_EQ(turned.sum, -1.0);
  EXPECT_EQ(turned.rest, 1e-20);
}

// Steps too small to move a double must add up all the same, and the high part must be the nearest double.
TEST(two_part, small_steps_add_up) {
  TwoPart q{Vector::Constant(2, 1.0), Vector::Zero(2)};
  const Vector step{{0x1p-60, -0x1p-60}};
  for (int i = 0; i < 1024; ++i) q += step;
  EXPECT_EQ(q.high, (Vector{{1.0 + 0x1p-50, 1.0 - 0x1p-50}}));
  EXPECT_EQ(q.low, Vector::Zero(2));
  q += Vector::Constant(2, -1.0);
  EXPECT_EQ(q.high, 1024.0 * step);
}

// The difference of two that round to the same doubles must be that of their rests.
TEST(two_part, difference_is_of_both_parts) {
  const Vector one = Vector::Ones(2);
  const TwoPart a{one, 1e-20 * one}, b{one, -3e-20 * one};
  EXPECT_LT(((a - b).high - 4e-20 * one).norm(), 1e-35);
  EXPECT_EQ((a - TwoPart(one)).segment(1, 1).high[0], 1e-20);
}
