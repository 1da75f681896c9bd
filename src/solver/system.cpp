#include "solver/system.hpp"

#include <algorithm>
#include <set>

#include "base/errors.hpp"
#include "body/turning.hpp"

namespace reye::solver {

namespace {

using Key = std::pair<int, int>;

std::set<Key> keys(const std::vector<contact::SurfaceNode>& nodes) {
  std::set<Key> result;
  for (const auto& node : nodes) result.insert({node.body, node.mesh_node});
  return result;
}

bool overlap(const std::set<Key>& a, const std::set<Key>& b) {
  return std::any_of(a.begin(), a.end(), [&](const Key& key) { return b.contains(key); });
}

/// first[c] lists contacts that must be eliminated before c: those whose primary side holds secondary nodes of c.
std::vector<int> ordered(const std::vector<contact::Setup>& contacts) {
  const int n = static_cast<int>(contacts.size());
  std::vector<int> order;
  std::vector<char> done(contacts.size(), 0);
  for (int round = 0; round < n; ++round)
    for (int c = 0; c < n; ++c) {
      if (done[c]) continue;
      bool ready = true;
      for (int other = 0; other < n; ++other)
        if (other != c && !done[other] &&
            overlap(keys(contacts[c].secondary_nodes), keys(contacts[other].primary_nodes)))
          ready = false;
      if (!ready) continue;
      done[c] = 1;
      order.push_back(c);
    }
  if (static_cast<int>(order.size()) < n)
    throw base::InputError({{"contact", "", "contacts form a ring: each one's secondary side is primary in another"}});
  return order;
}

/// A node carries one multiplier: where it is secondary in a contact, or in an earlier bond, a bond has none.
void cut_shared(std::vector<contact::Setup>& contacts) {
  std::set<Key> taken;
  for (const bool bonded : {false, true})
    for (auto& setup : contacts) {
      if (setup.options.bonded != bonded) continue;
      for (std::size_t j = 0; j < setup.secondary_nodes.size(); ++j) {
        const auto& node = setup.secondary_nodes[j];
        if (!taken.insert({node.body, node.mesh_node}).second && bonded) setup.cut[j] = 1;
      }
    }
}

double extent_of(const std::vector<contact::Setup>& contacts) {
  double largest = 0.0;
  for (const auto& setup : contacts)
    for (const auto* surface : {&setup.secondary, &setup.primary})
      for (const Vec2& x : surface->X) largest = std::max(largest, (x - surface->X.front()).norm());
  return largest;
}

Vector arms(const System& system) {
  Vector arm = Vector::Ones(system.dofs);
  if (system.extent == 0.0) return arm;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    constexpr int turning = 2;  // column of a rigid body, motion of a support
    if (std::holds_alternative<body::RigidBody>(system.bodies[b])) arm[system.offset[b] + turning] = system.extent;
    if (const auto* linear = std::get_if<body::LinearBody>(&system.bodies[b]); linear && linear->turning())
      arm[system.offset[b] + linear->turning()->angle] = system.extent;
    for (const auto& s : body::support_columns(system.bodies[b]))
      if (s.motion == turning) arm[system.offset[b] + s.column] = system.extent;
  }
  return arm;
}

}  // namespace

System make_system(std::vector<body::Operator> bodies, std::vector<contact::Setup> contacts) {
  System system;
  system.bodies = std::move(bodies);
  system.contacts = std::move(contacts);
  cut_shared(system.contacts);
  for (const auto& body : system.bodies) {
    system.offset.push_back(system.dofs);
    system.dofs += std::visit([](const auto& b) { return b.dofs(); }, body);
  }
  system.elimination = ordered(system.contacts);
  system.shared = shared_secondary(system.contacts);
  system.extent = extent_of(system.contacts);
  system.arm = arms(system);
  return system;
}

std::vector<Vector> System::parts(const Vector& q) const {
  std::vector<Vector> all;
  for (std::size_t b = 0; b < bodies.size(); ++b) all.emplace_back(part(q, static_cast<int>(b)));
  return all;
}

Sides positions(const System& system, const contact::Setup& setup, const Vector& q) {
  const auto own = system.parts(q);
  const auto at = [&](const std::vector<contact::SurfaceNode>& nodes) {
    Points x;
    x.reserve(nodes.size());
    for (const auto& node : nodes)
      x.push_back(std::visit([&](const auto& b) { return b.position(node.contact_node, own[node.body]).x; },
                             system.bodies[node.body]));
    return x;
  };
  return {at(setup.secondary_nodes), at(setup.primary_nodes)};
}

Vector contact_forces(const System& system, const std::vector<contact::ContactState>& contacts, const Vector& q) {
  Vector total = Vector::Zero(system.dofs);
  const auto own = system.parts(q);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const auto& state = contacts[c];
    const auto add = [&](const contact::SurfaceNode& node, const Vec2& force) {
      const auto p = std::visit([&](const auto& b) { return b.position(node.contact_node, own[node.body]); },
                                system.bodies[node.body]);
      for (int t = 0; t < p.count; ++t)
        total[system.offset[node.body] + p.terms[t].column] += force.dot(p.terms[t].direction);
    };
    for (int j = 0; j < setup.secondary_count(); ++j) {
      const auto& row = state.reference[j];
      if (state.lambda[j].isZero(0.0)) continue;
      add(setup.secondary_nodes[j], row.D * state.lambda[j]);
      for (const auto& [k, share] : row.off) add(setup.secondary_nodes[k], share * state.lambda[j]);
      for (const auto& [l, M] : row.M) add(setup.primary_nodes[l], -M * state.lambda[j]);
    }
  }
  return total;
}

Vector reactions(const System& system, const SolverState& state, const Controls& controls) {
  Vector total = contact_forces(system, state.contacts, state.q.high);
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const int body = static_cast<int>(b);
    const base::TwoPart q{system.part(state.q.high, body), system.part(state.q.low, body)};
    const Vector r = std::visit(
        [&](const auto& o) {
          if constexpr (std::is_same_v<std::decay_t<decltype(o)>, body::NonlinearBody>)
            return o.at_supports(state.interiors[b], state.interiors[b].y, q, controls.load_factors[b]);
          else if constexpr (std::is_same_v<std::decay_t<decltype(o)>, body::LinearBody>)
            return o.at_supports(q, controls.load_factors[b]);
          else
            return o.residual(q.high, controls.load_factors[b]);
        },
        system.bodies[b]);
    total.segment(system.offset[b], r.size()) += r;
  }
  return total;
}

SolverState::SolverState() = default;
SolverState::SolverState(const SolverState&) = default;
SolverState::SolverState(SolverState&&) noexcept = default;
SolverState& SolverState::operator=(const SolverState&) = default;
SolverState& SolverState::operator=(SolverState&&) noexcept = default;
SolverState::~SolverState() = default;

}  // namespace reye::solver
