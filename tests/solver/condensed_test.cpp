#include "solver/condensed.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace {

using reye::base::Matrix;
using reye::base::Vector;

/// A stiffness of a chain with long-range terms: symmetric, definite.
Matrix stiffness(int n) {
  Matrix S(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) S(i, j) = (i == j ? 3.0 + 0.1 * i : 0.0) + 1.0 / (1.0 + std::abs(i - j));
  return S;
}

// Solving on the columns kept and expanding must give what solving on all of them gives, and so must condensing twice.
TEST(condensed, leaves_no_trace) {
  const Matrix S = stiffness(9);
  Vector f(9);
  f << 1, -2, 3, 0.5, -1, 4, 2, -3, 1;
  const Vector q = S.lu().solve(f);
  reye::solver::Condensed once(S, {0, 2, 3, 5, 8}, {1, 4, 6, 7});
  const auto [near, own] = once.load(f);
  reye::solver::Condensed twice(once.stiffness(), {1, 3}, {0, 2, 4});
  const auto [nearest, between] = twice.load(near);
  const Vector expanded = once.expand(twice.expand(twice.stiffness().lu().solve(nearest), between), own);
  EXPECT_EQ(once.size(), 5);
  EXPECT_EQ(once.full(), 9);
  EXPECT_LT((once.expand(once.stiffness().lu().solve(near), own) - q).norm(), 1e-14 * q.norm());
  EXPECT_LT((expanded - q).norm(), 1e-14 * q.norm());
  EXPECT_EQ(once.stiffness(), once.stiffness().transpose());
}

// With nothing to condense everything must pass as it is.
TEST(condensed, keeps_everything) {
  const Matrix S = stiffness(3);
  reye::solver::Condensed all(S, {0, 1, 2}, {});
  const Vector f = Vector::LinSpaced(3, 1.0, 3.0);
  EXPECT_EQ(all.stiffness(), S);
  EXPECT_EQ(all.load(f).near, f);
  EXPECT_EQ(all.expand(f, all.load(f).own), f);
}

}  // namespace
