#include <algorithm>

#include "cad/meshing/region.hpp"
#include "mesh/quality.hpp"

namespace reye::cad {

namespace {

/// The four sides of the loop, each from corner to corner; empty unless there are just four corners.
std::vector<std::vector<int>> sides_of(const RegionLoop& loop) {
  const std::size_t count = loop.nodes.size();
  const std::size_t start = std::find(loop.corner.begin(), loop.corner.end(), true) - loop.corner.begin();
  std::vector<std::vector<int>> sides;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = (start + i) % count;
    if (loop.corner[k]) {
      if (!sides.empty()) sides.back().push_back(loop.nodes[k]);
      sides.emplace_back();
    }
    sides.back().push_back(loop.nodes[k]);
  }
  sides.back().push_back(loop.nodes[start]);
  return sides.size() == 4 ? sides : std::vector<std::vector<int>>{};
}

/// Coons' blend of the four sides at column i of n and row j of m.
Vec2 blend(const Points& X, const std::vector<std::vector<int>>& sides, std::size_t i, std::size_t j) {
  const std::size_t n = sides[0].size() - 1, m = sides[1].size() - 1;
  const double u = static_cast<double>(i) / static_cast<double>(n), v = static_cast<double>(j) / static_cast<double>(m);
  const auto at = [&](std::size_t side, std::size_t k) -> const Vec2& { return X[sides[side][k]]; };
  const Vec2 sum = (1.0 - v) * at(0, i) + v * at(2, n - i) + (1.0 - u) * at(3, m - j) + u * at(1, j);
  return sum - (1.0 - u) * (1.0 - v) * at(0, 0) - u * (1.0 - v) * at(1, 0) - u * v * at(2, 0) -
         (1.0 - u) * v * at(3, 0);
}

/// The nodes of the grid, row by row; the inner ones are added to the region.
std::vector<std::vector<int>> grid_nodes(const std::vector<std::vector<int>>& sides, Region& region) {
  const std::size_t n = sides[0].size() - 1, m = sides[1].size() - 1;
  std::vector<std::vector<int>> rows(m + 1, std::vector<int>(n + 1));
  rows[0] = sides[0];
  rows[m].assign(sides[2].rbegin(), sides[2].rend());
  for (std::size_t j = 1; j < m; ++j) {
    rows[j][0] = sides[3][m - j];
    rows[j][n] = sides[1][j];
    for (std::size_t i = 1; i < n; ++i) {
      rows[j][i] = static_cast<int>(region.X.size());
      region.X.push_back(blend(region.X, sides, i, j));
    }
  }
  return rows;
}

/// Whether all quads have a sound shape and are no longer than wished.
bool are_good(const std::vector<mesh::Cell>& quads, const Points& X, const SizeField& size) {
  constexpr double good = 0.7, coarsest = 2.0;  // scaled Jacobian; diagonal over wished size (a square: 1.41)
  return std::all_of(quads.begin(), quads.end(), [&](const mesh::Cell& cell) {
    if (mesh::scaled_jacobian(X, mesh::CellKind::quad4, cell) < good) return false;
    const Vec2 diagonal = X[cell[2]] - X[cell[0]];
    return !(diagonal.norm() > coarsest * size(X[cell[0]] + 0.5 * diagonal));
  });
}

}  // namespace

bool add_grid(Region& region, const SizeField& size) {
  if (region.loops.size() != 1) return false;
  const auto sides = sides_of(region.loops[0]);
  if (sides.empty() || sides[0].size() != sides[2].size() || sides[1].size() != sides[3].size()) return false;
  Region filled = region;
  const auto rows = grid_nodes(sides, filled);
  if (!are_good(cells_between(rows, mesh::CellKind::quad4), filled.X, size)) return false;
  filled.cells = cells_between(rows, region.kind);
  filled.loops.clear();
  region = std::move(filled);
  return true;
}

}  // namespace reye::cad
