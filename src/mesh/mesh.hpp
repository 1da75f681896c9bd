#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "base/linalg.hpp"

namespace reye::mesh {

using base::Points;
using base::Vec2;

enum class CellKind { tri3, quad4 };

/// Nodes of one cell; a triangle leaves the fourth entry at -1. Counter-clockwise.
using Cell = std::array<int, 4>;

inline int nodes_per_cell(CellKind kind) { return kind == CellKind::tri3 ? 3 : 4; }

/// A connected run of boundary edges as its nodes in order, body on the left.
/// Closed when first and last node are the same.
using Chain = std::vector<int>;

/// A named part of the outline: one or several disjoint chains.
using Boundary = std::vector<Chain>;

/// The mesh of one body on its worn material configuration X [mm]. A value; nothing moves in place.
/// All cells are of one kind. Every node belongs to a cell; every cell has a positive Jacobian.
struct Mesh {
  Points X;
  CellKind kind = CellKind::quad4;
  std::vector<Cell> cells;
  std::map<std::string, Boundary> boundaries;  ///< named in the scene or by physical curves
  std::vector<Chain> outline;                  ///< the whole closed outline: outer loop first, then holes

  int node_count() const { return static_cast<int>(X.size()); }
  int cell_count() const { return static_cast<int>(cells.size()); }
};

/// The distinct nodes of a boundary in order of its chains.
std::vector<int> nodes_of(const Boundary& boundary);

}  // namespace reye::mesh
