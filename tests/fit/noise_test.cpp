#include "fit/noise.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <random>

#include "fit/basis.hpp"
#include "fit/pairs.hpp"

namespace {

using namespace reye;
using base::Matrix;
using base::Vec2;
using base::Vector;

/// Places along a line, three of them farther apart, the last a block of fewer values.
fit::Blocks uneven() {
  fit::Blocks blocks;
  for (int i = 0; i < 40; ++i) blocks.at.emplace_back(0.1 * i + (i > 20 ? 0.05 * i : 0.0), 0.0);
  blocks.count = Vector::Constant(40, 4.0);
  blocks.count[39] = 3.0;
  return blocks;
}

Matrix covariance(const fit::Blocks& blocks, const fit::Noise& noise) {
  const Eigen::Index n = blocks.count.size();
  Matrix V(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) V(i, j) = fit::correlation(noise, (blocks.at[i] - blocks.at[j]).norm());
  V.diagonal() += noise.nugget * blocks.count.cwiseInverse();
  return V;
}

Matrix some_columns() {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  return Matrix::NullaryExpr(40, 3, [&] { return normal(random); });
}

// The filter along a line, and the factor of a map, must give Y^T V^-1 Y and log |V| of the whole covariance, for each
// order.
TEST(noise, weighed_as_by_the_whole_covariance) {
  const fit::Blocks blocks = uneven();
  const Matrix Y = some_columns();
  for (const int order : {0, 1, 2})
    for (const bool map : {false, true}) {
      const fit::Noise noise{order, 0.7, 0.2};
      const Matrix V = covariance(blocks, noise);
      const Eigen::LLT<Matrix> factor(V);
      const Matrix expected = Y.transpose() * factor.solve(Y);
      const auto [gram, logs] = fit::weigh(blocks, map, noise, Y);
      EXPECT_LT((gram - expected).norm(), 1e-8 * expected.norm()) << order;
      EXPECT_NEAR(logs, 2.0 * factor.matrixLLT().diagonal().array().log().sum(), 1e-8) << order;
    }
}

// Of columns that nearly depend on each other a basis must be orthonormal, and leave of others what least squares
// leave; beside a basis nothing is left of its own columns.
TEST(basis, of_nearly_dependent_columns) {
  constexpr int n = 200, powers = 14;
  Matrix columns(n, powers);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < powers; ++k) columns(i, k) = std::pow(i / (n - 1.0), k);
  const Matrix basis = fit::basis_of(columns);
  EXPECT_LT((basis.transpose() * basis - Matrix::Identity(basis.cols(), basis.cols())).norm(), 1e-7);
  EXPECT_LT((columns - basis * (basis.transpose() * columns)).norm(), 1e-6);
  EXPECT_EQ(fit::basis_beside(basis, 3.0 * columns * Matrix::Ones(powers, 4), 1e-4).cols(), 0);
  Matrix others(n, 2);
  others << columns.col(2), (20.0 * columns.col(1)).array().sin().matrix();
  const Matrix beside = fit::basis_beside(basis, others, 1e-4);
  ASSERT_EQ(beside.cols(), 1);
  EXPECT_LT((basis.transpose() * beside).norm(), 1e-7);
}

// Sums over pairs by distance must give u^T V u: exactly where places are evenly spaced, nearly elsewhere.
TEST(noise, variance_of_scores) {
  fit::Blocks even;
  for (int i = 0; i < 40; ++i) even.at.emplace_back(0.1 * i, 0.0);
  even.count = Vector::Ones(40);
  const Matrix u = some_columns();
  const fit::Noise noise{1, 0.7, 0.2};
  const Matrix exact = u.transpose() * covariance(even, noise) * u;
  EXPECT_LT((fit::variance_of(fit::pairs_of(even, u), noise) - exact).norm(), 1e-10 * exact.norm());
  const fit::Blocks blocks = uneven();
  const Matrix whole = u.transpose() * covariance(blocks, noise) * u;
  EXPECT_LT((fit::variance_of(fit::pairs_of(blocks, u), noise) - whole).norm(), 1e-2 * whole.norm());
}

// Elimination must leave what least squares leave, count a dependent column once, and give the determinant.
TEST(noise, elimination) {
  Matrix Y(40, 4);
  Y << some_columns().leftCols(2), 2.0 * some_columns().col(0), some_columns().col(2);
  Matrix gram = Y.transpose() * Y;
  const Matrix X = Y.leftCols(2);
  const auto [rank, logs] = fit::eliminate(gram, 3);
  EXPECT_EQ(rank, 2);
  const Matrix XX = X.transpose() * X;
  EXPECT_NEAR(logs, std::log(XX(0, 0) * XX(1, 1) - XX(0, 1) * XX(1, 0)), 1e-10);
  const Vector left = Y.col(3) - X * XX.llt().solve(X.transpose() * Y.col(3));
  EXPECT_NEAR(gram(3, 3), left.squaredNorm(), 1e-10);
}

// Long lines and maps must be averaged, with every value in one block and the mean of all kept.
TEST(noise, blocks) {
  fit::Series line, map;
  map.map = true;
  for (int i = 0; i < 1000; ++i) {
    line.at.emplace_back(0.01 * i, 0.0);
    map.at.emplace_back(i % 40, i / 40);
  }
  line.value = map.value = Vector::LinSpaced(1000, 0.0, 1.0);
  for (const fit::Series* series : {&line, &map}) {
    const fit::Blocks blocks = fit::blocks_of(*series);
    EXPECT_LE(blocks.at.size(), series->map ? 324u : 256u);
    EXPECT_GT(blocks.at.size(), 200u);
    EXPECT_EQ(blocks.count.sum(), 1000.0);
    EXPECT_NEAR(blocks.count.dot(blocks.averaged(series->value).col(0)), series->value.sum(), 1e-9);
  }
}

}  // namespace
