#include "sim/reshape/renew.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "adapt/shape/triggers.hpp"
#include "sim/measure/displacements.hpp"
#include "sim/measure/renewable.hpp"
#include "sim/problem/timer.hpp"
#include "sim/reshape/carry.hpp"
#include "sim/reshape/equilibrate.hpp"
#include "sim/reshape/remesh.hpp"
#include "sim/reshape/shape.hpp"
#include "sim/reshape/stay_in_gaps.hpp"

namespace reye::sim {

namespace {

/// The present positions of the nodes of a body.
base::Points current_nodes(const Problem& problem, const State& state, const solver::System& system, int b) {
  base::Points x = state.shapes[b]->mesh.X;
  const auto u = recovered(problem, state, system, b);
  for (std::size_t i = 0; i < u.size(); ++i) x[i] += u[i];
  return x;
}

/// The shape with its nodes at x. It keeps its mesh of birth, so that its outline is drawn through the nodes.
body::ShapePtr moved_to(const body::Shape& before, base::Points x) {
  auto shape = std::make_shared<body::Shape>(before);
  shape->mesh.X = std::move(x);
  return shape;
}

/// Why the current shape is to become X.
RemeshReason reason_of(const Problem& problem, const body::Shape& before, const base::Points& x) {
  const auto& triggers = problem.scene.remesh.triggers;
  const std::string why = adapt::why_renew(before, x, triggers);
  if (why.empty()) return {};
  return {"deformation: " + why, adapt::measure(before, x).size_ratio.value > triggers.size_ratio, true};
}

/// Stores the positions of the supports of a body when its reference is renewed.
void note_supports(const Problem& problem, const State& state, const solver::System& system, int b, State& next) {
  next.renewed_at.resize(problem.scene.supports.size());
  const Vector q = system.part(state.solution.q.high, b);
  for (const auto& column : std::get<body::NonlinearBody>(system.bodies[b]).support_columns())
    next.renewed_at[problem.support_of[b][column.support]][column.motion] += q[column.column];
}

/// Tractions that are counted on x stay what they are when x becomes X: their forces are those of the areas on x.
void count_on_current(const Problem& problem, const solver::System& system, Change& change) {
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const auto& ref = problem.contacts[c].secondary;
    if (setup.measure == base::Kinematics::small || !change.reasons[ref.body].renew) continue;
    const auto now = surface_of(ref, problem.scene.analysis, change.next.shapes).area;
    for (std::size_t j = 0; j < now.size(); ++j) {
      const double ratio = now[j] / setup.secondary.area[j];
      change.held[c].normal[j] *= ratio;
      change.held[c].tangential[j] *= ratio;
    }
  }
}

/// The present positions of the bodies whose references are to be renewed; `reasons` says why.
std::map<int, base::Points> renewed_nodes(const Problem& problem, const State& state, const solver::System& system,
                                          std::vector<RemeshReason>& reasons) {
  std::map<int, base::Points> renewed;
  for (int b = 0; b < problem.body_count(); ++b) {
    if (!can_renew(problem, b)) continue;
    auto x = current_nodes(problem, state, system, b);
    reasons[b] = reason_of(problem, *state.shapes[b], x);
    if (reasons[b].renew) renewed.emplace(b, std::move(x));
  }
  return renewed;
}

/// The current shapes as references, and the fields on them; empty where no reference is to be renewed.
std::optional<Change> renewal_of(const Problem& problem, const State& state, const solver::System& system) {
  std::vector<RemeshReason> reasons(state.shapes.size());
  auto renewed = renewed_nodes(problem, state, system, reasons);
  if (renewed.empty()) return std::nullopt;
  Change change{state, std::move(reasons), held_tractions(system, state)};
  for (auto& [b, x] : renewed) {
    change.next.shapes[b] = moved_to(*state.shapes[b], std::move(x));
    note_supports(problem, state, system, b, change.next);
  }
  count_on_current(problem, system, change);
  return change;
}

}  // namespace

bool renew_references(const Problem& problem, State& state, Cache& cache, const BlockSpan& span,
                      const Observer& observer) {
  if (!problem.scene.remesh.automatic || wear_waits(state)) return false;
  auto change = renewal_of(problem, state, *timed_system(problem, state, cache));
  if (!change) return false;
  Outcome outcome = settle(problem, state, std::move(*change), cache, span, observer);
  if (!outcome.failure.empty()) {
    if (observer.log) observer.log("the reference is kept: " + outcome.failure);
    return false;
  }
  state = std::move(outcome.state);
  return true;
}

}  // namespace reye::sim
