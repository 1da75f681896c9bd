#include "algebra/close_system.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dense.hpp"

using namespace reye;
using base::SparseMatrix;
using base::Vector;
using support::wave;

namespace {

/// Springs of stiffness 1 + soft sin(k) along a chain, its first mass held; upper triangle.
SparseMatrix chain(int n, double soft) {
  SparseMatrix K(n, n);
  for (int k = 0; k < n; ++k) {
    const double below = 1.0 + soft * std::sin(k), above = k + 1 < n ? 1.0 + soft * std::sin(k + 1.0) : 0.0;
    K.insert(k, k) = below + above;
    if (k > 0) K.insert(k - 1, k) = -below;
  }
  K.makeCompressed();
  return K;
}

}  // namespace

// A system must be solved to round-off with the factor of one that is near to it, of all rows and of the leading ones.
TEST(close_system, is_solved_by_the_factor_of_another) {
  const int n = 300;
  const algebra::SchurFactor near(chain(n, 0.0), 40);
  for (const int count : {300, 290}) {
    const SparseMatrix K = chain(n, 0.2).topLeftCorner(count, count);
    SparseMatrix sigma = K;  // the factor shifts its retained rows, and so must the system be
    for (int k = n - 40; k < count; ++k) sigma.coeffRef(k, k) += 2.0;
    const Vector b = wave(count);
    const auto x = algebra::solve_close(sigma, b, near);
    ASSERT_TRUE(x);
    EXPECT_LT((sigma.selfadjointView<Eigen::Upper>() * *x - b).norm(), 1e-11 * b.norm());
  }
}

// With its own factor the leading rows are solved at once.
TEST(close_system, leading_rows) {
  const int n = 60;
  const SparseMatrix K = chain(n, 0.3);
  const algebra::SchurFactor factor(K, 20, algebra::Ordering::nested_dissection, {});
  for (const int count : {60, 52, 40}) {
    const Vector b = wave(count);
    const SparseMatrix leading = K.topLeftCorner(count, count);
    EXPECT_LT((leading.selfadjointView<Eigen::Upper>() * factor.solve_leading(b) - b).norm(), 1e-12 * b.norm());
  }
}

// Where the matrices have nothing to do with each other there is no solution rather than a poor one.
TEST(close_system, far_from_it_there_is_none) {
  const int n = 300;
  SparseMatrix far(n, n);
  for (int k = 0; k < n; ++k) far.insert(k, k) = std::exp(0.1 * k);
  EXPECT_FALSE(algebra::solve_close(far, wave(n), algebra::SchurFactor(chain(n, 0.0), 40)));
}

// A factor that has eliminated nothing holds no L, and solves nothing.
TEST(close_system, of_a_factor_without_interior_there_is_none) {
  const algebra::SchurFactor all(chain(30, 0.0), 30);
  EXPECT_FALSE(all.has_whole());
  EXPECT_FALSE(algebra::solve_close(chain(30, 0.0), wave(30), all));
}
