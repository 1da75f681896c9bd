#pragma once
#include <optional>

#include "algebra/factor.hpp"
#include "algebra/unsymmetric.hpp"
#include "base/errors.hpp"
#include "body/operator.hpp"

namespace reye::body {

/// The Schur complement of a tangent: by Cholesky while it is symmetric, or its symmetric part is asked for, and
/// definite, else by LU at three times the cost.
class Condensation {
 public:
  void factorise(const base::SparseMatrix& K, int retained, bool symmetric, Tangent tangent) {
    if (symmetric)
      definite_ = try_cholesky(K, retained);
    else
      definite_ =
          tangent == Tangent::symmetric_part && try_cholesky(0.5 * (K + base::SparseMatrix(K.transpose())), retained);
    if (definite_) return;
    if (lu_)
      lu_->refactor(K);
    else
      lu_.emplace(K, retained);
  }
  const base::Matrix& schur() const { return definite_ ? cholesky_->schur() : lu_->schur(); }
  base::Vector condense(const base::Vector& f) const { return definite_ ? cholesky_->condense(f) : lu_->condense(f); }
  base::Vector recover(const base::Vector& f, const base::Vector& u_c) const {
    return definite_ ? cholesky_->recover(f, u_c) : lu_->recover(f, u_c);
  }

 private:
  bool try_cholesky(const base::SparseMatrix& K, int retained) {
    try {
      if (cholesky_)
        cholesky_->refactor(K);
      else
        cholesky_.emplace(K, retained);
      return true;
    } catch (const base::SolveError&) {
      return false;  // not definite: near a limit load, or far from equilibrium
    }
  }

  std::optional<algebra::SchurFactor> cholesky_;
  std::optional<algebra::UnsymmetricSchur> lu_;
  bool definite_ = false;
};

}  // namespace reye::body
