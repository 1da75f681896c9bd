#pragma once
#include <numbers>
#include <string>

#include "sim/study/run.hpp"
#include "support/problem.hpp"
#include "support/three_arcs.hpp"

namespace reye::support {

/// How a bore in a bush is drawn, and what is pressed into it.
struct Bore {
  double seam_deg = 0.0;  ///< where its circle begins
  bool arcs = false;      ///< drawn as three arcs, two of which meet there
  double size_mm = 0.5;
  int blocks = 6;
};

/// A shaft in a bush of plastic, pressed down by 10 N/mm and turned; the bore wears to a scar of 26 mm.
inline sim::Problem bush(const Bore& bore) {
  const std::string from = std::to_string(bore.seam_deg * std::numbers::pi / 180.0);
  const auto circle = [](int number, const char* r, const std::string& begin, const std::string& end) {
    return "Circle(" + std::to_string(number) + ") = {0, 0, 0, " + r + ", " + begin + ", " + end + "};\n";
  };
  std::string geo = "SetFactory(\"OpenCASCADE\");\n" + circle(1, "13", "0", "2*Pi") +
                    (bore.arcs ? three_arcs(bore.seam_deg) : circle(2, "10", from, from + " + 2*Pi"));
  geo +=
      "Circle(4) = {0, -0.05, 0, 9.95, 0, 2*Pi};\nCircle(5) = {0, -0.05, 0, 4, 0, 2*Pi};\n"
      "Curve Loop(1) = {1};\nCurve Loop(2) = {2" +
      std::string(bore.arcs ? ", 8, 9" : "") +
      "};\nCurve Loop(3) = {4};\nCurve Loop(4) = {5};\nPlane Surface(1) = {1, 2};\nPlane Surface(2) = {3, 4};\n" +
      "Physical Surface(\"bush\") = {1};\nPhysical Surface(\"shaft\") = {2};\nPhysical Curve(\"outside\") = {1};\n"
      "Physical Curve(\"bore\") = {2" +
      std::string(bore.arcs ? ", 8, 9" : "") +
      "};\nPhysical Curve(\"journal\") = {4};\nPhysical Curve(\"inner\") = {5};\n";
  const std::string scene = R"(geometry = ["bush.geo"]
[material.steel]
E_MPa = 210e3
nu = 0.3
[material.pom]
E_MPa = 2800
nu = 0.38
[body.shaft]
material = "steel"
mesh = { far_size_mm = 2.0 }
[body.bush]
material = "pom"
mesh = { far_size_mm = 2.0 }
[contact.bearing]
imposed_sliding_mm = 62.83185
secondary = "bore"
primary = ["journal"]
wear = { law = "archard", secondary_per_MPa = 1.0e-9 }
fine_zone = { centre_mm = [0, -10], half_width_mm = 7, depth_mm = 1.5, size_mm = )" +
                            std::to_string(bore.size_mm) + R"( }
[support.housing]
edge = "outside"
x = "fixed"
y = "fixed"
[support.shaft]
edge = "inner"
x = "fixed"
y = { force_N_per_mm = -10, history = "press" }
rotation = "fixed"
[history]
press = [[0, 0], [1, 1]]
[remesh]
every_blocks = 3
[[step]]
name = "press"
play = ["press"]
increments = 3
wear = false
[[step]]
name = "revolutions"
cycles = 1e6
jump = )" + std::to_string(1e6 / bore.blocks) +
                            "\n";
  return problem_from({{"bush.geo", geo}, {"scene.toml", scene}});
}

/// The contact at the end of a run of the bush.
inline sim::Summary worn_bush(const Bore& bore) {
  const auto problem = bush(bore);
  auto state = sim::initial_state(problem);
  return sim::run(problem, state, {});
}

}  // namespace reye::support
