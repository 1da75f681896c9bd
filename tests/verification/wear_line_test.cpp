#include <cmath>
#include <numbers>

#include "sim/problem/records.hpp"
#include "wear_scene.hpp"

/// References B8: a line contact in gross slip, S = k E* s / a0; universal curve of an implicit half-plane solution.
namespace reye::verification {

namespace {

using sim::Side;

struct LineContact {
  static constexpr double a0 = 0.0358622, p0 = 328.409, R = 6.0;  ///< mm and MPa
};

const std::string line_zone = "half_width_mm = 0.1, depth_mm = 0.05, size_mm = 0.0018";
/// The round may carry the multipliers only when its ends lie on no rigid edge.
const std::string rigid_holder = R"(edge     = "top"
x        = "fixed"
rotation = "fixed"
y        = { force_N_per_mm = -18.5, history = "press" }
)";
const std::string pressed_holder = R"(edge     = "top"
x        = "fixed"

[support.upright]
point_mm = [0.0, 3.0]
body     = "cylinder"
x        = "fixed"

[load.top]
edge         = "top"
pressure_MPa = 1.5416667
history      = "press"
)";
const std::string line_sides = "secondary = \"face\"\nprimary   = [\"round\"]";

/// A column of a surface at x by linear interpolation.
double at(const sim::SurfaceRecord& s, const std::vector<double>& column, double x) {
  for (std::size_t i = 1; i < s.x_mm.size(); ++i)
    if ((s.x_mm[i - 1] - x) * (s.x_mm[i] - x) <= 0.0)
      return column[i - 1] + (column[i] - column[i - 1]) * (x - s.x_mm[i - 1]) / (s.x_mm[i] - s.x_mm[i - 1]);
  return NAN;
}

/// Depth of both bodies in the middle, in units of a0^2 / (2 R).
double depth(const Played& run) {
  const auto &s = run.surface(Side::secondary), &p = run.surface(Side::primary);
  return (at(s, s.wear_depth_mm, 0.0) + at(p, p.wear_depth_mm, 0.0)) * 2.0 * LineContact::R /
         (LineContact::a0 * LineContact::a0);
}

/// The scene without the step named and those after it.
std::string up_to(const std::string& step, const Replacements& replacements) {
  const std::string text = scene_text("line_contact_gross_slip", replacements);
  const auto from = text.find("[[step]]\nname = \"" + step + "\"");
  if (from == std::string::npos) throw std::runtime_error("no step " + step);
  return text.substr(0, from);
}

void expect_line_book(const Played& run, double S) {
  EXPECT_LT(run.contact().ledger_relative_error.value(), 1e-9);
  const double area = run.contact().secondary.worn_area + run.contact().primary.worn_area;
  EXPECT_NEAR(area * 2.0 * LineContact::R / (LineContact::a0 * LineContact::a0 * LineContact::a0) /
                  (0.5 * std::numbers::pi * S),
              1.0, 1e-4);
  EXPECT_NEAR(run.contact().secondary.worn_area / run.contact().primary.worn_area, 2.0, 1e-9);
}

}  // namespace

/// At S = 0.1 depth and pressure in the middle lie on the universal curve, with half the elements of the case.
TEST(WearLine, ToATenth) {
  const Played run =
      played(up_to("to S = 1", {{line_zone, "half_width_mm = 0.06, depth_mm = 0.05, size_mm = 0.0036"}}));
  const auto& s = run.surface(Side::secondary);
  EXPECT_NEAR(depth(run) / 0.0984, 1.0, 0.01);
  EXPECT_NEAR(at(s, s.pressure_MPa, 0.0) / LineContact::p0 / 0.9681, 1.0, 0.01);
  expect_line_book(run, 0.1);
}

TEST(WearLine, ToOne) {
  const Played run = played(up_to("to S = 10", {{line_zone, "half_width_mm = 0.07, depth_mm = 0.05, size_mm = 0.0036"},
                                                {"cycles = 50\njump = 1", "cycles = 50\njump = 5"}}));
  const auto& s = run.surface(Side::secondary);
  EXPECT_NEAR(depth(run) / 0.8594, 1.0, 0.01);
  EXPECT_NEAR(at(s, s.pressure_MPa, 0.0) / LineContact::p0 / 0.7437, 1.0, 0.01);
  expect_line_book(run, 1.0);
}

/// Which body carries the multipliers matters no more than the mesh does: depth by 0.2 % at 20 elements across.
TEST(WearLine, SidesExchanged) {
  const auto ends = [](const std::string& size, bool exchanged) {
    Replacements r{{line_zone, "half_width_mm = 0.06, depth_mm = 0.05, size_mm = " + size},
                   {"cycles = 50\njump = 1", "cycles = 50\njump = 5"},
                   {rigid_holder, pressed_holder}};
    if (exchanged) {
      r.push_back({line_sides, "secondary = \"round\"\nprimary   = [\"face\"]"});
      r.push_back({"secondary_per_MPa = 2.0e-8, primary_per_MPa = 1.0e-8",
                   "secondary_per_MPa = 1.0e-8, primary_per_MPa = 2.0e-8"});
    }
    // On one mesh: with seven elements across, a fresh one would move the depth in the middle by some 9 %, and warn.
    return played(up_to("to S = 1", r) + "\n[remesh]\nautomatic = false\n");
  };
  const auto difference = [&](const std::string& size) {
    const Played one = ends(size, false), other = ends(size, true);
    EXPECT_NEAR(one.contact().secondary.worn_area / other.contact().primary.worn_area, 1.0, 1e-5);
    return std::abs(depth(one) / depth(other) - 1.0);
  };
  EXPECT_LT(difference("0.0072"), 0.02);
  EXPECT_LT(difference("0.0036"), 0.005);
}

}  // namespace reye::verification
