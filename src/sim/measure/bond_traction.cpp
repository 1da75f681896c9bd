#include "sim/measure/bond_traction.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/measure/surfaces.hpp"
#include "sim/problem/ending.hpp"

namespace reye::sim {

namespace {

/// Rows of a table that are within two facets of a free end of the bond: neither on a line of symmetry, which a support
/// holds, nor where a ring closes.
std::vector<char> rows_at_ends(const contact::Setup& setup, const SurfaceRecord& s) {
  std::set<int> held;
  for (int j = 0; j < setup.secondary_count(); ++j)
    if (setup.freedom[j].free < 2) held.insert(setup.secondary_nodes[j].mesh_node);
  const auto rows = static_cast<int>(s.node.size()), reach = 2 * setup.secondary.order;
  std::vector<char> at_end(s.node.size(), 0);
  for (int first = 0; first < rows;) {
    int last = first;  // of the chain
    while (last + 1 < rows && s.arc_length_mm[last + 1] > s.arc_length_mm[last]) ++last;
    const bool ring = s.node[first] == s.node[last];
    const auto carries = [&](int i) { return s.status[i] != 0; };
    for (int i = first; i <= last; ++i)
      for (const int beside : {i - 1, i + 1}) {
        const bool beyond = beside < first || beside > last;
        if (!carries(i) || (beyond && ring) || (!beyond && carries(beside))) continue;
        if (held.contains(s.node[i]) || (!beyond && held.contains(s.node[beside]))) continue;
        for (int k = std::max(first, i - reach); k <= std::min(last, i + reach); ++k) at_end[k] = 1;
      }
    first = last + 1;
  }
  return at_end;
}

template <class Value>
TractionPeak peak(const SurfaceRecord& s, const std::vector<char>& at_end, double cycle, Value value) {
  TractionPeak most;
  for (std::size_t i = 0; i < s.node.size(); ++i)
    if (value(i) > most.MPa) most = {value(i), Vec2(s.x_mm[i], s.y_mm[i]), cycle, at_end[i] != 0};
  return most;
}

/// Mean over the rows that carry tractions, by the trapezoidal rule along the table.
template <class Value>
double mean(const SurfaceRecord& s, Value value) {
  double sum = 0.0, length = 0.0;
  for (std::size_t i = 1; i < s.node.size(); ++i) {
    if (s.status[i] == 0 || s.status[i - 1] == 0) continue;
    const double step = s.arc_length_mm[i] - s.arc_length_mm[i - 1];
    sum += 0.5 * step * (value(i) + value(i - 1));
    length += step;
  }
  return length > 0.0 ? sum / length : 0.0;
}

}  // namespace

BondTraction bond_traction(const contact::Setup& setup, const SurfaceRecord& s, double cycle) {
  const auto tension = [&](std::size_t i) { return -s.pressure_MPa[i]; };
  const auto shear = [&](std::size_t i) { return std::abs(s.shear_MPa[i]); };
  const auto at_end = rows_at_ends(setup, s);
  return {peak(s, at_end, cycle, tension), peak(s, at_end, cycle, shear), mean(s, tension), mean(s, shear)};
}

std::vector<BondTraction> bond_tractions(const Problem& problem, const State& state, const solver::System& system,
                                         double cycle) {
  std::vector<BondTraction> all;
  for (std::size_t b = 0; b < problem.bonds.size(); ++b) {
    const auto c = problem.contacts.size() + b;
    const auto& setup = system.contacts[c];
    all.push_back(bond_traction(
        setup, surface_records(setup, state.solution.contacts[c], state.shapes, problem.bonds[b])[0], cycle));
  }
  return all;
}

void watch_bonds(State& state, const std::vector<BondTraction>& now) {
  state.bonds.resize(now.size());
  for (std::size_t b = 0; b < now.size(); ++b) {
    auto& most = state.bonds[b];
    if (now[b].tension.MPa > most.tension.MPa) most.tension = now[b].tension;
    if (now[b].shear.MPa > most.shear.MPa) most.shear = now[b].shear;
    most.mean_tension_MPa = std::max(most.mean_tension_MPa, now[b].mean_tension_MPa);
    most.mean_shear_MPa = std::max(most.mean_shear_MPa, now[b].mean_shear_MPa);
  }
}

std::vector<BondSummary> bond_summaries(const Problem& problem, const State& state, const solver::System& system) {
  std::vector<BondSummary> all;
  const auto now = bond_tractions(problem, state, system, state.cycle);
  for (std::size_t b = 0; b < now.size(); ++b)
    all.push_back({problem.bonds[b].options.name, now[b], b < state.bonds.size() ? state.bonds[b] : now[b]});
  return all;
}

}  // namespace reye::sim
