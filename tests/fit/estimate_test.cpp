#include "fit/estimate.hpp"

#include <gtest/gtest.h>

#include "support/scars.hpp"

namespace {

using namespace reye;
using base::Vector;

// Of exact data the true parameter must come back, with shift, offset and tilt, from a start that is off by a factor
// of three.
TEST(estimate, exact_data) {
  std::mt19937_64 random(1);
  const auto series = support::profile(random, {.noise = 1e-9});
  const auto model = support::model_of(support::Scar::u, {series}, {1.0});
  const auto result = fit::estimate({series}, model, {"k"}, Vector::Constant(1, 1.1));
  EXPECT_TRUE(result.converged);
  EXPECT_NEAR(result.theta[0], 0.0, 1e-6);
  EXPECT_NEAR(result.series[0].shift.x(), 0.03, 1e-6);
  EXPECT_NEAR(result.series[0].offset, 0.003, 1e-8);
  EXPECT_NEAR(result.series[0].tilt.x(), 0.002, 1e-8);
}

}  // namespace
