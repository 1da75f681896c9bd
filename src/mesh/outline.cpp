#include "mesh/outline.hpp"

#include <algorithm>
#include <map>

#include "base/errors.hpp"
#include "mesh/measure.hpp"

namespace reye::mesh {

namespace {

std::string where(const Points& X, int node) {
  return "node " + std::to_string(node) + " at (" + std::to_string(X[node].x()) + ", " + std::to_string(X[node].y()) +
         ")";
}

/// An edge as a cell runs along it; mid: its middle node, -1 where it is straight.
struct Edge {
  int from, to, mid;
};

bool runs_before(const Edge& a, const Edge& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); }

/// Edges of all cells in ascending order of their ends.
std::vector<Edge> edges_of(CellKind kind, const std::vector<Cell>& cells) {
  const int n = corners(kind);
  std::vector<Edge> edges;
  edges.reserve(n * cells.size());
  for (const Cell& cell : cells)
    for (int i = 0; i < n; ++i) edges.push_back({cell[i], cell[(i + 1) % n], order(kind) == 2 ? cell[n + i] : -1});
  std::sort(edges.begin(), edges.end(), runs_before);
  return edges;
}

/// Cell edges without a partner of opposite direction, by the vertex they start from.
std::map<int, Edge> boundary_edges(const Points& X, CellKind kind, const std::vector<Cell>& cells) {
  const auto edges = edges_of(kind, cells);
  std::map<int, Edge> next;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge& edge = edges[i];
    if (i > 0 && !runs_before(edges[i - 1], edge))
      throw base::MeshError("two cells lie on the same side of an edge at " + where(X, edge.from));
    const Edge back{edge.to, edge.from, edge.mid};
    const auto other = std::lower_bound(edges.begin(), edges.end(), back, runs_before);
    if (other != edges.end() && !runs_before(back, *other)) {
      if (other->mid != edge.mid)
        throw base::MeshError("two cells have different mid nodes on an edge at " + where(X, edge.from));
      continue;
    }
    if (!next.insert({edge.from, edge}).second) throw base::MeshError("two outlines meet in " + where(X, edge.from));
  }
  return next;
}

}  // namespace

std::vector<Chain> outline_of(const Points& X, CellKind kind, const std::vector<Cell>& cells) {
  std::map<int, Edge> next = boundary_edges(X, kind, cells);
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

namespace {

/// Appends the chains of chosen edges of a loop; edge `first` is not chosen, so that none is cut where the loop's own
/// numbering starts.
void add_chains(const Chain& loop, const std::vector<bool>& chosen, std::size_t first, Boundary& chains) {
  const std::size_t edges = loop.size() - 1;
  bool open = false;
  for (std::size_t step = 0; step < edges; ++step) {
    const std::size_t edge = (first + step) % edges;
    if (chosen[edge]) {
      if (!open) chains.push_back({loop[edge]});
      chains.back().push_back(loop[edge + 1]);
    }
    open = chosen[edge];
  }
}

}  // namespace

Boundary chains_along(const std::vector<Chain>& outline, const std::vector<std::vector<bool>>& selected) {
  Boundary chains;
  for (std::size_t loop = 0; loop < outline.size(); ++loop) {
    const auto gap = std::find(selected[loop].begin(), selected[loop].end(), false);
    if (gap == selected[loop].end())
      chains.push_back(outline[loop]);
    else
      add_chains(outline[loop], selected[loop], static_cast<std::size_t>(gap - selected[loop].begin()), chains);
  }
  return chains;
}

}  // namespace reye::mesh
