#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "cad/meshing/region.hpp"
#include "mesh/quality.hpp"

namespace reye::cad {

namespace {

/// Smallest scaled Jacobian of the cells round a node.
double worst_round(const Region& region, const std::vector<int>& cells) {
  double worst = 1.0;
  for (int cell : cells) worst = std::min(worst, mesh::scaled_jacobian(region.X, region.kind, region.cells[cell]));
  return worst;
}

/// Length of the longest side of the cells round a node.
double reach_of(const Region& region, const std::vector<int>& cells) {
  const int corners = mesh::nodes_per_cell(region.kind);
  double longest = 0.0;
  for (int cell : cells)
    for (int k = 0; k < corners; ++k)
      longest =
          std::max(longest, (region.X[region.cells[cell][k]] - region.X[region.cells[cell][(k + 1) % corners]]).norm());
  return longest;
}

/// Moves a node to the best of a star of places round it, ever closer ones, while that lifts the worst cell.
bool move(Region& region, int node, const std::vector<int>& cells) {
  constexpr int directions = 8;
  const double before = worst_round(region, cells);
  double best = before;
  double step = 0.2 * reach_of(region, cells);
  for (int scale = 0; scale < 5; ++scale, step *= 0.5) {
    const Vec2 from = region.X[node];
    Vec2 to = from;
    for (int k = 0; k < directions; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / directions;
      region.X[node] = from + step * Vec2(std::cos(angle), std::sin(angle));
      const double quality = worst_round(region, cells);
      if (quality <= best) continue;
      best = quality;
      to = region.X[node];
    }
    region.X[node] = to;
  }
  return best > before + 1e-3;
}

/// The node of a triangle opposite to its edge between two others.
int node_opposite(const mesh::Cell& cell, int a, int b) {
  int opposite = cell[0];
  for (int node : {cell[1], cell[2]})
    if (node != a && node != b) opposite = node;
  return opposite;
}

/// A triangle alone at a node, between two outline facets: where these are nearly in line it is flat whatever its inner
/// nodes do. Its inner edge is turned when that lifts the poorer of the two triangles at it.
void turn_ears(Region& region) {
  std::vector<int> count(region.X.size(), 0);
  std::map<std::pair<int, int>, int> at;  // directed edge to the cell on its left
  for (int c = 0; c < static_cast<int>(region.cells.size()); ++c)
    for (int k = 0; k < 3; ++k) {
      ++count[region.cells[c][k]];
      at[{region.cells[c][k], region.cells[c][(k + 1) % 3]}] = c;
    }
  const auto quality = [&](const mesh::Cell& cell) { return mesh::scaled_jacobian(region.X, region.kind, cell); };
  for (int c = 0; c < static_cast<int>(region.cells.size()); ++c)
    for (int k = 0; k < 3; ++k) {
      const mesh::Cell ear = region.cells[c];
      const int tip = ear[k], next = ear[(k + 1) % 3], last = ear[(k + 2) % 3];
      const auto other = at.find({last, next});
      if (count[tip] != 1 || other == at.end()) continue;
      const mesh::Cell beyond = region.cells[other->second];
      const int far = node_opposite(beyond, last, next);
      if (far == last || far == next) continue;
      const mesh::Cell one = mesh::cell_of({tip, next, far}), two = mesh::cell_of({tip, far, last});
      if (std::min(quality(one), quality(two)) <= std::min(quality(ear), quality(beyond))) continue;
      region.cells[c] = one;
      region.cells[other->second] = two;
      break;
    }
}

}  // namespace

void improve(Region& region, int first_free) {
  if (region.kind == mesh::CellKind::tri3) turn_ears(region);
  constexpr double content = 0.5;
  constexpr int sweeps = 8;
  std::vector<std::vector<int>> round(region.X.size());
  for (int cell = 0; cell < static_cast<int>(region.cells.size()); ++cell)
    for (int k = 0; k < mesh::nodes_per_cell(region.kind); ++k) round[region.cells[cell][k]].push_back(cell);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    bool moved = false;
    for (int node = first_free; node < static_cast<int>(region.X.size()); ++node)
      if (worst_round(region, round[node]) < content) moved = move(region, node, round[node]) || moved;
    if (!moved) return;
  }
}

}  // namespace reye::cad
