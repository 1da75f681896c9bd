#pragma once
#include <memory>

#include "base/linalg.hpp"

namespace reye::algebra {

using base::Matrix;
using base::SparseMatrix;
using base::Vector;

/// K of any symmetry, split into interior i and retained c (the last `retained` rows), with an LU factor of K_ii:
///   P R K_ii Q = L U,   S = K_cc - (U^-T Q^T K_ci^T)^T (L^-1 P R K_ic)
/// Only K_ii must be regular: K may have free rigid motions that the retained rows hold.
/// The symbolic analysis is kept: `refactor` with the same pattern reuses it.
class UnsymmetricSchur {
 public:
  /// K: n x n, all entries stored. Throws base::SolveError when K_ii is singular to working precision.
  UnsymmetricSchur(const SparseMatrix& K, int retained);
  ~UnsymmetricSchur();
  UnsymmetricSchur(UnsymmetricSchur&&) noexcept;
  UnsymmetricSchur& operator=(UnsymmetricSchur&&) noexcept;

  void refactor(const SparseMatrix& K);
  int size() const;
  int retained() const;
  const Matrix& schur() const;  ///< retained x retained

  /// f_c - K_ci K_ii^-1 f_i for a full load vector f (size n).
  Vector condense(const Vector& f) const;
  /// The full solution (size n) for loads f and known retained values u_c.
  Vector recover(const Vector& f, const Vector& u_c) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace reye::algebra
