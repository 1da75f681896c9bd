#include "sim/measure/seen_in_gaps.hpp"

#include <algorithm>
#include <utility>

#include "sim/measure/shared_wear.hpp"
#include "sim/measure/thickness.hpp"

namespace reye::sim {

namespace {

/// Adds what contacts are expected to wear from progress `to` on, where the play is continued: they see it already. Not
/// where they have got other nodes.
void see_ahead(solver::Controls& controls, const Problem& problem, const State& state, const BlockSpan& span,
               double to) {
  if (!span.continued) return;
  const auto& expected = *span.continued->expected;
  auto volumes = expected.after(to, span.jump / expected.cycles);
  if (!same_sizes(volumes, removed_volumes(state.solution.contacts))) return;
  State ahead;
  ahead.shapes = state.shapes;
  for (auto& [secondary, primary] : volumes) {
    auto& contact = ahead.solution.contacts.emplace_back();
    contact.pending_secondary = std::move(secondary);
    contact.pending_primary = std::move(primary);
    contact.energy_secondary.resize(contact.pending_secondary.size(), 0.0);
  }
  const auto add = [](std::vector<double>& waiting, const std::vector<double>& more) {
    waiting.resize(std::max(waiting.size(), more.size()), 0.0);
    for (std::size_t k = 0; k < more.size(); ++k) waiting[k] += more[k];
  };
  const auto of_others = left_by_others(problem, ahead);
  for (std::size_t c = 0; c < of_others.size(); ++c) {
    add(controls.contacts[c].waiting_secondary, ahead.solution.contacts[c].pending_secondary);
    add(controls.contacts[c].waiting_secondary, of_others[c].waiting_secondary);
    add(controls.contacts[c].waiting_primary, ahead.solution.contacts[c].pending_primary);
    add(controls.contacts[c].waiting_primary, of_others[c].waiting_primary);
  }
}

/// Gives each contact what the others have worn and dissipated at its nodes.
void pass_on_others(solver::Controls& controls, const Problem& problem, const State& state) {
  auto left = left_by_others(problem, state);
  for (std::size_t c = 0; c < left.size(); ++c) {
    controls.contacts[c].waiting_secondary = std::move(left[c].waiting_secondary);
    controls.contacts[c].waiting_primary = std::move(left[c].waiting_primary);
    controls.contacts[c].energy_elsewhere = std::move(left[c].energy);
  }
}

void set_thickness(solver::Controls& controls, const Problem& problem, const State& state,
                   const solver::System& system) {
  for (std::size_t c = 0; c < controls.contacts.size(); ++c) {
    if (!controls.contacts[c].wear) continue;
    auto thickness = layer_thickness(problem, state, system, static_cast<int>(c));
    controls.contacts[c].thickness_secondary = std::move(thickness.secondary);
    controls.contacts[c].thickness_primary = std::move(thickness.primary);
  }
}

}  // namespace

void set_seen_in_gaps(solver::Controls& controls, const Problem& problem, const State& state,
                      const solver::System& system, const BlockSpan& span, double to) {
  pass_on_others(controls, problem, state);
  see_ahead(controls, problem, state, span, to);
  set_thickness(controls, problem, state, system);
}

}  // namespace reye::sim
