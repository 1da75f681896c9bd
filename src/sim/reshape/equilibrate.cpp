#include "sim/reshape/equilibrate.hpp"

#include <cmath>
#include <limits>

#include "base/formatted.hpp"
#include "sim/measure/seen_in_gaps.hpp"
#include "sim/measure/why_failed.hpp"
#include "sim/problem/drive.hpp"
#include "sim/problem/recall.hpp"
#include "sim/problem/scene_line.hpp"
#include "sim/problem/timer.hpp"
#include "sim/reshape/approach.hpp"

namespace reye::sim {

namespace {

/// Sets the shear as given load; among the nodes that no support holds, the one of largest pressure is offered as
/// anchor.
void hold_shear(const contact::Setup& setup, const contact::ContactState& contact, const HeldTraction& held,
                contact::IncrementOptions& o) {
  for (std::size_t j = 0; j < held.normal.size(); ++j) {
    o.held_shear.push_back(held.tangential[j] / setup.secondary.area[j]);
    o.held_pressure.push_back(held.normal[j] / setup.secondary.area[j]);
    const bool offers = contact.status[j] != contact::ContactStatus::inactive && setup.freedom[j].free == 2;
    if (offers && (o.anchor < 0 || o.held_pressure[j] > o.held_pressure[o.anchor])) o.anchor = static_cast<int>(j);
  }
}

/// The node in contact that is nearest on X to node j; -1: none is in contact.
int nearest_in_contact(const contact::Setup& setup, const contact::ContactState& contact, std::size_t j) {
  const auto& X = setup.secondary.X;
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < contact.status.size(); ++k) {
    if (contact.status[k] == contact::ContactStatus::inactive) continue;
    if (const double far = (X[k] - X[j]).squaredNorm(); far < least) least = far, nearest = static_cast<int>(k);
  }
  return nearest;
}

/// Nodes that slide still do, with the shear that friction allows at their new pressure, as they will at the end of the
/// next cycle; so do those that begin to touch beside them: without shear there the next increment would have to
/// stretch the bodies until the whole contact slides.
void let_slide(const contact::Setup& setup, const contact::ContactState& contact, contact::IncrementOptions& o) {
  const auto shear = o.held_shear;
  for (std::size_t j = 0; j < shear.size(); ++j)
    if (const int k = nearest_in_contact(setup, contact, j);
        k >= 0 && shear[k] != 0.0 && contact.status[k] == contact::ContactStatus::slip)
      o.held_shear[j] = std::copysign(std::numeric_limits<double>::infinity(), shear[k]);  // cut to the bound
}

/// True when a body of the contact is free to move along it but for friction.
bool driven_only_by_friction(const Problem& problem, const solver::System& system, int contact) {
  const auto& s = system.contacts[contact].secondary;
  const auto [a, b, mid] = s.facets[s.facets.size() / 2];
  const Vec2 along = (s.X[b] - s.X[a]).normalized();
  const auto& placed = problem.contacts[contact];
  if (placed.options.friction == 0.0 || placed.options.imposed) return false;
  bool free = !held_along(problem, system, placed.secondary.body, along);
  for (const auto& ref : placed.primary) free = free || !held_along(problem, system, ref.body, along);
  return free;
}

/// The bodies without plastic flow. The change of stress by a new mesh has either sign and is not a load: if points at
/// yield flowed by it, p would grow with each mesh, since flow is not reversed.
solver::System unyielding(solver::System system) {
  for (auto& op : system.bodies)
    if (const auto* body = std::get_if<body::NonlinearBody>(&op)) op = body->unyielding();
  return system;
}

/// How soft springs must be for pressures that stay nearly as they are given: a layer of thirty lengths of the contact,
/// which leaves a thirtieth of the change by a gap to the next pass. Where normals have turned, the given tractions
/// miss the load, and a body moves by thirty times that share of the approach: on softer springs it would move too far
/// for gaps to be linear.
double soft(const contact::Setup& setup, const contact::ContactState& contact) {
  double compliance = 0.0;
  for (std::size_t j = 0; j < contact.status.size(); ++j)
    if (contact.status[j] != contact::ContactStatus::inactive) compliance += 30.0 / setup.stiffness[j];
  return compliance;
}

solver::SolveResult held_equilibrium(const Problem& problem, const State& state, const solver::System& system,
                                     Cache& cache, const BlockSpan& span, const std::vector<HeldTraction>& held,
                                     bool on_springs, double ahead = 0.0) {
  auto controls = controls_at(problem, system, state.factors, *span.step, 1.0, 1.0, 1.0);
  count_from_renewal(controls, problem, system, state);
  if (span.continued) set_seen_in_gaps(controls, problem, state, system, span, ahead);
  controls.ahead = touched(state.recall, state.step);  // the block that follows keeps this reach
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    auto& o = controls.contacts[c];
    o.held = true;
    o.friction = state.solution.contacts[c].friction;
    o.wear = false;
    hold_shear(system.contacts[c], state.solution.contacts[c], held[c], o);
    if (!driven_only_by_friction(problem, system, static_cast<int>(c))) o.anchor = -1;
    if (span.continued && o.anchor < 0) let_slide(system.contacts[c], state.solution.contacts[c], o);
    if (on_springs) o.compliance = soft(system.contacts[c], state.solution.contacts[c]);
  }
  Timer timer(cache, "solver");
  return cache.newton.solve(system, state.solution, controls);
}

std::string cycle_in_words(double cycle) { return base::formatted("%.9g", cycle); }

}  // namespace

std::vector<HeldTraction> held_tractions(const solver::System& system, const State& state) {
  std::vector<HeldTraction> tractions;
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const auto& contact = state.solution.contacts[c];
    auto& held = tractions.emplace_back();
    for (int j = 0; j < setup.secondary_count(); ++j) {
      const Vec2 n = contact.normal[j], force = contact.lambda[j] * setup.secondary.area[j];
      held.normal.push_back(force.dot(n));
      held.tangential.push_back(-n.y() * force.x() + n.x() * force.y());
    }
  }
  return tractions;
}

std::string equilibrate_on_springs(const Problem& problem, State& state, Cache& cache, const BlockSpan& span,
                                   const std::vector<HeldTraction>& held) {
  const auto system = unyielding(*timed_system(problem, state, cache));
  auto result = held_equilibrium(problem, state, system, cache, span, held, true);
  state.counts.equilibrium_iterations += result.report.solves;
  if (result.report.converged) state.solution = std::move(result.state);
  return result.report.converged ? std::string() : result.report.reason;
}

std::string re_equilibrate(const Problem& problem, State& state, Cache& cache, const BlockSpan& span,
                           const std::vector<HeldTraction>& held, double ahead) {
  const auto system = unyielding(*timed_system(problem, state, cache));
  std::vector<std::vector<contact::ContactStatus>> status;
  for (const auto& contact : state.solution.contacts) status.push_back(contact.status);
  auto result = held_equilibrium(problem, state, system, cache, span, held, false, ahead);
  state.counts.equilibrium_iterations += result.report.solves;
  if (!result.report.converged)
    return scene_line(problem.scene, "step " + span.step->name) +
           "no equilibrium was found on the worn shape of cycle " + cycle_in_words(state.cycle) + ": " +
           why_failed(problem, state, {span.step, span.jump, result.report.failure, result.report.reason}, system);
  state.solution = std::move(result.state);
  for (std::size_t c = 0; c < status.size(); ++c)
    for (std::size_t j = 0; j < status[c].size(); ++j)
      if (auto& s = state.solution.contacts[c].status[j];
          s != contact::ContactStatus::inactive && status[c][j] != contact::ContactStatus::inactive)
        s = status[c][j];
  return {};
}

}  // namespace reye::sim
