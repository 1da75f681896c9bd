#include "algebra/factor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "algebra/decompose.hpp"
#include "algebra/dense.hpp"
#include "algebra/factor_cost.hpp"
#include "base/cores.hpp"
#include "base/errors.hpp"

namespace {

using namespace reye;
using base::Matrix;
using base::SparseMatrix;
using base::Vector;
using support::dense_schur;
using support::wave;

/// Springs between neighbours of an nx times ny grid, two motions per node with a cross coupling; held to the
/// ground with stiffness `ground`. Without ground any common translation is free.
SparseMatrix grid(int nx, int ny, double ground, double softness = 1.0) {
  std::vector<base::Triplet> t;
  const auto couple = [&](int a, int b, double kx, double ky, double kxy) {
    const double k[2][2] = {{kx, kxy}, {kxy, ky}};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        t.emplace_back(2 * a + i, 2 * a + j, k[i][j]);
        t.emplace_back(2 * b + i, 2 * b + j, k[i][j]);
        t.emplace_back(2 * a + i, 2 * b + j, -k[i][j]);
        t.emplace_back(2 * b + i, 2 * a + j, -k[i][j]);
      }
  };
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = j * nx + i;
      const double stiff = 100.0 * (1.0 + 0.5 * softness * std::sin(7.0 * a));
      if (i + 1 < nx) couple(a, a + 1, 3 * stiff, stiff, 0.3 * stiff);
      if (j + 1 < ny) couple(a, a + nx, stiff, 3 * stiff, -0.2 * stiff);
      for (int c = 0; c < 2; ++c) t.emplace_back(2 * a + c, 2 * a + c, ground);
    }
  SparseMatrix K(2 * nx * ny, 2 * nx * ny);
  K.setFromTriplets(t.begin(), t.end());
  return K;
}

// The Schur complement must equal the dense computation to 1e-12, held or floating, whatever the split.
TEST(schur, equals_dense) {
  for (double ground : {0.0, 5.0})
    for (int retained : {2, 7, 30, 150, 199, 200}) {
      const SparseMatrix K = grid(10, 10, ground);
      const algebra::SchurFactor f(K, retained);
      const Matrix S = dense_schur(K, retained);
      EXPECT_LT((f.schur() - S).norm(), 1e-12 * K.norm()) << "retained " << retained << " ground " << ground;
      EXPECT_EQ((f.schur() - f.schur().transpose()).norm(), 0.0);
    }
}

// A free translation must stay free in the Schur complement: S times it vanishes to round-off.
TEST(schur, floating_motion_costs_nothing) {
  const algebra::SchurFactor f(grid(40, 25, 0.0), 80);
  Vector along_x = Vector::Zero(80);
  for (int k = 0; k < 80; k += 2) along_x[k] = 1.0;
  EXPECT_LT((f.schur() * along_x).norm(), 1e-12 * f.schur().norm());
}

// A retained column in another unit (a rotation beside displacements) must not cost the others a digit: S of the scaled
// matrix is the scaled S.
TEST(schur, columns_of_any_unit) {
  const SparseMatrix K = grid(6, 5, 0.0);
  constexpr int retained = 8;
  const Matrix S = algebra::SchurFactor(K, retained).schur();
  for (double unit : {1e-6, 1e6}) {
    Vector scale = Vector::Ones(K.rows());
    scale[K.rows() - 1] = unit;
    const SparseMatrix scaled = scale.asDiagonal() * K * scale.asDiagonal();
    const Vector back = scale.tail(retained).cwiseInverse();
    const Matrix T = back.asDiagonal() * algebra::SchurFactor(scaled, retained).schur() * back.asDiagonal();
    EXPECT_LT((T - S).cwiseAbs().maxCoeff(), 1e-13 * S.cwiseAbs().maxCoeff()) << unit;
  }
}

// A factor that is given another's analysis must give what a fresh one gives: of the same pattern, where the analysis
// is shared and outlives the first factor, and of another one, where it is not.
TEST(schur, known_analysis_equals_fresh) {
  const auto known = algebra::SchurFactor(grid(9, 8, 0.0), 16).analysis();
  algebra::SchurFactor same(grid(9, 8, 0.0, -0.7), 16, known), other(grid(12, 7, 1.0), 16, known);
  EXPECT_EQ(same.analysis(), known);
  EXPECT_NE(other.analysis(), known);
  same.refactor(grid(9, 8, 0.0, -0.3));
  EXPECT_EQ((same.schur() - algebra::SchurFactor(grid(9, 8, 0.0, -0.3), 16).schur()).norm(), 0.0);
  EXPECT_EQ((other.schur() - algebra::SchurFactor(grid(12, 7, 1.0), 16).schur()).norm(), 0.0);
}

// Nested dissection must give the same complement as minimum degree to round-off, whatever is retained, and keep its
// analysis apart.
TEST(schur, nested_dissection_equals_minimum_degree) {
  for (int retained : {0, 1, 30, 599, 600}) {
    const SparseMatrix K = grid(20, 15, 3.0);
    const algebra::SchurFactor a(K, retained), b(K, retained, a.analysis(), algebra::Ordering::nested_dissection);
    EXPECT_LT((a.schur() - b.schur()).norm(), 1e-13 * K.norm());
    const Vector load = wave(600), u_c = wave(retained);
    EXPECT_LT((a.condense(load) - b.condense(load)).norm(), 1e-11 * load.norm());
    EXPECT_LT((a.recover(load, u_c) - b.recover(load, u_c)).norm(), 1e-11 * a.recover(load, u_c).norm());
    EXPECT_TRUE(retained == 600 || a.analysis() != b.analysis());
  }
}

// With springs on chosen rows alone, S + sigma must come out inverted, its rows as they are, and what recovers
// unchanged.
TEST(schur, inverted_from_its_factor) {
  const int retained = 20;
  for (const double ground : {2.0, 0.0}) {
    const SparseMatrix K = grid(10, 10, ground);
    const algebra::SchurFactor whole(K, retained);
    const std::vector<int> shifted{0, 1, 18, 19};  // a node, for the motions that are free, and the last two rows
    algebra::SchurFactor f(K, retained, algebra::Ordering::nested_dissection, shifted);
    EXPECT_EQ(f.schur().size(), 0);
    Matrix held = whole.schur();
    for (const int k : shifted) held(k, k) += K.coeff(180 + k, 180 + k);
    EXPECT_LT((f.schur_rows(18) - whole.schur().bottomRows(2)).norm(), 1e-12 * held.norm());
    const Vector load = wave(200);
    EXPECT_LT((f.condense(load) - whole.condense(load)).norm(), 1e-12 * load.norm());
    const Vector u_c = wave(retained);
    EXPECT_LT((f.recover(load, u_c) - whole.recover(load, u_c)).norm(), 1e-11 * whole.recover(load, u_c).norm());
    const auto inverse = f.take_inverse(18);
    const Matrix leading = held.topLeftCorner(18, 18), one = Matrix::Identity(18, 18);
    EXPECT_LT((inverse.C * leading - one).norm(), 1e-11);
    EXPECT_EQ((inverse.C - inverse.C.transpose()).norm(), 0.0);
    EXPECT_NEAR(inverse.condition, inverse.C.diagonal().cwiseProduct(leading.diagonal()).maxCoeff(), 1e-9);
  }
}

// The predicted size of a factor must grow with what is retained, and be that of a dense one where all is.
TEST(factor_cost, counts_entries) {
  const int n = 300;
  SparseMatrix graph(n, n);
  std::vector<base::Triplet> t;
  for (int k = 0; k < n; ++k) {
    t.emplace_back(k, k, 1.0);
    if (k > 0) t.emplace_back(k - 1, k, 1.0);
  }
  graph.setFromTriplets(t.begin(), t.end());
  EXPECT_LT(algebra::factor_cost(graph, 0, 3).entries, 9.0 * 6.0 * n);
  EXPECT_NEAR(algebra::factor_cost(SparseMatrix(Matrix::Ones(50, 50).sparseView()), 50, 3).entries, 9.0 * 50 * 51 / 2,
              1.0);
}

// The inverse of a dense definite matrix must be one, and what is not definite be refused.
TEST(dense, inverts_definite_matrices) {
  const Matrix A = Matrix(grid(5, 4, 3.0));
  Matrix C = A;
  algebra::invert(C);
  EXPECT_LT((C * A - Matrix::Identity(40, 40)).norm(), 1e-11);
  EXPECT_EQ((C - C.transpose()).norm(), 0.0);
  C = -A;
  EXPECT_THROW(algebra::invert(C), base::SolveError);
}

// Condensed equations plus recovery must give the direct solution to 1e-11.
TEST(schur, condense_and_recover_equal_direct_solution) {
  for (int retained : {0, 1, 20, 200}) {
    const SparseMatrix K = grid(10, 10, 2.0);
    const algebra::SchurFactor f(K, retained);
    const Vector load = wave(200);
    Matrix S = f.schur();
    const Vector u_c = algebra::solve_dense(S, f.condense(load));
    const Vector u = f.recover(load, u_c);
    const Vector direct = algebra::Cholesky(K).solve(load);
    EXPECT_LT((u - direct).norm(), 1e-11 * direct.norm()) << retained;
    EXPECT_LT((K * u - load).norm(), 1e-11 * load.norm());
  }
}

// Refactoring must give what a new factorisation gives, with the same pattern and with another one.
TEST(schur, refactor_equals_fresh) {
  algebra::SchurFactor f(grid(9, 8, 0.0), 16);
  for (const SparseMatrix& K : {grid(9, 8, 0.0, -0.7), grid(12, 7, 1.0)}) {
    f.refactor(K);
    const algebra::SchurFactor fresh(K, 16);
    EXPECT_EQ((f.schur() - fresh.schur()).norm(), 0.0);
    const Vector load = wave(K.rows());
    EXPECT_EQ((f.condense(load) - fresh.condense(load)).norm(), 0.0);
  }
}

// A singular or indefinite interior, a value that is not finite and an impossible split must be SolveErrors.
TEST(schur, failures_are_solve_errors) {
  SparseMatrix K = grid(6, 6, 0.0);
  EXPECT_THROW(algebra::SchurFactor(K, 0), base::SolveError);  // both translations free inside
  EXPECT_THROW(algebra::SchurFactor(K, 1), base::SolveError);  // one still free
  EXPECT_THROW(algebra::SchurFactor(K, 73), base::SolveError);
  SparseMatrix negative = -1.0 * grid(6, 6, 1.0);
  EXPECT_THROW(algebra::SchurFactor(negative, 6), base::SolveError);
  K.coeffRef(5, 5) = std::nan("");
  EXPECT_THROW(algebra::SchurFactor(K, 6), base::SolveError);
}

// A factor that failed must work again once it is given a good matrix.
TEST(schur, recovers_after_failure) {
  const SparseMatrix K = grid(6, 6, 1.0);
  algebra::SchurFactor f(K, 10);
  const Matrix before = f.schur();
  EXPECT_THROW(f.refactor(SparseMatrix(-1.0 * K)), base::SolveError);
  f.refactor(K);
  EXPECT_EQ((f.schur() - before).norm(), 0.0);
}

// The plain factor must solve for several right-hand sides and refuse singular matrices.
TEST(cholesky, solves_and_refuses) {
  const SparseMatrix K = grid(12, 9, 1.0);
  Matrix b(K.rows(), 3);
  for (int j = 0; j < 3; ++j) b.col(j) = (j + 1.0) * wave(K.rows()).array().pow(j + 1);
  EXPECT_LT((K * algebra::Cholesky(K).solve(b) - b).norm(), 1e-12 * b.norm());
  EXPECT_THROW(algebra::Cholesky(grid(12, 9, 0.0)), base::SolveError);
}

// The dense solve must be exact for unsymmetric, badly scaled systems.
TEST(dense, solves_badly_scaled_systems) {
  const int n = 40;
  Matrix A(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) A(i, j) = std::sin(1.0 + i * 3.7 + j * j * 0.9) + (i == j ? 4.0 : 0.0);
  const Vector x = wave(n);
  const Vector rows = Vector::LinSpaced(n, -9.0, 6.0).unaryExpr([](double e) { return std::pow(10.0, e); });
  A = rows.asDiagonal() * A;
  const Vector b = A * x;
  EXPECT_LT((algebra::solve_dense(A, b) - x).norm(), 1e-12 * x.norm());
}

// A singular matrix must be a SolveError: a zero row, equal columns, a value that is not finite.
TEST(dense, same_bits_on_any_number_of_cores) {
  // Several panels of columns, of which the last is narrower, solve as another library does, and alike on all cores.
  const int n = 300;
  Matrix A(n, n);
  std::mt19937 random(1);
  for (double& entry : A.reshaped()) entry = std::ldexp(static_cast<double>(random()), -32) - 0.5;
  const Vector b = wave(n);
  const Vector expected = algebra::least_squares(A, b);
  std::vector<Vector> solutions;
  for (const int count : {1, 2, 3}) {
    const base::Cores cores(count);
    Matrix copy = A;
    solutions.push_back(algebra::solve_dense(copy, b));
  }
  EXPECT_LT((solutions[0] - expected).norm(), 1e-10 * expected.norm());
  EXPECT_EQ(solutions[1], solutions[0]);
  EXPECT_EQ(solutions[2], solutions[0]);
}

TEST(dense, singular_is_a_solve_error) {
  Matrix zero_row = Matrix::Identity(4, 4);
  zero_row(2, 2) = 0.0;
  Matrix equal = Matrix::Identity(4, 4);
  equal.col(3) = equal.col(1);
  Matrix bad = Matrix::Identity(4, 4);
  bad(0, 1) = INFINITY;
  for (Matrix* A : {&zero_row, &equal, &bad}) EXPECT_THROW(algebra::solve_dense(*A, Vector::Ones(4)), base::SolveError);
}

}  // namespace
