#include "sim/march/stick_edge.hpp"

#include <algorithm>
#include <cmath>

#include "base/formatted.hpp"
#include "scene/force_driven.hpp"
#include "sim/measure/stick_zone.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

namespace {

constexpr double most_lost =
    2.5;  ///< elements that a stick zone may lose: one at either end depends on which node is the last
constexpr int fewest_stuck =
    3;  ///< stick nodes of a zone: fewer may be a node on an axis, or one that has just touched

struct Loaded {
  int stick = 0, slip = 0;  ///< nodes that carry pressure: through the block in stick, or not
};

Loaded count(const contact::ContactState& state, const std::vector<double>& slip_before) {
  Loaded nodes;
  for (std::size_t j = 0; j < state.slip.size(); ++j)
    if (state.lambda[j].dot(state.normal[j]) > 0.0) ++(state.slip[j] > slip_before[j] ? nodes.slip : nodes.stick);
  return nodes;
}

/// Facets of a contact that carry pressure, of which some stick through a block.
StickZone stick_zone(const contact::Setup& setup, const contact::ContactState& state,
                     const std::vector<double>& slip_before) {
  StickZone zone;
  const auto loaded = [&](int j) { return state.lambda[j].dot(state.normal[j]) > 0.0; };
  const auto sticks = [&](int j) { return loaded(j) && state.slip[j] <= slip_before[j]; };
  for (const auto& [a, b, mid] : setup.secondary.facets) {
    if (!loaded(a) || !loaded(b)) continue;
    const double length = (setup.secondary.X[b] - setup.secondary.X[a]).norm();
    zone.contact_mm += length;
    if (!sticks(a) || !sticks(b)) continue;
    zone.stick_mm += length;
    zone.element_mm = std::max(zone.element_mm, length);
  }
  return zone;
}

std::string text_of(const Loaded& nodes) {
  const double share = nodes.stick / static_cast<double>(nodes.stick + nodes.slip), left = receded(share);
  std::string estimate = "; by the estimate for a round contact it vanishes";
  if (left > 0.0)
    estimate = base::formatted(
        "; by the estimate for a round contact by %.0f %% of its width, and the largest "
        "depth is %.0f %% too large in the end",
        100.0 * (1.0 - left / share), 100.0 * (limit_depth_of_cylinders(left) / limit_depth_of_cylinders(share) - 1.0));
  return std::to_string(nodes.stick) + " of " + std::to_string(nodes.stick + nodes.slip) +
         " nodes in contact stick while the others slip and wear, and on elements of first order the edge of a stick "
         "zone "
         "recedes as wear empties what lies around it" +
         estimate + "; order = 2 for the bodies and dual = \"linear\" for the contact hold it to one node";
}

}  // namespace

double receded(double stick_share) {
  return std::sqrt(std::max(0.0, 1.0 - edge_ratio * (1.0 - stick_share * stick_share)));
}

std::vector<std::vector<double>> slip_paths(const State& state) {
  std::vector<std::vector<double>> paths;
  for (const auto& contact : state.solution.contacts) paths.push_back(contact.slip);
  return paths;
}

void warn_of_stick_edge(const Problem& problem, const solver::System& system,
                        const std::vector<std::vector<double>>& slip_before, State& state, const Observer& observer) {
  const bool forced = scene::only_forces_drive(problem.scene);
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const auto& o = problem.contacts[c].options;
    if (o.friction == 0.0 || o.imposed || !o.wear.wears()) continue;
    const auto& contact = state.solution.contacts[c];
    if (forced && c < state.watch.size()) {
      const std::string about = "contact " + o.name;
      const StickZone now = stick_zone(system.contacts[c], contact, slip_before[c]);
      StickZone& widest = state.watch[c].widest;
      for (const auto& warning : {receding_stick(about, now, widest, most_lost, state.cycle, limit_depth_of_cylinders),
                                  unresolved_stick(about, widest, limit_depth_of_cylinders)})
        if (warning) warn(state, observer, *warning);
    }
    if (system.contacts[c].secondary.order != 1) continue;
    const Loaded nodes = count(state.solution.contacts[c], slip_before[c]);
    if (nodes.stick >= fewest_stuck && nodes.slip > 0)
      warn(state, observer, {"stick_edge", "contact " + o.name, text_of(nodes)});
  }
}

}  // namespace reye::sim
