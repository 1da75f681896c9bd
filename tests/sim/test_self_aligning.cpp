#include <gtest/gtest.h>

#include "sim/study/run.hpp"
#include "support/problem.hpp"

using namespace reye;

namespace {

/// A pad of 20 x 8 mm, free to turn about the middle of its back, dragged to and fro over a rail.
const char* const pad_geometry = R"(SetFactory("OpenCASCADE");
Rectangle(1) = {-30, -5, 0, 60, 5};
Rectangle(2) = {-10, 0, 0, 20, 8};
Physical Surface("rail") = {1};
Physical Surface("pad") = {2};
Physical Curve("base") = {1};
Physical Curve("track") = {3};
Physical Curve("sole") = {5};
Physical Curve("back") = {7};
)";

const char* const pad_scene = R"(geometry = ["pad.geo"]
[material.lining]
E_MPa = 1000
nu    = 0.25
[material.iron]
E_MPa = 110e3
nu    = 0.26
[body.pad]
material = "lining"
mesh     = { far_size_mm = 1.0 }
[body.rail]
material = "iron"
mesh     = { far_size_mm = 2.0 }
[contact.brake]
secondary = "sole"
primary   = ["track"]
friction  = 0.4
[support.caliper]
edge = "back"
x = { motion_mm = 10, history = "stroke" }
y = { force_N_per_mm = -20, history = "press" }
[support.base]
edge = "base"
x = "fixed"
y = "fixed"
[history]
press  = [[0, 0], [1, 1]]
stroke = [[0, 0], [0.5, 1], [1, 0]]
[[step]]
name = "press"
play = ["press"]
increments = 2
[[step]]
name = "drag"
play = ["stroke"]
increments = 20
)";

}  // namespace

// A pad that aligns itself must go over from rest to sliding, and from one direction to the other, without a cut-back,
// though it rolls off the rail where its nodes start in stick.
TEST(SelfAligning, SlidesAtOnce) {
  const auto problem = support::problem_from({{"pad.geo", pad_geometry}, {"scene.toml", pad_scene}});
  auto state = sim::initial_state(problem);
  std::vector<double> drag;
  sim::Observer observer;
  observer.increment = [&](const sim::IncrementRecord& r) {
    if (r.step == "drag") drag.push_back(r.support_forces.at(0).x());
  };
  const auto summary = sim::run(problem, state, observer);
  EXPECT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  EXPECT_EQ(summary.counts.cutbacks, 0);
  ASSERT_EQ(drag.size(), 20u);
  for (std::size_t i = 0; i < drag.size(); ++i) EXPECT_NEAR(drag[i], i < 10 ? 8.0 : -8.0, 1e-3) << i;  // mu x 20 N/mm
}

// What it wears under a tolerance must be coefficient x work to rounding, though the gap is carried round its rounded
// edges in the middle of blocks: what moves from node to node there is no wear.
TEST(SelfAligning, LedgerIsExact) {
  std::string rounded = pad_geometry, worn = pad_scene;
  const auto put = [](std::string& in, const std::string& from, const std::string& to) {
    in.replace(in.find(from), from.size(), to);
  };
  put(rounded, "20, 8};", "20, 8, 0.5};");
  put(rounded, "Physical Curve(\"sole\") = {5};\nPhysical Curve(\"back\") = {7};\n", "");
  put(worn, "far_size_mm = 1.0", "far_size_mm = 0.4");
  put(worn, "[contact.brake]",
      "[boundary]\nsole = { body = \"pad\", box_mm = [-10.1, -0.1, 10.1, 0.6] }\n"
      "back = { body = \"pad\", nearest_mm = [0, 8] }\n[contact.brake]");
  put(worn, "friction  = 0.4\n", "friction  = 0.4\nwear      = { law = \"energy\", secondary_mm3_per_J = 2.5e-5 }\n");
  put(worn, "motion_mm = 10", "motion_mm = 15");
  put(worn, "increments = 2\n", "increments = 2\nwear = false\n");
  put(worn, "increments = 20\n", "increments = 20\ncycles = 5000\njump = { tolerance = 0.01 }\n");
  const auto problem = support::problem_from({{"pad.geo", rounded}, {"scene.toml", worn}});
  auto state = sim::initial_state(problem);
  const auto summary = sim::run(problem, state, {});
  EXPECT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  EXPECT_LT(*summary.contacts[0].ledger_relative_error, 1e-9);
}
