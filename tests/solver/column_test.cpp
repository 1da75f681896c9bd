#include <gtest/gtest.h>

#include "support/assembly.hpp"

namespace {

using namespace reye;
using base::Vec2;
using contact::ContactStatus;

struct Column {
  static constexpr double E = 2e5, nu = 0.3;                                           ///< E in MPa
  static constexpr double height = 10.0, press = 0.01, stroke = 1000.0;                ///< [mm]
  static constexpr double modulus = E * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));  ///< held sideways [MPa]
};

body::Support clamp() {
  auto s = support::fixed_edge("clamp", "bottom");
  s.rotation.drive = body::Drive::fixed;
  return s;
}

/// A column between walls that hold it laterally, pressed on a rigid floor that slides; wear is Archard's.
support::Assembly column(double k, double c0, double friction = 0.0) {
  support::Assembly a;
  a.meshes = {support::rectangle({.corner = {0, 0}, .size = {3, Column::height}, .nx = 3, .ny = 5}),
              support::rectangle({.corner = {-1, -1}, .size = {5, 1}, .nx = 2, .ny = 1})};
  a.inputs = {support::elastic(Column::E, Column::nu), support::elastic(Column::E, Column::nu)};
  a.inputs[0].supports = {support::guide("left", "left", 'x'), support::guide("right", "right", 'x'),
                          support::guide("head", "top", 'y', support::moved(-Column::press))};
  a.inputs[1].supports = {clamp()};
  a.rigid = {0, 1};
  a.modulus_MPa = Column::E;
  contact::ContactOptions o;
  o.friction = friction;
  o.wear = {wear::LawKind::archard, k, 0.0};
  o.imposed = true;
  o.c_normal = o.c_tangential = c0;
  support::touch(a, o, {0, "bottom"}, {1, "top"});
  return a;
}

// One step of stroke must leave p0 / (1 + kappa) exactly, whatever kappa and the factors of the decision; the
// corner nodes, held sideways by the walls, carry the same pressure.
TEST(column, one_step_is_exact) {
  const double p0 = Column::modulus * Column::press / Column::height;
  for (double kappa : {0.0, 0.27, 2.7, 2.7e3})
    for (double c0 : {0.1, 1.0, 10.0}) {
      const auto a = column(kappa * Column::height / (Column::modulus * Column::stroke), c0);
      const auto system = support::system_of(a);
      auto controls = support::controls_of(a, system);
      controls.contacts[0].imposed_slip = Column::stroke;
      const auto result = solver::Newton().solve(system, support::fresh(system), controls);
      ASSERT_TRUE(result.report.converged) << result.report.reason;
      for (int j = 0; j < 4; ++j) {
        const Vec2 t = support::traction(system.contacts[0], result.state.contacts[0], j);
        EXPECT_NEAR(t.x(), p0 / (1.0 + kappa), 1e-9 * p0 / (1.0 + kappa)) << kappa << " " << c0;
        EXPECT_EQ(result.state.contacts[0].status[j], ContactStatus::slip);
      }
    }
}

// Ten steps must follow the backward Euler sequence, p = p0 / (1 + kappa)^10, and remove k p s in each.
TEST(column, ten_steps_follow_the_sequence) {
  const double p0 = Column::modulus * Column::press / Column::height, k = 1e-7, ds = 100.0,
               kappa = Column::modulus / Column::height * k * ds;
  const auto a = column(k, 1.0);
  const auto system = support::system_of(a);
  solver::Newton newton;
  auto state = support::fresh(system);
  auto controls = support::controls_of(a, system);
  double depth = 0.0, p = p0;
  for (int step = 0; step < 10; ++step) {
    controls.contacts[0].imposed_slip = ds;
    const auto result = newton.solve(system, state, controls);
    ASSERT_TRUE(result.report.converged) << result.report.reason;
    state = result.state;
    p /= 1.0 + kappa;
    depth += k * p * ds;
  }
  EXPECT_NEAR(p, 24.815257, 1e-6);
  EXPECT_NEAR(depth, 9.0782905e-3, 1e-10);
  for (int j = 0; j < 4; ++j) {
    EXPECT_NEAR(support::traction(system.contacts[0], state.contacts[0], j).x(), p, 1e-9 * p);
    EXPECT_NEAR(state.contacts[0].pending_secondary[j] / system.contacts[0].secondary.area[j], depth, 1e-11);
  }
}

// A node held by a roller along the contact must keep its normal multiplier, and carry no shear where nothing slides,
// friction or not.
TEST(column, roller_keeps_the_normal_multiplier) {
  for (double friction : {0.0, 0.3}) {
    auto a = column(0.0, 1.0, friction);
    a.touches[0].options.wear = {};
    a.touches[0].options.imposed = friction == 0.0;
    const auto system = support::system_of(a);
    EXPECT_EQ(system.contacts[0].freedom[0].free, 1);
    EXPECT_EQ(system.contacts[0].cut[0], 0);
    const auto result = solver::Newton().solve(system, support::fresh(system), support::controls_of(a, system));
    ASSERT_TRUE(result.report.converged) << result.report.reason;
    for (int j : {0, 3}) EXPECT_EQ(support::traction(system.contacts[0], result.state.contacts[0], j).y(), 0.0);
    for (int j : {0, 3}) EXPECT_GT(support::traction(system.contacts[0], result.state.contacts[0], j).x(), 1.0);
  }
}

// Where sliding is imposed it must drag the roller's node as all others.
TEST(column, roller_feels_imposed_sliding) {
  const auto a = column(0.0, 1.0, 0.3);
  const auto system = support::system_of(a);
  const auto result = solver::Newton().solve(system, support::fresh(system), support::controls_of(a, system));
  ASSERT_TRUE(result.report.converged) << result.report.reason;
  for (int j = 0; j < 4; ++j) {
    const auto traction = support::traction(system.contacts[0], result.state.contacts[0], j);
    EXPECT_NEAR(std::abs(traction.y()) / traction.x(), 0.3, 1e-9);
  }
}

}  // namespace
