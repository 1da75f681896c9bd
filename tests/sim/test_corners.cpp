#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "problem_of.hpp"
#include "sim/study/run.hpp"

using namespace reye;

namespace {

/// A square that stands on its corner, `turn` rad from its side, above a flat block.
sim::Problem standing(const std::string& sides, double turn, const std::string& slider_bottom = "{1, 4}") {
  const std::string geometry =
      "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 1, 1};\nRotate {{0,0,1},{0,0,0}, " +
      std::to_string(turn) +
      "} { Surface{1}; }\nRectangle(2) = {-2, -1, 0, 4, 1};\n"
      "Physical Surface(\"slider\") = {1};\nPhysical Surface(\"base\") = {2};\nPhysical Curve(\"slider_bottom\") = " +
      slider_bottom +
      ";\nPhysical Curve(\"slider_top\") = {2};\n"
      "Physical Curve(\"base_bottom\") = {5};\nPhysical Curve(\"base_top\") = {7};\n";
  const std::string scene =
      test::with(test::block_scene, {{"secondary = \"slider_bottom\"\nprimary   = [\"base_top\"]", sides},
                                     {"cycles = 40\njump = 10\n", "cycles = 1\n"}});
  return support::problem_from({{"blocks.geo", geometry}, {"scene.toml", scene}});
}

const std::string corner_secondary = "secondary = \"slider_bottom\"\nprimary = [\"base_top\"]";
const std::string corner_primary = "secondary = \"base_top\"\nprimary = [\"slider_bottom\"]";
constexpr double diagonal = 0.7853981633974483;

}  // namespace

// A secondary side that touches with a sharp corner must be refused, with what to change.
TEST(Corners, ATouchingCornerIsNoSecondarySide) {
  try {
    standing(corner_secondary, diagonal);
    FAIL() << "accepted";
  } catch (const base::InputError& error) {
    ASSERT_EQ(error.issues().size(), 1U);
    EXPECT_NE(error.issues()[0].rule.find("swap primary and secondary"), std::string::npos) << error.issues()[0].rule;
    EXPECT_NE(error.issues()[0].key.find("contact.pad.secondary"), std::string::npos) << error.issues()[0].key;
  }
}

// With the sides swapped the same contact must keep within the cone of friction.
TEST(Corners, ItMayBePrimary) {
  const auto problem = standing(corner_primary, diagonal);
  auto state = sim::initial_state(problem);
  std::vector<sim::IncrementRecord> rows;
  sim::Observer watch;
  watch.increment = [&](const sim::IncrementRecord& r) { rows.push_back(r); };
  EXPECT_EQ(sim::run(problem, state, watch).status, sim::RunStatus::done);
  for (const auto& r : rows)
    EXPECT_LE(std::abs(r.support_forces[1].x()), 0.3 * std::abs(r.support_forces[1].y()) + 1e-6);
}

// Corners that do not point out of the body cause neither error nor warning: a block whose sides are named with its
// foot stays welcome.
TEST(Corners, AFlatFootWithItsSidesIsAccepted) {
  EXPECT_NO_THROW(standing(corner_secondary, 0.0));
  EXPECT_NO_THROW(standing(corner_secondary, 0.01));
}
