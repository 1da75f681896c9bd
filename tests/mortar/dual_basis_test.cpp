#include <gtest/gtest.h>

#include "support/surfaces.hpp"

namespace {

using namespace reye;
using base::Analysis;
using base::Vec2;

/// A facet from (2, 0) to (1, 0) under two leaning primary facets that reach from x = a to x = b.
mortar::Workspace<double> facet_under(double a, double b, Analysis analysis = Analysis::plane_strain) {
  mortar::Workspace<double> w;
  w.in.X = {mortar::Pair<double>{2, 0}, mortar::Pair<double>{1, 0}};
  w.in.x_before = w.in.X;
  w.in.x = {mortar::Pair<double>{2, 0}, mortar::Pair<double>{1, 0}};
  w.in.n = {mortar::Pair<double>{0.1, std::sqrt(0.99)}, mortar::Pair<double>{-0.2, std::sqrt(0.96)}};
  w.in.xm = {{a, 0.02}, {0.4 * a + 0.6 * b, 0.01}, {b, 0.04}};
  w.in.xm_before.assign(3, {});
  w.in.pairs = {{0, 1, -1}, {1, 2, -1}};
  w.in.analysis = analysis;
  w.in.search = 0.5;
  return w;
}

/// Largest |int psi_j N_k - delta_jk int N_j|.
double biorthogonality_error(const mortar::Workspace<double>& w) {
  const auto basis = mortar::dual_basis(w.in, w.points);
  double error = 0.0;
  for (int j = 0; j < w.in.count(); ++j)
    for (int k = 0; k < w.in.count(); ++k) {
      if (w.in.cut[j] || w.in.cut[k]) continue;
      double sum = 0.0;
      for (const auto& q : w.points)
        sum += q.weight * (mortar::dual_functions(w.in, basis, q)[j] * q.N[k] - (j == k ? q.N[j] : 0.0));
      error = std::max(error, std::abs(sum));
    }
  return error;
}

struct Cover {
  double from, to;
};
constexpr Cover covers[] = {{0.5, 2.5}, {1.3, 2.5}, {0.5, 1.7}, {1.2, 1.6}, {1.48, 1.55}};

// int psi_j N_k = delta_jk int N_j must hold over the covered part, whole or cut, plane or ring.
TEST(dual_basis, biorthogonal_on_the_covered_part) {
  for (Analysis analysis : {Analysis::plane_strain, Analysis::axisymmetric})
    for (const auto& cover : covers) {
      auto w = facet_under(cover.from, cover.to, analysis);
      mortar::integrate(w);
      ASSERT_FALSE(w.points.empty());
      EXPECT_LT(biorthogonality_error(w), 1e-13) << cover.from << " to " << cover.to;
    }
}

// The dual functions must add up to one everywhere, on cut facets too.
TEST(dual_basis, partition_of_unity) {
  for (const auto& cover : covers) {
    auto w = facet_under(cover.from, cover.to);
    mortar::integrate(w);
    const auto A = mortar::dual_basis(w.in, w.points).A;
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(A[0][k] + A[1][k], 1.0, 1e-11);
  }
}

// On a whole straight facet the basis must be the known one: psi_0 = 2 N_0 - N_1.
TEST(dual_basis, known_on_a_whole_facet) {
  auto w = facet_under(0.5, 2.5);
  mortar::integrate(w);
  const auto A = mortar::dual_basis(w.in, w.points).A;
  EXPECT_NEAR(A[0][0], 2.0, 1e-13);
  EXPECT_NEAR(A[0][1], -1.0, 1e-13);
  EXPECT_NEAR(A[1][0], -1.0, 1e-13);
  EXPECT_NEAR(A[1][1], 2.0, 1e-13);
}

// Beside a node without multiplier the other one must carry the whole facet, and the cut one nothing.
TEST(dual_basis, redistributes_beside_a_cut_node) {
  for (int cut = 0; cut < 2; ++cut) {
    auto w = facet_under(0.5, 2.5);
    w.in.cut[cut] = true;
    mortar::integrate(w);
    const int kept = 1 - cut;
    EXPECT_NEAR(w.out.D[kept], 0.5, 1e-14);
    EXPECT_NEAR(w.out.off[kept][cut], 0.5, 1e-14);
    EXPECT_EQ(w.out.D[cut], 0.0);
    EXPECT_EQ(w.out.off[cut][kept], 0.0);
    for (double M : w.out.M[cut]) EXPECT_EQ(M, 0.0);
  }
}

// A facet covered by less than a thousandth must take no part at all: neither in D nor where wear is spread.
TEST(dual_basis, sliver_takes_no_part) {
  auto w = facet_under(1.9995, 2.5);
  w.in.n = {mortar::Pair<double>{0, 1}, mortar::Pair<double>{0, 1}};
  mortar::integrate(w);
  for (int j = 0; j < 2; ++j) {
    EXPECT_EQ(w.out.D[j], 0.0);
    for (double T : w.out.cover[j]) EXPECT_EQ(T, 0.0);
  }
}

}  // namespace
