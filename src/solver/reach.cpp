#include "solver/reach.hpp"

#include <algorithm>

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

/// Adds one contact; false where none of its nodes is active.
bool Reach::add(const contact::Setup& setup, const std::vector<ContactStatus>& status,
                const std::vector<contact::MortarRow>& rows, Margin margin, const std::vector<char>& ahead) {
  std::vector<char> near_secondary(setup.secondary.X.size(), 0), near_primary(setup.primary.X.size(), 0);
  int active = 0;
  for (std::size_t j = 0; j < near_secondary.size(); ++j) {
    if (status[j] == ContactStatus::inactive) continue;
    ++active;
    near_secondary[j] = 1;
    for (const auto& [l, M] : rows[j].M) near_primary[l] = 1;
  }
  const int wider = margin.nodes + (margin.active_per_node > 0 ? active / margin.active_per_node : 0);
  for (std::size_t j = 0; j < ahead.size(); ++j)
    if (ahead[j]) near_secondary[j] = 1;
  widen(setup.secondary, near_secondary, wider);
  for (std::size_t j = 0; j < near_secondary.size(); ++j)
    if (near_secondary[j])
      for (const auto& [l, M] : rows[j].M) near_primary[l] = 1;
  widen(setup.primary, near_primary, wider);
  secondary.push_back(std::move(near_secondary));
  primary.push_back(std::move(near_primary));
  return active > 0;
}

Reach Reach::round_contact(const System& system, const std::vector<contact::ContactState>& contacts, Margin margin,
                           const std::vector<std::vector<char>>& ahead) {
  Reach reach;
  for (std::size_t c = 0; c < system.contacts.size(); ++c)
    if (!reach.add(system.contacts[c], contacts[c].status, contacts[c].reference, margin,
                   ahead.empty() ? std::vector<char>() : ahead[c]))
      return all(system);
  return reach;
}

Reach Reach::round_contact(const System& system, const std::vector<contact::Interface>& contacts, Margin margin) {
  Reach reach;
  for (std::size_t c = 0; c < system.contacts.size(); ++c)
    if (!reach.add(system.contacts[c], contacts[c].status(), contacts[c].rows(), margin)) return all(system);
  return reach;
}

Reach Reach::of_derivatives(const std::vector<contact::Interface>& contacts,
                            const std::vector<contact::Linearised>& derivatives) {
  Reach reach;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto& face = contacts[c];
    const int ns = face.setup().secondary_count(), all = ns + face.setup().primary_count();
    std::vector<char> touched(all, 0);
    for (int j = 0; j < ns; ++j) {
      if (!face.active(j)) continue;
      touched[j] = 1;
      for (const auto& [k, share] : face.rows()[j].off) touched[k] = 1;
      for (const auto& [l, M] : face.rows()[j].M) touched[ns + l] = 1;
    }
    for (const auto& e : derivatives[c].force) touched[e.row / 2] = touched[e.col / 2] = 1;
    for (const auto& e : derivatives[c].rows)
      if (e.col < 2 * all && face.active(e.row / 2)) touched[e.col / 2] = 1;
    // Where nothing touches, a body may be held by nothing but the columns kept.
    if (std::find(touched.begin(), touched.end(), 1) == touched.end()) touched.assign(all, 1);
    reach.secondary.emplace_back(touched.begin(), touched.begin() + ns);
    reach.primary.emplace_back(touched.begin() + ns, touched.end());
  }
  return reach;
}

Reach Reach::widened(const System& system, int nodes) const {
  Reach reach = *this;
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    widen(system.contacts[c].secondary, reach.secondary[c], nodes);
    widen(system.contacts[c].primary, reach.primary[c], nodes);
  }
  return reach;
}

int Reach::nodes() const {
  int count = 0;
  for (const auto* side : {&secondary, &primary})
    for (const auto& near : *side) count += static_cast<int>(std::count(near.begin(), near.end(), 1));
  return count;
}

bool Reach::holds(const Reach& smaller) const {
  const auto inside = [](const auto& all, const auto& some) {
    for (std::size_t c = 0; c < all.size(); ++c)
      for (std::size_t k = 0; k < all[c].size(); ++k)
        if (some[c][k] && !all[c][k]) return false;
    return true;
  };
  return inside(secondary, smaller.secondary) && inside(primary, smaller.primary);
}

std::vector<char> Reach::columns_out(const System& system, Bodies of) const {
  std::vector<char> far(system.dofs, 0), near(system.dofs, 0);
  const Vector at_rest = Vector::Zero(system.dofs);
  const auto mark = [&](const std::vector<contact::SurfaceNode>& nodes, const std::vector<char>& in_reach) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const int body = nodes[k].body;
      const auto mark_own = [&](const auto& own) {
        const auto p = own.position(nodes[k].contact_node, at_rest);
        const int free = own.freedom(nodes[k].contact_node).free;
        for (int t = p.count - free; t < p.count; ++t)
          (in_reach[k] ? near : far)[system.offset[body] + p.terms[t].column] = 1;
      };
      if (const auto* linear = std::get_if<body::LinearBody>(&system.bodies[body])) mark_own(*linear);
      if (of == Bodies::linear) continue;
      if (const auto* nonlinear = std::get_if<body::NonlinearBody>(&system.bodies[body])) mark_own(*nonlinear);
    }
  };
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    mark(system.contacts[c].secondary_nodes, secondary[c]);
    mark(system.contacts[c].primary_nodes, primary[c]);
  }
  for (std::size_t k = 0; k < far.size(); ++k) far[k] = far[k] && !near[k];
  return far;
}

double facet_length(const contact::Setup& setup) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const auto* surface : {&setup.secondary, &setup.primary}) {
    for (const auto& facet : surface->facets) sum += (surface->X[facet[1]] - surface->X[facet[0]]).norm();
    count += surface->facets.size();
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

bool Reach::encloses(int contact, const contact::Interface& face) const {
  const auto& setup = face.setup();
  const auto &near_secondary = secondary[contact], &near_primary = primary[contact];
  const auto rim = [](const mortar::Surface& s, const std::vector<char>& near, int node) {
    for (int facet : {s.before[node], s.after[node]})
      for (int k : facet < 0 ? mortar::LineFacet{-1, -1, -1} : s.facets[facet])
        if (k >= 0 && !near[k]) return true;
    return false;
  };
  for (int j = 0; j < setup.secondary_count(); ++j) {
    if (!near_secondary[j]) {
      if (!setup.cut[j] && face.touching(j) && face.gap()[j] + face.worn_gap(j) < 0.0) return false;
      continue;
    }
    if (!face.active(j)) continue;
    if (!face.touching(j)) return false;  // another contact, which was out of reach there, has it
    // The normals at its neighbours, along which their facets are projected, depend on one node more.
    for (int facet : {setup.secondary.before[j], setup.secondary.after[j]})
      for (int k : facet < 0 ? mortar::LineFacet{j, -1, -1} : setup.secondary.facets[facet])
        if (k >= 0 && (!near_secondary[k] || rim(setup.secondary, near_secondary, k))) return false;
    for (const auto& [l, M] : face.rows()[j].M)
      if (!near_primary[l] || rim(setup.primary, near_primary, l)) return false;
  }
  return true;
}

}  // namespace reye::solver
