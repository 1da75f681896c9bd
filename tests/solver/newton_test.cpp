#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>

#include "base/errors.hpp"
#include "material/parameters.hpp"
#include "solver/blocks.hpp"

namespace {

using namespace reye;
using contact::ContactStatus;
using support::Assembly;
using support::BlocksOptions;
using support::residual;
using wear::LawKind;

std::string text(const std::vector<solver::Iteration>& table) {
  std::ostringstream s;
  s << std::scientific << std::setprecision(2);
  for (const auto& row : table)
    s << "\n  force " << row.force << "  condition " << row.condition << "  changes " << row.changes;
  return s.str();
}

/// The last step, with a settled active set, must square the residual (both relative): e <= e_before^1.9; one that
/// ends below 1e-12 is at rounding.
void expect_quadratic_tail(const solver::SolveReport& report) {
  ASSERT_TRUE(report.converged) << report.reason << text(report.table);
  const auto& t = report.table;
  ASSERT_GE(t.size(), 3u);
  const double last = residual(t[t.size() - 1]), before = residual(t[t.size() - 2]);
  EXPECT_EQ(t[t.size() - 2].changes, 0) << text(t);
  EXPECT_LT(last, std::max(1e-12, std::pow(before, 1.9))) << text(t);
}

struct Played {
  solver::SolverState state;
  solver::SolveReport report;
};

/// Newton's steps alone.
const solver::NewtonOptions no_chords{.chords = false};

/// One increment from rest, and one more that continues it.
Played play(const Assembly& a, double first = 1.0, double second = 1.2) {
  const auto system = support::system_of(a);
  solver::Newton newton(no_chords);
  const auto start = newton.solve(system, support::fresh(system), support::controls_of(a, system, first));
  expect_quadratic_tail(start.report);
  if (!start.report.converged) return {support::fresh(system), start.report};
  const auto next = newton.solve(system, start.state, support::controls_of(a, system, second));
  expect_quadratic_tail(next.report);
  return {next.report.converged ? next.state : start.state, next.report};
}

int count(const contact::ContactState& state, ContactStatus wanted) {
  int n = 0;
  for (auto s : state.status) n += s == wanted;
  return n;
}

// A frictionless press of curved blocks must converge quadratically.
TEST(newton, quadratic_frictionless) {
  const auto played = play(support::blocks({.press = 0.03, .angle = 0.4}));
  EXPECT_GT(count(played.state.contacts[0], ContactStatus::slip), 2);
}

// So must a dragged contact that sticks wholly.
TEST(newton, quadratic_in_stick) {
  const auto played = play(support::blocks({.friction = 5.0, .press = 0.03, .drag = 0.01, .angle = 0.4}));
  EXPECT_GT(count(played.state.contacts[0], ContactStatus::stick), 2);
  EXPECT_EQ(count(played.state.contacts[0], ContactStatus::slip), 0);
}

// So must one that slips wholly, by a third of a facet.
TEST(newton, quadratic_in_slip) {
  const auto played = play(support::blocks({.friction = 0.2, .press = 0.03, .drag = 0.1, .angle = 0.4}));
  EXPECT_GT(count(played.state.contacts[0], ContactStatus::slip), 2);
  EXPECT_EQ(count(played.state.contacts[0], ContactStatus::stick), 0);
}

// So must slip with wear on both sides that takes a good part of the overlap.
TEST(newton, quadratic_with_wear_on_both_sides) {
  const wear::Law law{LawKind::energy, 1e-3, 2e-3};
  const auto played = play(support::blocks({.friction = 0.3, .wear = law, .press = 0.03, .drag = 0.1, .angle = 0.4}));
  EXPECT_GT(count(played.state.contacts[0], ContactStatus::slip), 2);
  double depth = 0.0;
  for (double v : played.state.contacts[0].removed_secondary) depth = std::max(depth, v * 3.0);
  EXPECT_GT(depth, 1e-4);
}

// So must all of that with cells of second order and either kind of multipliers.
TEST(newton, quadratic_with_cells_of_second_order) {
  for (auto dual : {contact::DualOrder::quadratic, contact::DualOrder::linear})
    for (auto upper : {mesh::CellKind::tri6, mesh::CellKind::quad4}) {
      BlocksOptions o{.friction = 0.2, .wear = {LawKind::energy, 1e-3, 2e-3}, .press = 0.03, .drag = 0.1, .angle = 0.4};
      o.lower = mesh::CellKind::quad8;
      o.upper = upper;
      o.dual = dual;
      const auto played = play(support::blocks(o));
      EXPECT_GT(count(played.state.contacts[0], ContactStatus::slip), 2);
      o.wear = {};
      play(support::blocks(o));
    }
}

// So must contact with a rigid body that turns by two degrees, rolling and sliding over the crown.
TEST(newton, quadratic_with_a_turning_rigid_body) {
  BlocksOptions o{.friction = 0.3, .wear = {LawKind::energy, 1e-3, 2e-3}, .press = 0.02, .drag = 0.05};
  o.crown = 0.1;
  o.upper_rigid = true;
  o.rotation = 0.035;
  const auto played = play(support::blocks(o));
  EXPECT_GT(played.state.contacts[0].frictional_work, 0.0);
}

// Chords must lead to the state that Newton's steps lead to, with fewer matrices, wear included.
TEST(newton, chords_change_nothing_but_the_cost) {
  const wear::Law law{LawKind::energy, 1e-3, 2e-3};
  const auto a = support::blocks({.friction = 0.3, .wear = law, .press = 0.03, .drag = 0.1, .angle = 0.4});
  const auto system = support::system_of(a);
  const auto controls = support::controls_of(a, system);
  const auto steps = solver::Newton(no_chords).solve(system, support::fresh(system), controls);
  const auto chords = solver::Newton().solve(system, support::fresh(system), controls);
  ASSERT_TRUE(steps.report.converged && chords.report.converged) << chords.report.reason;
  EXPECT_EQ(steps.report.matrices, steps.report.solves);
  EXPECT_LT(chords.report.matrices, steps.report.matrices);
  EXPECT_LT((chords.state.q.high - steps.state.q.high).norm(), 1e-11 * steps.state.q.high.norm());
  double largest = 0.0, difference = 0.0;
  for (std::size_t j = 0; j < steps.state.contacts[0].lambda.size(); ++j) {
    largest = std::max(largest, steps.state.contacts[0].lambda[j].norm());
    difference = std::max(difference, (chords.state.contacts[0].lambda[j] - steps.state.contacts[0].lambda[j]).norm());
  }
  EXPECT_LT(difference, 1e-9 * largest);
}

// So must tangents that nonlinear bodies keep, with fewer of them.
TEST(newton, kept_tangents_change_nothing_but_the_cost) {
  auto a = support::blocks(
      {.friction = 0.3, .wear = {LawKind::energy, 1e-3, 2e-3}, .press = 0.03, .drag = 0.1, .angle = 0.4});
  for (auto& input : a.inputs) {
    input.kinematics = base::Kinematics::finite;
    input.material = material::NeoHookean{1000.0, 0.3, material::Volumetric::log_squared};
  }
  const auto system = support::system_of(a);
  const auto controls = support::controls_of(a, system);
  const auto steps = solver::Newton(no_chords).solve(system, support::fresh(system), controls);
  const auto kept = solver::Newton().solve(system, support::fresh(system), controls);
  ASSERT_TRUE(steps.report.converged && kept.report.converged) << kept.report.reason;
  EXPECT_EQ(steps.report.tangents + 1, static_cast<int>(steps.report.table.size())) << text(steps.report.table);
  EXPECT_LT(kept.report.tangents, steps.report.tangents) << text(kept.report.table);
  EXPECT_LT((kept.state.q.high - steps.state.q.high).norm(), 1e-10 * steps.state.q.high.norm());
  for (std::size_t b = 0; b < steps.state.interiors.size(); ++b) {
    const auto &y = kept.state.interiors[b].y.high, &exact = steps.state.interiors[b].y.high;
    EXPECT_LT((y - exact).norm(), 1e-10 * exact.norm());
  }
}

// A solve that runs out of iterations must be a result that says so, and keeps its table.
TEST(newton, too_few_iterations_are_a_reason) {
  const auto a = support::blocks({.friction = 0.3, .drag = 0.02});
  const auto system = support::system_of(a);
  solver::Newton newton({.max_iterations = 1});
  const auto result = newton.solve(system, support::fresh(system), support::controls_of(a, system));
  EXPECT_FALSE(result.report.converged);
  EXPECT_EQ(result.report.reason.rfind("no convergence in 1 iterations", 0), 0u) << result.report.reason;
  EXPECT_EQ(result.report.table.size(), 2u);
  EXPECT_NE(result.report.reason.find(") mm of contact"), std::string::npos) << result.report.reason;
}

// A body that nothing holds must end as a result with a reason too, never as a crash.
TEST(newton, a_singular_system_is_a_reason) {
  auto a = support::blocks({});
  a.inputs[1].supports.clear();
  a.inputs[1].boundary_loads = {{"p", "top", 1.0, {0.0, 0.0}, {}, ""}};
  a.meshes[1] = support::mapped(a.meshes[1], [](const base::Vec2& x) { return base::Vec2(x.x(), x.y() + 0.1); });
  const auto system = support::system_of(a);
  const auto result = solver::Newton().solve(system, support::fresh(system), support::controls_of(a, system));
  EXPECT_FALSE(result.report.converged);
  EXPECT_NE(result.report.reason.find("is unsupported"), std::string::npos) << result.report.reason;
}

/// Blocks in another unit of length, forces the same; the upper one is held by an edge that may turn.
Assembly in_unit(double length) {
  auto a = support::blocks({.press = 0.03 * length});
  for (auto& mesh : a.meshes) mesh = support::mapped(mesh, [&](const base::Vec2& x) { return base::Vec2(length * x); });
  a.inputs[0].material = support::elastic(1000.0 / (length * length), 0.3).material;
  a.inputs[1].material = support::elastic(2000.0 / (length * length), 0.25).material;
  a.modulus_MPa /= length * length;
  a.inputs[1].supports[0].rigid = true;
  a.inputs[1].supports[0].rotation = {body::Drive::fixed};
  return a;
}

// What counts as balanced must not depend on the unit of length, in which moments outgrow forces: every residual above
// rounding is the same.
TEST(newton, residuals_know_no_unit) {
  const auto table = [](const Assembly& a) {
    const auto system = support::system_of(a);
    return solver::Newton().solve(system, support::fresh(system), support::controls_of(a, system)).report.table;
  };
  const auto plain = table(in_unit(1.0));
  for (double length : {1e-6, 1e6}) {
    const auto other = table(in_unit(length));
    ASSERT_EQ(plain.size(), other.size()) << length << text(plain) << text(other);
    for (std::size_t i = 0; i < plain.size(); ++i) {
      EXPECT_NEAR(other[i].force, plain[i].force, 1e-3 * plain[i].force + 1e-12)
          << length << text(plain) << text(other);
      EXPECT_NEAR(other[i].condition, plain[i].condition, 1e-3 * plain[i].condition + 1e-12) << length;
    }
  }
}

// Contacts in a chain must be eliminated before those whose secondary nodes they load.
TEST(order, chain) { EXPECT_EQ(support::system_of(support::chain(0.0)).elimination, (std::vector<int>{0, 2, 1})); }

// Contacts whose sides load each other in a ring must be refused as bad input.
TEST(order, ring_is_refused) {
  auto a = support::blocks({});
  support::touch(a, {}, {1, "bottom"}, {0, "top"});
  EXPECT_THROW(support::system_of(a), base::InputError);
}

}  // namespace
