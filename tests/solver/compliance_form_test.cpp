#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "solver/blocks.hpp"

namespace {

using namespace reye;
using support::Assembly;
using support::residual;
using wear::LawKind;

struct Options {
  bool by_force = true;  ///< pressed by a force on its support, else by a motion of it
  wear::Law wear = {};
  double friction = 0.3;
  double crown = 0.005;  ///< curvature of the lower block [1/mm], half of it
  mesh::CellKind kind = mesh::CellKind::quad4;
  contact::DualOrder dual = contact::DualOrder::quadratic;
};

/// A crowned block under a wide flat one that is pressed on its middle and dragged: contact is a small part of both.
Assembly wide(const Options& o, double press, double drag) {
  Assembly a;
  a.meshes = {support::mapped(support::rectangle({.corner = {0, 0}, .size = {4, 1}, .nx = 60, .ny = 5, .kind = o.kind}),
                              [&](const base::Vec2& x) {
                                return base::Vec2(x.x(), x.y() * (1.0 - o.crown * (x.x() - 2.0) * (x.x() - 2.0)));
                              }),
              support::rectangle({.corner = {-0.5, 1}, .size = {5, 1}, .nx = 80, .ny = 5, .kind = o.kind})};
  a.inputs = {support::elastic(1000.0, 0.3), support::elastic(2000.0, 0.25)};
  a.inputs[0].supports = {support::fixed_edge("base", "bottom")};
  a.inputs[1].supports = {support::fixed_edge("holder", "top")};
  auto& holder = a.inputs[1].supports[0];
  holder.x = support::moved(drag);
  holder.y = support::moved(-press);
  holder.rotation.drive = body::Drive::fixed;
  if (o.by_force) holder.y.drive = body::Drive::loaded;
  contact::ContactOptions c;
  c.friction = o.friction;
  c.wear = o.wear;
  c.dual = o.dual;
  support::touch(a, c, {0, "top"}, {1, "bottom"});
  return a;
}

/// A stroke forth and back in increments, after two that press.
struct Stroke {
  std::vector<solver::SolveReport> reports;
  solver::SolverState end;
};

Stroke played(const Options& o, double press, double drag, bool chords) {
  const auto system = support::system_of(wide(o, press, drag));
  solver::NewtonOptions options;
  options.chords = chords;
  solver::Newton newton(options);
  Stroke stroke{{}, support::fresh(system)};
  const std::vector<std::pair<double, double>> ways{{0.5, 0.0}, {1.0, 0.0}, {1.0, 0.5},
                                                    {1.0, 1.0}, {1.0, 0.2}, {1.0, -1.0}};
  for (const auto& [pressed, dragged] : ways) {
    auto controls = support::controls_of(wide(o, pressed * press, dragged * drag), system);
    controls.contacts[0].jump = 20.0;
    controls.contacts[0].wear = pressed == 1.0;
    auto result = newton.solve(system, stroke.end, controls);
    EXPECT_TRUE(result.report.converged) << result.report.reason;
    stroke.reports.push_back(result.report);
    if (!result.report.converged) break;
    stroke.end = std::move(result.state);
  }
  return stroke;
}

int in_compliance_form(const Stroke& stroke) {
  int count = 0;
  for (const auto& report : stroke.reports) count += report.compliant;
  return count;
}

void expect_same(const solver::SolverState& one, const solver::SolverState& other) {
  EXPECT_LT((one.q.high - other.q.high).lpNorm<Eigen::Infinity>(), 1e-9 * other.q.high.lpNorm<Eigen::Infinity>());
  double largest = 0.0, apart = 0.0, deepest = 0.0, deeper = 0.0;
  for (std::size_t j = 0; j < other.contacts[0].lambda.size(); ++j) {
    largest = std::max(largest, other.contacts[0].lambda[j].norm());
    apart = std::max(apart, (one.contacts[0].lambda[j] - other.contacts[0].lambda[j]).norm());
    deepest = std::max(deepest, other.contacts[0].removed_secondary[j]);
    deeper = std::max(deeper, std::abs(one.contacts[0].removed_secondary[j] - other.contacts[0].removed_secondary[j]));
  }
  EXPECT_GT(largest, 1.0);
  EXPECT_LT(apart, 1e-9 * largest);
  EXPECT_LE(deeper, 1e-9 * deepest);
}

// In compliance form Newton must find the states of the exact matrix: a support that a force presses or one that is
// moved, with wear on both sides and without, cells of first and second order, both kinds of multipliers.
TEST(compliance_form, finds_the_states_of_the_exact_matrix) {
  const wear::Law worn{LawKind::energy, 4e-4, 7e-4};
  const auto quad8 = mesh::CellKind::quad8;
  for (const auto& [what, o, press] : std::vector<std::tuple<std::string, Options, double>>{
           {"force", {}, 1.4},
           {"motion", {.by_force = false}, 0.002},
           {"no friction", {.friction = 0.0}, 1.4},
           {"wear", {.wear = worn}, 1.4},
           {"second order", {.wear = worn, .kind = quad8}, 1.4},
           {"linear multipliers", {.wear = worn, .kind = quad8, .dual = contact::DualOrder::linear}, 1.4}}) {
    SCOPED_TRACE(what);
    const auto quick = played(o, press, 0.02, true), exact = played(o, press, 0.02, false);
    EXPECT_GT(in_compliance_form(quick), 4);
    EXPECT_EQ(in_compliance_form(exact), 0);
    expect_same(quick.end, exact.end);
  }
}

// Steps in compliance form must gain a factor of twenty or more each once no node changes status, wear included: what
// they leave out is of the order of pressure over modulus.
TEST(compliance_form, gains_a_constant_factor) {
  const auto stroke = played({.wear = {LawKind::energy, 4e-4, 7e-4}}, 1.4, 0.02, true);
  int judged = 0;
  for (const auto& report : stroke.reports) {
    if (report.compliant < report.matrices) continue;  // an exact matrix gains more
    const auto& table = report.table;
    for (std::size_t k = 1; k < table.size(); ++k) {
      if (table[k].changes > 0 || residual(table[k]) < 1e-12) continue;
      EXPECT_LT(residual(table[k]), 0.05 * residual(table[k - 1])) << k;
      ++judged;
    }
  }
  EXPECT_GT(judged, 8);
}

// A body that contact alone holds has no compliance: Newton must take the whole matrix, and converge.
TEST(compliance_form, needs_bodies_that_are_held) {
  auto a = wide({}, 1.4, 0.0);
  a.inputs[1].supports = {support::pin("middle", {2.0, 2.0}), support::pin("inside", {2.0, 1.4})};
  a.inputs[1].boundary_loads = {{"press", "top", 0.0, base::Vec2(0.0, -0.3), {}, {}}};
  const auto system = support::system_of(a);
  solver::Newton newton;
  auto state = support::fresh(system);
  for (double factor : {0.5, 0.6, 0.7}) {
    auto result = newton.solve(system, state, support::controls_of(a, system, factor));
    ASSERT_TRUE(result.report.converged) << result.report.reason;
    EXPECT_EQ(result.report.compliant, 0);
    state = std::move(result.state);
  }
}

// Where pressure is not small against the modulus steps in compliance form gain little: Newton must go over to the
// exact matrix within an increment, and find the states of exact matrices in less than twice their steps.
TEST(compliance_form, yields_to_the_exact_matrix_where_it_gains_little) {
  const Options o{.by_force = false, .crown = 0.2};
  const auto quick = played(o, 0.1, 0.1, true), exact = played(o, 0.1, 0.1, false);
  int solves = 0, of_exact = 0, gone_over = 0;
  for (std::size_t k = 0; k < quick.reports.size(); ++k) {
    const auto& report = quick.reports[k];
    solves += report.solves;
    gone_over += report.compliant > 0 && report.compliant < report.matrices;
    of_exact += exact.reports[k].solves;
  }
  EXPECT_GE(gone_over, 2);
  EXPECT_LT(solves, 2 * of_exact);
  expect_same(quick.end, exact.end);
}

}  // namespace
