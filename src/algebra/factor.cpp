#include "algebra/factor.hpp"

#include <optional>
#include <string>
#include <utility>

#include "algebra/blas.hpp"
#include "algebra/ranks.hpp"
#include "algebra/schur_analysis.hpp"
#include "base/errors.hpp"

namespace reye::algebra {

using base::SolveError;

namespace {

/// Smallest share of its diagonal entry that a pivot of a healthy matrix keeps; below it the
/// solution would have lost all but four digits.
constexpr double smallest_pivot_share = 1e-12;

/// Rows to eliminate from which all ranks hold a factor; a smaller one takes one process about half a second.
constexpr int smallest_ranked = 20000;

/// The upper triangle, the only part of a symmetric matrix that is read.
SparseMatrix upper_triangle(const SparseMatrix& K) {
  if (K.rows() != K.cols()) throw SolveError("sparse Cholesky: the matrix is not square");
  const auto in_triangle = [&](int j, auto take) {
    for (SparseMatrix::InnerIterator it(K, j); it && it.index() <= j; ++it)
      take(static_cast<int>(it.index()), it.value());
  };
  const int n = static_cast<int>(K.cols());
  int count = 0;
  for (int j = 0; j < n; ++j) in_triangle(j, [&](int, double) { ++count; });
  SparseMatrix U(n, n);
  U.resizeNonZeros(count);
  int at = 0;
  for (int j = 0; j < n; ++j) {
    U.outerIndexPtr()[j] = at;
    in_triangle(j, [&](int row, double value) {
      U.innerIndexPtr()[at] = row;
      U.valuePtr()[at++] = value;
    });
  }
  U.outerIndexPtr()[n] = at;
  if (!U.coeffs().allFinite()) throw SolveError("sparse Cholesky: the matrix holds a value that is not finite");
  return U;
}

/// A singular matrix often passes the factorisation with a last pivot of pure round-off.
void check_pivots(const Supernodal& L, const SparseMatrix& K, int count) {
  const Vector l = L.diagonal(), k = K.diagonal();
  const auto order = L.order();
  for (int j = 0; j < count; ++j)
    if (!(l[j] * l[j] > smallest_pivot_share * k[order[j]]))
      throw SolveError("sparse Cholesky: the matrix is singular to working precision (pivot of row " +
                       std::to_string(order[j]) + "); a rigid motion may be unconstrained");
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
  mirror_lower(S);
  return S;
}

}  // namespace

struct SchurFactor::Impl {
  int size = 0, retained = 0;
  Ordering ordering = Ordering::minimum_degree;
  std::optional<std::vector<int>> shifted;  ///< retained rows, counted from the first; else all
  SchurAnalysisPtr analysis;
  mutable Supernodal L;  // its workspace changes in solves
  Matrix S;
  Vector shift;
  std::unique_ptr<RankedFactor> ranked;  ///< in place of L, where several processes factorise
  SparseMatrix K_ic;                     ///< with `ranked` alone

  Impl(const SparseMatrix& K, int c, Ordering by) : retained(c), ordering(by) {
    if (c < 0 || c > K.rows()) throw SolveError("Schur complement: more retained rows than there are");
  }

  int interior() const { return size - retained; }

  /// `known`: an analysis to reuse if it is of this pattern. The diagonal of `upper` is shifted.
  void factorise(SparseMatrix& upper, const SchurAnalysisPtr& known) {
    size = static_cast<int>(upper.rows());
    shift = chosen_shift(upper);
    S.resize(0, 0);
    if (interior() == 0) {  // nothing to eliminate: no definiteness needed either
      S = Matrix(SparseMatrix(upper.selfadjointView<Eigen::Upper>()));
      return;
    }
    if (ordering == Ordering::nested_dissection && ranks_of(interior()) > 1) {
      ranked.reset();
      K_ic = SparseMatrix(upper.rightCols(retained)).topRows(interior());
      ranked = std::make_unique<RankedFactor>(upper, retained);
      S = ranked->take_schur();
      return;
    }
    start(known && known->fits(upper, retained, ordering)
              ? known
              : std::make_shared<const SchurAnalysis>(upper, retained, ordering));
    for (int j = 0; j < retained; ++j)
      if (shift[j] > 0.0) upper.coeffRef(interior() + j, interior() + j) += shift[j];
    L.factorise(upper);
    check_pivots(L, upper, interior());
    if (!shifted) S = product(L.trailing(retained, retained), shift);
  }

  /// Whether S is there itself, and not L_cc of S + sigma.
  bool has_schur() const { return S.rows() == retained; }

  void start(const SchurAnalysisPtr& fitting) {
    if (fitting == analysis) return;
    L.start(fitting->symbolic);
    analysis = fitting;
  }

  /// As large as the diagonal of K_cc, each row by its own entry, for what is small in one unit is large in another; of
  /// rows that are not chosen none.
  Vector chosen_shift(const SparseMatrix& K) const {
    Vector all = K.diagonal().tail(retained).unaryExpr([](double k) { return k > 0.0 ? k : 1.0; });
    if (!shifted) return all;
    Vector chosen = Vector::Zero(retained);
    for (const int j : *shifted) chosen[j] = all[j];
    return chosen;
  }

  /// L_ii^-1 f_i above, -L_ci L_ii^-1 f_i (in the basis of L_cc) below.
  Vector forward(const Vector& f) const {
    Vector b = Vector::Zero(size);
    const auto order = L.order();
    for (int k = 0; k < interior(); ++k) b[k] = f[order[k]];
    return L.forward(b);
  }
};

SchurFactor::SchurFactor(SparseMatrix K, int retained, SchurAnalysisPtr known, Ordering ordering)
    : impl_(std::make_unique<Impl>(K, retained, ordering)) {
  SparseMatrix upper = upper_triangle(K);
  SparseMatrix().swap(K);  // assignment from an empty matrix would keep the memory
  impl_->factorise(upper, known);
}
SchurFactor::SchurFactor(SparseMatrix K, int retained, Ordering ordering, std::vector<int> shifted)
    : impl_(std::make_unique<Impl>(K, retained, ordering)) {
  impl_->shifted = std::move(shifted);
  SparseMatrix upper = upper_triangle(K);
  SparseMatrix().swap(K);
  impl_->factorise(upper, {});
}
SchurFactor::~SchurFactor() = default;
SchurFactor::SchurFactor(SchurFactor&&) noexcept = default;
SchurFactor& SchurFactor::operator=(SchurFactor&&) noexcept = default;

void SchurFactor::refactor(const SparseMatrix& K) {
  SparseMatrix upper = upper_triangle(K);
  impl_->factorise(upper, impl_->analysis);
}
void SchurFactor::refactor(const SparseMatrix& K, std::vector<int> shifted) {
  impl_->shifted = std::move(shifted);
  refactor(K);
}
const SchurAnalysisPtr& SchurFactor::analysis() const { return impl_->analysis; }
int SchurFactor::size() const { return impl_->size; }
int SchurFactor::retained() const { return impl_->retained; }
const Matrix& SchurFactor::schur() const { return impl_->S; }

SchurFactor::Inverse SchurFactor::take_inverse(int count) {
  Inverse inverse;
  Matrix& C = inverse.C;
  Vector diagonal;
  if (impl_->has_schur()) {
    C = std::exchange(impl_->S, {});
    if (count < C.rows()) C = Matrix(C.topLeftCorner(count, count));
    C.diagonal() += impl_->shift.head(count);
    diagonal = C.diagonal();
    invert(C);
  } else {
    C = impl_->L.trailing(retained(), count);
    diagonal = C.rowwise().squaredNorm();
    invert_from_factor(C);
  }
  if (count > 0) inverse.condition = C.diagonal().cwiseProduct(diagonal).maxCoeff();
  return inverse;
}

Matrix SchurFactor::schur_rows(int first) const {
  const int c = retained();
  if (impl_->has_schur()) return impl_->S.bottomRows(c - first);
  Matrix rows = impl_->L.trailing_rows(c, first);
  Matrix S(c - first, c);
  for (int k = first; k < c; ++k)
    S.row(k - first) = impl_->L.times_trailing(rows.row(k - first).transpose()).transpose();
  S.rightCols(c - first).diagonal() -= impl_->shift.tail(c - first);
  return S;
}

Vector SchurFactor::condense(const Vector& f) const {
  const int c = retained();
  if (size() == c) return f;
  if (impl_->ranked) return f.tail(c) - impl_->K_ic.transpose() * impl_->ranked->solve_interior(f.head(size() - c));
  const Vector tail = impl_->forward(f).tail(c);
  return f.tail(c) + impl_->L.times_trailing(tail);
}

Vector SchurFactor::recover(const Vector& f, const Vector& u_c) const {
  const int c = retained();
  if (size() == c) return u_c;
  if (impl_->ranked) {
    Vector u(size());
    u << impl_->ranked->solve_interior(f.head(size() - c) - impl_->K_ic * u_c), u_c;
    return u;
  }
  Vector y = impl_->forward(f);
  y.tail(c) = impl_->L.times_trailing_transposed(u_c);
  const Vector x = impl_->L.backward(y);
  const auto order = impl_->L.order();
  Vector u(size());
  for (int k = 0; k < size() - c; ++k) u[order[k]] = x[k];
  u.tail(c) = u_c;
  return u;
}

Vector SchurFactor::solve_leading(const Vector& b) const {
  const int interior = size() - retained(), left_out = size() - static_cast<int>(b.size());
  const auto order = impl_->L.order();
  Vector y = Vector::Zero(size());
  for (Eigen::Index k = 0; k < b.size(); ++k) y[k] = b[k < interior ? order[k] : k];
  y = impl_->L.forward(y);
  y.tail(left_out).setZero();
  y = impl_->L.backward(y);
  Vector x(b.size());
  for (Eigen::Index k = 0; k < b.size(); ++k) x[k < interior ? order[k] : k] = y[k];
  return x;
}

bool SchurFactor::has_whole() const { return impl_->ranked == nullptr && impl_->interior() > 0; }

int ranks_of(int interior) { return interior >= smallest_ranked ? ranks() : 1; }

struct Cholesky::Impl {
  mutable Supernodal L;
};

Cholesky::Cholesky(const SparseMatrix& K) : impl_(std::make_unique<Impl>()) {
  SparseMatrix upper = upper_triangle(K);
  impl_->L.start(analyse(upper, {}));
  impl_->L.factorise(upper);
  check_pivots(impl_->L, upper, static_cast<int>(K.rows()));
}
Cholesky::~Cholesky() = default;
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

Matrix Cholesky::solve(const Matrix& rhs) const { return impl_->L.solve(rhs); }

}  // namespace reye::algebra
