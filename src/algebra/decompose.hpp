#pragma once
#include <vector>

#include "base/linalg.hpp"

/// Decompositions of small dense matrices by LAPACK: Eigen's cost the compiler seconds in every file that names them.
/// Loops over points that need one of a fixed size name Eigen's own. Where A or B is not finite, every value that comes
/// out is NaN.
namespace reye::algebra {

using base::Matrix;
using base::Vector;

/// A = V diag(values) V^T of a symmetric A, of which the lower triangle is read. Values ascend.
struct Eigenpairs {
  Vector values;
  Matrix vectors;
};
Eigenpairs eigenpairs(const Matrix& A);

/// A = U diag(values) V^T; values descend, U and V are square.
struct SingularValues {
  Vector values;
  Matrix U, V;
};
SingularValues singular_values(const Matrix& A);
/// Values and V alone; U would have as many rows as A.
SingularValues right_singular_values(const Matrix& A);

/// A^+ of Moore and Penrose, by a complete orthogonal decomposition (dgelsy).
Matrix pseudo_inverse(const Matrix& A);

/// Column by column the shortest x of all with the least |A x - b|; A may have no rows or no columns.
Matrix least_squares(const Matrix& A, const Matrix& B);
/// Least squares by the leading columns, with pivoting, whose condition number is below 1 / least.
Matrix least_squares(const Matrix& A, const Matrix& B, double least);

/// X of A X = B with a symmetric, definite or semidefinite A: LDL^T with pivoting (Eigen's).
Matrix solve_symmetric(const Matrix& A, const Matrix& B);

/// As many columns of A as it has rows (or all), each the longest of what is left beside those before it, and that
/// length.
struct LeadingColumns {
  std::vector<int> columns;
  Vector lengths;
};
LeadingColumns leading_columns(const Matrix& A);

}  // namespace reye::algebra
