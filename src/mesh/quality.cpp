#include "mesh/quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

#include "base/errors.hpp"
#include "mesh/measure.hpp"
#include "mesh/outline.hpp"
#include "mesh/shape.hpp"

namespace reye::mesh {

namespace {

std::string at(const Vec2& p) {
  std::ostringstream text;
  text << " at (" << p.x() << ", " << p.y() << ")";
  return text.str();
}

/// Applies f(e1, e2) to the two edges leaving each corner and keeps the smallest result.
template <class F>
double smallest_over_corners(const Points& X, CellKind kind, const Cell& cell, F f) {
  const int n = corners(kind);
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < n; ++i) {
    const Vec2& corner = X[cell[i]];
    smallest = std::min(smallest, f(X[cell[(i + 1) % n]] - corner, X[cell[(i + n - 1) % n]] - corner));
  }
  return smallest;
}

double jacobian(const Points& X, CellKind kind, const Cell& cell, const Vec2& xi) {
  const NodeGradients dN = shape_gradients(kind, xi);
  Eigen::Matrix2d J = Eigen::Matrix2d::Zero();
  for (int a = 0; a < nodes_per_cell(kind); ++a) J += X[cell[a]] * dN.row(a);
  return base::cross(J.col(0), J.col(1));
}

/// Sample points of the Jacobian of a cell of second order: its nodes, its centre, and between centre and corners.
std::vector<Vec2> samples(CellKind kind) {
  std::vector<Vec2> points;
  for (int a = 0; a < nodes_per_cell(kind); ++a) points.push_back(reference_node(kind, a));
  const Vec2 centre = corners(kind) == 3 ? Vec2(1.0 / 3.0, 1.0 / 3.0) : Vec2(0.0, 0.0);
  points.push_back(centre);
  for (int a = 0; a < corners(kind); ++a) points.push_back(0.5 * (centre + reference_node(kind, a)));
  return points;
}

/// Smallest det J of a cell of second order over that of the cell with the same corners and straight edges.
double bending(const Points& X, CellKind kind, const Cell& cell) {
  static const std::vector<Vec2> triangle = samples(CellKind::tri6), square = samples(CellKind::quad8);
  const bool tri = kind == CellKind::tri6;
  double smallest = 1.0;
  for (const Vec2& xi : tri ? triangle : square)
    smallest =
        std::min(smallest, jacobian(X, kind, cell, xi) / jacobian(X, tri ? CellKind::tri3 : CellKind::quad4, cell, xi));
  return smallest;
}

void check_nodes(const Mesh& mesh) {
  std::vector<bool> used(mesh.X.size(), false);
  const auto mark = [&](int node, const char* whose) {
    if (node < 0 || node >= mesh.node_count())
      throw base::MeshError(std::string(whose) + " names node " + std::to_string(node) + ", which does not exist");
    used[node] = true;
  };
  for (const Cell& cell : mesh.cells)
    for (int i = 0; i < nodes_per_cell(mesh.kind); ++i) mark(cell[i], "a cell");
  if (mesh.cells.empty())
    for (const Chain& loop : mesh.outline)
      for (int node : loop) mark(node, "the outline");
  for (int node = 0; node < mesh.node_count(); ++node) {
    if (!mesh.X[node].allFinite()) throw base::MeshError("node " + std::to_string(node) + " has no finite position");
    if (!used[node]) throw base::MeshError("node " + std::to_string(node) + at(mesh.X[node]) + " belongs to no cell");
  }
}

void check_cells(const Mesh& mesh) {
  for (int cell = 0; cell < mesh.cell_count(); ++cell)
    if (!(scaled_jacobian(mesh.X, mesh.kind, mesh.cells[cell]) > 0.0))
      throw base::MeshError(
          "cell " + std::to_string(cell) + at(mesh.X[mesh.cells[cell][0]]) +
          (order(mesh.kind) == 1 ? " has a corner that is folded over or flat" : " is folded over or flat"));
}

std::set<std::pair<int, int>> edges_of(const std::vector<Chain>& chains) {
  std::set<std::pair<int, int>> edges;
  for (const Chain& chain : chains)
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) edges.insert({chain[i], chain[i + 1]});
  return edges;
}

void check_outline(const Mesh& mesh) {
  if (mesh.outline.empty()) throw base::MeshError("the body has no outline");
  for (std::size_t k = 0; k < mesh.outline.size(); ++k) {
    const Chain& loop = mesh.outline[k];
    if (!is_closed(loop)) throw base::MeshError("loop " + std::to_string(k) + " of the outline is not closed");
    if ((enclosed_area(mesh.X, loop, order(mesh.kind)) > 0.0) != (k == 0))
      throw base::MeshError("loop " + std::to_string(k) + " of the outline" + at(mesh.X[loop[0]]) +
                            " does not have the body on its left");
  }
  if (!mesh.cells.empty() && edges_of(mesh.outline) != edges_of(outline_of(mesh.X, mesh.kind, mesh.cells)))
    throw base::MeshError("the outline is not that of the cells");
}

void check_boundaries(const Mesh& mesh) {
  const std::set<std::pair<int, int>> outline = edges_of(mesh.outline);
  std::set<int> mids;
  for (const Chain& loop : mesh.outline)
    for (std::size_t i = 1; order(mesh.kind) == 2 && i < loop.size(); i += 2) mids.insert(loop[i]);
  for (const auto& [name, chains] : mesh.boundaries) {
    for (const Chain& chain : chains) {
      if (chain.size() < 2) throw base::MeshError("boundary '" + name + "' has a chain without an edge");
      if (mids.contains(chain.front()) || mids.contains(chain.back()))
        throw base::MeshError("boundary '" + name + "' ends in the middle of an edge at node " +
                              std::to_string(mids.contains(chain.front()) ? chain.front() : chain.back()));
      for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        if (outline.contains({chain[i], chain[i + 1]})) continue;
        const bool exists = chain[i] >= 0 && chain[i] < mesh.node_count();
        throw base::MeshError("boundary '" + name + "' leaves the outline at node " + std::to_string(chain[i]) +
                              (exists ? at(mesh.X[chain[i]]) : ", which does not exist"));
      }
    }
  }
}

}  // namespace

double scaled_jacobian(const Points& X, CellKind kind, const Cell& cell) {
  const double straight = smallest_over_corners(X, kind, cell, [](const Vec2& a, const Vec2& b) {
    const double lengths = a.norm() * b.norm();
    return lengths > 0.0 ? base::cross(a, b) / lengths : 0.0;
  });
  return order(kind) == 1 || !(straight > 0.0) ? straight : straight * bending(X, kind, cell);
}

double smallest_angle(const Points& X, CellKind kind, const Cell& cell) {
  // Where the unit square |x| + |y| = 1 is met separates corners without an arc tangent each: from -2 to 2.
  const double met = smallest_over_corners(X, kind, cell, [](const Vec2& a, const Vec2& b) {
    const double x = a.dot(b), y = base::cross(a, b), sum = std::abs(x) + std::abs(y);
    if (!(sum > 0.0)) return 0.0;
    return x >= 0.0 ? y / sum : std::copysign(2.0, y) - y / sum;
  });
  return std::atan2(std::abs(met) > 1.0 ? std::copysign(2.0, met) - met : met, 1.0 - std::abs(met));
}

PoorestCell poorest_cell(const Mesh& mesh) {
  PoorestCell poorest;
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const double quality = scaled_jacobian(mesh.X, mesh.kind, mesh.cells[cell]);
    if (poorest.cell < 0 || quality < poorest.scaled_jacobian) poorest = {cell, quality};
  }
  return poorest;
}

void check(const Mesh& mesh) {
  check_nodes(mesh);
  check_cells(mesh);
  check_outline(mesh);
  check_boundaries(mesh);
}

}  // namespace reye::mesh
