#include "solver/report.hpp"

#include "base/formatted.hpp"

namespace reye::solver {

namespace {

using Placed = std::vector<std::vector<PlacedNode>>;

std::string short_number(double value) { return base::formatted("%.1e", value); }

std::string node_in_words(int mesh_node, const Vec2& x, const std::string& owner) {
  const std::string text = base::formatted("node %d at (%.4g, %.4g) mm of ", mesh_node, x.x(), x.y());
  return text + owner;
}

/// A secondary node in words; an empty text without one.
std::string named(const System& system, const Placed& nodes, const Suspects::Node& node) {
  if (node.contact < 0) return {};
  const auto& setup = system.contacts[node.contact];
  return node_in_words(setup.secondary_nodes[node.node].mesh_node, nodes[node.contact][node.node].position.x,
                       "contact " + setup.options.name);
}

std::string least_balanced(const System& system, const Placed& nodes, const Suspects& suspects) {
  if (suspects.unbalanced < 0) return suspects.inside;
  for (std::size_t c = 0; c < nodes.size(); ++c)
    for (std::size_t k = 0; k < nodes[c].size(); ++k)
      for (int t = 0; t < nodes[c][k].position.count; ++t) {
        if (nodes[c][k].column[t] != suspects.unbalanced) continue;
        const auto& setup = system.contacts[c];
        const auto ns = setup.secondary_nodes.size();
        const auto& node = k < ns ? setup.secondary_nodes[k] : setup.primary_nodes[k - ns];
        return node_in_words(node.mesh_node, nodes[c][k].position.x, "contact " + setup.options.name);
      }
  return "a support";
}

}  // namespace

std::string no_convergence(const System& system, const Placed& nodes, const Suspects& suspects,
                           const std::vector<Iteration>& table, const NewtonOptions& options) {
  const Iteration& last = table.back();
  const auto at = [](const std::string& place) { return place.empty() ? "" : " at " + place; };
  std::vector<std::string> unmet;
  if (last.force > options.force_tolerance)
    unmet.push_back("forces are out of balance by " + short_number(last.force) + " of the largest" +
                    at(least_balanced(system, nodes, suspects)));
  if (last.condition > options.condition_tolerance)
    unmet.push_back("a gap or shear violates its condition by " + short_number(last.condition) +
                    " of the largest traction" + at(named(system, nodes, suspects.unmet)));
  if (suspects.circles)
    unmet.push_back("no consistent contact status exists" + at(named(system, nodes, suspects.asking)));
  else if (last.changes > 0)
    unmet.push_back(std::to_string(last.changes) + (last.changes == 1 ? " node still changes" : " nodes still change") +
                    " status, the first" + at(named(system, nodes, suspects.asking)));
  std::string text = "no convergence in " + std::to_string(table.size() - 1) + " iterations";
  for (std::size_t i = 0; i < unmet.size(); ++i)
    text += (i == 0 ? ": " : i + 1 == unmet.size() ? ", and " : ", ") + unmet[i];
  return text;
}

}  // namespace reye::solver
