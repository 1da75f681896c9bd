#include <gtest/gtest.h>

#include <numbers>

#include "elastic.hpp"
#include "support/assembly.hpp"
#include "support/surfaces.hpp"

namespace {

using namespace reye;
using base::Vec2;
using contact::ContactStatus;
using support::Assembly;
using support::Elastic;

/// The lower block is [0, width] x [-1, 0], the upper one [a, b] x [0, 1].
struct Patch {
  static constexpr double E = Elastic::E, nu = Elastic::nu, G = E / (2.0 * (1.0 + nu));
  static constexpr double p = 10.0;                           ///< [MPa]
  static constexpr double lateral = nu * (1.0 + nu) * p / E;  ///< strain along the contact under p, free sideways

  int upper = 3, lower = 2;
  double a = 0.0, b = 2.0, width = 2.0;
  double shear = 0.0, friction = 0.0;
  double slide = 0.0;  ///< of the upper block along the contact
  double angle = 0.0;  ///< [degrees] of the whole scene
  bool upper_secondary = true;
  mesh::CellKind lower_kind = mesh::CellKind::quad4, upper_kind = mesh::CellKind::quad4;
  contact::DualOrder dual = contact::DualOrder::quadratic;
};

fem::BoundaryLoad load(const Patch& s, const std::string& edge, double x, double y) {
  fem::BoundaryLoad l;
  l.name = l.edge = edge;
  l.traction_MPa = support::turned({x, y}, s.angle * std::numbers::pi / 180.0);
  return l;
}

/// Tractions of the uniform state sigma_yy = -p, sigma_xy = shear on the two sides of a block.
std::vector<fem::BoundaryLoad> sides(const Patch& s) {
  return {load(s, "right", 0.0, s.shear), load(s, "left", 0.0, -s.shear)};
}

body::BodyInput lower_input(const Patch& s) {
  auto in = support::elastic(Patch::E, Patch::nu);
  in.supports = {support::guide("floor", "bottom", 'y', {body::Drive::fixed}, s.angle),
                 support::pin("pin", support::turned(Vec2(0, -1), s.angle * std::numbers::pi / 180.0),
                              support::moved(-Patch::lateral * s.a - s.shear / Patch::G), s.angle)};
  in.boundary_loads = sides(s);
  in.boundary_loads.push_back(load(s, "bottom", -s.shear, 0.0));
  const double left = s.a + s.slide / (1.0 + Patch::lateral), right = left + s.b - s.a;
  for (const auto& [from, to] : {std::pair{0.0, left}, {right, s.width}}) {
    if (to - from < 1e-9) continue;
    in.boundary_loads.push_back(load(s, "top", s.shear, -Patch::p));
    in.boundary_loads.back().interval_mm = {from, to};
  }
  return in;
}

body::BodyInput upper_input(const Patch& s) {
  auto in = support::elastic(Patch::E, Patch::nu);
  in.supports = {support::pin("pin", support::turned(Vec2(s.a, 1), s.angle * std::numbers::pi / 180.0),
                              support::moved(s.shear / Patch::G + s.slide), s.angle)};
  in.boundary_loads = sides(s);
  in.boundary_loads.push_back(load(s, "top", s.shear, -Patch::p));
  return in;
}

Assembly assembly(const Patch& s) {
  const double angle = s.angle * std::numbers::pi / 180.0;
  Assembly a;
  a.meshes = {support::turned(support::rectangle({.corner = {0, -1},
                                                  .size = {s.width, 1},
                                                  .nx = s.lower,
                                                  .ny = 2,
                                                  .kind = s.lower_kind,
                                                  .distortion = 0.4}),
                              angle),
              support::turned(support::rectangle({.corner = {s.a, 0},
                                                  .size = {s.b - s.a, 1},
                                                  .nx = s.upper,
                                                  .ny = 3,
                                                  .kind = s.upper_kind,
                                                  .distortion = 0.4}),
                              angle)};
  a.inputs = {lower_input(s), upper_input(s)};
  contact::ContactOptions o;
  o.friction = s.friction;
  o.dual = s.dual;
  support::touch_either(a, o, s.upper_secondary, {1, "bottom"}, {0, "top"});
  return a;
}

/// Every active node must carry (p, shear) to 1e-10 of p; returns how many there are. In second order D falls with the
/// cube of the share of a facet that is covered, and the rounding of its node's force counts A / D times.
int expect_uniform(const Patch& s, ContactStatus status) {
  const auto a = assembly(s);
  const auto system = support::system_of(a);
  solver::Newton newton({.max_iterations = 30, .force_tolerance = 1e-12, .condition_tolerance = 1e-11});
  const auto result = newton.solve(system, support::fresh(system), support::controls_of(a, system));
  EXPECT_TRUE(result.report.converged) << result.report.reason;
  if (!result.report.converged) return 0;
  int active = 0;
  const auto& state = result.state.contacts[0];
  for (int j = 0; j < system.contacts[0].secondary_count(); ++j) {
    if (state.status[j] == ContactStatus::inactive) continue;
    ++active;
    const Vec2 t = support::traction(system.contacts[0], state, j);
    const auto& secondary = system.contacts[0].secondary;
    const double rounding = secondary.order == 1 ? 1.0 : secondary.area[j] / state.reference[j].D;
    EXPECT_NEAR(t.x(), Patch::p, 1e-10 * Patch::p * rounding) << "node " << j;
    EXPECT_NEAR(t.y(), s.shear, 1e-10 * Patch::p * rounding) << "node " << j;
    EXPECT_EQ(state.status[j], status) << "node " << j;
  }
  return active;
}

/// Cells of second order on both sides or one, with either kind of multipliers.
std::vector<Patch> of_second_order(Patch s) {
  using mesh::CellKind;
  std::vector<Patch> all;
  for (const auto& [lower, upper] : {std::pair{CellKind::quad8, CellKind::quad8},
                                     {CellKind::tri6, CellKind::quad4},
                                     {CellKind::quad4, CellKind::tri6}})
    for (auto dual : {contact::DualOrder::quadratic, contact::DualOrder::linear}) {
      s.lower_kind = lower;
      s.upper_kind = upper;
      s.dual = dual;
      all.push_back(s);
    }
  return all;
}

/// Both side choices at 0 and 30 degrees.
template <class Check>
void every_way(Patch s, Check check) {
  for (bool upper_secondary : {true, false})
    for (double angle : {0.0, 30.0}) {
      s.upper_secondary = upper_secondary;
      s.angle = angle;
      SCOPED_TRACE(std::to_string(s.upper) + " on " + std::to_string(s.lower) + ", " +
                   (upper_secondary ? "upper" : "lower") + " secondary, " + std::to_string(angle) + " degrees");
      check(s);
    }
}

constexpr std::pair<int, int> meshes[] = {{2, 3}, {3, 2}, {7, 5}, {5, 7}};

// Pressure must pass uniformly between blocks of 2:3 and 7:5 facets.
TEST(patch, uniform_pressure) {
  for (const auto& [upper, lower] : meshes)
    every_way({.upper = upper, .lower = lower}, [](const Patch& s) {
      EXPECT_EQ(expect_uniform(s, ContactStatus::slip), (s.upper_secondary ? s.upper : s.lower) + 1);
    });
}

// So it must where facets are covered in part and the rest carries the pressure as a load.
TEST(patch, partly_covered) {
  for (const auto& [upper, lower] : meshes)
    every_way({.upper = upper, .lower = lower, .a = 0.7, .b = 2.23, .width = 3.1},
              [](const Patch& s) { EXPECT_GE(expect_uniform(s, ContactStatus::slip), 3); });
}

// Shear below the friction bound must pass uniformly, all nodes sticking.
TEST(patch, stick) {
  for (const auto& [upper, lower] : meshes) {
    const auto check = [](const Patch& s) { EXPECT_GE(expect_uniform(s, ContactStatus::stick), 3); };
    every_way({.upper = upper, .lower = lower, .shear = 2.0, .friction = 0.3}, check);
    every_way({.upper = upper, .lower = lower, .a = 0.7, .b = 2.23, .width = 3.1, .shear = -2.0, .friction = 0.3},
              check);
  }
}

// Shear at the friction bound must do so while the upper block slides. By little: the first iteration takes the
// contact as sticking, and a block that is held by contact alone would tip over under the shear of a long slide.
TEST(patch, slip) {
  for (const auto& [upper, lower] : meshes)
    for (double sign : {1.0, -1.0})
      every_way({.upper = upper,
                 .lower = lower,
                 .a = 0.7,
                 .b = 2.23,
                 .width = 3.1,
                 .shear = sign * 3.0,
                 .friction = 0.3,
                 .slide = sign * 0.01},
                [](const Patch& s) { EXPECT_GE(expect_uniform(s, ContactStatus::slip), 3); });
}

// All of that must hold for cells of second order, against each other and against cells of first order.
TEST(patch, second_order) {
  const auto pressure = [](const Patch& s) { EXPECT_GE(expect_uniform(s, ContactStatus::slip), 3); };
  const auto shear = [](const Patch& s) { EXPECT_GE(expect_uniform(s, ContactStatus::stick), 3); };
  for (const auto& [upper, lower] : {std::pair{2, 3}, {7, 5}}) {
    for (const auto& s : of_second_order({.upper = upper, .lower = lower})) every_way(s, pressure);
    for (const auto& s : of_second_order({.upper = upper, .lower = lower, .a = 0.7, .b = 2.23, .width = 3.1}))
      every_way(s, pressure);
    for (const auto& s : of_second_order(
             {.upper = upper, .lower = lower, .a = 0.7, .b = 2.23, .width = 3.1, .shear = -2.0, .friction = 0.3}))
      every_way(s, shear);
  }
}

}  // namespace
