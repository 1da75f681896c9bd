#include "sim/measure/zones.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/study/run.hpp"
#include "support/problem.hpp"

using namespace reye;

namespace {

/// A yoke with two feet on a flat, round ones of radius 1 and 4 or flat ones, 6 apart.
std::string yoke(bool round) {
  const std::string feet =
      round ? "Circle(2) = {2, 20, 3};\nCircle(6) = {6, 21, 7};\n" : "Line(2) = {2, 3};\nLine(6) = {6, 7};\n";
  const std::string ends =
      round ? "Point(2) = {-3.8, 0.4, 0};\nPoint(3) = {-2.2, 0.4, 0};\nPoint(20) = {-3, 1, 0};\n"
              "Point(6) = {1.6, 0.25, 0};\nPoint(7) = {4.4, 0.25, 0};\nPoint(21) = {3, 4, 0};\n"
            : "Point(2) = {-3.5, 0, 0};\nPoint(3) = {-2.5, 0, 0};\nPoint(6) = {2.5, 0, 0};\nPoint(7) = {3.5, 0, 0};\n";
  const std::string left = round ? "-3.8" : "-3.5", right = round ? "4.4" : "3.5";
  return ends + "Point(1) = {" + left +
         ", 3, 0};\nPoint(4) = {-2.2, 1.5, 0};\nPoint(5) = {1.6, 1.5, 0};\nPoint(8) = {" + right + ", 3, 0};\n" + feet +
         "Line(1) = {1, 2};\nLine(3) = {3, 4};\nLine(4) = {4, 5};\nLine(5) = {5, 6};\nLine(7) = {7, 8};\nLine(8) = {8, "
         "1};\n"
         "Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7, 8};\nPlane Surface(1) = {1};\n"
         "Point(31) = {-6, -1, 0};\nPoint(32) = {6, -1, 0};\nPoint(33) = {6, 0, 0};\nPoint(34) = {-6, 0, 0};\n"
         "Line(31) = {31, 32};\nLine(32) = {32, 33};\nLine(33) = {33, 34};\nLine(34) = {34, 31};\n"
         "Curve Loop(2) = {31, 32, 33, 34};\nPlane Surface(2) = {2};\n"
         "Physical Surface(\"yoke\") = {1};\nPhysical Surface(\"flat\") = {2};\nPhysical Curve(\"feet\") = {2, 6};\n"
         "Physical Curve(\"top\") = {8};\nPhysical Curve(\"face\") = {33};\nPhysical Curve(\"bottom\") = {31};\n";
}

const char* const yoke_scene = R"(geometry = ["yoke.geo"]
[material.steel]
E_MPa = 200e3
nu = 0.3
[body.yoke]
material = "steel"
order = 1
mesh = { far_size_mm = 0.5 }
[body.flat]
rigid = true
[contact.feet]
secondary = "feet"
primary = ["face"]
imposed_sliding_mm = 1.0
wear = { law = "archard", secondary_per_MPa = 2e-6 }
fine_zone = [
  { centre_mm = [-3, 0], half_width_mm = 0.2, depth_mm = 0.1, size_mm = 0.02 },
  { centre_mm = [3, 0], half_width_mm = 1.0, depth_mm = 0.2, size_mm = 0.1 },
]
[support.holder]
edge = "top"
x = "fixed"
y = { force_N_per_mm = -200, history = "press" }
rotation = "fixed"
[support.floor]
edge = "bottom"
x = "fixed"
y = "fixed"
rotation = "fixed"
[history]
press = [[0, 0], [1, 1]]
[[step]]
play = ["press"]
wear = false
)";

/// The lengths of the facets of the feet that lie within a zone, the shortest and the longest.
std::array<double, 2> spacing(const mesh::Mesh& mesh, const cad::FineZone& zone) {
  std::array<double, 2> range{1e9, 0.0};
  for (const auto& chain : mesh.boundaries.at("feet"))
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const auto &a = mesh.X[chain[i - 1]], &b = mesh.X[chain[i]];
      if (std::max(std::abs(a.x() - zone.centre_mm.x()), std::abs(b.x() - zone.centre_mm.x())) >
          zone.half_width_mm + 1e-9)
        continue;
      range = {std::min(range[0], (b - a).norm()), std::max(range[1], (b - a).norm())};
    }
  return range;
}

}  // namespace

// Of two fine zones of a contact the one that wear outruns must grow, and the other stay as the scene asks, its
// elements, too.
TEST(Zones, EachGrowsByItself) {
  const auto problem = support::problem_from(
      {{"yoke.geo", yoke(true)},
       {"scene.toml",
        std::string(yoke_scene) + "[[step]]\nplay = []\ncycles = 60\njump = { tolerance = 0.1, first = 1 }\n"}});
  auto state = sim::initial_state(problem);
  const auto summary = sim::run(problem, state, {});
  ASSERT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  EXPECT_GE(summary.counts.remeshes, 1);
  EXPECT_LT(summary.contacts[0].ledger_relative_error.value(), 1e-9);
  const auto& asked = problem.scene.geometry.fine_zones;
  const auto& zones = state.shapes[0]->drawing->zones;
  ASSERT_EQ(zones.size(), 2U);
  EXPECT_GT(zones[0].half_width_mm, 1.2 * asked[0].half_width_mm);
  EXPECT_NEAR(zones[0].size_mm / asked[0].size_mm, zones[0].half_width_mm / asked[0].half_width_mm, 1e-12);
  EXPECT_EQ(zones[1].half_width_mm, asked[1].half_width_mm);
  EXPECT_EQ(zones[1].size_mm, asked[1].size_mm);
  for (const auto& zone : zones) {
    const auto [least, most] = spacing(state.shapes[0]->mesh, zone);
    EXPECT_GT(least, 0.75 * zone.size_mm) << zone.key;
    EXPECT_LT(most, 1.3 * zone.size_mm) << zone.key;
  }
}

// A zone as wide as its foot must not be outrun because the boundary continues at the other foot.
TEST(Zones, AnotherFootIsNotBeyondTheZone) {
  const auto problem = support::problem_from({{"yoke.geo", yoke(false)}, {"scene.toml", yoke_scene}});
  auto state = sim::initial_state(problem);
  const auto summary = sim::run(problem, state, {});
  ASSERT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  auto wide = *state.shapes[0];
  auto drawing = *wide.drawing;
  for (auto& zone : drawing.zones) zone.half_width_mm = 0.5;  // the foot's
  wide.drawing = std::make_shared<const cad::Drawing>(drawing);
  EXPECT_EQ(sim::leaves_zone(problem, state, 0, wide), "");
  drawing.zones.pop_back();
  drawing.zones[0].half_width_mm = 0.4;
  wide.drawing = std::make_shared<const cad::Drawing>(drawing);
  EXPECT_NE(sim::leaves_zone(problem, state, 0, wide), "") << "the foot is wider than this zone";
}
