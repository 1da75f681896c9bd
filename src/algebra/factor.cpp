#include "algebra/factor.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "algebra/blas.hpp"
#include "algebra/supernodal.hpp"
#include "base/errors.hpp"

namespace reye::algebra {

using base::SolveError;

namespace {

/// Smallest share of its diagonal entry that a pivot of a healthy matrix keeps; below it the
/// solution would have lost all but four digits.
constexpr double smallest_pivot = 1e-12;

SparseMatrix checked(const SparseMatrix& K) {
  if (K.rows() != K.cols()) throw SolveError("sparse Cholesky: the matrix is not square");
  SparseMatrix copy = K;
  copy.makeCompressed();
  if (!copy.coeffs().allFinite()) throw SolveError("sparse Cholesky: the matrix holds a value that is not finite");
  return copy;
}

bool same_pattern(const SparseMatrix& A, const SparseMatrix& B) {
  return A.rows() == B.rows() && A.nonZeros() == B.nonZeros() &&
         std::equal(A.outerIndexPtr(), A.outerIndexPtr() + A.cols() + 1, B.outerIndexPtr()) &&
         std::equal(A.innerIndexPtr(), A.innerIndexPtr() + A.nonZeros(), B.innerIndexPtr());
}

/// A singular matrix often passes the factorisation with a last pivot of pure round-off.
void check_pivots(const Supernodal& L, const SparseMatrix& K, int count) {
  const Vector l = L.diagonal(), k = K.diagonal();
  const auto order = L.order();
  for (int j = 0; j < count; ++j)
    if (!(l[j] * l[j] > smallest_pivot * k[order[j]]))
      throw SolveError("sparse Cholesky: the matrix is singular to working precision (pivot of row " +
                       std::to_string(order[j]) + "); a motion may be free that nothing holds");
}

/// L L^T - diag(shift), both triangles. LAPACK multiplies a triangle with its own transpose as U U^T; L turned round in
/// rows and columns is such a U.
Matrix product(const Matrix& L, const Vector& shift) {
  const int n = static_cast<int>(L.rows());
  Matrix U = L.reverse();
  int info = 0;
  if (n > 0) dlauum_("U", &n, U.data(), &n, &info);
  Matrix S = U.reverse();
  S.diagonal() -= shift;
  S.triangularView<Eigen::StrictlyUpper>() = S.transpose();
  return S;
}

}  // namespace

struct SchurFactor::Impl {
  SparseMatrix K;  ///< last matrix factorised, with the shift on its trailing diagonal
  int retained = 0;
  mutable Supernodal L;  // its workspace changes in solves
  Matrix Lcc, S;

  int interior() const { return static_cast<int>(K.rows()) - retained; }

  /// `like`: a factor whose analysis will do if it is of this pattern; its own.
  void factorise(const SparseMatrix& fresh, const Impl& like) {
    SparseMatrix next = checked(fresh);
    const bool known = like.L.analysed() && like.retained == retained && same_pattern(like.K, next);
    K = std::move(next);
    if (interior() == 0) {  // nothing to eliminate: no definiteness needed either
      S = Matrix(K);
      return;
    }
    if (!known)
      analyse();
    else if (&like != this)
      L.share_analysis(like.L);
    const Vector shift = add_shift();
    L.factorise(K);
    check_pivots(L, K, interior());
    Lcc = L.trailing(retained);
    S = product(Lcc, shift);
  }

  void analyse() {
    std::vector<int> order = minimum_degree(K, interior());
    order.resize(static_cast<size_t>(K.rows()));
    std::iota(order.begin() + interior(), order.end(), interior());
    L.analyse(K, order);
  }

  /// Doubles the diagonal of K_cc: each row by its own entry, for what is small in one unit is large in another.
  Vector add_shift() {
    Vector shift = K.diagonal().tail(retained);
    for (int j = 0; j < retained; ++j) {
      if (!(shift[j] > 0.0)) shift[j] = 1.0;
      K.coeffRef(interior() + j, interior() + j) += shift[j];
    }
    return shift;
  }

  /// L_ii^-1 f_i above, -L_ci L_ii^-1 f_i (in the basis of L_cc) below.
  Vector forward(const Vector& f) const {
    Vector b = Vector::Zero(K.rows());
    const auto order = L.order();
    for (int k = 0; k < interior(); ++k) b[k] = f[order[k]];
    return L.forward(b);
  }
};

SchurFactor::SchurFactor(const SparseMatrix& K, int retained, const SchurFactor* like)
    : impl_(std::make_unique<Impl>()) {
  if (retained < 0 || retained > K.rows()) throw SolveError("Schur complement: more retained rows than there are");
  impl_->retained = retained;
  impl_->factorise(K, like ? *like->impl_ : *impl_);
}
SchurFactor::~SchurFactor() = default;
SchurFactor::SchurFactor(SchurFactor&&) noexcept = default;
SchurFactor& SchurFactor::operator=(SchurFactor&&) noexcept = default;

void SchurFactor::refactor(const SparseMatrix& K) { impl_->factorise(K, *impl_); }
int SchurFactor::size() const { return static_cast<int>(impl_->K.rows()); }
int SchurFactor::retained() const { return impl_->retained; }
const Matrix& SchurFactor::schur() const { return impl_->S; }

Vector SchurFactor::condense(const Vector& f) const {
  const int c = retained();
  if (size() == c) return f;
  const Vector tail = impl_->forward(f).tail(c);
  return f.tail(c) + impl_->Lcc.triangularView<Eigen::Lower>() * tail;
}

Vector SchurFactor::recover(const Vector& f, const Vector& u_c) const {
  const int c = retained();
  if (size() == c) return u_c;
  Vector y = impl_->forward(f);
  y.tail(c) = impl_->Lcc.transpose().triangularView<Eigen::Upper>() * u_c;
  const Vector x = impl_->L.backward(y);
  const auto order = impl_->L.order();
  Vector u(size());
  for (int k = 0; k < size() - c; ++k) u[order[k]] = x[k];
  u.tail(c) = u_c;
  return u;
}

struct Cholesky::Impl {
  SparseMatrix K;
  mutable Supernodal L;
};

Cholesky::Cholesky(const SparseMatrix& K) : impl_(std::make_unique<Impl>()) { refactor(K); }
Cholesky::~Cholesky() = default;
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

void Cholesky::refactor(const SparseMatrix& K) {
  SparseMatrix next = checked(K);
  const bool known = impl_->L.analysed() && same_pattern(impl_->K, next);
  impl_->K = std::move(next);
  if (!known) impl_->L.analyse(impl_->K, {});
  impl_->L.factorise(impl_->K);
  check_pivots(impl_->L, impl_->K, static_cast<int>(K.rows()));
}

Matrix Cholesky::solve(const Matrix& rhs) const { return impl_->L.solve(rhs); }

}  // namespace reye::algebra
