#include <gtest/gtest.h>

#include "problem_of.hpp"
#include "sim/measure/overlap.hpp"
#include "sim/study/run.hpp"

using namespace reye;

namespace {

/// Two blocks in contact and a post on the same base, `gap` right of the slider; no contact is between post and slider.
sim::Problem with_post(double gap, const std::string& stroke) {
  const std::string geometry =
      "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {1, 0, 0, 2, 1};\nRectangle(2) = {0, -1, 0, 4, 1};\n"
      "Rectangle(3) = {" +
      std::to_string(3.0 + gap) +
      ", 0.2, 0, 0.5, 0.5};\n"
      "Physical Surface(\"slider\") = {1};\nPhysical Surface(\"base\") = {2};\n"
      "Physical Surface(\"post\") = {3};\nPhysical Curve(\"slider_bottom\") = {1};\n"
      "Physical Curve(\"slider_top\") = {3};\nPhysical Curve(\"base_bottom\") = {5};\n"
      "Physical Curve(\"base_top\") = {7};\nPhysical Curve(\"post_right\") = {10};\n";
  const std::string scene =
      test::with(test::block_scene,
                 {{"motion_mm = 0.01", "motion_mm = " + stroke},
                  {"[contact.pad]", "[body.post]\nmaterial = \"steel\"\nmesh = { far_size_mm = 0.25 }\n[contact.pad]"},
                  {"[history]", "[support.post]\nedge = \"post_right\"\nx = \"fixed\"\ny = \"fixed\"\n[history]"},
                  {"cycles = 40\njump = 10\n", "wear = false\n"},
                  {"[0.25, 1.0], [0.75, -1.0], [1.0, 0.0]", "[1.0, 1.0]"}});
  return support::problem_from({{"blocks.geo", geometry}, {"scene.toml", scene}});
}

std::vector<sim::Warning> overlaps_among(std::vector<sim::Warning> list) {
  std::erase_if(list, [](const auto& w) { return w.kind != "overlap"; });
  return list;
}

std::vector<sim::Warning> overlaps_in(const sim::Problem& problem) {
  auto state = sim::initial_state(problem);
  sim::Observer watch;
  watch.frame = [](const sim::Frame&) {};
  EXPECT_EQ(sim::run(problem, state, watch).status, sim::RunStatus::done);
  return overlaps_among(state.warnings);
}

}  // namespace

// Bodies that come to lie inside one another where no contact is between them must be named, with the depth.
TEST(Overlap, OfBodiesWithoutContact) {
  const auto problem = with_post(0.1, "0.15");
  EXPECT_TRUE(overlaps_among(problem.warnings).empty());
  const auto found = overlaps_in(problem);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].about, "bodies post and slider");
  EXPECT_NEAR(found[0].severity, 0.05, 1e-3);
  EXPECT_TRUE(overlaps_in(with_post(0.2, "0.15")).empty());
}

// One that is drawn so must be named before the run.
TEST(Overlap, DrawnSo) {
  const auto found = overlaps_among(with_post(-0.05, "0.01").warnings);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].severity, 0.05, 1e-12);
}

// What a contact keeps apart is its own concern, pressed or drawn into one another.
TEST(Overlap, BetweenTheSidesOfAContactIsNone) {
  EXPECT_TRUE(overlaps_among(test::problem_of(test::block_scene, -0.05).warnings).empty());
}
