#include <algorithm>
#include <cmath>
#include <numbers>

#include "cad/region.hpp"
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

}  // namespace

void improve(Region& region, int first_free) {
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
