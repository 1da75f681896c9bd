#include "mesh/second_order.hpp"

#include <utility>

namespace reye::mesh {

namespace {

/// Calls change(chain) for every chain of the outline and the boundaries.
template <class Change>
void for_each_chain(Mesh& mesh, Change change) {
  for (Chain& loop : mesh.outline) change(loop);
  for (auto& [name, boundary] : mesh.boundaries)
    for (Chain& chain : boundary) change(chain);
}

/// The node in the middle of the edge a, b, made on first request.
struct MidNodes {
  Points& X;
  std::map<std::pair<int, int>, int> known;

  int operator()(int a, int b) {
    const auto [entry, is_new] = known.try_emplace(std::minmax(a, b), static_cast<int>(X.size()));
    if (is_new) X.push_back(0.5 * (X[a] + X[b]));
    return entry->second;
  }
};

}  // namespace

Mesh to_second_order(const Mesh& mesh) {
  if (order(mesh.kind) == 2) return mesh;
  Mesh result = mesh;
  result.kind = mesh.kind == CellKind::tri3 ? CellKind::tri6 : CellKind::quad8;
  const int n = corners(mesh.kind);
  MidNodes mid{result.X, {}};
  for (Cell& cell : result.cells)
    for (int k = 0; k < n; ++k) cell[n + k] = mid(cell[k], cell[(k + 1) % n]);
  for_each_chain(result, [&](Chain& chain) {
    Chain refined{chain.front()};
    for (std::size_t i = 1; i < chain.size(); ++i) {
      refined.push_back(mid(chain[i - 1], chain[i]));
      refined.push_back(chain[i]);
    }
    chain = std::move(refined);
  });
  return result;
}

namespace {

/// Per node: 0 where it is a corner of a cell or a vertex of a chain, else -1. `mesh`: its chains have vertices alone.
std::vector<int> marked_vertices(Mesh& mesh, int corners) {
  std::vector<int> mark(mesh.X.size(), -1);
  for (const Cell& cell : mesh.cells)
    for (int k = 0; k < corners; ++k) mark[cell[k]] = 0;
  for_each_chain(mesh, [&](const Chain& chain) {
    for (int node : chain) mark[node] = 0;
  });
  return mark;
}

/// Leaves out the unmarked nodes, and numbers the others in their order; `number`: -1 or the new number of a node.
void keep_marked(Mesh& mesh, std::vector<int>& number) {
  const Points X = std::exchange(mesh.X, {});
  for (std::size_t node = 0; node < X.size(); ++node) {
    if (number[node] < 0) continue;
    number[node] = mesh.node_count();
    mesh.X.push_back(X[node]);
  }
}

}  // namespace

Mesh to_first_order(const Mesh& mesh) {
  if (order(mesh.kind) == 1) return mesh;
  Mesh result = mesh;
  result.kind = mesh.kind == CellKind::tri6 ? CellKind::tri3 : CellKind::quad4;
  const int n = corners(mesh.kind);
  for_each_chain(result, [&](Chain& chain) {
    Chain vertices;
    for (std::size_t i = 0; i < chain.size(); i += 2) vertices.push_back(chain[i]);
    chain = std::move(vertices);
  });
  std::vector<int> number = marked_vertices(result, n);
  keep_marked(result, number);
  for (Cell& cell : result.cells)
    for (int k = 0; k < most_cell_nodes; ++k) cell[k] = k < n ? number[cell[k]] : -1;
  for_each_chain(result, [&](Chain& chain) {
    for (int& node : chain) node = number[node];
  });
  for (auto& [name, origins] : result.arc_origin)
    for (int& node : origins) node = number[node];
  std::erase_if(result.points, [&](int node) { return number[node] < 0; });
  for (int& node : result.points) node = number[node];
  return result;
}

}  // namespace reye::mesh
