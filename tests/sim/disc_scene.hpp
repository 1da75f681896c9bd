#pragma once
#include "problem_of.hpp"
#include "sim/problem/problem.hpp"
#include "support/scene_words.hpp"

/// Half a disc of R = 1 mm pressed with 60 N/mm on a flat of 2 x 1: by Hertz 2 a = 0.0527 mm.
namespace reye::test {

/// `end`: where the flat's boundary "face" ends; the flat continues as "rest" to x = 1.
inline std::string disc_geo(const std::string& end) {
  return R"(SetFactory("OpenCASCADE");
Point(1) = {-1, 1, 0}; Point(2) = {0, 0, 0}; Point(3) = {1, 1, 0}; Point(4) = {0, 1, 0};
Circle(1) = {1, 4, 2}; Circle(2) = {2, 4, 3}; Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3}; Plane Surface(1) = {1};
Delete { Point{4}; }
Point(11) = {-1, -1, 0}; Point(12) = {1, -1, 0}; Point(13) = {1, 0, 0}; Point(14) = {)" +
         end + R"(, 0, 0}; Point(15) = {-1, 0, 0};
Line(11) = {11, 12}; Line(12) = {12, 13}; Line(13) = {13, 14}; Line(14) = {14, 15}; Line(15) = {15, 11};
Curve Loop(2) = {11, 12, 13, 14, 15}; Plane Surface(2) = {2};
Physical Surface("disc") = {1}; Physical Surface("flat") = {2};
Physical Curve("round") = {1, 2}; Physical Curve("top") = {3};
Physical Curve("bottom") = {11}; Physical Curve("rest") = {13}; Physical Curve("face") = {14};
)";
}

inline const std::string disc_scene = "geometry = [\"disc.geo\"]\n" +
                                      support::steel_bodies({{"disc", "far_size_mm = 0.35, growth = 1.8"},
                                                             {"flat", "far_size_mm = 0.35, growth = 1.8"}}) +
                                      R"([contact.pad]
secondary = "face"
primary   = ["round"]
fine_zone = { centre_mm = [0.0, 0.0], half_width_mm = 0.06, depth_mm = 0.02, size_mm = 0.005 }
[support.holder]
edge     = "top"
x        = "fixed"
rotation = "fixed"
y        = { force_N_per_mm = -60.0, history = "press" }
[support.floor]
edge     = "bottom"
x        = "fixed"
y        = "fixed"
)" + support::press_step(2);

inline sim::Problem disc_problem(const Changes& changes = {}, const std::string& end = "0.5") {
  return support::problem_from({{"disc.geo", disc_geo(end)}, {"scene.toml", with(disc_scene, changes)}});
}

}  // namespace reye::test
