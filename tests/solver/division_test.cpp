#include <gtest/gtest.h>

#include <cmath>

#include "solver/blocks.hpp"

/// Two contacts that share their secondary side.
namespace {

using namespace reye;
using contact::ContactStatus;
using support::Assembly;

struct Joint {
  double at = 1.0;  ///< where one upper block ends and the other begins; nodes of the lower one are 1/3 apart
  double crown = 0.0;
  double drag = 0.0;
  double nu = 0.0;
  mesh::CellKind lower = mesh::CellKind::quad4;
  contact::DualOrder dual = contact::DualOrder::quadratic;
  std::array<contact::ContactOptions, 2> contacts{};
};

/// The lower block [0, 2] x [0, 1]; on its top two blocks side by side, each a contact of its own.
Assembly side_by_side(const Joint& j) {
  Assembly a;
  const auto crowned = support::mapped(
      support::rectangle({.corner = {0, 0}, .size = {2, 1}, .nx = 6, .ny = 3, .kind = j.lower}),
      [&](const base::Vec2& x) { return base::Vec2(x.x(), x.y() * (1.0 - j.crown * (x.x() - 1.0) * (x.x() - 1.0))); });
  a.meshes = {crowned, support::rectangle({.corner = {0.0, 1}, .size = {j.at, 1}, .nx = 4, .ny = 3}),
              support::rectangle({.corner = {j.at, 1}, .size = {2.0 - j.at, 1}, .nx = 5, .ny = 3})};
  a.inputs = {support::elastic(1000.0, j.nu), support::elastic(2000.0, j.nu), support::elastic(2000.0, j.nu)};
  a.inputs[0].supports = {support::fixed_edge("base", "bottom")};
  for (int b : {1, 2}) {
    a.inputs[b].supports = {support::fixed_edge("holder", "top")};
    a.inputs[b].supports[0].x = support::moved(j.drag);
    a.inputs[b].supports[0].y = support::moved(-0.03);
    auto options = j.contacts[b - 1];
    options.dual = j.dual;
    support::touch(a, options, {0, "top"}, {b, "bottom"});
  }
  return a;
}

solver::SolveResult solved(const Assembly& a) {
  solver::Newton newton({.chords = false});
  const auto system = support::system_of(a);
  return newton.solve(system, support::fresh(system), support::controls_of(a, system));
}

/// Force of a contact on its secondary side.
base::Vec2 force_of(const contact::ContactState& state) {
  base::Vec2 sum = base::Vec2::Zero();
  for (std::size_t j = 0; j < state.lambda.size(); ++j) sum += state.reference[j].carried() * state.lambda[j];
  return sum;
}

}  // namespace

// Where one primary side ends at a node and another begins, one pressure must pass exactly, and no node carries two
// multipliers.
TEST(division, uniform_pressure_across_a_joint_at_a_node) {
  for (const auto lower : {mesh::CellKind::quad4, mesh::CellKind::quad8})
    for (const auto dual : {contact::DualOrder::linear, contact::DualOrder::quadratic}) {
      Joint j{.at = 4.0 / 3.0, .lower = lower, .dual = dual};
      const auto a = side_by_side(j);
      const auto system = support::system_of(a);
      const auto result = solved(a);
      ASSERT_TRUE(result.report.converged) << result.report.reason;
      const double pressure = 0.03 / (1.0 / 1000.0 + 1.0 / 2000.0);
      int carrying = 0;
      for (int node = 0; node < system.contacts[0].secondary_count(); ++node) {
        const bool first = result.state.contacts[0].status[node] != ContactStatus::inactive;
        const bool second = result.state.contacts[1].status[node] != ContactStatus::inactive;
        EXPECT_FALSE(first && second) << node;
        carrying += first || second;
        for (int c : {0, 1}) {
          const double own = support::traction(system.contacts[c], result.state.contacts[c], node).x();
          EXPECT_NEAR(own, (c == 0 ? first : second) ? pressure : 0.0, 1e-9 * pressure) << c << node;
        }
      }
      EXPECT_GE(carrying, 7);
      EXPECT_NEAR(force_of(result.state.contacts[0]).norm(), pressure * 4.0 / 3.0, 1e-9 * pressure);
      EXPECT_NEAR(force_of(result.state.contacts[1]).norm(), pressure * 2.0 / 3.0, 1e-9 * pressure);
    }
}

// With a joint anywhere, friction in one contact, another in the other, and wear on all sides, Newton's last step must
// square the residual: the multipliers of both are eliminated in an order in which each node's balance is whole.
TEST(division, quadratic_across_a_joint_anywhere) {
  for (const double at : {0.9, 1.0, 1.1, 1.3, 4.0 / 3.0})
    for (const auto lower : {mesh::CellKind::quad4, mesh::CellKind::quad8})
      for (const auto dual : {contact::DualOrder::linear, contact::DualOrder::quadratic}) {
        Joint j{.at = at, .crown = 0.02, .drag = 0.05, .nu = 0.3, .lower = lower, .dual = dual};
        j.contacts[0].friction = 0.1;
        j.contacts[0].wear = {wear::LawKind::energy, 1e-3, 2e-3};
        j.contacts[1].friction = 0.3;
        j.contacts[1].wear = {wear::LawKind::archard, 2e-4, 0.0};
        const auto a = side_by_side(j);
        const auto system = support::system_of(a);
        const auto result = solved(a);
        ASSERT_TRUE(result.report.converged) << at << ' ' << result.report.reason;
        const auto& t = result.report.table;
        ASSERT_GE(t.size(), 3U);
        EXPECT_LT(support::residual(t.back()), std::max(1e-12, std::pow(support::residual(t[t.size() - 2]), 1.9)))
            << at;
        const auto reactions = solver::reactions(system, result.state, support::controls_of(a, system));
        for (int c : {0, 1}) {
          base::Vec2 held = base::Vec2::Zero();
          for (const auto& column : std::visit(
                   [](const auto& o) -> const auto& { return o.support_columns(); }, system.bodies[c + 1]))
            held += reactions[system.offset[c + 1] + column.column] * column.direction;
          EXPECT_LT((force_of(result.state.contacts[c]) + held).norm(), 1e-7) << at << ' ' << c;
        }
      }
}
