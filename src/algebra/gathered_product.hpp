#pragma once
#include "base/linalg.hpp"

namespace reye::algebra {

/// A -= L^T C R for a dense symmetric C and sparse L and R with as many rows. Columns are taken 32 at a time with the
/// rows that they touch, as dense blocks: where columns that follow each other touch the same rows, this takes a small
/// part of the operations of dense products, at their speed.
void subtract_gathered_product(const base::SparseMatrix& L, const base::Matrix& C, const base::SparseMatrix& R,
                               Eigen::Ref<base::Matrix> A);

}  // namespace reye::algebra
