#include <algorithm>
#include <limits>

#include "cad/meshing/region.hpp"
#include "mesh/measure.hpp"
#include "mesh/quality.hpp"

namespace reye::cad {

namespace {

constexpr double least_width = 0.5;

/// Nodes of the stretch in order; empty if it is not on this loop or runs all round it.
std::vector<int> stretch_of(const RegionLoop& loop, int first, int last) {
  const auto begin = std::find(loop.nodes.begin(), loop.nodes.end(), first);
  if (begin == loop.nodes.end()) return {};
  const std::size_t count = loop.nodes.size(), start = static_cast<std::size_t>(begin - loop.nodes.begin());
  std::vector<int> nodes;
  for (std::size_t i = 0; i < count; ++i) {
    nodes.push_back(loop.nodes[(start + i) % count]);
    if (i > 0 && nodes.back() == last) return nodes;
  }
  return {};
}

/// Inward unit normal at each node: the mean of its two edges; at the ends the neighbours outside the stretch count
/// too.
Points inward_normals(const Region& region, const RegionLoop& loop, const std::vector<int>& stretch) {
  const std::size_t count = loop.nodes.size();
  const std::size_t start = std::find(loop.nodes.begin(), loop.nodes.end(), stretch[0]) - loop.nodes.begin();
  Points normals;
  for (std::size_t i = 0; i < stretch.size(); ++i) {
    const Vec2& here = region.X[stretch[i]];
    const Vec2 in = (here - region.X[loop.nodes[(start + i + count - 1) % count]]).normalized();
    const Vec2 out = (region.X[loop.nodes[(start + i + 1) % count]] - here).normalized();
    normals.push_back(-base::right_of((in + out).normalized()));
  }
  return normals;
}

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const double u = mesh::nearest_parameter(a, b, p);
  return (a + u * (b - a) - p).norm();
}

double distance_to_loops(const Region& region, const Vec2& p) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const RegionLoop& loop : region.loops)
    for (std::size_t i = 0; i < loop.nodes.size(); ++i)
      smallest = std::min(
          smallest, distance_to_segment(p, region.X[loop.nodes[i]], region.X[loop.nodes[(i + 1) % loop.nodes.size()]]));
  return smallest;
}

/// Whether a ray from p along x leaves through the loops.
bool is_inside(const Region& region, const Vec2& p) {
  bool inside = false;
  for (const RegionLoop& loop : region.loops)
    for (std::size_t i = 0; i < loop.nodes.size(); ++i) {
      const Vec2 &a = region.X[loop.nodes[i]], &b = region.X[loop.nodes[(i + 1) % loop.nodes.size()]];
      if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
        inside = !inside;
    }
  return inside;
}

/// The rows as a table of nodes: rows[j][i] lies j layers beneath stretch node i. New nodes follow those of the region.
struct Rows {
  std::vector<std::vector<int>> nodes;
  Points added;
};

Rows make_rows(const Region& region, const std::vector<int>& stretch, const Points& normals, int layers, double depth) {
  Rows rows{{stretch}, {}};
  for (int j = 1; j <= layers; ++j) {
    rows.nodes.emplace_back();
    for (std::size_t i = 0; i < stretch.size(); ++i) {
      rows.nodes.back().push_back(static_cast<int>(region.X.size() + rows.added.size()));
      rows.added.push_back(region.X[stretch[i]] + depth * j / layers * normals[i]);
    }
  }
  return rows;
}

/// Whether the rim of the rows keeps as far from the outline as its depth lets expect, and lies inside the body: in a
/// body thinner than the rows are deep it would lie beyond the opposite face.
bool is_clear(const Region& region, const Rows& rows, double depth) {
  const std::size_t width = rows.nodes[0].size(), layers = rows.nodes.size() - 1;
  for (std::size_t j = 1; j <= layers; ++j)
    for (std::size_t i = 0; i < width; ++i) {
      if (j < layers && i != 0 && i + 1 != width) continue;
      const double expected = depth * static_cast<double>(j) / static_cast<double>(layers);
      const Vec2& p = rows.added[(j - 1) * width + i];
      if (distance_to_loops(region, p) < 0.6 * expected || !is_inside(region, p)) return false;
    }
  return true;
}

/// Smallest width of a cell in the last row against that of its facet: under a bend of the outline rows may keep their
/// angles and lose their width.
double narrowest(const Points& X, const Rows& rows) {
  double smallest = 1.0;
  const auto &top = rows.nodes.front(), &last = rows.nodes.back();
  for (std::size_t i = 0; i + 1 < top.size(); ++i)
    smallest = std::min(smallest, (X[last[i + 1]] - X[last[i]]).norm() / (X[top[i + 1]] - X[top[i]]).norm());
  return smallest;
}

/// Replaces the stretch in its loop by the way round the rows.
void go_round(RegionLoop& loop, const Rows& rows) {
  const std::vector<int>& stretch = rows.nodes.front();
  const auto start = std::find(loop.nodes.begin(), loop.nodes.end(), stretch[0]) - loop.nodes.begin();
  std::rotate(loop.nodes.begin(), loop.nodes.begin() + start, loop.nodes.end());
  std::rotate(loop.corner.begin(), loop.corner.begin() + start, loop.corner.end());
  std::vector<int> way;
  for (const auto& row : rows.nodes) way.push_back(row.front());
  way.insert(way.end(), rows.nodes.back().begin() + 1, rows.nodes.back().end());
  for (auto row = rows.nodes.rbegin() + 1; row != rows.nodes.rend(); ++row) way.push_back(row->back());
  std::vector<bool> corner(way.size(), false);
  const std::size_t down = rows.nodes.size() - 1;
  for (std::size_t turn : {std::size_t{0}, down, way.size() - 1 - down, way.size() - 1}) corner[turn] = true;
  const auto cut = static_cast<std::ptrdiff_t>(stretch.size());
  way.insert(way.end(), loop.nodes.begin() + cut, loop.nodes.end());
  corner.insert(corner.end(), loop.corner.begin() + cut, loop.corner.end());
  loop = {std::move(way), std::move(corner)};
}

}  // namespace

std::vector<mesh::Cell> cells_between(const std::vector<std::vector<int>>& rows, mesh::CellKind kind) {
  std::vector<mesh::Cell> cells;
  for (std::size_t j = 0; j + 1 < rows.size(); ++j)
    for (std::size_t i = 0; i + 1 < rows[j].size(); ++i) {
      const int a = rows[j][i], b = rows[j][i + 1], c = rows[j + 1][i + 1], d = rows[j + 1][i];
      if (kind == mesh::CellKind::quad4) {
        cells.push_back(mesh::cell_of({a, b, c, d}));
      } else if ((i + j) % 2 == 0) {
        cells.push_back(mesh::cell_of({a, b, c}));
        cells.push_back(mesh::cell_of({a, c, d}));
      } else {
        cells.push_back(mesh::cell_of({a, b, d}));
        cells.push_back(mesh::cell_of({b, c, d}));
      }
    }
  return cells;
}

bool add_layers(Region& region, int first, int last, int layers, double depth) {
  for (RegionLoop& loop : region.loops) {
    const std::vector<int> stretch = stretch_of(loop, first, last);
    if (stretch.size() < 3) continue;
    const Rows rows = make_rows(region, stretch, inward_normals(region, loop, stretch), layers, depth);
    if (!is_clear(region, rows, depth)) return false;
    Points X = region.X;
    X.insert(X.end(), rows.added.begin(), rows.added.end());
    const std::vector<mesh::Cell> quads = cells_between(rows.nodes, mesh::CellKind::quad4);
    constexpr double good = 0.7;
    for (const mesh::Cell& cell : quads)
      if (mesh::scaled_jacobian(X, mesh::CellKind::quad4, cell) < good) return false;
    if (narrowest(X, rows) < least_width) return false;
    region.X = std::move(X);
    const std::vector<mesh::Cell> cells = cells_between(rows.nodes, region.kind);
    region.cells.insert(region.cells.end(), cells.begin(), cells.end());
    go_round(loop, rows);
    return true;
  }
  return false;
}

}  // namespace reye::cad
