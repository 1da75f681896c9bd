#include "algebra/unsymmetric.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "algebra/blas.hpp"
#include "algebra/sparse_lu.hpp"
#include "base/errors.hpp"

namespace reye::algebra {

using base::SolveError;

namespace {

using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Rows = SparseLu::Factors::Rows;

/// Rows that are not zero after a forward solve, packed; `place[k]` is the packed row of row k, or -1.
struct Packed {
  std::vector<int> place;
  Block rows;
};

/// Solves T W = B for the lower triangular T, whose rows end on the diagonal, and a sparse B given by rows. Rows of W
/// that stay zero are neither stored nor visited: rows that a contact node does not reach cost a single test.
Packed forward(const Rows& T, const Rows& B) {
  const int n = static_cast<int>(T.rows());
  Packed W{std::vector<int>(static_cast<size_t>(n), -1), Block(n, B.cols())};
  int count = 0;
  for (int k = 0; k < n; ++k) {
    const int first = T.outerIndexPtr()[k], last = T.outerIndexPtr()[k + 1] - 1;
    auto row = W.rows.row(count);
    bool touched = false;
    const auto touch = [&] {
      if (!std::exchange(touched, true)) row.setZero();
    };
    for (Rows::InnerIterator b(B, k); b; ++b) {
      touch();
      row[b.col()] = b.value();
    }
    for (int at = first; at < last; ++at) {
      const int j = W.place[T.innerIndexPtr()[at]];
      if (j < 0) continue;
      touch();
      row.noalias() -= T.valuePtr()[at] * W.rows.row(j);
    }
    if (!touched) continue;
    row /= T.valuePtr()[last];
    W.place[k] = count++;
  }
  W.rows.conservativeResize(count, Eigen::NoChange);
  return W;
}

/// V^T W over the rows that both have.
Matrix product(const Packed& V, const Packed& W) {
  const int columns = static_cast<int>(W.rows.cols());
  Block v(W.rows.rows(), columns), w(W.rows.rows(), columns);
  int count = 0;
  for (size_t k = 0; k < V.place.size(); ++k) {
    if (V.place[k] < 0 || W.place[k] < 0) continue;
    v.row(count) = V.rows.row(V.place[k]);
    w.row(count++) = W.rows.row(W.place[k]);
  }
  Matrix S(columns, columns);
  const double one = 1.0, zero = 0.0;
  // By columns, the rows of v and w are columns: S = v w^T.
  if (columns > 0)
    dgemm_("N", "T", &columns, &columns, &count, &one, v.data(), &columns, w.data(), &columns, &zero, S.data(),
           &columns);
  return S;
}

bool same_pattern(const SparseMatrix& A, const SparseMatrix& B) {
  return A.rows() == B.rows() && A.nonZeros() == B.nonZeros() &&
         std::equal(A.outerIndexPtr(), A.outerIndexPtr() + A.cols() + 1, B.outerIndexPtr()) &&
         std::equal(A.innerIndexPtr(), A.innerIndexPtr() + A.nonZeros(), B.innerIndexPtr());
}

}  // namespace

struct UnsymmetricSchur::Impl {
  int retained = 0, size = 0;
  SparseMatrix Kii, Kic, Kci;
  SparseLu lu;
  Matrix S;

  int interior() const { return size - retained; }

  void factorise(const SparseMatrix& K) {
    if (K.rows() != K.cols()) throw SolveError("sparse LU: the matrix is not square");
    if (!K.coeffs().allFinite()) throw SolveError("sparse LU: the matrix holds a value that is not finite");
    size = static_cast<int>(K.rows());
    const int i = interior();
    SparseMatrix next = K.topLeftCorner(i, i);
    const bool known = same_pattern(Kii, next);
    Kii = std::move(next);
    Kic = K.topRightCorner(i, retained);
    Kci = K.bottomLeftCorner(retained, i);
    S = Matrix(K.bottomRightCorner(retained, retained));
    if (i == 0) return;
    lu.factorise(Kii, known);
    if (retained > 0) S -= coupling();
  }

  /// K_ci K_ii^-1 K_ic
  Matrix coupling() const {
    const SparseLu::Factors f = lu.factors();
    const auto i = static_cast<size_t>(interior());
    std::vector<int> row_place(i), column_place(i);
    for (size_t k = 0; k < i; ++k) {
      row_place[f.row[k]] = static_cast<int>(k);
      column_place[f.column[k]] = static_cast<int>(k);
    }
    std::vector<base::Triplet> right, left;
    for (int c = 0; c < retained; ++c)
      for (SparseMatrix::InnerIterator e(Kic, c); e; ++e)
        right.emplace_back(row_place[e.row()], c, f.scale[e.row()] * e.value());
    for (int j = 0; j < interior(); ++j)
      for (SparseMatrix::InnerIterator e(Kci, j); e; ++e) left.emplace_back(column_place[j], e.row(), e.value());
    Rows B(interior(), retained), C(interior(), retained);
    B.setFromTriplets(right.begin(), right.end());
    C.setFromTriplets(left.begin(), left.end());
    return product(forward(f.upper_transposed, C), forward(f.lower, B));
  }
};

UnsymmetricSchur::UnsymmetricSchur(const SparseMatrix& K, int retained) : impl_(std::make_unique<Impl>()) {
  if (retained < 0 || retained > K.rows()) throw SolveError("Schur complement: more retained rows than there are");
  impl_->retained = retained;
  impl_->factorise(K);
}
UnsymmetricSchur::~UnsymmetricSchur() = default;
UnsymmetricSchur::UnsymmetricSchur(UnsymmetricSchur&&) noexcept = default;
UnsymmetricSchur& UnsymmetricSchur::operator=(UnsymmetricSchur&&) noexcept = default;

void UnsymmetricSchur::refactor(const SparseMatrix& K) { impl_->factorise(K); }
int UnsymmetricSchur::size() const { return impl_->size; }
int UnsymmetricSchur::retained() const { return impl_->retained; }
const Matrix& UnsymmetricSchur::schur() const { return impl_->S; }

Vector UnsymmetricSchur::condense(const Vector& f) const {
  const int i = impl_->interior();
  if (i == 0) return f;
  return f.tail(retained()) - impl_->Kci * impl_->lu.solve(impl_->Kii, f.head(i));
}

Vector UnsymmetricSchur::recover(const Vector& f, const Vector& u_c) const {
  const int i = impl_->interior();
  Vector u(size());
  u.tail(retained()) = u_c;
  if (i > 0) u.head(i) = impl_->lu.solve(impl_->Kii, f.head(i) - impl_->Kic * u_c);
  return u;
}

}  // namespace reye::algebra
