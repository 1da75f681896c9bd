#include <gtest/gtest.h>

#include "solver/blocks.hpp"

/// Secondary nodes that a support holds along the direction of sliding.
namespace {

using namespace reye;
using contact::ContactStatus;
using support::Assembly;
using support::residual;

/// A block [0.1, 1.8] x [1, 2], pressed on its top and dragged by its left side, on a flat one [0, 2] x [0, 1].
struct Dragged {
  static constexpr double mu = 0.3, press_mm = 2e-6;
  double drag = 1e-5;      ///< mm that the side moves along x
  double base_drag = 0.0;  ///< and the counter body, whose nodes all move so along x when it is not rigid
  double friction = mu;
  bool rigid_base = false;
};

/// So little pressed that its foot stays flat.
Assembly dragged(const Dragged& o) {
  Assembly a = support::blocks({.friction = o.friction, .crown = 0.0, .upper_secondary = true});
  a.rigid = {static_cast<char>(o.rigid_base), 0};
  a.inputs[0].supports = {support::fixed_edge("base", "bottom")};
  a.inputs[0].supports[0].x = support::moved(o.base_drag);
  if (o.rigid_base) a.inputs[0].supports[0].rotation.drive = body::Drive::fixed;
  a.inputs[1].supports = {support::guide("push", "top", 'y', support::moved(-Dragged::press_mm)),
                          support::guide("drag", "left", 'x', support::moved(o.drag))};
  return a;
}

struct Solved {
  solver::System system;
  solver::SolveResult result;
  double drive = 0.0, press = 0.0;  ///< forces of the two supports on the block

  const contact::ContactState& contact() const { return result.state.contacts[0]; }
  /// The secondary node at the dragged side.
  int side() const {
    int node = 0;
    for (int j = 0; j < system.contacts[0].secondary_count(); ++j)
      if (system.contacts[0].secondary.X[j].x() < system.contacts[0].secondary.X[node].x()) node = j;
    return node;
  }
};

Solved solve(const Assembly& a) {
  Solved s{support::system_of(a), {}, 0.0, 0.0};
  solver::Newton newton({.chords = false});
  const auto controls = support::controls_of(a, s.system);
  s.result = newton.solve(s.system, support::fresh(s.system), controls);
  EXPECT_TRUE(s.result.report.converged) << s.result.report.reason;
  if (!s.result.report.converged) return s;
  const auto forces = solver::reactions(s.system, s.result.state, controls);
  for (const auto& column : std::visit(
           [](const auto& b) -> const auto& { return b.support_columns(); }, s.system.bodies[1]))
    (column.support == 1 ? s.drive : s.press) += forces[s.system.offset[1] + column.column];
  return s;
}

// A block dragged by its side must be driven by mu N, the node at the side included, whatever lies under it.
TEST(held, a_dragged_side_feels_all_of_friction) {
  for (bool rigid_base : {false, true})
    for (double drag : {1e-5, -1e-5}) {
      const auto s = solve(dragged({.drag = drag, .rigid_base = rigid_base}));
      EXPECT_LT(s.press, -1e-4);
      EXPECT_NEAR(s.drive / (Dragged::mu * std::abs(s.press)), drag > 0.0 ? 1.0 : -1.0, rigid_base ? 1e-9 : 1e-5);
      EXPECT_EQ(s.contact().status[s.side()], ContactStatus::slip);
      EXPECT_GT(s.contact().energy_secondary[s.side()], 0.0);
    }
}

// So must one that rests while its counter body is dragged along.
TEST(held, the_counter_body_may_be_what_moves) {
  for (bool rigid_base : {false, true}) {
    const auto s = solve(dragged({.drag = 0.0, .base_drag = 1e-5, .rigid_base = rigid_base}));
    EXPECT_NEAR(s.drive / (Dragged::mu * std::abs(s.press)), -1.0, rigid_base ? 1e-9 : 1e-5);
  }
}

// Newton must converge quadratically with multipliers that a support takes.
TEST(held, quadratic) {
  for (bool rigid_base : {false, true}) {
    const auto table = solve(dragged({.rigid_base = rigid_base})).result.report.table;
    ASSERT_GE(table.size(), 3u);
    EXPECT_LT(residual(table.back()), std::max(1e-12, std::pow(residual(table[table.size() - 2]), 1.9)));
  }
}

// On a line that both sides cannot leave nothing slides, and no shear may act.
TEST(held, a_line_of_symmetry_carries_no_shear) {
  auto a = dragged({.drag = 0.0});
  a.inputs[0].supports.push_back(support::guide("symmetry", "left", 'x'));
  a.meshes[1] = support::rectangle({.corner = {0.0, 1}, .size = {1.7, 1}, .nx = 7, .ny = 3});
  const auto s = solve(a);
  const auto& lambda = s.contact().lambda[s.side()];
  EXPECT_GT(lambda.norm(), 1e-4);
  EXPECT_NEAR(base::cross(s.contact().normal[s.side()], lambda), 0.0, 1e-9 * lambda.norm());
  EXPECT_EQ(s.contact().status[s.side()], ContactStatus::stick);
}

// Without friction a held node must carry pressure along its normal alone, also where its free direction is another.
TEST(held, frictionless_pressure_is_normal) {
  auto a = dragged({.drag = 0.0, .friction = 0.0});
  a.meshes[1] = support::mapped(a.meshes[1], [](const base::Vec2& x) {  // its lower edge falls to the right
    return base::Vec2(x.x(), x.y() + (2.0 - x.y()) * 0.01 * (1.8 - x.x()));
  });
  const auto s = solve(a);
  const auto& state = s.contact();
  for (std::size_t j = 0; j < state.lambda.size(); ++j)
    EXPECT_NEAR(base::cross(state.normal[j], state.lambda[j]), 0.0, 1e-12);
  EXPECT_EQ(state.frictional_work, 0.0);
}

}  // namespace
