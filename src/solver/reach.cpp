#include "solver/reach.hpp"

namespace reye::solver {

using contact::ContactStatus;

Reach Reach::all(const System& system) {
  Reach reach;
  for (const auto& setup : system.contacts) {
    reach.secondary.emplace_back(setup.secondary.X.size(), 1);
    reach.primary.emplace_back(setup.primary.X.size(), 1);
  }
  return reach;
}

namespace {

/// Marks everything within `margin` facets of a marked node.
void widen(const mortar::Surface& surface, std::vector<char>& mark, int margin) {
  for (int round = 0; round < margin; ++round) {
    const auto old = mark;
    for (const auto& [a, b, c] : surface.facets) {
      if (!old[a] && !old[b] && !(c >= 0 && old[c])) continue;
      mark[a] = mark[b] = 1;
      if (c >= 0) mark[c] = 1;
    }
  }
}

}  // namespace

Reach Reach::round_contact(const System& system, const std::vector<contact::ContactState>& contacts, int margin) {
  Reach reach;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const auto& state = contacts[c];
    std::vector<char> secondary(setup.secondary.X.size(), 0), primary(setup.primary.X.size(), 0);
    int active = 0;
    for (std::size_t j = 0; j < secondary.size(); ++j) {
      if (state.status[j] == ContactStatus::inactive) continue;
      ++active;
      secondary[j] = 1;
      for (const auto& [l, M] : state.reference[j].M) primary[l] = 1;
    }
    if (active == 0) return all(system);
    widen(setup.secondary, secondary, margin + active / 16);
    for (std::size_t j = 0; j < secondary.size(); ++j)
      if (secondary[j])
        for (const auto& [l, M] : state.reference[j].M) primary[l] = 1;
    widen(setup.primary, primary, margin + active / 16);
    reach.secondary.push_back(std::move(secondary));
    reach.primary.push_back(std::move(primary));
  }
  return reach;
}

bool Reach::encloses(int contact, const contact::Interface& face) const {
  const auto& setup = face.setup();
  const auto &near_secondary = secondary[contact], &near_primary = primary[contact];
  const auto rim = [](const mortar::Surface& s, const std::vector<char>& near, int node) {
    for (int facet : {s.before[node], s.after[node]})
      for (int k : facet < 0 ? mortar::Facet{-1, -1, -1} : s.facets[facet])
        if (k >= 0 && !near[k]) return true;
    return false;
  };
  for (int j = 0; j < setup.secondary_count(); ++j) {
    if (!near_secondary[j]) {
      if (!setup.cut[j] && face.touching(j) && face.gap()[j] + face.worn_gap(j) < 0.0) return false;
      continue;
    }
    if (!face.active(j)) continue;
    if (rim(setup.secondary, near_secondary, j)) return false;
    for (const auto& [l, M] : face.rows()[j].M)
      if (!near_primary[l] || rim(setup.primary, near_primary, l)) return false;
  }
  return true;
}

}  // namespace reye::solver
