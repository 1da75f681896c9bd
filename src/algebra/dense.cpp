#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "algebra/blas.hpp"
#include "algebra/factor.hpp"
#include "base/cores.hpp"
#include "base/errors.hpp"

namespace reye::algebra {

using base::SolveError;

namespace {

/// Power of two nearest below 1 / largest: scaling by it adds no round-off.
double scale_for(double largest, const char* what, Eigen::Index index) {
  if (!std::isfinite(largest)) throw SolveError("dense solve: the matrix holds a value that is not finite");
  if (!(largest > 0.0))
    throw SolveError("dense solve: the matrix is singular (" + std::string(what) + " " + std::to_string(index) +
                     " is zero)");
  return std::ldexp(1.0, -std::ilogb(largest));
}

/// Scales rows, then columns, to a largest entry in [1, 2): rows of equilibrium [N/mm] and rows of
/// contact conditions [mm] become comparable, so that the condition number is meaningful. Returns the largest column
/// sum of the result.
double equilibrate(Matrix& A, Vector& rows, Vector& columns) {
  const Eigen::Index n = A.rows();
  rows.setZero();
  for (Eigen::Index j = 0; j < n; ++j) rows = rows.cwiseMax(A.col(j).cwiseAbs());
  // The largest may be hidden by a NaN, the sum not.
  if (!std::isfinite(A.sum())) throw SolveError("dense solve: the matrix holds a value that is not finite");
  for (Eigen::Index i = 0; i < n; ++i) rows[i] = scale_for(rows[i], "row", i);
  double norm = 0.0;
  for (Eigen::Index j = 0; j < n; ++j) {
    auto column = A.col(j);
    column.array() *= rows.array();
    columns[j] = scale_for(column.cwiseAbs().maxCoeff(), "column", j);
    column *= columns[j];
    norm = std::max(norm, column.cwiseAbs().sum());
  }
  return norm;
}

constexpr double worth_waking = 5e6;  ///< multiplications that take longer than to wake another thread, by far

/// The factors of A, as LAPACK's dgetrf gives them, in panels of columns: what a panel leaves to do in the others is
/// done side by side. Returns 0, or the number of the first pivot that is zero, counted from 1.
int factorise_in_panels(Matrix& A, std::vector<int>& pivots) {
  constexpr int width = 128;
  const int n = static_cast<int>(A.rows()), step = 1;
  const double one = 1.0, minus = -1.0;
  int zero_pivot = 0;
  for (int first = 0; first < n; first += width) {
    const int wide = std::min(width, n - first), tall = n - first, below = tall - wide, top = first + 1;
    const int end = first + wide;
    double* panel = A.data() + first + static_cast<std::ptrdiff_t>(first) * n;
    int info = 0;
    dgetrf_(&tall, &wide, panel, &n, pivots.data() + first, &info);
    if (info > 0 && zero_pivot == 0) zero_pivot = first + info;
    for (int k = first; k < end; ++k) pivots[static_cast<std::size_t>(k)] += first;
    const auto finish = [&](int block) {
      const int from = block * width, count = std::min(width, n - from);
      if (from == first) return;
      double* columns = A.data() + static_cast<std::ptrdiff_t>(from) * n;
      dlaswp_(&count, columns, &n, &top, &end, pivots.data(), &step);
      if (from < first) return;
      dtrsm_("L", "L", "N", "U", &wide, &count, &one, panel, &n, columns + first, &n);
      if (below > 0)
        dgemm_("N", "N", &below, &count, &wide, &minus, panel + wide, &n, columns + first, &n, &one, columns + end, &n);
    };
    const int blocks = (n + width - 1) / width;
    if (static_cast<double>(below) * below * wide > worth_waking)
      base::side_by_side(blocks, finish);
    else
      for (int block = 0; block < blocks; ++block) finish(block);
  }
  return zero_pivot;
}

/// Whether a pivot is so small against the largest that the condition has to be estimated. This is not a bound: a
/// nearly singular matrix may pass and give a large solution, which the next residual of Newton then shows.
bool doubtful(const Matrix& LU) {
  const auto pivots = LU.diagonal().cwiseAbs();
  return !(pivots.minCoeff() > 1e-9 * pivots.maxCoeff());
}

void require_definite(int info, int rows) {
  if (info != 0)
    throw SolveError("dense inverse: the matrix of " + std::to_string(rows) + " rows is not positive definite");
}

}  // namespace

void DenseFactor::factor(Matrix& A) {
  single_thread();
  LU_.swap(A);
  const int n = static_cast<int>(LU_.rows());
  if (LU_.cols() != n) throw SolveError("dense solve: the matrix is not square");
  rows_.resize(n);
  columns_.resize(n);
  if (n == 0) return;
  const double norm = equilibrate(LU_, rows_, columns_);
  pivots_.resize(static_cast<size_t>(n));
  int info = factorise_in_panels(LU_, pivots_);
  double rcond = 1.0;
  if (info == 0 && doubtful(LU_)) {
    work_.resize(4 * n);
    iwork_.resize(static_cast<size_t>(n));
    dgecon_("1", &n, LU_.data(), &n, &norm, &rcond, work_.data(), iwork_.data(), &info);
  }
  if (info != 0 || !(rcond > std::numeric_limits<double>::epsilon()))
    throw SolveError("dense solve: the matrix of " + std::to_string(n) + " rows is singular to working precision" +
                     (info > 0 ? " (zero pivot " + std::to_string(info - 1) + ")" : ""));
}

Vector DenseFactor::solve(const Vector& b, const char* trans) const {
  const int n = static_cast<int>(LU_.rows()), one = 1;
  if (b.size() != n) throw SolveError("dense solve: sizes do not match");
  if (n == 0) return b;
  const bool transposed = *trans == 'T';
  Vector x = (transposed ? columns_ : rows_).cwiseProduct(b);
  int info = 0;
  dgetrs_(trans, &n, &one, LU_.data(), &n, pivots_.data(), x.data(), &n, &info);
  x.array() *= (transposed ? rows_ : columns_).array();
  if (!x.allFinite()) throw SolveError("dense solve: the solution is not finite");
  return x;
}

Matrix DenseFactor::solve_columns(Matrix B) const {
  const int n = static_cast<int>(LU_.rows()), count = static_cast<int>(B.cols());
  if (B.rows() != n) throw SolveError("dense solve: sizes do not match");
  if (n == 0 || count == 0) return B;
  B.array().colwise() *= rows_.array();
  int info = 0;
  dgetrs_("N", &n, &count, LU_.data(), &n, pivots_.data(), B.data(), &n, &info);
  B.array().colwise() *= columns_.array();
  if (!B.allFinite()) throw SolveError("dense solve: the solution is not finite");
  return B;
}

DenseCholesky::DenseCholesky(Matrix A) : L_(std::move(A)) {
  single_thread();
  const int n = static_cast<int>(L_.rows());
  int info = 0;
  dpotrf_("L", &n, L_.data(), &n, &info);
  if (info != 0) throw SolveError("dense solve: the matrix of " + std::to_string(n) + " rows is not positive definite");
}

Vector DenseCholesky::solve(Vector b) const {
  const int n = static_cast<int>(L_.rows()), one = 1;
  int info = 0;
  dpotrs_("L", &n, &one, L_.data(), &n, b.data(), &n, &info);
  return b;
}

Matrix DenseCholesky::condense(Matrix& B) const {
  const int n = static_cast<int>(B.rows()), m = static_cast<int>(B.cols());
  Matrix C = Matrix::Zero(m, m);
  if (m == 0) return C;
  const double one = 1.0, zero = 0.0;
  dtrsm_("L", "L", "N", "N", &n, &m, &one, L_.data(), &n, B.data(), &n);
  dsyrk_("L", "T", &m, &n, &one, B.data(), &n, &zero, C.data(), &m);
  mirror_lower(C);
  dtrsm_("L", "L", "T", "N", &n, &m, &one, L_.data(), &n, B.data(), &n);
  return C;
}

double DenseCholesky::log_determinant() const { return 2.0 * L_.diagonal().array().log().sum(); }

void mirror_lower(Matrix& A) {
  constexpr Eigen::Index block = 64;  // rows and columns of both stay in the cache
  const Eigen::Index n = A.rows();
  for (Eigen::Index j = 0; j < n; j += block) {
    const Eigen::Index wide = std::min(block, n - j);
    A.block(j, j, wide, wide).triangularView<Eigen::StrictlyUpper>() = A.block(j, j, wide, wide).transpose();
    for (Eigen::Index i = j + wide; i < n; i += block) {
      const Eigen::Index tall = std::min(block, n - i);
      A.block(j, i, wide, tall) = A.block(i, j, tall, wide).transpose();
    }
  }
}

void invert(Matrix& A) {
  single_thread();
  const int n = static_cast<int>(A.rows());
  if (n == 0) return;
  int info = 0;
  dpotrf_("L", &n, A.data(), &n, &info);
  require_definite(info, n);
  invert_from_factor(A);
}

void invert_held(Matrix& A) {
  constexpr double digits = 1e-8;
  Vector known(A.rows());  // without a pattern that a motion of a body could have
  for (Eigen::Index k = 0; k < known.size(); ++k) known[k] = std::cos(static_cast<double>(k * k));
  const Vector image = A * known;
  invert(A);
  if (!((A * image - known).lpNorm<Eigen::Infinity>() < digits))
    throw SolveError("dense inverse: the matrix is definite by round-off alone");
}

void invert_from_factor(Matrix& L) {
  single_thread();
  const int n = static_cast<int>(L.rows());
  if (n == 0) return;
  int info = 0;
  dpotri_("L", &n, L.data(), &n, &info);
  require_definite(info, n);
  mirror_lower(L);
}

Vector solve_dense(Matrix& A, const Vector& b) {
  DenseFactor factor;
  factor.factor(A);
  return factor.solve(b);
}

}  // namespace reye::algebra
