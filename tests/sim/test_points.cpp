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

double centre_of_pressure(const sim::SurfaceRecord& s, std::vector<double> sim::SurfaceRecord::*place) {
  double force = 0.0, moment = 0.0;
  for (std::size_t i = 1; i < s.node.size(); ++i) {
    const double half = 0.5 * (s.arc_length_mm[i] - s.arc_length_mm[i - 1]);
    for (const std::size_t k : {i - 1, i}) {
      force += half * s.pressure_MPa[k];
      moment += half * s.pressure_MPa[k] * (s.*place)[k];
    }
  }
  return moment / force;
}

/// A block on a rigid wall, rubbing without friction, and a fluid that presses on the upper 3 mm of its flank. The
/// flank is vertical: which of its ends lies left is decided by round-off, and by wear.
const char* const wall_geometry = R"(SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 5, 10};
Rectangle(2) = {-3, -2, 0, 3, 14};
Physical Surface("block") = {1};
Physical Surface("wall") = {2};
Physical Curve("flank") = {4};
Physical Curve("back") = {2};
Physical Curve("wall_face") = {6};
)";

const char* const on_a_wall = R"(geometry = ["wall.geo"]
[material.steel]
E_MPa = 200e3
nu    = 0.0
[body.block]
material = "steel"
mesh     = { far_size_mm = 1.0 }
[body.wall]
rigid = true
[contact.pad]
secondary = "flank"
primary   = ["wall_face"]
imposed_sliding_mm = 1.0
wear      = { law = "archard", secondary_per_MPa = 1e-8 }
[support.back]
edge     = "back"
y        = "fixed"
x        = { force_N_per_mm = -1000.0, history = "press" }
rotation = "fixed"
[support.wall]
edge     = "wall_face"
x        = "fixed"
y        = "fixed"
rotation = "fixed"
[load.fluid]
edge         = "flank"
pressure_MPa = 50.0
interval_mm  = [7.0, 10.0]
history      = "press"
[history]
press = [[0, 0], [1, 1]]
[[step]]
name = "press"
play = ["press"]
wear = false
[[step]]
name = "slide"
cycles = 10
[output]
frames = { every_cycles = 1 }
)";

}  // namespace

// The place where a point load acts must not move when the body is remeshed: the moments about it stay in balance.
TEST(Points, ALoadStaysWhereItIsThroughRemeshes) {
  const auto problem = test::problem_of(worn_under_a_point("[1.87, 1.0]"));
  EXPECT_TRUE(problem.warnings.empty());
  auto state = sim::initial_state(problem);
  sim::Frame last;
  sim::Observer observer;
  observer.frame = [&](const sim::Frame& frame) { last = frame; };
  const auto summary = sim::run(problem, state, observer);
  ASSERT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  // The driven top is 1 mm above what rubs: there 6 N turn the block as 20 N do 0.3 mm beside the load.
  EXPECT_NEAR(centre_of_pressure(last.surfaces.at(0), &sim::SurfaceRecord::x_mm), 1.87 + 0.3, 5e-3);
  EXPECT_GT(summary.counts.remeshes, 3);
  for (const auto& shape : {problem.shapes[0], state.shapes[0]}) {
    ASSERT_EQ(shape->mesh.points.size(), 1U);
    EXPECT_LT((shape->mesh.X[shape->mesh.points[0]] - base::Vec2(1.87, 1.0)).norm(), 1e-12);
  }
}

// An interval of arc length must be counted from the same end in every cycle: a fluid keeps pressing where it pressed
// at first, and tables keep their direction.
TEST(Points, AnIntervalStaysAtItsEnd) {
  const auto problem = support::problem_from({{"wall.geo", wall_geometry}, {"scene.toml", on_a_wall}});
  auto state = sim::initial_state(problem);
  std::vector<double> centres, first_y;
  sim::Observer observer;
  observer.frame = [&](const sim::Frame& frame) {
    const auto& flank = frame.surfaces.at(0);
    first_y.push_back(flank.y_mm.front());
    if (frame.step != "start") centres.push_back(centre_of_pressure(flank, &sim::SurfaceRecord::y_mm));
  };
  ASSERT_EQ(sim::run(problem, state, observer).status, sim::RunStatus::done);
  ASSERT_EQ(centres.size(), 11U);
  for (double y : centres)
    EXPECT_NEAR(y, (1000.0 * 5.0 - 150.0 * 8.5) / 850.0, 0.01);  // what the fluid carries the wall does not
  for (double y : first_y) EXPECT_NEAR(y, first_y.front(), 1e-3);
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
