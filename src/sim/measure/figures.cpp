#include "sim/measure/figures.hpp"

#include <algorithm>

#include "sim/measure/bond_traction.hpp"
#include "sim/measure/measure.hpp"
#include "sim/measure/nodal_depth.hpp"
#include "sim/measure/shared_wear.hpp"
#include "sim/measure/surfaces.hpp"
#include "sim/problem/drive.hpp"

namespace reye::sim {

IncrementRecord figures_of(const Problem& problem, const State& state, const solver::System& system,
                           const solver::Controls& controls) {
  IncrementRecord r = wear_of(problem, system, state);
  r.contacts.resize(problem.contacts.size());
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    auto& row = r.contacts[c];
    row.pressure_max_MPa = peak_pressure(system.contacts[c], state.solution.contacts[c]);
    std::tie(row.normal_force, row.tangential_force) = forces_of(state.solution.contacts[c], problem.scene.analysis);
    r.pressure_max_MPa = std::max(r.pressure_max_MPa, row.pressure_max_MPa);
  }
  const Vector reactions = solver::reactions(system, state.solution, controls);
  r.support_forces = support_forces(problem, system, reactions);
  r.support_moments = support_moments(problem, system, reactions);
  r.bonds = bond_tractions(problem, state, system, state.cycle);
  return r;
}

IncrementRecord wear_of(const Problem& problem, const solver::System& system, const State& state) {
  IncrementRecord r;
  const auto removed = removed_as_shown(problem, state);
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const auto& contact = state.solution.contacts[c];
    ContactRow row;
    row.depth_max_secondary_mm = deepest(setup.secondary, removed[c][0]);
    row.depth_max_primary_mm = deepest(setup.primary, removed[c][1]);
    row.energy_mJ = setup.options.wear.wears() ? contact.worn_work : contact.frictional_work;
    r.depth_max_secondary_mm = std::max(r.depth_max_secondary_mm, row.depth_max_secondary_mm);
    r.depth_max_primary_mm = std::max(r.depth_max_primary_mm, row.depth_max_primary_mm);
    r.energy_mJ += row.energy_mJ;
    r.contacts.push_back(row);
  }
  return r;
}

void add_wear(IncrementRecord& row, double share, const IncrementRecord& before, const IncrementRecord& after) {
  const auto add = [share](auto& to, const auto& from, const auto& end) {
    to.depth_max_secondary_mm += share * (end.depth_max_secondary_mm - from.depth_max_secondary_mm);
    to.depth_max_primary_mm += share * (end.depth_max_primary_mm - from.depth_max_primary_mm);
    to.energy_mJ += share * (end.energy_mJ - from.energy_mJ);
  };
  add(row, before, after);
  for (std::size_t c = 0; c < row.contacts.size(); ++c) add(row.contacts[c], before.contacts[c], after.contacts[c]);
}

}  // namespace reye::sim
