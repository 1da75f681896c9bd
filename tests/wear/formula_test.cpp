#include "wear/formula.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/dual.hpp"
#include "wear/law.hpp"

namespace {

using namespace reye;
using wear::Formula;
using wear::Place;
using wear::Variable;

// A formula must give the value of its variables, and know which of them it reads.
TEST(Formula, ValueAndVariables) {
  const Formula f("2*pressure_MPa + depth_mm/4 + (cycle > 10 ? 1 : 0)");
  EXPECT_DOUBLE_EQ(f.at({.pressure = 3.0, .depth = 8.0}), 8.0);
  EXPECT_DOUBLE_EQ(f.at({.pressure = 3.0, .depth = 8.0, .cycle = 11.0}), 9.0);
  EXPECT_TRUE(f.uses(Variable::pressure) && f.uses(Variable::depth) && f.uses(Variable::cycle));
  EXPECT_FALSE(f.uses(Variable::speed) || f.uses(Variable::path));
  EXPECT_FALSE(static_cast<bool>(Formula()));
  const Formula copy = f;
  EXPECT_EQ(copy.text(), f.text());
}

// What cannot be a coefficient must be refused with the reason: grammar, unknown names, assignments, values at the
// start that are negative or not finite.
TEST(Formula, Refused) {
  const auto says = [](const std::string& text, const std::string& words) {
    EXPECT_NE(wear::broken_formula(text).find(words), std::string::npos) << text << ": " << wear::broken_formula(text);
  };
  says("2*", "Unexpected end of expression");
  says("2*(1+", "Unexpected end of expression");
  says("2*pressure", "\"pressure\"");
  says("pressure_MPa = 3", "assigns");
  says("1, 2", "2 parts");
  says("\"text\"", "");
  EXPECT_FALSE(wear::broken_formula("\"text\"").empty());
  says("-1e-6", "not negative");
  says("1/path_mm", "finite");
  says("sqrt(-1)", "finite");
  says("log(depth_mm)", "finite");
  says(std::string(3000, '1'), "2000");
  EXPECT_FALSE(wear::broken_formula("").empty());
  for (const char* fine : {"0.3", "1e-6*(depth_mm<=0.002) + 3e-5*(depth_mm>0.002)", "max(0, 1-path_mm/1e4)",
                           "pressure_MPa>=2 && cycle!=3 ? 1 : 2"})
    EXPECT_EQ(wear::broken_formula(fine), "") << fine;
}

// A value that is refused during a run must be named with its formula and its place.
TEST(Formula, NamesThePlace) {
  const Formula f("1 - path_mm/100");
  try {
    f.at({.path = 150.0});
    FAIL();
  } catch (const wear::FormulaError& error) {
    EXPECT_EQ(std::string(error.what()),
              "the formula \"1 - path_mm/100\" is -0.5 at path_mm = 150; it must be finite and not negative");
  }
}

// Slopes must be those of the formula to 1e-11, and zero where pressure or speed is raised to its least value.
TEST(Formula, Slope) {
  const Formula f("1e-6*(pressure_MPa/50)^0.7*exp(-speed_mm_per_s/20)");
  const Place at{.pressure = 80.0, .speed = 13.0};
  EXPECT_NEAR(f.slope(at, Variable::pressure) / (f.at(at) * 0.7 / 80.0), 1.0, 1e-11);
  EXPECT_NEAR(f.slope(at, Variable::speed) / (-f.at(at) / 20.0), 1.0, 1e-11);
  EXPECT_EQ(f.slope(at, Variable::depth), 0.0);
  EXPECT_EQ(f.slope({.pressure = -3.0, .speed = 1.0}, Variable::pressure), 0.0);
  EXPECT_GT(f.at({.pressure = -3.0, .speed = 1.0}), 0.0);
}

// Depth must grow as its differential equation asks: exponentials of depth and of path, and two coefficients with the
// change inside the increment, to 1e-12.
TEST(Growth, ClosedForms) {
  const double unit = 1e-3, load = 40.0;
  const auto grown = [&](const std::string& text, const Place& start = {}, double path = 0.0) {
    return wear::growth(Formula(text), unit, start, {load, path});
  };
  EXPECT_DOUBLE_EQ(grown("2"), 2.0 * unit * load);
  EXPECT_NEAR(grown("1 + depth_mm/0.01") / (0.01 * std::expm1(unit * load / 0.01)), 1.0, 1e-12);
  EXPECT_NEAR(
      grown("exp(-path_mm/3)", {.path = 1.0}, 5.0) / (unit * load * 0.6 * (std::exp(-1.0 / 3) - std::exp(-2.0))), 1.0,
      1e-12);
  const double before = 0.013 / (unit * 0.5);  // load that takes the coating off
  EXPECT_NEAR(grown("depth_mm < 0.02 ? 0.5 : 3", {.depth = 0.007}) / (0.013 + 3.0 * unit * (load - before)), 1.0,
              1e-12);
  EXPECT_EQ(wear::growth(Formula("depth_mm"), unit, {}, {load, 0.0}), 0.0);
}

// The derivatives of the removed volumes must be those of differences, whatever the formula reads.
TEST(Growth, Derivatives) {
  using Four = base::Dual<4>;
  for (const char* text :
       {"1 + pressure_MPa/50", "exp(-speed_mm_per_s/5)", "1 + depth_mm/0.01", "exp(-path_mm/3)*(1+depth_mm)",
        "depth_mm < 0.02 ? 0.5 : 3", "(depth_mm < 0.02 ? 0.5 : 3)*pressure_MPa^0.3/(1+path_mm)"}) {
    wear::Law law{.kind = wear::LawKind::archard, .secondary = 1e-3, .primary = 2e-3};
    law.secondary_formula = law.primary_formula = Formula(text);
    const wear::Start start{.jump = 3.0,
                            .duration_s = 0.1,
                            .energy = 0.0,
                            .area = 0.4,
                            .path = 1.0,
                            .cycle = 2.0,
                            .depth_secondary = 0.011,
                            .depth_primary = 0.0};
    const auto volumes = [&](const auto& p, const auto& t, const auto& u, const auto& D) {
      return wear::worn(law, wear::along_a_line(p, t, u, D), start);
    };
    const std::array<double, 4> x{20.0, 6.0, 0.13, 0.35};
    const auto dual =
        volumes(Four::variable(x[0], 0), Four::variable(x[1], 1), Four::variable(x[2], 2), Four::variable(x[3], 3));
    for (int i = 0; i < 4; ++i) {
      const double h = 1e-5 * x[i];
      auto above = x, below = x;
      above[i] += h;
      below[i] -= h;
      const auto a = volumes(above[0], above[1], above[2], above[3]),
                 b = volumes(below[0], below[1], below[2], below[3]);
      const double scale = dual.secondary.v / x[i];
      EXPECT_NEAR(dual.secondary.d[i], (a.secondary - b.secondary) / (2.0 * h), 1e-6 * scale) << text << ", " << i;
      EXPECT_NEAR(dual.primary.d[i], (a.primary - b.primary) / (2.0 * h), 1e-6 * dual.primary.v / x[i]) << text << i;
    }
  }
}

// A rate per sliding distance must remove rate x distance x length, whatever the pressure.
TEST(Growth, RatePerDistance) {
  const wear::Law law{.kind = wear::LawKind::rate, .secondary = 1e-6};
  const auto worn = wear::worn(law, wear::along_a_line(7.0, 2.0, -0.3, 0.5), {.jump = 10.0, .area = 0.5});
  EXPECT_DOUBLE_EQ(worn.secondary, 1e-6 * 10.0 * 0.3);
  EXPECT_EQ(worn.primary, 0.0);
}

}  // namespace
