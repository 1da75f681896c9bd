#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "mesh/arc.hpp"
#include "problem_of.hpp"
#include "sim/study/run.hpp"

using namespace reye;

namespace {

/// The slider worn under a point load, remeshed after every block.
std::string worn_under_a_point(const std::string& at) {
  return test::with(
      test::block_scene,
      {{"y        = { force_N_per_mm = -20.0, history = \"press\" }\nrotation = \"fixed\"",
        "y = \"free\"\nrigid = false"},
       {"[history]", "[load.weight]\nbody = \"slider\"\npoint_mm = " + at +
                         "\nforce_N_per_mm = [0, -20]\nhistory = \"press\"\n[remesh]\nevery_blocks = 1\n[history]"}});
}

}  // namespace

// The place where a point load acts must not move when the body is remeshed: the moments about it stay in balance.
TEST(Points, ALoadStaysWhereItIsThroughRemeshes) {
  const auto problem = test::problem_of(worn_under_a_point("[1.87, 1.0]"));
  EXPECT_TRUE(problem.warnings.empty());
  auto state = sim::initial_state(problem);
  const auto summary = sim::run(problem, state, {});
  ASSERT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  EXPECT_GT(summary.counts.remeshes, 3);
  for (const auto& shape : {problem.shapes[0], state.shapes[0]}) {
    ASSERT_EQ(shape->mesh.points.size(), 1U);
    EXPECT_LT((shape->mesh.X[shape->mesh.points[0]] - base::Vec2(1.87, 1.0)).norm(), 1e-12);
  }
}

// A point outside of its body must be refused with its line and the nearest place of the body; one within a quarter of
// an element of its outline is taken to it.
TEST(Points, OutsideOfTheBodyIsRefused) {
  const auto refusal = [](const std::string& at) -> std::string {
    try {
      test::problem_of(worn_under_a_point(at));
    } catch (const base::InputError& error) {
      return error.what();
    }
    return {};
  };
  const std::string told = refusal("[1.87, 1.6]");
  EXPECT_NE(told.find("scene.toml:28: load.weight.point_mm = [1.87, 1.6]: lies outside of body slider, whose nearest "
                      "place is (1.87, 1), 0.6 mm away; "
                      "put the point on the body"),
            std::string::npos)
      << told;
  EXPECT_EQ(refusal("[1.87, 1.1]"), "");
}
