#include "algebra/congruence.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace reye;

namespace {

base::SparseMatrix random_entries(int rows, int columns, int count, std::mt19937_64& random) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<base::Triplet> entries;
  for (int i = 0; i < count; ++i)
    entries.emplace_back(static_cast<int>(random() % static_cast<unsigned>(rows)),
                         static_cast<int>(random() % static_cast<unsigned>(columns)), number(random));
  base::SparseMatrix A(rows, columns);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

base::Matrix dense_congruence(const base::SparseMatrix& K, const base::SparseMatrix& B) {
  return base::Matrix(B).transpose() * base::Matrix(K) * base::Matrix(B);
}

double largest(const base::Matrix& A) { return A.size() == 0 ? 0.0 : A.cwiseAbs().maxCoeff(); }

}  // namespace

TEST(Congruence, IsTheProductOfTheWholeMatrices) {
  // Whatever K and B hold, rows and columns of B without an entry included, their product is that of the dense
  // matrices, with its rows in order.
  std::mt19937_64 random(5);
  for (const auto& [m, n, of_K, of_B] :
       {std::array{40, 30, 200, 45}, std::array{40, 30, 0, 45}, std::array{7, 1, 30, 9}, std::array{60, 60, 900, 60},
        std::array{20, 9, 100, 0}}) {
    const auto K = random_entries(m, m, of_K, random), B = random_entries(m, n, of_B, random);
    base::SparseMatrix product;
    algebra::congruence(K, B, product);
    ASSERT_EQ(product.rows(), n);
    EXPECT_LE(largest(base::Matrix(product) - dense_congruence(K, B)), 1e-14);
    for (int c = 0; c < n; ++c) {
      int last = -1;
      for (base::SparseMatrix::InnerIterator e(product, c); e; ++e) {
        EXPECT_GT(e.row(), last);
        last = static_cast<int>(e.row());
      }
    }
  }
}

TEST(Congruence, KeepsItsPatternWhereThatHoldsAllEntries) {
  // A second product with the same patterns moves no entry, one with an entry more has it, too.
  std::mt19937_64 random(6);
  auto K = random_entries(50, 50, 300, random);
  const auto B = random_entries(50, 40, 60, random);
  base::SparseMatrix product;
  algebra::congruence(K, B, product);
  const auto* place = product.valuePtr();
  const auto count = product.nonZeros();
  K *= -2.0;
  algebra::congruence(K, B, product);
  EXPECT_EQ(product.valuePtr(), place);
  EXPECT_LE(largest(base::Matrix(product) - dense_congruence(K, B)), 1e-14);
  K += random_entries(50, 50, 60, random);
  algebra::congruence(K, B, product);
  EXPECT_GT(product.nonZeros(), count);
  EXPECT_LE(largest(base::Matrix(product) - dense_congruence(K, B)), 1e-14);
}

TEST(SymmetricPart, IsTheUpperTriangleWhateverThePattern) {
  // The upper triangle of (K + K^T) / 2 comes out whole where the pattern of K is symmetric, and where an entry has no
  // mirror image: above the diagonal, below it, in the last row, or on a diagonal that is partly empty.
  std::mt19937_64 random(8);
  const auto upper = [](const base::SparseMatrix& K) {
    const base::Matrix D = K;
    return base::Matrix((0.5 * (D + D.transpose())).triangularView<Eigen::Upper>());
  };
  base::SparseMatrix lone_below(4, 4), lone_above(4, 4);
  lone_below.insert(3, 1) = 2.0;
  lone_above.insert(0, 2) = 2.0;
  for (auto* lone : {&lone_below, &lone_above}) lone->makeCompressed();
  const auto A = random_entries(60, 60, 300, random);
  base::SparseMatrix mirrored = A + base::SparseMatrix(0.3 * base::SparseMatrix(A.transpose()));
  mirrored.makeCompressed();
  for (const auto& K : {mirrored, A, lone_below, lone_above, base::SparseMatrix(5, 5)}) {
    const auto part = algebra::symmetric_part(K);
    EXPECT_EQ(largest(base::Matrix(part) - upper(K)), 0.0);
    EXPECT_EQ(largest(base::Matrix(part.triangularView<Eigen::StrictlyLower>())), 0.0);
  }
}
