#include "body/condensation.hpp"

#include "algebra/congruence.hpp"
#include "base/errors.hpp"

namespace reye::body {

void Condensation::factorise(const base::SparseMatrix& K, int retained, bool symmetric, Tangent tangent) {
  if (symmetric)
    definite_ = try_cholesky(K, retained);
  else
    definite_ = tangent == Tangent::symmetric_part && try_cholesky(algebra::symmetric_part(K), retained);
  symmetrised_ = definite_ && !symmetric;
  if (definite_) return;
  if (lu_)
    lu_->refactor(K);
  else
    lu_.emplace(K, retained);
}

const base::Matrix& Condensation::schur() const { return definite_ ? cholesky_->schur() : lu_->schur(); }

base::Vector Condensation::condense(const base::Vector& f) const {
  return definite_ ? cholesky_->condense(f) : lu_->condense(f);
}

base::Vector Condensation::recover(const base::Vector& f, const base::Vector& u_c) const {
  return definite_ ? cholesky_->recover(f, u_c) : lu_->recover(f, u_c);
}

base::Vector Condensation::left_out(const base::SparseMatrix& K, const base::Vector& v) const {
  if (!symmetrised_) return base::Vector::Zero(v.size());
  return 0.5 * (K * v - K.transpose() * v);
}

bool Condensation::try_cholesky(const base::SparseMatrix& K, int retained) {
  try {
    if (cholesky_)
      cholesky_->refactor(K);
    else
      cholesky_.emplace(K, retained);
    return true;
  } catch (const base::SolveError&) {
    return false;
  }
}

}  // namespace reye::body
