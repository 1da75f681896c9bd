#include "algebra/decompose.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "algebra/blas.hpp"
#include "base/errors.hpp"

namespace reye::algebra {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Calls a routine of LAPACK twice, the first time for the size of its work space; routine(work, size, info).
template <class Routine>
void with_work_space(const char* name, Routine routine) {
  single_thread();
  double size = 0.0;
  int ask = -1, info = 0;
  routine(&size, &ask, &info);
  std::vector<double> work(static_cast<std::size_t>(std::max(size, 1.0)));
  const int count = static_cast<int>(work.size());
  routine(work.data(), &count, &info);
  if (info != 0) throw base::SolveError(std::string(name) + " of LAPACK ended with info = " + std::to_string(info));
}

Matrix not_a_number(Eigen::Index rows, Eigen::Index columns) {
  return Matrix::Constant(rows, columns, std::numeric_limits<double>::quiet_NaN());
}

SingularValues decomposed(Matrix A, bool with_U) {
  const int m = static_cast<int>(A.rows()), n = static_cast<int>(A.cols()), count = std::min(m, n);
  const int rows_of_U = with_U ? m : 1;
  SingularValues out{Vector(count), Matrix(with_U ? m : 0, with_U ? m : 0), Matrix(n, n)};
  if (count == 0) return {out.values, Matrix::Identity(out.U.rows(), out.U.cols()), Matrix::Identity(n, n)};
  if (!A.allFinite()) return {not_a_number(count, 1), not_a_number(out.U.rows(), out.U.cols()), not_a_number(n, n)};
  with_work_space("dgesvd", [&](double* work, const int* size, int* info) {
    dgesvd_(with_U ? "A" : "N", "A", &m, &n, A.data(), &m, out.values.data(), out.U.data(), &rows_of_U, out.V.data(),
            &n, work, size, info);
  });
  out.V.transposeInPlace();
  return out;
}

}  // namespace

Eigenpairs eigenpairs(const Matrix& A) {
  Eigenpairs out{Vector(A.rows()), A.selfadjointView<Eigen::Lower>()};
  const int n = static_cast<int>(A.rows());
  if (n == 0) return out;
  if (!out.vectors.allFinite()) return {not_a_number(n, 1), not_a_number(n, n)};
  with_work_space("dsyev", [&](double* work, const int* size, int* info) {
    dsyev_("V", "L", &n, out.vectors.data(), &n, out.values.data(), work, size, info);
  });
  return out;
}

SingularValues singular_values(const Matrix& A) { return decomposed(A, true); }

SingularValues right_singular_values(const Matrix& A) { return decomposed(A, false); }

Matrix pseudo_inverse(const Matrix& A) { return least_squares(A, Matrix::Identity(A.rows(), A.rows())); }

Matrix least_squares(const Matrix& A, const Matrix& B) {
  return least_squares(A, B, epsilon * static_cast<double>(std::min(A.rows(), A.cols())));
}

Matrix least_squares(const Matrix& A, const Matrix& B, double least) {
  if (A.size() == 0 || B.size() == 0) return Matrix::Zero(A.cols(), B.cols());
  if (!A.allFinite() || !B.allFinite()) return not_a_number(A.cols(), B.cols());
  Matrix factors = A, X = Matrix::Zero(std::max(A.rows(), A.cols()), B.cols());
  X.topRows(B.rows()) = B;
  const int m = static_cast<int>(A.rows()), n = static_cast<int>(A.cols()), columns = static_cast<int>(B.cols());
  const int rows = static_cast<int>(X.rows());
  std::vector<int> pivots(static_cast<std::size_t>(n), 0);
  int rank = 0;
  with_work_space("dgelsy", [&](double* work, const int* size, int* info) {
    dgelsy_(&m, &n, &columns, factors.data(), &m, X.data(), &rows, pivots.data(), &least, &rank, work, size, info);
  });
  return X.topRows(n);
}

Matrix solve_symmetric(const Matrix& A, const Matrix& B) { return A.ldlt().solve(B); }

LeadingColumns leading_columns(const Matrix& A) {
  Matrix R = A;
  const int m = static_cast<int>(A.rows()), n = static_cast<int>(A.cols()), count = std::min(m, n);
  if (count == 0) return {{}, Vector(0)};
  std::vector<int> order(static_cast<std::size_t>(n), 0);
  if (!A.allFinite()) {
    order.resize(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    return {std::move(order), not_a_number(count, 1)};
  }
  Vector scales(count);
  with_work_space("dgeqp3", [&](double* work, const int* size, int* info) {
    dgeqp3_(&m, &n, R.data(), &m, order.data(), scales.data(), work, size, info);
  });
  order.resize(static_cast<std::size_t>(count));
  for (int& column : order) --column;  // LAPACK counts from 1
  return {std::move(order), R.diagonal().head(count).cwiseAbs()};
}

}  // namespace reye::algebra
