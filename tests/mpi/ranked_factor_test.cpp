// Played by several ranks; the first one tests, the others serve its factors.
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "algebra/factor.hpp"
#include "algebra/ranks.hpp"
#include "base/errors.hpp"

using namespace reye;
using algebra::Matrix;
using algebra::SparseMatrix;
using algebra::Vector;

namespace {

/// Springs between the points of a grid of n x n x n, three dofs a point, each held a little; stiffness is scattered.
SparseMatrix grid(int n, double held) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> stiffness(0.5, 2.0);
  std::vector<base::Triplet> entries;
  const auto at = [n](int i, int j, int k, int d) { return 3 * ((i * n + j) * n + k) + d; };
  const auto spring = [&](int a, int b) {
    const double s = stiffness(random);
    entries.insert(entries.end(), {{a, a, s}, {b, b, s}, {std::min(a, b), std::max(a, b), -s}});
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        for (int d = 0; d < 3; ++d) {
          if (i + 1 < n) spring(at(i, j, k, d), at(i + 1, j, k, d));
          if (j + 1 < n) spring(at(i, j, k, d), at(i, j + 1, k, d));
          if (k + 1 < n) spring(at(i, j, k, d), at(i, j, k + 1, (d + 1) % 3));
          entries.push_back({at(i, j, k, d), at(i, j, k, d), held});
        }
  const int size = 3 * n * n * n;
  SparseMatrix K(size, size);
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

double apart(const Matrix& a, const Matrix& b) { return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff(); }

}  // namespace

TEST(RankedFactor, CondensesAsOneProcessDoes) {
  // Schur complement and interior solutions of all ranks are those of CHOLMOD to 1e-12, for none, few and many
  // retained rows, and while another factor lives.
  const SparseMatrix K = grid(10, 0.01);
  const int n = static_cast<int>(K.rows());
  std::unique_ptr<algebra::RankedFactor> before;
  for (int retained : {0, 3, 300}) {
    auto ranked = std::make_unique<algebra::RankedFactor>(K, retained);
    const algebra::SchurFactor one(K, retained);
    if (retained > 0) {
      EXPECT_LT(apart(ranked->take_schur(), one.schur()), 1e-12) << retained;
    }
    const Vector f = Vector::Random(n - retained);
    Vector whole = Vector::Zero(n);
    whole.head(n - retained) = f;
    const Vector expected = one.recover(whole, Vector::Zero(retained)).head(n - retained);
    EXPECT_LT(apart(ranked->solve_interior(f), expected), 1e-12) << retained;
    before = std::move(ranked);
  }
}

TEST(RankedFactor, LargeOnesAreShared) {
  // A factor of a solid of more than 20 000 dofs is that of the ranks: it condenses and recovers as one process does.
  const SparseMatrix K = grid(22, 0.01);
  const int retained = 99, n = static_cast<int>(K.rows());
  const algebra::SchurFactor shared(K, retained, {}, algebra::Ordering::nested_dissection), one(K, retained);
  EXPECT_EQ(shared.analysis() == nullptr, algebra::ranks() > 1);
  EXPECT_NE(one.analysis(), nullptr);
  EXPECT_LT(apart(shared.schur(), one.schur()), 1e-12);
  const Vector f = Vector::Random(n), u = Vector::Random(retained);
  EXPECT_LT(apart(shared.condense(f), one.condense(f)), 1e-12);
  EXPECT_LT(apart(shared.recover(f, u), one.recover(f, u)), 1e-12);
}

TEST(RankedFactor, WhatCannotBeFactorisedIsRefused) {
  // A matrix that is not definite and one that is singular to working precision are errors on all ranks, after which
  // others are factorised as before.
  SparseMatrix wrong = grid(6, 0.01), loose = grid(6, 0.0);
  wrong.coeffRef(5, 5) = -3.0;
  EXPECT_THROW(algebra::RankedFactor(wrong, 3), base::SolveError);
  EXPECT_THROW(algebra::RankedFactor(loose, 0), base::SolveError);
  EXPECT_NO_THROW(algebra::RankedFactor(grid(6, 0.01), 3));
}

int main(int argc, char** argv) {
  const algebra::Ranks ranks;
  if (ranks.served()) return 0;
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
