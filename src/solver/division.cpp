#include "solver/division.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace reye::solver {

namespace {

using Places = SharedSecondary::Places;

template <class Key>
std::vector<Places> of_several(const std::map<Key, Places>& all) {
  std::vector<Places> shared;
  for (const auto& [key, places] : all)
    if (places.size() > 1) shared.push_back(places);
  return shared;
}

/// The part of a node that a contact covers, less where it is open: a gap of a hundredth of the facet halves it.
double claim(const contact::Interface& face, int node) {
  const auto& row = face.rows()[node];
  if (!face.touching(node) || row.D <= 0.0) return 0.0;
  constexpr double near = 0.01;
  const double open = std::max(0.0, face.gap()[node] + face.worn_gap(node)) / row.D;
  const double active = face.active(node) ? 2.0 : 1.0;
  return active * row.cover / (1.0 + open / (near * face.setup().length[node]));
}

/// The nodes and facets that a contact leaves to others.
struct Left {
  std::set<int> nodes, facets;
};

/// All but the first of the largest values.
template <class Value, class Leave>
void leave_to_largest(const Places& places, Value value, Leave leave) {
  std::vector<double> values;
  for (const auto& place : places) values.push_back(value(place));
  const auto largest = std::max_element(values.begin(), values.end());
  if (*largest <= 0.0) return;
  for (auto v = values.begin(); v != values.end(); ++v)
    if (v != largest && *v > 0.0) leave(places[static_cast<std::size_t>(v - values.begin())]);
}

}  // namespace

SharedSecondary shared_secondary(const std::vector<contact::Setup>& contacts) {
  std::map<std::pair<int, int>, Places> nodes;
  std::map<std::tuple<int, int, int>, Places> facets;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto& setup = contacts[c];
    if (setup.options.bonded) continue;
    const auto& at = setup.secondary_nodes;
    for (int j = 0; j < setup.secondary_count(); ++j) nodes[{at[j].body, at[j].mesh_node}].emplace_back(c, j);
    for (int f = 0; f < setup.secondary.facet_count(); ++f) {
      const auto& [a, b, mid] = setup.secondary.facets[f];
      facets[{at[a].body, at[a].mesh_node, at[b].mesh_node}].emplace_back(c, f);
    }
  }
  return {of_several(nodes), of_several(facets)};
}

void divide(const SharedSecondary& shared, std::vector<contact::Interface>& faces) {
  if (shared.nodes.empty()) return;
  std::vector<Left> left(faces.size());
  for (const auto& places : shared.nodes)
    leave_to_largest(
        places, [&](const auto& p) { return claim(faces[p.first], p.second); },
        [&](const auto& p) { left[p.first].nodes.insert(p.second); });
  const auto covered = [&](const std::pair<int, int>& place) {
    const auto& face = faces[place.first];
    const auto& facet = face.setup().secondary.facets[place.second];
    const bool carried = std::any_of(facet.begin(), facet.end(), [&](int node) {
      return node >= 0 && face.touching(node) && face.rows()[node].D > 0.0 && !left[place.first].nodes.contains(node);
    });
    return carried ? face.covered(place.second) : 0.0;
  };
  for (const auto& places : shared.facets)
    leave_to_largest(places, covered, [&](const auto& p) { left[p.first].facets.insert(p.second); });
  for (std::size_t c = 0; c < faces.size(); ++c)
    if (!left[c].nodes.empty() || !left[c].facets.empty())
      faces[c].leave({left[c].nodes.begin(), left[c].nodes.end()}, {left[c].facets.begin(), left[c].facets.end()});
}

}  // namespace reye::solver
