#pragma once
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "base/linalg.hpp"

namespace reye::algebra {

/// Sparse LU with row scaling, P R A Q = L U, by UMFPACK, which is called only here. Every failure is a
/// base::SolveError.
class SparseLu {
 public:
  /// Factorises A (compressed, sorted, square). `same_pattern`: as in the last call, whose analysis is reused.
  void factorise(const base::SparseMatrix& A, bool same_pattern);

  /// A^-1 b. A: the matrix last factorised.
  base::Vector solve(const base::SparseMatrix& A, const base::Vector& b) const;

  /// The factors themselves. Row k of `lower` and of `upper_transposed` holds the entries before and on the diagonal.
  struct Factors {
    using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
    Rows lower;             ///< L, unit diagonal stored
    Rows upper_transposed;  ///< U^T
    std::vector<int> row;   ///< row[k] of A is pivot row k
    std::vector<int> column;
    base::Vector scale;  ///< R
  };
  Factors factors() const;

 private:
  struct FreeSymbolic {
    void operator()(void* p) const;
  };
  struct FreeNumeric {
    void operator()(void* p) const;
  };
  int size_ = 0;
  std::unique_ptr<void, FreeSymbolic> symbolic_;
  std::unique_ptr<void, FreeNumeric> numeric_;
};

}  // namespace reye::algebra
