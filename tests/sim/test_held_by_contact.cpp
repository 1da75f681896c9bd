#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "problem_of.hpp"
#include "sim/study/run.hpp"

using namespace reye;

namespace {

/// Three blocks on one another, the middle one guided sideways alone; `lift`: how far the upper one is drawn above it.
sim::Problem stack(double lift) {
  const std::string geo =
      "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 2, 1};\nRectangle(2) = {0, 1, 0, 2, 1};\nRectangle(3) = "
      "{0, " +
      std::to_string(2.0 + lift) + ", 0, 2, 1};\n" + R"(
Physical Surface("low") = {1}; Physical Surface("middle") = {2}; Physical Surface("high") = {3};
Physical Curve("floor") = {1}; Physical Curve("low_top") = {3}; Physical Curve("under") = {5}; Physical Curve("side") = {8};
Physical Curve("over") = {7}; Physical Curve("high_bottom") = {9}; Physical Curve("roof") = {11};
)";
  const std::string scene = R"(geometry = ["stack.geo"]
[material.steel]
E_MPa = 200e3
nu = 0.0
[body.low]
material = "steel"
mesh = { far_size_mm = 0.5 }
[body.middle]
material = "steel"
mesh = { far_size_mm = 0.4 }
[body.high]
material = "steel"
mesh = { far_size_mm = 0.5 }
[contact.below]
secondary = "under"
primary = ["low_top"]
[contact.above]
secondary = "over"
primary = ["high_bottom"]
[support.floor]
edge = "floor"
x = "fixed"
y = "fixed"
[support.guide]
edge = "side"
x = "fixed"
[support.roof]
edge = "roof"
x = "fixed"
y = { motion_mm = -0.003, history = "press" }
[history]
press = [[0.0, 0.0], [1.0, 1.0]]
[[step]]
play = ["press"]
)";
  return support::problem_from({{"stack.geo", geo}, {"scene.toml", scene}});
}

}  // namespace

// A body that lies between two frictionless contacts must need neither a support along their normal nor a load: the
// motion of the upper block goes through it, sigma = E 0.003 / 3.
TEST(HeldByContact, BetweenTwoContacts) {
  const auto problem = stack(0.0);
  auto state = sim::initial_state(problem);
  const auto summary = sim::run(problem, state, {});
  ASSERT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  for (const auto& contact : summary.contacts)
    EXPECT_NEAR(contact.peak_pressure_MPa.value_or(0.0), 200.0, 1e-6) << contact.name;
}

// With a contact on one side alone nothing holds it: the motion must be refused by its name.
TEST(HeldByContact, BesideOneContact) {
  try {
    stack(0.1);
    FAIL() << "nothing was refused";
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("body.middle: translation along y is free: no support holds it and no load drives it"),
              std::string::npos)
        << error.what();
  }
}
