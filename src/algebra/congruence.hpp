#pragma once
#include "base/linalg.hpp"

namespace reye::algebra {

/// Makes `result` = B^T K B, n x n, of K, m x m, and B, m x n, of which most rows have few entries. The pattern of
/// `result` is kept where it holds all entries, as after a call with matrices of the same patterns.
void congruence(const base::SparseMatrix& K, const base::SparseMatrix& B, base::SparseMatrix& result);

/// The upper triangle of (K + K^T) / 2. Fast where K has an entry at (j, i) wherever it has one at (i, j).
base::SparseMatrix symmetric_part(const base::SparseMatrix& K);

}  // namespace reye::algebra
