#include <algorithm>
#include <cstdlib>

#include "sim/march/block.hpp"
#include "sim/problem/drive.hpp"
#include "verification/contact_scene.hpp"

using namespace reye;
using namespace reye::verification;

namespace {

struct Row {
  std::string step;
  double progress = 0.0;
  int iteration = 0;
  solver::Iteration at;
};

/// Newton tables of all increments of a scene's steps, each from the accepted state before it; without chords.
std::vector<Row> newton_rows(const std::string& text) {
  const auto problem = prepared(text);
  auto state = sim::initial_state(problem);
  sim::Cache cache;
  cache.newton = solver::Newton({.chords = false});
  sim::begin_state(problem, state, cache);
  const auto kept = sim::system_of(problem, state, cache);
  const auto& system = *kept;
  std::vector<Row> rows;
  for (const auto& step : problem.scene.steps) {
    double from = 0.0;
    const auto held = state.factors;
    for (const double to : sim::increment_ends(problem.scene, step)) {
      state.factors = sim::factors_at(problem.scene.histories, step, to, held);
      auto result = cache.newton.solve(system, state.solution,
                                       sim::controls_at(problem, system, state.factors, step, from, to, 1.0));
      EXPECT_TRUE(result.report.converged) << result.report.reason;
      int iteration = 0;
      for (const auto& at : result.report.table) rows.push_back({step.name, to, iteration++, at});
      state.solution = std::move(result.state);
      from = to;
    }
  }
  return rows;
}

/// As CSV where the caller asks for it.
void write_rows(const std::string& name, const std::vector<Row>& rows) {
  const char* folder = std::getenv("REYE_NEWTON");
  if (!folder) return;
  std::ofstream out(std::string(folder) + "/" + name + ".csv");
  out << "step,progress,iteration,force,condition,changes\n";
  for (const auto& r : rows)
    out << r.step << ',' << r.progress << ',' << r.iteration << ',' << r.at.force << ',' << r.at.condition << ','
        << r.at.changes << '\n';
}

double worse(const solver::Iteration& i) { return std::max(i.force, i.condition); }

/// log(r_k+1) / log(r_k) over the tails, smallest first: no status change, r_k from largest / 1000 to largest. Each
/// must exceed 1.
std::vector<double> orders(const std::vector<Row>& rows, double largest = 1e-2) {
  std::vector<double> found;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    if (rows[i + 1].iteration != rows[i].iteration + 1 || rows[i].at.changes != 0 || rows[i + 1].at.changes != 0)
      continue;
    const double now = worse(rows[i].at), next = std::max(worse(rows[i + 1].at), 1e-13);
    if (now > largest || now < 1e-3 * largest) continue;
    found.push_back(std::log(next) / std::log(now));
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

// Once the active set has settled the residual must fall quadratically: r_k+1 < r_k^1.5 at the least.
TEST(ContactNewton, QuadraticTail) {
  for (const std::string name : {"hertz", "cattaneo_mindlin"}) {
    const auto rows = newton_rows(
        scene_text(name, name == "hertz" ? Replacements{} : Replacements{{"increments = 20", "increments = 5"}}));
    write_rows(name, rows);
    const auto found = orders(rows);
    ASSERT_GE(found.size(), 2U) << name;
    EXPECT_GT(found.front(), 1.5) << name;
  }
}

// At finite strain, with friction, large sliding and plastic flow, most tails are quadratic, too; a Gauss point that
// starts to yield or a node that starts to slip late may spoil a single one.
TEST(ContactNewton, QuadraticTailAtFiniteStrain) {
  for (const std::string name : {"ironing", "pressed_ring_plastic"}) {
    const auto rows = newton_rows(scene_text(name));
    write_rows(name, rows);
    const auto found = orders(rows);
    ASSERT_GE(found.size(), 20U) << name;
    EXPECT_GT(found[found.size() / 2], 1.7) << name;
    int most = 0;
    for (const auto& row : rows) most = std::max(most, row.iteration);
    EXPECT_LE(most, name == "ironing" ? 8 : 16) << name;
  }
}

// A strip that yields under the die must take every increment as planned, with few renewals of the bodies in each: half
// of the stroke, beyond where one of little hardening collapses.
TEST(ContactNewton, PlasticIroning) {
  const auto rows = newton_rows(scene_text("ironing_plastic", {{"motion_mm = 8.0", "motion_mm = 4.0"},
                                                               {"[0.125, 1.0]", "[0.25, 1.0]"},
                                                               {"increments = 80 ", "increments = 40 "}}));
  write_rows("ironing_plastic", rows);
  const auto found = orders(rows, 1e-3);  // nearer the solution than the others: from 1e-2 on it is 1.66
  ASSERT_GE(found.size(), 20U);
  EXPECT_GT(found[found.size() / 2], 1.7);
  int most = 0, increments = 0, renewals = 0;
  for (const auto& row : rows) {
    most = std::max(most, row.iteration);
    (row.iteration == 0 ? increments : renewals) += 1;
  }
  EXPECT_EQ(increments, 40);
  EXPECT_LE(most, 12);
  EXPECT_LE(renewals, 8 * increments);
}

// Where stress is not small against the tangent modulus, symmetric parts of tangents must give way to exact ones: alone
// they take a quarter more steps.
TEST(ContactNewton, PlasticIroningWithExactTangents) {
  const auto run = played(scene_text("ironing_plastic", {{"motion_mm = 8.0", "motion_mm = 2.0"},
                                                         {"[0.125, 1.0]", "[0.5, 1.0]"},
                                                         {"increments = 80 ", "increments = 20 "}}));
  const auto& counts = run.summary.counts;
  EXPECT_EQ(counts.cutbacks, 0);
  EXPECT_LE(counts.newton_iterations, 9 * counts.increments);
}

// Newton must be quadratic with wear whose rate depends on pressure and speed, so that every increment is nonlinear in
// its pressure.
TEST(ContactNewton, QuadraticTailWithRates) {
  const auto rows =
      newton_rows(scene_text("column", {{"secondary_per_MPa = 1.0e-7",
                                         "secondary_per_MPa = 1.0e-6, pressure_exponent = 0.8, pressure_ref_MPa = 50, "
                                         "speed_exponent = -0.5, speed_ref_mm_per_s = 1000"},
                                        {"increments = 10", "increments = 10\nperiod_s = 4.0"}}));
  const auto found = orders(rows);
  ASSERT_GE(found.size(), 2U);
  EXPECT_GT(found.front(), 1.5);
}
