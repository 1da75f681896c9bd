#pragma once
#include <optional>

#include "algebra/factor.hpp"
#include "algebra/unsymmetric.hpp"
#include "body/operator.hpp"

namespace reye::body {

/// The Schur complement of a tangent: by Cholesky while it is symmetric, or its symmetric part is asked for, and
/// definite, else by LU at three times the cost.
class Condensation {
 public:
  void factorise(const base::SparseMatrix& K, int retained, bool symmetric, Tangent tangent);
  const base::Matrix& schur() const;
  base::Vector condense(const base::Vector& f) const;
  base::Vector recover(const base::Vector& f, const base::Vector& u_c) const;
  /// Forces of a step v of all columns that the factor of K leaves out: (K - K^T) / 2 v where it is that of the
  /// symmetric part, else nothing.
  base::Vector left_out(const base::SparseMatrix& K, const base::Vector& v) const;

 private:
  /// False where K is not definite: near a limit load, or far from equilibrium.
  bool try_cholesky(const base::SparseMatrix& K, int retained);

  std::optional<algebra::SchurFactor> cholesky_;
  std::optional<algebra::UnsymmetricSchur> lu_;
  bool definite_ = false;
  bool symmetrised_ = false;  ///< the factor is that of the symmetric part alone
};

}  // namespace reye::body
