#include <gtest/gtest.h>

#include "support/solid_hertz.hpp"

using namespace reye;

namespace {

constexpr double back_and_forth[4][2] = {{0.0, 0.0}, {0.25, 1.0}, {0.75, -1.0}, {1.0, 0.0}};

scene::History there_and_back() {
  scene::History history;
  for (const auto& corner : back_and_forth) history.push_back({corner[0], corner[1]});
  return history;
}

/// Two equal balls with nu = 0 under a tangential force that swings between +-q mu P: Cattaneo's and Mindlin's problem.
struct Mindlin {
  double q, mu, a, force, G;

  double stick_radius() const { return a * std::cbrt(1.0 - q); }
  /// 4.8 mu P K {1 - (1-q)^(5/3) - (5 q / 6)(1 + (1-q)^(2/3))} for one cycle, K = (3 mu P / 16 a) (2 (2 - nu) / G).
  double loop() const {
    const double K = 3.0 * mu * force / (16.0 * a) * (4.0 / G);
    return 4.8 * mu * force * K *
           (1.0 - std::pow(1.0 - q, 5.0 / 3.0) - 5.0 * q / 6.0 * (1.0 + std::pow(1.0 - q, 2.0 / 3.0)));
  }
};

}  // namespace

TEST(SolidFriction, StickRadiusAndLoopOfTwoEqualBalls) {
  // Under a swinging tangential force two equal balls slip in Cattaneo's and Mindlin's annulus: with six hexahedra per
  // radius the radius of stick is within half an element, the work of a loop within 10 % (within 2 % with ten).
  support::HertzCase c;
  c.nu = 0.0;
  c.mu = 0.5;
  c.half = c.two_balls = true;
  const Mindlin exact{0.5, c.mu, c.a_mm, c.force(), 0.5 * c.E_MPa};
  auto problem = support::hertz_problem(c, exact.q * c.mu * c.force());
  problem.scene.histories["slide"] = there_and_back();
  problem.scene.steps = {support::step_of(1, {"press"}), support::step_of(40, {"slide"}, 2)};
  const auto played = support::play(problem);
  ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  EXPECT_NEAR(*played.summary.contacts[0].energy_last_cycle_mJ / c.share() / exact.loop(), 1.0, 0.1);
  const auto& turning = played.rows[10];
  ASSERT_DOUBLE_EQ(turning.progress, 0.25);
  const double stick = std::sqrt(turning.contacts[0].stick_area_mm2 / c.share() / std::numbers::pi);
  EXPECT_NEAR(stick, exact.stick_radius(), 0.5 * c.a_mm / c.elements);
  EXPECT_LE(played.summary.balance, 1e-10);
  EXPECT_EQ(played.summary.counts.cutbacks, 0);
}

TEST(SolidFriction, ABallInGrossSlipNeedsFiveIterationsAnIncrement) {
  // A ball that slides to and fro by a fifth of its contact dissipates mu P times its way less the elastic reversals,
  // and an increment of the cycle needs at most five Newton iterations in the mean, without a cut-back.
  support::HertzCase c;
  c.mu = 0.6;
  c.half = true;
  c.elements = 4.0;
  auto problem = support::hertz_problem(c, 1.0);
  for (auto& input : problem.inputs)
    for (auto& support : input.supports)
      if (support.name == "top") support.along[0] = support::moved(0.1, "slide");
  problem.scene.histories["slide"] = there_and_back();
  problem.scene.steps = {support::step_of(1, {"press"}), support::step_of(40, {"slide"}, 1)};
  const auto played = support::play(problem);
  ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  double iterations = 0.0, largest = 0.0;
  for (std::size_t k = 1; k < played.rows.size(); ++k) {
    iterations += played.rows[k].newton / 40.0;
    largest = std::max(largest, played.rows[k].contacts[0].tangential_force_N);
  }
  EXPECT_LE(iterations, 5.0);
  EXPECT_EQ(played.summary.counts.cutbacks, 0);
  EXPECT_NEAR(largest, c.mu * c.share() * c.force(), 1e-3 * c.mu * c.share() * c.force());
  EXPECT_LE(played.summary.contacts[0].dissipated_energy_mJ, 4.0 * c.mu * c.share() * c.force() * 0.1);
  EXPECT_GE(played.summary.contacts[0].dissipated_energy_mJ, 0.85 * 4.0 * c.mu * c.share() * c.force() * 0.1);
}
