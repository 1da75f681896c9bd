#include "mesh/outline.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <span>

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

/// Edges of all cells by the node they start from, and there in ascending order of the nodes they end in.
struct Edges {
  std::vector<Edge> all;
  std::vector<std::size_t> first;  ///< of each node, and the number of all

  std::span<const Edge> from(int node) const {
    const auto at = static_cast<std::size_t>(node);
    return std::span(all).subspan(first[at], first[at + 1] - first[at]);
  }
};

Edges edges_of(std::size_t nodes, CellKind kind, const std::vector<Cell>& cells) {
  const int n = corners(kind);
  Edges edges;
  edges.first.assign(nodes + 1, 0);
  for (const Cell& cell : cells)
    for (int i = 0; i < n; ++i) {
      if (cell[i] < 0 || static_cast<std::size_t>(cell[i]) >= nodes)
        throw base::MeshError("a cell names node " + std::to_string(cell[i]) + ", which does not exist");
      ++edges.first[static_cast<std::size_t>(cell[i]) + 1];
    }
  std::partial_sum(edges.first.begin(), edges.first.end(), edges.first.begin());
  edges.all.resize(edges.first.back());
  auto next = edges.first;
  for (const Cell& cell : cells)
    for (int i = 0; i < n; ++i)
      edges.all[next[static_cast<std::size_t>(cell[i])]++] = {cell[i], cell[(i + 1) % n],
                                                              order(kind) == 2 ? cell[n + i] : -1};
  for (std::size_t node = 0; node < nodes; ++node)
    std::sort(edges.all.begin() + static_cast<std::ptrdiff_t>(edges.first[node]),
              edges.all.begin() + static_cast<std::ptrdiff_t>(edges.first[node + 1]),
              [](const Edge& a, const Edge& b) { return a.to < b.to; });
  return edges;
}

/// Cell edges without a partner of opposite direction, by the vertex they start from.
std::map<int, Edge> boundary_edges(const Points& X, CellKind kind, const std::vector<Cell>& cells) {
  const Edges edges = edges_of(X.size(), kind, cells);
  std::map<int, Edge> next;
  for (const Edge& edge : edges.all) {
    const auto beside = edges.from(edge.from), opposite = edges.from(edge.to);
    if (&edge != beside.data() && (&edge - 1)->to == edge.to)
      throw base::MeshError("two cells lie on the same side of an edge at " + where(X, edge.from));
    const auto back = std::find_if(opposite.begin(), opposite.end(), [&](const Edge& e) { return e.to == edge.from; });
    if (back != opposite.end()) {
      if (back->mid != edge.mid)
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
