#include "sim/march/stick_edge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/formatted.hpp"
#include "scene/choose_elements.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

namespace {

constexpr double most_lost =
    2.5;  ///< elements that a stick zone may lose: one at either end depends on which node is the last
constexpr double most_unresolved = 0.2;  ///< of the largest depth in the end, by one element of the stick zone
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

/// Lengths of the facets of a contact that carry pressure: of those that stick through a block, of all, and of the
/// longest that sticks.
struct Widths {
  double stick = 0.0, all = 0.0, element = 0.0;
};

Widths widths(const contact::Setup& setup, const contact::ContactState& state, const std::vector<double>& slip_before) {
  Widths w;
  const auto loaded = [&](int j) { return state.lambda[j].dot(state.normal[j]) > 0.0; };
  const auto sticks = [&](int j) { return loaded(j) && state.slip[j] <= slip_before[j]; };
  for (const auto& [a, b, mid] : setup.secondary.facets) {
    if (!loaded(a) || !loaded(b)) continue;
    const double length = (setup.secondary.X[b] - setup.secondary.X[a]).norm();
    w.all += length;
    if (!sticks(a) || !sticks(b)) continue;
    w.stick += length;
    w.element = std::max(w.element, length);
  }
  return w;
}

/// A warning of a receding stick zone: under forces alone it keeps its width whatever wears around it, so a loss of
/// more than two elements is due to the mesh.
std::optional<Warning> receding(const std::string& contact, const Widths& now, ContactWatch& watch, double cycle) {
  if (now.stick > watch.stick_mm) {
    watch.stick_mm = now.stick;
    watch.contact_mm = now.all;
    watch.facet_mm = now.element;
  }
  const double lost = watch.stick_mm - now.stick, share = watch.stick_mm / watch.contact_mm;
  if (lost <= most_lost * watch.facet_mm || share >= 1.0) return std::nullopt;
  const double left = share * now.stick / watch.stick_mm;
  std::string estimate = "it wears without bound";
  if (left > 0.0)
    estimate = base::formatted("by the estimate for a round contact the largest depth is %.0f %% too large in the end",
                               100.0 * (limit_depth(left) / limit_depth(share) - 1.0));
  const std::string words = base::formatted(
      "its stick zone has receded from %.3g to %.3g mm by cycle %g, and would keep its width under "
      "forces of one amplitude: %s; shorter elements hold its edge longer",
      watch.stick_mm, now.stick, cycle, estimate.c_str());
  return Warning{"stick_zone", "contact " + contact, words, lost / watch.stick_mm};
}

/// By how much the largest depth of the end is too large when a stick zone is `less` narrower than it was [mm].
double deeper(const ContactWatch& watch, double less) {
  const double left = (watch.stick_mm - less) / watch.contact_mm;
  if (left <= 0.0) return std::numeric_limits<double>::infinity();
  return limit_depth(left) / limit_depth(watch.stick_mm / watch.contact_mm) - 1.0;
}

/// A warning of a stick zone of few elements: its edge is known to one of them, and the depth in the end hangs on it.
std::optional<Warning> unresolved(const std::string& contact, const ContactWatch& watch) {
  if (watch.stick_mm <= 0.0 || watch.stick_mm >= watch.contact_mm) return std::nullopt;
  const double error = deeper(watch, watch.facet_mm);
  if (error <= most_unresolved) return std::nullopt;
  double suited = watch.facet_mm;
  while (deeper(watch, suited) > 0.5 * most_unresolved) suited *= 0.9;
  const std::string by = std::isfinite(error) ? base::formatted("uncertain by %.0f %% in the end", 100.0 * error)
                                              : "unknown: without that element nothing would stick";
  return Warning{
      "stick_elements", "contact " + contact,
      base::formatted("its stick zone of %.3g mm has %.3g elements, and its edge is known to one of them: by "
                      "the estimate for a round contact the largest depth is %s; elements of %.2g mm would "
                      "leave a tenth",
                      watch.stick_mm, watch.stick_mm / watch.facet_mm, by.c_str(), suited),
      watch.facet_mm / watch.stick_mm};
}

std::string text_of(const Loaded& nodes) {
  const double share = nodes.stick / static_cast<double>(nodes.stick + nodes.slip), left = receded(share);
  std::string estimate = "; by the estimate for a round contact it vanishes";
  if (left > 0.0)
    estimate = base::formatted(
        "; by the estimate for a round contact by %.0f %% of its width, and the largest "
        "depth is %.0f %% too large in the end",
        100.0 * (1.0 - left / share), 100.0 * (limit_depth(left) / limit_depth(share) - 1.0));
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

double limit_depth(double stick_share) {
  const double c2 = stick_share * stick_share, x = std::sqrt(0.5 * (1.0 + c2));
  return std::acosh(x / stick_share) - x * std::sqrt(x * x - c2);
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
      const Widths now = widths(system.contacts[c], contact, slip_before[c]);
      for (const auto& warning :
           {receding(o.name, now, state.watch[c], state.cycle), unresolved(o.name, state.watch[c])})
        if (warning) warn(state, observer, *warning);
    }
    if (system.contacts[c].secondary.order != 1) continue;
    const Loaded nodes = count(state.solution.contacts[c], slip_before[c]);
    if (nodes.stick >= fewest_stuck && nodes.slip > 0)
      warn(state, observer, {"stick_edge", "contact " + o.name, text_of(nodes)});
  }
}

}  // namespace reye::sim
