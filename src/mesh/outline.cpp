#include "mesh/outline.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "base/errors.hpp"
#include "mesh/measure.hpp"

namespace reye::mesh {

namespace {

using Edge = std::pair<int, int>;

std::string where(const Points& X, int node) {
  return "node " + std::to_string(node) + " at (" + std::to_string(X[node].x()) + ", " + std::to_string(X[node].y()) +
         ")";
}

/// Cell edges without a partner of opposite direction, as from -> to.
std::map<int, int> boundary_edges(const Points& X, CellKind kind, const std::vector<Cell>& cells) {
  const int corners = nodes_per_cell(kind);
  std::set<Edge> edges;
  for (const Cell& cell : cells)
    for (int i = 0; i < corners; ++i)
      if (!edges.insert({cell[i], cell[(i + 1) % corners]}).second)
        throw base::MeshError("two cells lie on the same side of an edge at " + where(X, cell[i]));
  std::map<int, int> next;
  for (const auto& [from, to] : edges) {
    if (edges.contains({to, from})) continue;
    if (!next.insert({from, to}).second) throw base::MeshError("two outlines meet in " + where(X, from));
  }
  return next;
}

}  // namespace

std::vector<Chain> outline_of(const Points& X, CellKind kind, const std::vector<Cell>& cells) {
  std::map<int, int> next = boundary_edges(X, kind, cells);
  std::vector<Chain> loops;
  while (!next.empty()) {
    const int start = next.begin()->first;
    Chain loop{start};
    for (int node = start;;) {
      const auto step = next.find(node);
      if (step == next.end()) throw base::MeshError("the outline is not closed at " + where(X, node));
      node = step->second;
      next.erase(step);
      loop.push_back(node);
      if (node == start) break;
    }
    loops.push_back(std::move(loop));
  }
  const auto outer = std::max_element(loops.begin(), loops.end(), [&](const Chain& a, const Chain& b) {
    return enclosed_area(X, a) < enclosed_area(X, b);
  });
  if (outer != loops.end()) std::rotate(loops.begin(), outer, outer + 1);
  return loops;
}

Boundary chains_along(const std::vector<Chain>& outline, const std::vector<std::vector<bool>>& selected) {
  Boundary chains;
  for (std::size_t loop = 0; loop < outline.size(); ++loop) {
    const Chain& nodes = outline[loop];
    const std::vector<bool>& chosen = selected[loop];
    const std::size_t edges = nodes.size() - 1;
    const auto gap = std::find(chosen.begin(), chosen.end(), false);
    if (gap == chosen.end()) {
      chains.push_back(nodes);
      continue;
    }
    // Starting at an edge left out, no chain is cut where the loop's own numbering starts.
    const std::size_t first = static_cast<std::size_t>(gap - chosen.begin());
    bool open = false;
    for (std::size_t step = 0; step < edges; ++step) {
      const std::size_t edge = (first + step) % edges;
      if (chosen[edge]) {
        if (!open) chains.push_back({nodes[edge]});
        chains.back().push_back(nodes[edge + 1]);
      }
      open = chosen[edge];
    }
  }
  return chains;
}

}  // namespace reye::mesh
