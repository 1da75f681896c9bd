#include "algebra/unsymmetric.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "algebra/dense.hpp"
#include "algebra/factor.hpp"
#include "base/errors.hpp"

namespace {

using namespace reye;
using algebra::UnsymmetricSchur;
using base::Matrix;
using base::SparseMatrix;
using base::Vector;
using support::dense_schur;
using support::wave;

/// Springs between neighbours of an nx times ny grid of nodes with two motions; `drift` makes what a node exerts on
/// its right neighbour differ from what it takes, so that K is unsymmetric. Columns still sum to `ground`.
SparseMatrix drifting_grid(int nx, int ny, double ground, double drift) {
  std::vector<base::Triplet> t;
  const auto couple = [&](int a, int b, double k) {
    const double cross[2][2] = {{2.0, 0.4}, {-0.3, 1.0}};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        const double there = k * cross[i][j] * (1 + drift), back = k * cross[i][j] * (1 - drift);
        t.emplace_back(2 * a + i, 2 * a + j, there);
        t.emplace_back(2 * b + i, 2 * a + j, -there);
        t.emplace_back(2 * b + i, 2 * b + j, back);
        t.emplace_back(2 * a + i, 2 * b + j, -back);
      }
  };
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = j * nx + i;
      if (i + 1 < nx) couple(a, a + 1, 100.0 + 50.0 * std::sin(7.0 * a));
      if (j + 1 < ny) couple(a, a + nx, 80.0);
      for (int c = 0; c < 2; ++c) t.emplace_back(2 * a + c, 2 * a + c, ground);
    }
  SparseMatrix K(2 * nx * ny, 2 * nx * ny);
  K.setFromTriplets(t.begin(), t.end());
  return K;
}

// The Schur complement of an unsymmetric matrix must equal the dense computation, held or floating, at any split.
TEST(unsymmetric, equals_dense) {
  for (double ground : {0.0, 5.0})
    for (int retained : {2, 7, 30, 150, 199, 200}) {
      const SparseMatrix K = drifting_grid(10, 10, ground, 0.3);
      const UnsymmetricSchur f(K, retained);
      EXPECT_LT((f.schur() - dense_schur(K, retained)).norm(), 1e-12 * K.norm()) << retained << " " << ground;
    }
}

// Of a symmetric matrix it must be what the Cholesky factor gives.
TEST(unsymmetric, agrees_with_cholesky) {
  SparseMatrix K = drifting_grid(20, 15, 1.0, 0.0);
  K = 0.5 * (K + SparseMatrix(K.transpose()));
  const UnsymmetricSchur f(K, 40);
  const algebra::SchurFactor g(K, 40);
  EXPECT_LT((f.schur() - g.schur()).norm(), 1e-12 * K.norm());
}

// Condensed equations plus recovery must give the direct solution.
TEST(unsymmetric, condense_and_recover_equal_direct_solution) {
  for (int retained : {0, 1, 20, 200}) {
    const SparseMatrix K = drifting_grid(10, 10, 2.0, 0.4);
    const UnsymmetricSchur f(K, retained);
    const Vector load = wave(200);
    Matrix S = f.schur();
    const Vector u = f.recover(load, algebra::solve_dense(S, f.condense(load)));
    EXPECT_LT((K * u - load).norm(), 1e-11 * load.norm()) << retained;
  }
}

// Refactoring must give what a new factorisation gives, with the same pattern and with another one, and an indefinite
// matrix must be no obstacle.
TEST(unsymmetric, refactor_equals_fresh) {
  UnsymmetricSchur f(drifting_grid(9, 8, 0.0, 0.2), 16);
  for (const SparseMatrix& K :
       {drifting_grid(9, 8, 0.0, -0.5), drifting_grid(9, 8, -150.0, 0.2), drifting_grid(12, 7, 1.0, 0.2)}) {
    f.refactor(K);
    EXPECT_LT((f.schur() - dense_schur(K, 16)).norm(), 1e-11 * K.norm());
    const Vector load = wave(K.rows());
    EXPECT_LT((f.condense(load) - UnsymmetricSchur(K, 16).condense(load)).norm(), 1e-11 * load.norm());
  }
}

// A singular interior, a value that is not finite and an impossible split must be SolveErrors.
TEST(unsymmetric, failures_are_solve_errors) {
  SparseMatrix K = drifting_grid(6, 6, 0.0, 0.3);
  EXPECT_THROW(UnsymmetricSchur(K, 0), base::SolveError);  // both translations free inside
  EXPECT_THROW(UnsymmetricSchur(K, 73), base::SolveError);
  K.coeffRef(5, 5) = std::nan("");
  EXPECT_THROW(UnsymmetricSchur(K, 6), base::SolveError);
}

}  // namespace
