#pragma once
#include <vector>

#include "algebra/ordering.hpp"
#include "algebra/supernodal.hpp"

namespace reye::algebra {

using base::SparseMatrix;

/// Where a compressed matrix has entries.
struct Entries {
  std::vector<int> start, row;

  explicit Entries(const SparseMatrix& A);
  bool are_of(const SparseMatrix& A) const;
};

/// Elimination order of an upper triangle: the interior as chosen, then what is retained as it stands.
std::vector<int> retained_last(const SparseMatrix& upper, int retained, Ordering by);

/// The order of elimination of a pattern, what is retained last, and the fill that follows.
struct SchurAnalysis {
  int retained;
  Ordering ordering;
  Entries entries;  ///< of the upper triangle
  Symbolic symbolic;

  /// Of an upper triangle with `c` rows retained.
  SchurAnalysis(SparseMatrix& upper, int c, Ordering by);

  bool fits(const SparseMatrix& upper, int c, Ordering by) const;
};

}  // namespace reye::algebra
