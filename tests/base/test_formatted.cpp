#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>

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

// Tenths are the nearest ones, with the sign of what is left of the value.
TEST(Tenths, AreTheNearest) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> number(-1000.0, 1000.0);
  for (int i = 0; i < 20000; ++i) {
    const double value = number(random);
    std::string text = "L";
    base::append_tenths(value, text);
    ASSERT_EQ(text[0], 'L');
    ASSERT_NEAR(std::stod(text.substr(1)), value, 0.05 + 1e-9);
  }
  for (const auto& [value, expected] : {std::pair{0.0, "0.0"},
                                        {-0.04, "0.0"},
                                        {-0.06, "-0.1"},
                                        {12.34, "12.3"},
                                        {-7.98, "-8.0"},
                                        {1e14, "100000000000000.0"}}) {
    std::string text;
    base::append_tenths(value, text);
    EXPECT_EQ(text, expected);
  }
}

}  // namespace
