#include <gtest/gtest.h>

#include <algorithm>

#include "base/errors.hpp"
#include "sim/study/run.hpp"
#include "support/problem.hpp"

using namespace reye;

namespace {

/// A pin with a ball end, R = 2, on a block, drawn whole or as the halves x >= 0 by hand.
std::string drawn(bool whole) {
  const std::string head =
      "SetFactory(\"Built-in\");\nPoint(1) = {0, 0, 0};\nPoint(2) = {2, 2, 0};\nPoint(3) = {2, 4, 0};\nPoint(9) = {0, "
      "2, 0};\n"
      "Circle(1) = {1, 9, 2};\nLine(2) = {2, 3};\nPoint(12) = {4, -2, 0};\nPoint(13) = {4, 0, 0};\nLine(12) = {12, "
      "13};\n";
  const std::string rest =
      "Plane Surface(1) = {1};\nPlane Surface(2) = {2};\nPhysical Surface(\"pin\") = {1};\nPhysical Surface(\"block\") "
      "= {2};\n"
      "Physical Curve(\"face\") = {13};\nPhysical Curve(\"bottom\") = {11};\nPhysical Curve(\"top\") = {3};\n";
  if (whole)
    return head +
           "Point(5) = {-2, 4, 0};\nPoint(6) = {-2, 2, 0};\nLine(3) = {3, 5};\nLine(4) = {5, 6};\nCircle(5) = {6, 9, "
           "1};\n"
           "Curve Loop(1) = {1, 2, 3, 4, 5};\nPoint(11) = {-4, -2, 0};\nPoint(14) = {-4, 0, 0};\nLine(11) = {11, "
           "12};\nLine(13) = {13, 14};\n"
           "Line(14) = {14, 11};\nCurve Loop(2) = {11, 12, 13, 14};\n" +
           rest + "Physical Curve(\"ball\") = {1, 5};\nPhysical Curve(\"wall\") = {14};\n";
  return head +
         "Point(4) = {0, 4, 0};\nLine(3) = {3, 4};\nLine(4) = {4, 1};\nCurve Loop(1) = {1, 2, 3, 4};\nPoint(11) = {0, "
         "-2, 0};\n"
         "Point(14) = {0, 0, 0};\nLine(11) = {11, 12};\nLine(13) = {13, 14};\nLine(14) = {14, 11};\nCurve Loop(2) = "
         "{11, 12, 13, 14};\n" +
         rest + "Physical Curve(\"ball\") = {1};\n";
}

const char* const pin_scene = R"(analysis = "axisymmetric"
geometry = ["pin.geo"]
[material.steel]
E_MPa = 200e3
nu = 0.3
[body.pin]
material = "steel"
mesh = { far_size_mm = 0.5 }
[body.block]
material = "steel"
mesh = { far_size_mm = 0.5 }
[contact.pad]
secondary = "ball"
primary = ["face"]
fine_zone = { centre_mm = [0, 0], half_width_mm = 0.4, depth_mm = 0.1, size_mm = 0.05 }
[support.holder]
edge = "top"
y = { motion_mm = -0.02, history = "press" }
[support.floor]
edge = "bottom"
y = "fixed"
[history]
press = [[0, 0], [1, 1]]
[[step]]
play = ["press"]
wear = false
)";

sim::Problem pin_problem(bool whole, const std::string& text = pin_scene) {
  return support::problem_from({{"pin.geo", drawn(whole)}, {"scene.toml", text}});
}

}  // namespace

// Of whole sections through the axis the halves must be taken, which is said, and press as the halves drawn by hand.
TEST(WholeSection, PressesAsTheHalfByHand) {
  std::vector<sim::State> ends;
  for (const bool whole : {true, false}) {
    const auto problem = pin_problem(whole);
    const auto says = std::count(problem.plan.lines.begin(), problem.plan.lines.end(),
                                 "body pin: its file has the whole section through the axis; the half x >= 0 is taken");
    EXPECT_EQ(says, whole ? 1 : 0);
    ends.push_back(sim::initial_state(problem));
    const auto summary = sim::run(problem, ends.back(), {});
    ASSERT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
    EXPECT_GT(summary.contacts[0].normal_force, 1.0);
  }
  const auto &a = ends[0].solution.contacts[0], &b = ends[1].solution.contacts[0];
  ASSERT_EQ(a.lambda.size(), b.lambda.size());
  double peak = 0.0;
  for (const auto& lambda : b.lambda) peak = std::max(peak, lambda.norm());
  for (std::size_t j = 0; j < a.lambda.size(); ++j) {
    EXPECT_LT((a.lambda[j] - b.lambda[j]).norm(), 1e-10 * peak) << j;
    EXPECT_EQ(a.status[j], b.status[j]) << j;
  }
}

// A curve that is cut away must be reported when the scene names it.
TEST(WholeSection, TellsOfCurvesThatAreCutAway) {
  std::string text = pin_scene;
  text.replace(text.find("\"bottom\""), 8, "\"wall\"");
  try {
    pin_problem(true, text);
    FAIL() << "the wall at x < 0 is no boundary";
  } catch (const base::InputError& error) {
    EXPECT_NE(
        std::string(error.what())
            .find("; its curve lies at x < 0, which is cut away, and its mirror image does not have this name: the "
                  "half x >= 0 of "
                  "body \"block\" is taken"),
        std::string::npos)
        << error.what();
  }
}
