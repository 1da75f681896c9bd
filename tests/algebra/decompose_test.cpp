#include "algebra/decompose.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace reye;
using base::Matrix;
using base::Vector;

/// Rank 2: the last column is the sum of the others, of which the first is the longer.
Matrix dependent() {
  Matrix A(4, 3);
  A << 3, 1, 4, 0, 1, 1, -4, 1, -3, 0, 1, 1;
  return A;
}

// Eigenpairs, read from the lower triangle, must give the matrix back, values ascending.
TEST(decompose, eigenpairs) {
  Matrix A(3, 3);
  A << 2, 99, 99, 1, 3, 99, -1, 0.5, 1;
  const auto [values, V] = algebra::eigenpairs(A);
  const Matrix whole = A.selfadjointView<Eigen::Lower>();
  EXPECT_LT((V * values.asDiagonal() * V.transpose() - whole).norm(), 1e-14 * whole.norm());
  EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
  A(0, 2) = std::nan("");
  EXPECT_EQ(algebra::eigenpairs(A).values, values);
}

// Singular values must give the matrix back, descend, and show its rank; without U they are the same.
TEST(decompose, singular_values) {
  const Matrix A = dependent();
  const auto [values, U, V] = algebra::singular_values(A);
  EXPECT_EQ(U.rows(), 4);
  EXPECT_LT((U.leftCols(3) * values.asDiagonal() * V.transpose() - A).norm(), 1e-14 * A.norm());
  EXPECT_GT(values[1], 1.0);
  EXPECT_LT(values[2], 1e-14);
  const auto right = algebra::right_singular_values(A);
  EXPECT_LT((right.values - values).norm(), 1e-14);
  EXPECT_LT((A * right.V.col(2)).norm(), 1e-14);
  EXPECT_EQ(right.U.size(), 0);
}

// Of all solutions of a singular system the shortest must come, and the pseudo-inverse must give the same one.
TEST(decompose, least_squares) {
  const Matrix A = dependent();
  const Vector b = A * Vector::Ones(3) + Vector::Unit(4, 1) - Vector::Unit(4, 3);  // the rest is normal to all columns
  const Vector x = algebra::least_squares(A, b);
  EXPECT_LT((A * (x - Vector::Ones(3))).norm(), 1e-13);
  EXPECT_NEAR(x.dot(Vector{{1.0, 1.0, -1.0}}), 0.0, 1e-14);  // the motion that A does not see
  EXPECT_LT((algebra::pseudo_inverse(A) * b - x).norm(), 1e-13);
}

// Without columns, or without rows, there is nothing to find, and nothing must fail.
TEST(decompose, empty_matrices) {
  EXPECT_EQ(algebra::least_squares(Matrix(3, 0), Matrix::Ones(3, 2)).rows(), 0);
  EXPECT_EQ(algebra::least_squares(Matrix(0, 2), Matrix(0, 1)), Matrix::Zero(2, 1));
  EXPECT_EQ(algebra::pseudo_inverse(Matrix(3, 0)).cols(), 3);
  EXPECT_EQ(algebra::eigenpairs(Matrix(0, 0)).values.size(), 0);
  EXPECT_EQ(algebra::singular_values(Matrix(3, 0)).U, Matrix::Identity(3, 3));
  EXPECT_EQ(algebra::right_singular_values(Matrix(0, 2)).V, Matrix::Identity(2, 2));
  EXPECT_TRUE(algebra::leading_columns(Matrix(0, 2)).columns.empty());
}

// What is not finite must show in every value that comes out, and nothing must fail or run for ever.
TEST(decompose, not_finite) {
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    Matrix A = dependent(), square = Matrix::Identity(3, 3);
    A(1, 1) = square(1, 1) = bad;
    const auto all_nan = [](const Matrix& values) { return values.size() > 0 && values.array().isNaN().all(); };
    EXPECT_TRUE(all_nan(algebra::eigenpairs(square).values));
    EXPECT_TRUE(all_nan(algebra::singular_values(A).values));
    EXPECT_TRUE(all_nan(algebra::right_singular_values(A).V));
    EXPECT_TRUE(all_nan(algebra::pseudo_inverse(A)));
    EXPECT_TRUE(all_nan(algebra::least_squares(dependent(), Vector::Constant(4, bad))));
    const auto [columns, lengths] = algebra::leading_columns(A);
    EXPECT_EQ(columns, (std::vector<int>{0, 1, 2}));
    EXPECT_TRUE(all_nan(lengths));
  }
}

// What is nearly dependent must count as dependent where the threshold says so.
TEST(decompose, rank_threshold) {
  const Matrix A{{1.0, 1.0}, {0.0, 1e-8}};
  const Vector b{{1.0, 1.0}};
  EXPECT_GT(algebra::least_squares(A, b).norm(), 1e7);
  EXPECT_LT((algebra::least_squares(A, b, 1e-6) - Vector{{0.5, 0.5}}).norm(), 1e-7);
}

// A semidefinite system must be solved where it can be.
TEST(decompose, symmetric) {
  const Matrix A{{2.0, -2.0}, {-2.0, 2.0}};
  const Vector x = algebra::solve_symmetric(A, Vector{{1.0, -1.0}});
  EXPECT_LT((A * x - Vector{{1.0, -1.0}}).norm(), 1e-15);
}

// The columns that span the others must come first, with what is left of each beside those before it.
TEST(decompose, leading_columns) {
  const auto [columns, lengths] = algebra::leading_columns(dependent());
  EXPECT_EQ(columns, (std::vector<int>{2, 0, 1}));
  EXPECT_NEAR(lengths[0], std::sqrt(27.0), 1e-14);
  EXPECT_LT(lengths[2], 1e-14);
}

}  // namespace
