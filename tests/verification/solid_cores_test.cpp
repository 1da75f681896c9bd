#include <gtest/gtest.h>

#include "base/cores.hpp"
#include "support/solid_mindlin.hpp"

using namespace reye;

namespace {

/// Two balls pressed and pushed to one side, on so many cores.
support::PlayedSolids pushed_on(int count) {
  const base::Cores cores(count);
  support::HertzCase c;
  c.mu = 0.5;
  c.nu = 0.0;
  c.half = c.two_balls = true;
  c.elements = 8.0;
  auto problem = support::swinging_balls(0.5, c);
  problem.scene.steps = {support::step_of(1, {"press"}), support::step_of(1, {"slide"})};
  return support::play(problem);
}

/// Largest difference of tractions over the largest traction.
double difference(const support::PlayedSolids& a, const support::PlayedSolids& b) {
  const auto &one = a.frames.back().surfaces[0], &other = b.frames.back().surfaces[0];
  double largest = 0.0, apart = 0.0;
  for (std::size_t j = 0; j < one.pressure_MPa.size(); ++j) {
    largest = std::max(largest, one.pressure_MPa[j]);
    apart = std::max(
        {apart, std::abs(one.pressure_MPa[j] - other.pressure_MPa[j]), (one.shear_MPa[j] - other.shear_MPa[j]).norm()});
  }
  return apart / largest;
}

}  // namespace

TEST(SolidCores, BitsDoNotDependOnTheNumberOfCores) {
  // Bodies, facets, matrices and motions are divided in shares that are the same on any number of cores.
  const auto one = pushed_on(1), two = pushed_on(2), three = pushed_on(3);
  ASSERT_EQ(one.summary.status, sim::RunStatus::done) << one.summary.reason;
  EXPECT_EQ(difference(one, two), 0.0);
  EXPECT_EQ(difference(one, three), 0.0);
}
