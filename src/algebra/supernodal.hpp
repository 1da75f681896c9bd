#pragma once
#include <cholmod.h>

#include <memory>
#include <span>
#include <vector>

#include "base/linalg.hpp"

namespace reye::algebra {

/// Supernodal Cholesky P K P^T = L L^T of a symmetric sparse matrix by CHOLMOD; owns the library's workspace.
/// The one place that calls CHOLMOD. Every failure is a base::SolveError.
class Supernodal {
 public:
  Supernodal();
  ~Supernodal();
  Supernodal(const Supernodal&) = delete;
  Supernodal& operator=(const Supernodal&) = delete;

  /// Symbolic analysis. `order` empty: AMD with postordering; else the given elimination order, kept as it is.
  void analyse(base::SparseMatrix& K, std::span<int> order);
  /// Takes the symbolic analysis of another factor over, of a matrix with the same pattern.
  void share_analysis(const Supernodal& other);
  bool analysed() const { return factor_ != nullptr; }
  /// Numeric factorisation with the analysed pattern.
  void factorise(base::SparseMatrix& K);

  /// Solves K x = b for all columns of b.
  base::Matrix solve(const base::Matrix& b);
  /// Solves L y = b and L^T y = b in the order of elimination (no permutation).
  base::Vector forward(const base::Vector& b) { return triangular(CHOLMOD_L, b); }
  base::Vector backward(const base::Vector& b) { return triangular(CHOLMOD_Lt, b); }

  /// Elimination order: order()[k] is the row of K eliminated as k-th.
  std::span<const int> order() const;
  base::Vector diagonal() const;               ///< of L, in the order of elimination
  base::Matrix trailing(int count) const;      ///< dense lower triangle of the last `count` rows and columns of L

 private:
  base::Vector triangular(int system, const base::Vector& b);
  base::Matrix dense_solve(int system, const double* b, int columns);
  void check(const char* task) const;
  void release();

  cholmod_common common_;
  cholmod_factor* factor_ = nullptr;
  std::shared_ptr<cholmod_factor> analysis_;  ///< without numbers; shared by all factors of the pattern
};

/// Fill-reducing order (approximate minimum degree) of the leading `count` rows of K.
std::vector<int> minimum_degree(const base::SparseMatrix& K, int count);

}  // namespace reye::algebra
