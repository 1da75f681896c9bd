#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "algebra/blas.hpp"
#include "algebra/factor.hpp"
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
/// contact conditions [mm] become comparable, so that the condition number means something.
void equilibrate(Matrix& A, Vector& rows, Vector& columns) {
  const Eigen::Index n = A.rows();
  if (!A.allFinite()) throw SolveError("dense solve: the matrix holds a value that is not finite");
  const Vector row_max = A.cwiseAbs().rowwise().maxCoeff();
  for (Eigen::Index i = 0; i < n; ++i) rows[i] = scale_for(row_max[i], "row", i);
  A.array().colwise() *= rows.array();
  for (Eigen::Index j = 0; j < n; ++j) {
    columns[j] = scale_for(A.col(j).cwiseAbs().maxCoeff(), "column", j);
    A.col(j) *= columns[j];
  }
}

/// Solves op(A) x = b in place, op the identity ("N") or the transpose ("T").
Vector solve(Matrix& A, const Vector& b, const char* trans) {
  single_thread();
  const int n = static_cast<int>(A.rows()), one = 1;
  if (A.cols() != n || b.size() != n) throw SolveError("dense solve: sizes do not match");
  if (n == 0) return b;
  Vector rows(n), columns(n), work(4 * n);
  equilibrate(A, rows, columns);
  const bool transposed = *trans == 'T';
  Vector x = (transposed ? columns : rows).cwiseProduct(b);

  std::vector<int> pivots(static_cast<size_t>(n)), iwork(static_cast<size_t>(n));
  int info = 0;
  double rcond = 0.0;
  const double norm = dlange_("1", &n, &n, A.data(), &n, work.data());
  dgetrf_(&n, &n, A.data(), &n, pivots.data(), &info);
  if (info == 0) dgecon_("1", &n, A.data(), &n, &norm, &rcond, work.data(), iwork.data(), &info);
  if (info != 0 || !(rcond > std::numeric_limits<double>::epsilon()))
    throw SolveError("dense solve: the matrix of " + std::to_string(n) + " rows is singular to working precision" +
                     (info > 0 ? " (zero pivot " + std::to_string(info - 1) + ")" : ""));
  dgetrs_(trans, &n, &one, A.data(), &n, pivots.data(), x.data(), &n, &info);
  x.array() *= (transposed ? rows : columns).array();
  if (!x.allFinite()) throw SolveError("dense solve: the solution is not finite");
  return x;
}

}  // namespace

Vector solve_dense(Matrix& A, const Vector& b) { return solve(A, b, "N"); }
Vector solve_dense_transposed(Matrix& At, const Vector& b) { return solve(At, b, "T"); }

}  // namespace reye::algebra
