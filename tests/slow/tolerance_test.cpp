#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/problem.hpp"
#include "verification/wear_scene.hpp"

using namespace reye;

namespace {

const char* const ball = R"(SetFactory("OpenCASCADE");
Point(1) = {0, 0, 0};
Point(2) = {5, 5, 0};
Point(3) = {0, 5, 0};
Circle(1) = {1, 3, 2};
Line(2) = {2, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Rectangle(2) = {0, -4, 0, 6, 4};
Physical Surface("ball") = {1};
Physical Surface("disc") = {2};
Physical Curve("round") = {1};
Physical Curve("top") = {2};
Physical Curve("bottom") = {4};
Physical Curve("face") = {6};
)";

const char* const worn_ball = R"(analysis = "axisymmetric"
geometry = ["ball.geo"]
[material.steel]
E_MPa = 200e3
nu    = 0.3
[body.ball]
material = "steel"
order    = 1
mesh     = { far_size_mm = 0.8 }
[body.disc]
material = "steel"
order    = 1
mesh     = { far_size_mm = 0.8 }
[contact.c]
secondary = "round"
primary   = ["face"]
imposed_sliding_mm = 1.0
wear      = { law = "archard", secondary_per_MPa = 1e-9 }
fine_zone = { centre_mm = [0.0, 0.0], half_width_mm = 1.0, depth_mm = 0.2, size_mm = 0.04 }
[support.top]
edge     = "top"
y        = { force_N = -10.0, history = "press" }
rotation = "fixed"
[support.bottom]
edge = "bottom"
y    = "fixed"
[history]
press = [[0.0, 0.0], [1.0, 1.0]]
[remesh]
automatic = false
[[step]]
name = "press"
play = ["press"]
increments = 2
wear = false
[[step]]
name = "wear"
cycles = 4e6
)";

sim::SurfaceRecord end_of(const std::string& jump) {
  const auto problem =
      support::problem_from({{"ball.geo", ball}, {"scene.toml", std::string(worn_ball) + "jump = " + jump + "\n"}});
  auto state = sim::initial_state(problem);
  sim::Frame last;
  sim::Observer observer;
  observer.frame = [&](const sim::Frame& frame) { last = frame; };
  EXPECT_EQ(sim::run(problem, state, observer).status, sim::RunStatus::done);
  return last.surfaces.at(0);
}

/// The fretting disc of geo/life_band without its limit and on its first meshes.
verification::Replacements life(const std::string& jump, const std::string& more) {
  return {{"[limit.life]\ncontact     = \"pad\"\ndepth_mm    = 1e-3\nstop        = true\nwear_factor = [0.5, 2.0]\n",
           "[remesh]\nautomatic = false\n" + more},
          {"cycles = 2000\njump = 100", "cycles = 300\njump = " + jump}};
}

std::vector<double> worn(const sim::State& state) { return state.solution.contacts[0].removed_secondary; }

}  // namespace

// A ball worn on its axis under a tolerance must end with the pressures of a run in short fixed blocks.
TEST(Tolerance, WornBallEndsWithLevelPressure) {
  const auto right = end_of("50000"), found = end_of("{ tolerance = 0.005 }");
  EXPECT_NEAR(found.pressure_MPa[0] / right.pressure_MPa[0], 1.0, 0.03);
  const double edge = 0.9 * 0.7284;
  double peak = 0.0, expected = 0.0;
  for (std::size_t i = 0; i < found.x_mm.size(); ++i) {
    if (found.arc_length_mm[i] < edge) peak = std::max(peak, found.pressure_MPa[i]);
    if (right.arc_length_mm[i] < edge) expected = std::max(expected, right.pressure_MPa[i]);
  }
  EXPECT_NEAR(peak / expected, 1.0, 0.05);
}

// The estimated error must lie between a half and five times the true one, with increments that are cut as well as
// without.
TEST(Tolerance, EstimateSurvivesCutBacks) {
  const auto run = [](const std::string& jump, const std::string& more) {
    const auto problem = verification::prepared(verification::scene_text("life_band", life(jump, more)));
    auto state = sim::initial_state(problem);
    EXPECT_EQ(sim::run(problem, state, {}).status, sim::RunStatus::done);
    return state;
  };
  const auto exact = worn(run("{ tolerance = 0.2, first = 1, most = 5 }", ""));
  for (const std::string newton : {"", "[solver]\nmax_newton = 5\n"}) {
    const auto state = run("{ tolerance = 0.01 }", newton);
    const auto now = worn(state);
    double apart = 0.0, all = 0.0;
    for (std::size_t j = 0; j < now.size(); ++j) {
      apart += std::abs(now[j] - exact[j]);
      all += exact[j];
    }
    EXPECT_EQ(state.counts.cutbacks > 0, !newton.empty());
    EXPECT_LT(apart / all, 0.01);
    EXPECT_GT(state.jump_error.value(), 0.5 * apart / all);
    EXPECT_LT(state.jump_error.value(), 5.0 * apart / all);
  }
}
