#pragma once
#include <vector>

#include "base/linalg.hpp"
#include "mesh/mesh.hpp"

namespace reye::fem {

/// The sparsity of a stiffness, 2 x 2 block by block: every node meets the nodes of its cells. Built once per mesh.
class Pattern {
 public:
  explicit Pattern(const mesh::Mesh& mesh);

  /// The zero matrix with every entry of the pattern present, 2n x 2n, dof = 2 * node + component.
  base::SparseMatrix zero() const;

  /// Adds the 2 x 2 block `at(row, column)` of nodes that share a cell; K: made by `zero`.
  template <class Block>
  void add(int row, int column, const Block& block, base::SparseMatrix& K) const {
    const int slot = 2 * position(column, row);
    for (int c = 0; c < 2; ++c) {
      double* entry = K.valuePtr() + K.outerIndexPtr()[2 * column + c] + slot;
      entry[0] += block(0, c);
      entry[1] += block(1, c);
    }
  }

  /// Adds the matrix of a cell on its first `count` nodes.
  template <class CellMatrix>
  void add_cell(const CellMatrix& Ke, const mesh::Cell& cell, int count, base::SparseMatrix& K) const {
    for (int b = 0; b < count; ++b)
      for (int a = 0; a < count; ++a) add(cell[a], cell[b], Ke.template block<2, 2>(2 * a, 2 * b), K);
  }

 private:
  int position(int of, int neighbour) const;
  int count(int of) const { return start_[of + 1] - start_[of]; }

  std::vector<int> start_;  ///< n + 1
  std::vector<int> nodes_;  ///< sorted neighbours of every node, itself included
};

}  // namespace reye::fem
