#pragma once
#include <algorithm>
#include <array>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "base/linalg.hpp"

namespace reye::mesh {

using base::Points;
using base::Vec2;

/// Straight-sided cells of first order, and cells of second order with a node on every edge (serendipity).
enum class CellKind { tri3, quad4, tri6, quad8 };

inline constexpr int most_cell_nodes = 8;

/// Nodes of one cell: the corners counter-clockwise, then in second order the mid nodes of the edges 01, 12, 20
/// (triangle) or 01, 12, 23, 30. Entries beyond the nodes of the kind are -1.
using Cell = std::array<int, most_cell_nodes>;

inline int order(CellKind kind) { return kind == CellKind::tri3 || kind == CellKind::quad4 ? 1 : 2; }
inline int corners(CellKind kind) { return kind == CellKind::tri3 || kind == CellKind::tri6 ? 3 : 4; }
inline int nodes_per_cell(CellKind kind) { return order(kind) * corners(kind); }

/// The cell of these nodes, unused entries -1.
inline Cell cell_of(std::initializer_list<int> nodes) {
  Cell cell;
  cell.fill(-1);
  std::copy(nodes.begin(), nodes.end(), cell.begin());
  return cell;
}

/// A connected run of boundary edges as ALL its nodes in order, body on the left: vertex, vertex, ... in first order,
/// vertex, mid, vertex, ..., vertex in second. Closed when first and last node are the same.
using Chain = std::vector<int>;

/// A named part of the outline: one or several disjoint chains.
using Boundary = std::vector<Chain>;

/// The mesh of one body on its worn material configuration X [mm]. A value; nothing moves in place.
/// All cells are of one kind; the kind's order says how chains are to be read, without cells too. Every node belongs to
/// a cell; every cell has a positive Jacobian.
struct Mesh {
  Points X;
  CellKind kind = CellKind::quad4;
  std::vector<Cell> cells;
  std::map<std::string, Boundary> boundaries;  ///< named in the scene or by physical curves
  std::vector<Chain> outline;                  ///< the whole closed outline: outer loop first, then holes
  /// Per named boundary the node from which each of its chains counts arc length, in the order of arc length; it is
  /// chosen once and follows the boundary through every later mesh. Without an entry `arc_chains` chooses.
  std::map<std::string, std::vector<int>> arc_origin;
  std::vector<int> points;  ///< vertices that hold a point load or support: they stay where they are

  int node_count() const { return static_cast<int>(X.size()); }
  int cell_count() const { return static_cast<int>(cells.size()); }
};

/// The distinct nodes of a boundary in order of its chains.
std::vector<int> nodes_of(const Boundary& boundary);

}  // namespace reye::mesh
