#include "mesh/outline.hpp"

#include <algorithm>
#include <map>

#include "base/errors.hpp"
#include "mesh/measure.hpp"

namespace reye::mesh {

namespace {

using Edge = std::pair<int, int>;

std::string where(const Points& X, int node) {
  return "node " + std::to_string(node) + " at (" + std::to_string(X[node].x()) + ", " + std::to_string(X[node].y()) +
         ")";
}

/// Where an edge leads, and by which mid node (-1: straight there).
struct Step {
  int mid, to;
};

/// Cell edges without a partner of opposite direction, by the vertex they start from.
std::map<int, Step> boundary_edges(const Points& X, CellKind kind, const std::vector<Cell>& cells) {
  const int n = corners(kind);
  std::map<Edge, int> mid_of;
  for (const Cell& cell : cells)
    for (int i = 0; i < n; ++i)
      if (!mid_of.insert({{cell[i], cell[(i + 1) % n]}, order(kind) == 2 ? cell[n + i] : -1}).second)
        throw base::MeshError("two cells lie on the same side of an edge at " + where(X, cell[i]));
  std::map<int, Step> next;
  for (const auto& [edge, mid] : mid_of) {
    const auto [from, to] = edge;
    if (const auto other = mid_of.find({to, from}); other != mid_of.end()) {
      if (other->second != mid) throw base::MeshError("two cells have different mid nodes on an edge at " + where(X, from));
      continue;
    }
    if (!next.insert({from, {mid, to}}).second) throw base::MeshError("two outlines meet in " + where(X, from));
  }
  return next;
}

}  // namespace

std::vector<Chain> outline_of(const Points& X, CellKind kind, const std::vector<Cell>& cells) {
  std::map<int, Step> next = boundary_edges(X, kind, cells);
  std::vector<Chain> loops;
  while (!next.empty()) {
    const int start = next.begin()->first;
    Chain loop{start};
    for (int node = start;;) {
      const auto step = next.find(node);
      if (step == next.end()) throw base::MeshError("the outline is not closed at " + where(X, node));
      node = step->second.to;
      if (step->second.mid >= 0) loop.push_back(step->second.mid);
      next.erase(step);
      loop.push_back(node);
      if (node == start) break;
    }
    loops.push_back(std::move(loop));
  }
  const auto outer = std::max_element(loops.begin(), loops.end(), [&](const Chain& a, const Chain& b) {
    return enclosed_area(X, a, order(kind)) < enclosed_area(X, b, order(kind));
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
