#pragma once
#include <vector>

#include "fem/solid/solid_dofs.hpp"

namespace reye::fem {

/// The upper triangle of the own dofs of a solid, block by block: every node meets the nodes of its cells.
class SolidPattern {
 public:
  SolidPattern(const mesh::SolidMesh& mesh, const SolidDofs& dofs);

  /// The zero matrix with every entry of the pattern present, dofs.size() x dofs.size(); shared dofs have none.
  base::SparseMatrix zero() const;

  /// Adds the block of nodes a and b, both plain; it counts once, whichever of the two comes first.
  template <class Block>
  void add(int a, int b, const Block& block, base::SparseMatrix& K) const {
    const bool turned = dofs_.first[a] > dofs_.first[b];
    const int row = turned ? b : a, column = turned ? a : b;
    const int slot = offset_[position(row, column)];
    const int rows_of_diagonal = a == b ? 1 : 3;
    for (int c = 0; c < 3; ++c) {
      double* entry = K.valuePtr() + K.outerIndexPtr()[dofs_.first[column] + c] + slot;
      for (int r = 0; r < (a == b ? rows_of_diagonal + c : 3); ++r) entry[r] += turned ? block(c, r) : block(r, c);
    }
  }

  /// Adds one entry of own dofs, row <= column, of nodes that share a cell.
  void add(int row, int column, double value, base::SparseMatrix& K) const {
    const int slot = offset_[position(owner_[row], owner_[column])] + row - dofs_.first[owner_[row]];
    K.valuePtr()[K.outerIndexPtr()[column] + slot] += value;
  }

 private:
  int position(int of, int in_column) const;

  const SolidDofs& dofs_;
  std::vector<int> owner_;   ///< node of each own dof
  std::vector<int> start_;   ///< per node, n + 1
  std::vector<int> nodes_;   ///< neighbours not after a node, by their first dof; itself last
  std::vector<int> offset_;  ///< of each of `nodes_`: entries above it in the node's columns
};

}  // namespace reye::fem
