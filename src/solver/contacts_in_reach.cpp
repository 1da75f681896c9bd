#include "solver/contacts_in_reach.hpp"

#include <algorithm>
#include <utility>

#include "base/formatted.hpp"
#include "solver/mobility.hpp"
#include "solver/passage.hpp"

namespace reye::solver {

namespace {

constexpr Reach::Margin reach_margin{.nodes = 6, .active_per_node = 16};
constexpr Reach::Margin wide_margin{.nodes = 24, .active_per_node = 4};
constexpr double worth_narrowing = 0.6;  ///< of the nodes in reach; a window leaves out most of the others anyway

/// Of linear bodies columns out of reach are condensed out; of others a wide reach costs a few integrals, and to find
/// after an increment that contact has outrun it costs several tangents.
Reach::Margin margin(const System& system) {
  return std::any_of(system.bodies.begin(), system.bodies.end(),
                     [](const auto& b) { return std::holds_alternative<body::LinearBody>(b); })
             ? reach_margin
             : wide_margin;
}

/// The reach round the contact, with what lies ahead where that adds so little that it costs less than to follow.
Reach round_contact(const System& system, const SolverState& before, const std::vector<std::vector<char>>& ahead) {
  constexpr double worth = 1.5;  // of the nodes
  Reach now = Reach::round_contact(system, before.contacts, margin(system));
  if (ahead.empty()) return now;
  Reach with = Reach::round_contact(system, before.contacts, margin(system), ahead);
  return with.nodes() > worth * now.nodes() ? now : with;
}

/// Nodes just out of reach move with their neighbour in reach. Otherwise a slide of more than a facet in one increment
/// would reverse the facet at the rim, and with it the averaged normal beside it.
void carry_rim(const mortar::Surface& surface, const std::vector<char>& near, const std::vector<Vec2>& before,
               std::vector<Vec2>& x) {
  for (const auto& facet : surface.facets)
    for (int in : facet)
      for (int out : facet)
        if (in >= 0 && out >= 0 && near[in] && !near[out]) x[out] = before[out] + x[in] - before[in];
}

}  // namespace

bool ContactsInReach::choose(const System& system, const SolverState& before,
                             const std::vector<std::vector<char>>& ahead, bool everything, bool limited) {
  if (chosen_ && !everything) return false;
  limited_ = limited;
  take(system, everything || !limited ? Reach::all(system) : round_contact(system, before, ahead));
  chosen_ = !(reach_ == Reach::all(system)) || !limited;
  return true;
}

bool ContactsInReach::look_ahead(const System& system, const SolverState& before, const Controls& controls,
                                 const Multipliers& lambda, const Vector& q) {
  if (!chosen_ || !limited_) return false;
  begin(system, before, controls, controls.guess);
  place_all(system, q);
  for (std::size_t c = 0; c < faces_.size(); ++c) faces_[c].decide(lambda[c], 0, contact::Start::predicted);
  if (enclosed()) return false;
  take(system, reach_round_faces(system));
  chosen_ = !(reach_ == Reach::all(system));
  return true;
}

void ContactsInReach::begin(const System& system, const SolverState& before, const Controls& controls,
                            const Guess* guess) {
  const auto n = system.contacts.size();
  faces_.resize(n);
  nodes_.resize(n);
  sides_.resize(n);
  start_.resize(n);
  for (std::size_t c = 0; c < n; ++c) {
    const auto& setup = system.contacts[c];
    start_[c] = sides_[c] = positions(system, setup, before.q.high);
    faces_[c].begin(setup, before.contacts[c], sides_[c].secondary, sides_[c].primary, controls.contacts[c]);
    faces_[c].hold(mobility(system, setup, before.q.high, controls));
    if (guess) faces_[c].expect(guess->status[c], guess->lambda[c]);
  }
  limit_faces();
}

void ContactsInReach::limit_faces() {
  placed_in_reach_ = false;
  for (std::size_t c = 0; c < faces_.size(); ++c) faces_[c].limit_to(reach_.secondary[c], reach_.primary[c]);
}

void ContactsInReach::take(const System& system, Reach reach) {
  reach_ = std::move(reach);
  constexpr int a_few = 4;  // choices cost as much as the inverse that serves any number
  reduction_ = Reduction(system, reach_, ++choices_ > a_few);
}

/// Round the contact that was found among all nodes, or all nodes.
Reach ContactsInReach::reach_round_faces(const System& system) const {
  Reach reach = Reach::round_contact(system, faces_, margin(system));
  return enclosed_by(reach) ? reach : Reach::all(system);
}

void ContactsInReach::change(const System& system, Reach reach, const Reduction::Loads& loads, base::TwoPart& q) {
  const auto all = reduction_.expand(q, loads);
  take(system, std::move(reach));
  limit_faces();
  q = {reduction_.restrict_to(all.high), reduction_.restrict_to(all.low)};
}

bool ContactsInReach::narrow(const System& system, const Reduction::Loads& loads, base::TwoPart& q) {
  if (chosen_) return false;
  Reach reach = Reach::round_contact(system, faces_, margin(system));
  if (reach.nodes() > worth_narrowing * reach_.nodes()) return false;
  change(system, std::move(reach), loads, q);
  return true;
}

bool ContactsInReach::enclosed_by(const Reach& reach) const {
  for (std::size_t c = 0; c < faces_.size(); ++c)
    if (!reach.encloses(static_cast<int>(c), faces_[c])) return false;
  return true;
}

std::string ContactsInReach::passed_through() const {
  for (std::size_t c = 0; c < faces_.size(); ++c) {
    const auto found = passage(faces_[c], start_[c], sides_[c]);
    if (!found) continue;
    return base::formatted(
        "node %d at (%.4g, %.4g) mm went through the other side of contact %s, to %.3g mm behind it: it moved "
        "farther in this increment than search_mm = %.3g sees",
        found->node.mesh_node, found->x.x(), found->x.y(), faces_[c].setup().options.name.c_str(), found->depth,
        faces_[c].setup().search);
  }
  return {};
}

void ContactsInReach::follow(const System& system, const Reduction::Loads& loads, base::TwoPart& q) {
  change(system, reach_round_faces(system), loads, q);
  chosen_ = !(reach_ == Reach::all(system));
}

/// Moves the surface nodes in reach (or all) to where the full vector q puts them, and integrates.
void ContactsInReach::integrate(const System& system, const Vector& q, bool everything) {
  const auto parts = system.parts(q);
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    auto& nodes = nodes_[c];
    if (everything || !placed_in_reach_) nodes.assign(setup.secondary_nodes.size() + setup.primary_nodes.size(), {});
    const auto put = [&](const contact::SurfaceNode& node, char near, PlacedNode& placed, Vec2& x) {
      if (!near && !everything) return;
      std::visit(
          [&](const auto& b) {
            placed.position = b.position(node.contact_node, parts[node.body]);
            placed.free = b.freedom(node.contact_node).free;
          },
          system.bodies[node.body]);
      for (int t = 0; t < placed.position.count; ++t)
        placed.column[t] = reduction_.index(system.offset[node.body] + placed.position.terms[t].column);
      const int angle = placed.position.angle;
      placed.angle = angle < 0 ? -1 : reduction_.index(system.offset[node.body] + angle);
      x = placed.position.x;
    };
    const auto ns = setup.secondary_nodes.size();
    for (std::size_t j = 0; j < ns; ++j)
      put(setup.secondary_nodes[j], reach_.secondary[c][j], nodes[j], sides_[c].secondary[j]);
    for (std::size_t l = 0; l < setup.primary_nodes.size(); ++l)
      put(setup.primary_nodes[l], reach_.primary[c][l], nodes[ns + l], sides_[c].primary[l]);
    if (everything) {
      faces_[c].limit_to({}, {});
    } else {
      carry_rim(setup.secondary, reach_.secondary[c], start_[c].secondary, sides_[c].secondary);
      carry_rim(setup.primary, reach_.primary[c], start_[c].primary, sides_[c].primary);
    }
    faces_[c].integrate(sides_[c].secondary, sides_[c].primary);
  }
  placed_in_reach_ = !everything;
  divide(system.shared, faces_);
}

}  // namespace reye::solver
