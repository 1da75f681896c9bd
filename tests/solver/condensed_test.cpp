#include "solver/condensed.hpp"

#include <gtest/gtest.h>

#include "algebra/decompose.hpp"
#include "base/errors.hpp"

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

std::shared_ptr<const Matrix> shared(Matrix S) { return std::make_shared<const Matrix>(std::move(S)); }

void expect_no_trace(const reye::solver::Condensed& once, const Matrix& S, double digits) {
  Vector f(9);
  f << 1, -2, 3, 0.5, -1, 4, 2, -3, 1;
  const Vector q = reye::algebra::least_squares(S, f);
  const auto [near, own] = once.load(f);
  const auto twice = once.part({1, 3}, {0, 2, 4});
  const auto [nearest, between] = twice.load(near);
  const Vector expanded =
      once.expand(twice.expand(reye::algebra::least_squares(twice.stiffness(), nearest), between), own);
  EXPECT_EQ(once.size(), 5);
  EXPECT_EQ(once.full(), 9);
  EXPECT_LT((once.expand(reye::algebra::least_squares(once.stiffness(), near), own) - q).norm(), digits * q.norm());
  EXPECT_LT((expanded - q).norm(), digits * q.norm());
  EXPECT_EQ(once.stiffness(), once.stiffness().transpose());
}

const std::vector<int> near{0, 2, 3, 5, 8}, far{1, 4, 6, 7};

// Solving on the columns kept and expanding must give what solving on all of them gives, and so must condensing twice.
TEST(condensed, leaves_no_trace) {
  const Matrix S = stiffness(9);
  expect_no_trace({shared(S), nullptr, near, far}, S, 1e-14);
}

// The inverse of the whole must give what the stiffness gives, also once all columns were kept.
TEST(condensed, by_the_inverse) {
  const Matrix S = stiffness(9);
  const auto inverse = std::make_shared<const reye::algebra::Compliance>(S, std::vector<int>{3, 8});
  expect_no_trace({shared(S), inverse, near, far}, S, 1e-14);
  const reye::solver::Condensed all(shared(S), inverse, {0, 1, 2, 3, 4, 5, 6, 7, 8}, {});
  EXPECT_EQ(all.stiffness(), S);
  expect_no_trace(all.part(near, far), S, 1e-14);
}

// A stiffness that nothing holds has no inverse, and must be condensed all the same: springs hold it and go again.
TEST(condensed, where_nothing_holds) {
  Matrix S = -stiffness(9);
  for (int i = 0; i < 9; ++i) S(i, i) -= S.row(i).sum();
  const reye::solver::Condensed directly(shared(S), nullptr, near, far);
  const reye::solver::Condensed inversely(
      shared(S), std::make_shared<const reye::algebra::Compliance>(S, std::vector<int>{3}), near, far);
  EXPECT_LT((inversely.stiffness() - directly.stiffness()).norm(), 1e-13 * S.norm());
  EXPECT_LT((inversely.stiffness() * Vector::Ones(5)).norm(), 1e-13 * S.norm());
  const Vector f = Vector::LinSpaced(9, -1.0, 1.0);
  EXPECT_LT((inversely.load(f).near - directly.load(f).near).norm(), 1e-13);
  EXPECT_LT((inversely.load(f).own - directly.load(f).own).norm(), 1e-13);
}

// Where springs leave a motion free, round-off is all that an inverse would be made of, and must be refused.
TEST(condensed, no_inverse_of_a_free_motion) {
  Matrix S = Matrix::Zero(18, 18);
  for (int part : {0, 9}) {
    S.block(part, part, 9, 9) = -stiffness(9);
    for (int i = 0; i < 9; ++i) S(part + i, part + i) -= S.block(part, part, 9, 9).row(i).sum();
  }
  EXPECT_NO_THROW(reye::algebra::Compliance(S, {3, 12}));
  EXPECT_THROW(reye::algebra::Compliance(S, {3, 4}), reye::base::SolveError);
}

// Tangents of nonlinear bodies need be neither symmetric nor definite, and must be condensed as exactly; a linear body
// whose stiffness is not definite must be refused.
TEST(condensed, where_not_symmetric_or_not_definite) {
  Matrix unsymmetric = stiffness(9), indefinite = stiffness(9);
  for (int i = 0; i < 9; ++i) unsymmetric(i, (i + 4) % 9) += 0.4;
  indefinite(4, 4) = -2.0;
  Vector f(9);
  f << 1, -2, 3, 0.5, -1, 4, 2, -3, 1;
  for (const Matrix& S : {unsymmetric, indefinite}) {
    const Vector q = reye::algebra::least_squares(S, f);
    const auto once = reye::solver::Condensed::tangent(S, near, far);
    const auto [kept, own] = once.load(f);
    EXPECT_LT((once.expand(reye::algebra::least_squares(once.stiffness(), kept), own) - q).norm(), 1e-14 * q.norm());
  }
  EXPECT_THROW(reye::solver::Condensed(shared(indefinite), nullptr, near, far), reye::base::SolveError);
  Matrix singular = stiffness(9);
  singular.row(6) = singular.row(7);
  singular.col(6) = singular.col(7);
  EXPECT_THROW(reye::solver::Condensed(shared(singular), nullptr, near, far), reye::base::SolveError);
  EXPECT_THROW(reye::solver::Condensed::tangent(singular, near, far), reye::base::SolveError);
}

// With nothing to condense everything must pass as it is.
TEST(condensed, keeps_everything) {
  const Matrix S = stiffness(3);
  reye::solver::Condensed all(shared(S), nullptr, {0, 1, 2}, {});
  const Vector f = Vector::LinSpaced(3, 1.0, 3.0);
  EXPECT_EQ(all.stiffness(), S);
  EXPECT_EQ(all.load(f).near, f);
  EXPECT_EQ(all.expand(f, all.load(f).own), f);
}

}  // namespace
