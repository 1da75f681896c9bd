#include <gtest/gtest.h>

#include "problem_of.hpp"
#include "sim/march/block.hpp"
#include "sim/measure/why_failed.hpp"

using namespace reye;
using test::Changes;

namespace {

/// A scene before its first increment, and what it says of a failure there.
struct Begun {
  explicit Begun(const Changes& changes = {}, double gap = 0.0)
      : problem(test::problem_of(test::with(test::block_scene, changes), gap)), state(sim::initial_state(problem)) {
    sim::begin_state(problem, state, cache);
    system = *sim::system_of(problem, state, cache);
    attempt.step = &problem.scene.steps.back();
  }
  std::string why() const { return sim::why_failed(problem, state, attempt, system); }

  sim::Problem problem;
  sim::State state;
  sim::Cache cache;
  solver::System system;
  sim::Attempt attempt{nullptr, 1.0, solver::Failure::no_convergence, "no convergence in 30 iterations"};
};

}  // namespace

// Where none of the known causes is there, the solver's own reason must be left.
TEST(WhyFailed, NoKnownCause) { EXPECT_EQ(Begun().why(), "no convergence in 30 iterations"); }

// Sides farther apart than facets are paired must be named with both lengths.
TEST(WhyFailed, OutOfReach) {
  Begun begun({{"force_N_per_mm = -20.0", "motion_mm = -0.2"}}, 0.1);
  begun.system.contacts[0].search = 0.05;
  begun.attempt.failure = solver::Failure::contact_lost;
  EXPECT_EQ(begun.why(),
            "the sides of contact pad are 0.1 mm apart, and facets are paired no farther than search_mm = 0.05; write "
            "search_mm = 0.15");
}

// A contact of two nodes must be reported as too coarse.
TEST(WhyFailed, TwoNodes) {
  Begun begun;
  auto& status = begun.state.solution.contacts[0].status;
  status[0] = status[1] = contact::ContactStatus::stick;
  EXPECT_EQ(begun.why(),
            "only 2 nodes of contact pad touch, on elements of 0.5 mm: too coarse to carry its load; make them shorter "
            "there, with a fine_zone");
}

// A body that nothing but the lost contact held must be named with its motion.
TEST(WhyFailed, CameAway) {
  Begun begun;
  begun.attempt.failure = solver::Failure::contact_lost;
  EXPECT_EQ(begun.why(),
            "body slider has come away from contact pad, and no support holds its translation along y; check the "
            "direction of its loads, and "
            "that they press it on throughout the step");
}

// A body that friction alone held must be said to slide off once friction is spent, not to come away; a body that its
// supports hold along the contact cannot slide off.
TEST(WhyFailed, SlidesOff) {
  const auto why = [](const Changes& changes) {
    Begun begun(changes);
    begun.attempt.failure = solver::Failure::contact_lost;
    auto& contact = begun.state.solution.contacts[0];
    contact.friction = 0.3;
    for (auto& n : contact.normal) n = base::Vec2(0.0, -1.0);
    for (auto& traction : contact.lambda) traction = base::Vec2(0.297, -1.0);
    return begun.why();
  };
  EXPECT_EQ(why({{"x        = { motion_mm = 0.01", "x        = { force_N_per_mm = 5.0"}}),
            "body slider slides off: friction of contact pad carries 99.0 % of what it can, and no support holds its "
            "translation along x; check its loads and the friction, or support it");
  EXPECT_NE(why({}).find("has come away from contact pad"), std::string::npos);
}

// Wear beyond the length of an element in one block must be named with its depth: 3e-8 mm^2/N x 1e4 cycles x 0.3 x 1e6
// MPa x 0.04 mm.
TEST(WhyFailed, WearsTooFast) {
  Begun begun;
  auto& contact = begun.state.solution.contacts[0];
  contact.friction = 0.3;
  contact.normal[2] = base::Vec2(0.0, -1.0);
  contact.lambda[2] = base::Vec2(0.0, -1e6);
  begun.attempt.jump = 1e4;
  EXPECT_EQ(begun.why(),
            "contact pad would wear by some 3.6 mm in a block of 10000 cycles, more than its elements of 0.5 mm are "
            "long; check its wear "
            "coefficients, or write a smaller jump");
}
