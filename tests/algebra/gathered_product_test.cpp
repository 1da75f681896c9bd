#include "algebra/gathered_product.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace reye;

namespace {

base::SparseMatrix scattered(int rows, int columns, int per_column, std::mt19937_64& random) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<base::Triplet> entries;
  for (int k = 0; k < columns; ++k)
    for (int i = 0; i < per_column; ++i)
      entries.emplace_back(
          static_cast<int>((static_cast<unsigned>(7 * k) + random() % 40) % static_cast<unsigned>(rows)), k,
          number(random));
  base::SparseMatrix A(rows, columns);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

}  // namespace

TEST(GatheredProduct, SubtractsTheProductOfTheWholeMatrices) {
  // Whatever the numbers of rows and of columns, none and empty ones included, what is subtracted is the product of the
  // dense matrices.
  std::mt19937_64 random(3);
  for (const auto& [rows, left, right, entries] :
       {std::array{90, 70, 33, 5}, std::array{90, 1, 64, 9}, std::array{90, 0, 5, 3}, std::array{90, 5, 0, 3},
        std::array{90, 40, 40, 0}, std::array{1400, 260, 100, 4}}) {
    const base::Matrix half = base::Matrix::Random(rows, rows), C = half + half.transpose();
    const auto L = scattered(rows, left, entries, random), R = scattered(rows, right, entries, random);
    const base::Matrix expected = base::Matrix(L).transpose() * C * base::Matrix(R);
    base::Matrix product = base::Matrix::Ones(left, right);
    algebra::subtract_gathered_product(L, C, R, product);
    if (expected.size() == 0) continue;
    EXPECT_LE((product + expected - base::Matrix::Ones(left, right)).lpNorm<Eigen::Infinity>(), 1e-13);
  }
}
