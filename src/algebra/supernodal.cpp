#include "algebra/supernodal.hpp"

#include <amd.h>

#include <cstring>
#include <string>

#include "algebra/blas.hpp"
#include "base/errors.hpp"

namespace reye::algebra {

using base::Matrix;
using base::SolveError;
using base::SparseMatrix;
using base::Vector;

namespace {

/// An Eigen matrix as CHOLMOD sees it, without a copy; its upper triangle is read.
cholmod_sparse view(SparseMatrix& K) {
  cholmod_sparse A{};
  A.nrow = A.ncol = static_cast<size_t>(K.cols());
  A.nzmax = static_cast<size_t>(K.nonZeros());
  A.p = K.outerIndexPtr();
  A.i = K.innerIndexPtr();
  A.x = K.valuePtr();
  A.stype = 1;
  A.itype = CHOLMOD_INT;
  A.xtype = CHOLMOD_REAL;
  A.dtype = CHOLMOD_DOUBLE;
  A.sorted = A.packed = 1;
  return A;
}

/// Releases a factor that outlives the workspace it was made with.
void free_factor(cholmod_factor* factor) {
  cholmod_common common;
  cholmod_start(&common);
  cholmod_free_factor(&factor, &common);
  cholmod_finish(&common);
}

const int* ints(const void* p) { return static_cast<const int*>(p); }

}  // namespace

Workspace::Workspace() {
  single_thread();
  cholmod_start(&common);
  common.print = 0;
  common.supernodal = CHOLMOD_SUPERNODAL;
  common.final_ll = 1;
  common.nmethods = 1;
}

void Workspace::check(const char* task, const cholmod_factor* factor) const {
  if (common.status == CHOLMOD_OK) return;
  if (common.status == CHOLMOD_OUT_OF_MEMORY) throw SolveError(std::string(task) + ": out of memory");
  if (common.status == CHOLMOD_TOO_LARGE)
    throw SolveError(std::string(task) +
                     ": the factor would have more than 2^31 entries (17 GB), more than can be addressed; a coarser "
                     "mesh away from contact makes it smaller");
  if (common.status == CHOLMOD_NOT_POSDEF) {
    const int at = factor && factor->minor < factor->n ? ints(factor->Perm)[factor->minor] : -1;
    throw SolveError(std::string(task) + ": the matrix is not positive definite (pivot of row " + std::to_string(at) +
                     "); a rigid motion may be unconstrained, or a cell may be inverted");
  }
  throw SolveError(std::string(task) + ": CHOLMOD status " + std::to_string(common.status));
}

Symbolic analyse(SparseMatrix& K, std::span<int> order, Fill* fill) {
  Workspace workspace;
  // Postordering would shuffle rows the caller wants last; without a given order it helps and is allowed.
  workspace.common.postorder = order.empty();
  workspace.common.method[0].ordering = order.empty() ? CHOLMOD_AMD : CHOLMOD_GIVEN;
  cholmod_sparse A = view(K);
  cholmod_factor* factor = cholmod_analyze_p(&A, order.empty() ? nullptr : order.data(), nullptr, 0, &workspace.common);
  workspace.check("symbolic analysis");
  if (fill) *fill = {workspace.common.lnz, workspace.common.fl};
  return {factor, free_factor};
}

void Supernodal::release() {
  if (factor_) cholmod_free_factor(&factor_, &workspace_.common);
}

void Supernodal::start(const Symbolic& symbolic) {
  release();
  factor_ = cholmod_copy_factor(symbolic.get(), &workspace_.common);
  workspace_.check("symbolic analysis");
}

void Supernodal::factorise(SparseMatrix& K) {
  cholmod_sparse A = view(K);
  cholmod_factorize(&A, factor_, &workspace_.common);
  workspace_.check("sparse Cholesky", factor_);
  cholmod_free_work(&workspace_.common);
}

Matrix Supernodal::dense_solve(int system, const double* b, int columns) {
  const int n = static_cast<int>(factor_->n);
  cholmod_dense rhs{};
  rhs.nrow = rhs.d = static_cast<size_t>(n);
  rhs.ncol = static_cast<size_t>(columns);
  rhs.nzmax = rhs.nrow * rhs.ncol;
  rhs.x = const_cast<double*>(b);  // the library takes a mutable pointer and only reads it
  rhs.xtype = CHOLMOD_REAL;
  rhs.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* x = cholmod_solve(system, factor_, &rhs, &workspace_.common);
  workspace_.check("triangular solve", factor_);
  Matrix result = Eigen::Map<const Matrix>(static_cast<const double*>(x->x), n, columns);
  cholmod_free_dense(&x, &workspace_.common);
  return result;
}

Matrix Supernodal::solve(const Matrix& b) { return dense_solve(CHOLMOD_A, b.data(), static_cast<int>(b.cols())); }

Vector Supernodal::triangular(int system, const Vector& b) { return dense_solve(system, b.data(), 1); }

std::span<const int> Supernodal::order() const { return {ints(factor_->Perm), factor_->n}; }

Vector Supernodal::diagonal() const {
  const int *super = ints(factor_->super), *pi = ints(factor_->pi), *px = ints(factor_->px);
  const double* x = static_cast<const double*>(factor_->x);
  Vector d(static_cast<Eigen::Index>(factor_->n));
  for (size_t s = 0; s < factor_->nsuper; ++s) {
    const int rows = pi[s + 1] - pi[s];
    for (int j = super[s]; j < super[s + 1]; ++j) d[j] = x[px[s] + static_cast<ptrdiff_t>(j - super[s]) * (rows + 1)];
  }
  return d;
}

/// Calls take(column, rows, values, count) for the last columns of L: from the diagonal down, numbered from the first.
template <class Take>
void Supernodal::for_each_trailing(int count, Take take) const {
  const int first = static_cast<int>(factor_->n) - count;
  const int *super = ints(factor_->super), *pi = ints(factor_->pi), *px = ints(factor_->px), *row = ints(factor_->s);
  const double* x = static_cast<const double*>(factor_->x);
  std::vector<int> below;
  for (size_t s = 0; s < factor_->nsuper; ++s) {
    if (super[s + 1] <= first) continue;
    const int rows = pi[s + 1] - pi[s];
    below.assign(row + pi[s], row + pi[s + 1]);
    for (int& r : below) r -= first;
    // A supernode may straddle the border between leading and trailing columns.
    for (int j = std::max(super[s], first); j < super[s + 1]; ++j) {
      const int local = j - super[s];
      take(j - first, below.data() + local, x + px[s] + static_cast<ptrdiff_t>(local) * rows + local, rows - local);
    }
  }
}

Matrix Supernodal::trailing(int count, int size) const {
  Matrix L = Matrix::Zero(size, size);
  for_each_trailing(count, [&](int column, const int* row, const double* value, int entries) {
    for (int k = 0; column < size && k < entries && row[k] < size; ++k) L(row[k], column) = value[k];
  });
  return L;
}

Matrix Supernodal::trailing_rows(int count, int first) const {
  Matrix rows = Matrix::Zero(count - first, count);
  for_each_trailing(count, [&](int column, const int* row, const double* value, int entries) {
    for (int k = entries - 1; k >= 0 && row[k] >= first; --k) rows(row[k] - first, column) = value[k];
  });
  return rows;
}

Vector Supernodal::times_trailing(const Vector& v) const {
  Vector product = Vector::Zero(v.size());
  for_each_trailing(static_cast<int>(v.size()), [&](int column, const int* row, const double* value, int entries) {
    for (int k = 0; k < entries; ++k) product[row[k]] += value[k] * v[column];
  });
  return product;
}

Vector Supernodal::times_trailing_transposed(const Vector& v) const {
  Vector product = Vector::Zero(v.size());
  for_each_trailing(static_cast<int>(v.size()), [&](int column, const int* row, const double* value, int entries) {
    for (int k = 0; k < entries; ++k) product[column] += value[k] * v[row[k]];
  });
  return product;
}

std::vector<int> minimum_degree(const SparseMatrix& K, int count) {
  std::vector<int> start{0}, index;
  index.reserve(static_cast<size_t>(K.nonZeros()));
  for (int j = 0; j < count; ++j) {
    for (SparseMatrix::InnerIterator it(K, j); it && it.index() < count; ++it)
      index.push_back(static_cast<int>(it.index()));
    start.push_back(static_cast<int>(index.size()));
  }
  std::vector<int> order(static_cast<size_t>(count));
  if (count > 0 && amd_order(count, start.data(), index.data(), order.data(), nullptr, nullptr) < AMD_OK)
    throw SolveError("minimum degree ordering failed");
  return order;
}

}  // namespace reye::algebra
