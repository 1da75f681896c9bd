#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/formatted.hpp"

namespace {

using namespace reye;

// Texts longer than what is printed at once come out whole, as do those that just fit.
TEST(Formatted, AnyLength) {
  for (const int length : {0, 1, 254, 255, 256, 257, 5000}) {
    const std::string text(length, 'x');
    EXPECT_EQ(base::formatted("%s", text.c_str()), text) << length;
  }
}

// A number with fixed decimals is what printf makes of it, digit for digit.
TEST(Fixed, AsPrintf) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-12.0, 12.0), mantissa(-10.0, 10.0);
  for (int i = 0; i < 20000; ++i) {
    const double value = mantissa(random) * std::pow(10.0, exponent(random));
    for (const int decimals : {0, 1, 2, 6})
      ASSERT_EQ(base::fixed(value, decimals), base::formatted("%.*f", decimals, value));
  }
  for (const double value : {0.0, -0.0, 0.25, 0.35, 1e300, -1e300, 0.05})
    EXPECT_EQ(base::fixed(value, 1), base::formatted("%.1f", value));
}

}  // namespace
