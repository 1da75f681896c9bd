#include <gtest/gtest.h>

#include "body/turning.hpp"
#include "solver/blocks.hpp"
#include "solver/rolling.hpp"
#include "solver/uncondensed.hpp"

namespace {

using namespace reye;
using base::Vec2;
using support::Assembly;
using support::BlocksOptions;
using support::moved;

/// The blocks with both of them on edges that turn by `angle` about the middle of the lower one's, and the upper one
/// pressed and dragged as it was; a dead traction on its side turns along.
Assembly turning_blocks(const BlocksOptions& o, double angle, double traction = 1.0) {
  Assembly a = support::blocks(o);
  const Eigen::Matrix2d R = body::rotation(angle);
  const Vec2 base{1.0, 0.0}, holder{0.95, 2.0};
  a.inputs[0].supports[0].rotation = moved(angle);
  auto& upper = a.inputs[1].supports[0];
  const Vec2 way = (R - Eigen::Matrix2d::Identity()) * (holder - base) + R * Vec2(o.drag, -o.press);
  upper.x = moved(way.x());
  upper.y = moved(way.y());
  upper.rotation = moved(angle);
  a.inputs[1].boundary_loads = {{"side", "right", 0.0, traction * R * Vec2(-2.0, 1.0), {}, ""}};
  return a;
}

/// Newton, condensed, against the whole saddle-point system step by step.
void expect_newton_is_exact(const Assembly& a, const std::string& what) {
  const auto system = support::system_of(a);
  auto state = support::fresh(system);
  for (double factor : {1.0, 1.3, 0.9}) {
    const auto controls = support::controls_of(a, system, factor);
    support::Uncondensed oracle(system, state, controls);
    const auto result = solver::Newton({.chords = false}).solve(system, state, controls);
    ASSERT_TRUE(result.report.converged) << what << ": " << result.report.reason;
    for (int i = 0; i < result.report.solves; ++i) oracle.step(i);
    EXPECT_LT((result.state.q.high - oracle.q).lpNorm<Eigen::Infinity>(), 1e-10 * oracle.q.lpNorm<Eigen::Infinity>())
        << what;
    const auto& t = result.report.table;
    ASSERT_GE(t.size(), 3u);
    EXPECT_LT(support::residual(t.back()), std::max(1e-11, std::pow(support::residual(t[t.size() - 2]), 1.9))) << what;
    state = result.state;
  }
}

// Newton must be exact and converge at rate 2 on bodies that turn, whichever carries the multipliers.
TEST(turning, newton_is_exact) {
  for (bool swapped : {false, true})
    for (double friction : {0.0, 0.3}) {
      const BlocksOptions o{.friction = friction, .drag = 0.01, .upper_secondary = swapped};
      expect_newton_is_exact(turning_blocks(o, 0.05), "friction " + std::to_string(friction));
    }
}

// However far a shaft turns in an increment, what its friction dissipates must be what its support works: nothing is
// lost between the way that slides and its chord.
TEST(turning, friction_dissipates_what_the_support_works) {
  const auto states = rolling::spun(480, {0.01, 0.03, 0.07, 0.15, 0.3}, 3e4);
  ASSERT_EQ(states.size(), 5u);
  for (std::size_t k = 1; k < states.size(); ++k) {
    const double dissipated = states[k].friction_work - states[k - 1].friction_work;
    EXPECT_NEAR(dissipated / (std::abs(states[k].moment) * (states[k].angle - states[k - 1].angle)), 1.0, 2e-3)
        << states[k].angle;
  }
}

/// The upper block without supports: pressed by a pressure on its top that turns along, held by friction.
Assembly guided_by_contact() {
  Assembly a = support::blocks({.friction = 0.8});
  a.inputs[1].supports.clear();
  a.inputs[1].centre = {0.95, 1.5};
  a.inputs[1].boundary_loads = {{"top", "top", 20.0, {1.0, 0.0}, {}, ""}};
  return a;
}

// Where contact alone guides a body its rotation must be found with it, the angle tied to its chord.
TEST(turning, contact_alone_guides) {
  const Assembly a = guided_by_contact();
  const auto system = support::system_of(a);
  const auto result =
      solver::Newton({.chords = false}).solve(system, support::fresh(system), support::controls_of(a, system));
  ASSERT_TRUE(result.report.converged) << result.report.reason;
  const auto& upper = std::get<body::LinearBody>(system.bodies[1]);
  const base::Vector q = system.part(result.state.q.high, 1);
  EXPECT_LT(std::abs(upper.turning()->chord_of(q)), 1e-14);
  EXPECT_GT(std::abs(upper.angle(q)), 1e-6);
  Vec2 force{0, 0};
  for (std::size_t j = 0; j < result.state.contacts[0].lambda.size(); ++j)
    force += result.state.contacts[0].reference[j].carried() * result.state.contacts[0].lambda[j];
  const Eigen::Matrix2d R = body::rotation(upper.angle(q));
  EXPECT_LT((force - R * Vec2(0.0, 1.7 * 20.0) - Vec2(-1.7, 0.0)).norm(), 1e-7 * force.norm());
}

// Two bodies that have turned together must press and rub one another as they would have before, to 1e-10.
TEST(turning, pressures_are_objective) {
  for (double friction : {0.0, 0.3}) {
    const BlocksOptions o{.friction = friction, .drag = 0.01};
    const auto pressed = [&](double angle) {
      const Assembly a = turning_blocks(o, angle);
      const auto system = support::system_of(a);
      solver::Newton newton({.force_tolerance = 1e-13, .condition_tolerance = 1e-13});
      auto state = support::fresh(system);
      const BlocksOptions apart{.friction = friction, .press = -0.01};
      for (const Assembly& imposed : {turning_blocks(apart, angle, 0.0), a}) {
        const auto result = newton.solve(system, state, support::controls_of(imposed, system));
        EXPECT_TRUE(result.report.converged) << angle << ": " << result.report.reason;
        if (result.report.converged) state = result.state;
      }
      return state.contacts[0].lambda;
    };
    const auto still = pressed(0.0);
    double largest = 0.0;
    for (const auto& l : still) largest = std::max(largest, l.norm());
    for (double angle : {0.7, -2.5, 6.0}) {
      const auto turned = pressed(angle);
      for (std::size_t j = 0; j < still.size(); ++j)
        EXPECT_LT((body::rotation(-angle) * turned[j] - still[j]).norm(), 1e-10 * largest) << angle << ", node " << j;
    }
  }
}

}  // namespace
