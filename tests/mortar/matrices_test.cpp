#include <gtest/gtest.h>

#include <Eigen/LU>
#include <numbers>

#include "straight.hpp"
#include "support/surfaces.hpp"

namespace {

using namespace reye;
using base::Analysis;
using base::Matrix;
using base::Vec2;
using base::Vector;
using support::FacingOptions;
using support::straight;

/// Exact for cubics: hats times hats times 2 pi r.
template <class F>
double simpson(double a, double b, F f) {
  return (b - a) / 6.0 * (f(a) + 4.0 * f(0.5 * (a + b)) + f(b));
}

/// Hat function of node l of a line of nodes along x.
double hat(const base::Points& X, int l, double x) {
  double value = 0.0;
  for (int k : {l - 1, l + 1}) {
    if (k < 0 || k >= static_cast<int>(X.size())) continue;
    const double share = (x - X[k].x()) / (X[l].x() - X[k].x());
    if (share >= 0.0 && share <= 1.0) value = std::max(value, share);
  }
  return value;
}

struct Exact {
  Vector D;
  Matrix M, T;
};

/// int of f over [a, b] cut at the primary nodes.
template <class F>
double piecewise(const base::Points& cuts, double a, double b, F f) {
  double sum = 0.0, from = a;
  for (const auto& x : cuts)
    if (x.x() > from && x.x() < b) {
      sum += simpson(from, x.x(), f);
      from = x.x();
    }
  return sum + simpson(from, b, f);
}

/// D, M and T of two straight surfaces along x that touch, by exact integration of polynomials.
Exact exact(const support::Facing& f) {
  const auto& X = f.secondary.X;
  const int ns = static_cast<int>(X.size()), nm = static_cast<int>(f.xm.size());
  Exact e{Vector::Zero(ns), Matrix::Zero(ns, nm), Matrix::Zero(ns, nm)};
  const auto r = [&](double x) { return base::out_of_plane(f.analysis, x); };
  for (const auto& [i, k, mid] : f.secondary.facets) {
    const double a = std::max(X[k].x(), f.xm.front().x()), b = std::min(X[i].x(), f.xm.back().x());
    if (a >= b) continue;
    const double length = X[i].x() - X[k].x();
    const auto N = [&, i = i, k = k](int j, double x) { return (j == 0 ? x - X[k].x() : X[i].x() - x) / length; };
    Eigen::Matrix2d mass;
    Eigen::Vector2d own;
    for (int j = 0; j < 2; ++j) {
      own[j] = simpson(a, b, [&](double x) { return N(j, x) * r(x); });
      for (int l = 0; l < 2; ++l) mass(j, l) = simpson(a, b, [&](double x) { return N(j, x) * N(l, x) * r(x); });
    }
    const Eigen::Matrix2d A = own.asDiagonal() * mass.inverse();
    for (int j = 0; j < 2; ++j) {
      const int node = j == 0 ? i : k;
      e.D[node] += own[j];
      for (int l = 0; l < nm; ++l) {
        e.M(node, l) += piecewise(
            f.xm, a, b, [&](double x) { return (A(j, 0) * N(0, x) + A(j, 1) * N(1, x)) * hat(f.xm, l, x) * r(x); });
        e.T(node, l) += piecewise(f.xm, a, b, [&](double x) { return N(j, x) * hat(f.xm, l, x) * r(x); });
      }
    }
  }
  return e;
}

void expect_exact(const FacingOptions& o) {
  const auto f = support::facing(o);
  const auto s = support::integrals(support::placed(f));
  const auto e = exact(f);
  const double size = e.D.lpNorm<Eigen::Infinity>();
  EXPECT_LT((s.D - e.D).lpNorm<Eigen::Infinity>(), 1e-13 * size);
  EXPECT_LT((s.M - e.M).lpNorm<Eigen::Infinity>(), 1e-13 * size);
  EXPECT_LT((s.cover - e.T).lpNorm<Eigen::Infinity>(), 1e-13 * size);
  EXPECT_LT(s.gap.lpNorm<Eigen::Infinity>(), 1e-14);
}

// D, M and T must be exact on straight surfaces of 2 against 3 and 7 against 5 facets, in both roles.
TEST(matrices, exact_on_straight_surfaces) {
  for (const auto& [a, b] : {std::pair{2, 3}, {3, 2}, {7, 5}, {5, 7}}) expect_exact(straight(a, b));
}

// They must stay exact where facets are covered in part: drop-off edges of either side, at both ends.
TEST(matrices, exact_on_partly_covered_facets) {
  for (const auto& [a, b] : {std::pair{2, 3}, {7, 5}, {1, 9}, {9, 1}}) {
    expect_exact(straight(a, b, 0.13, 0.82));
    expect_exact(straight(a, b, -0.31, 0.57));
    expect_exact(straight(a, b, -0.2, 1.4));
  }
}

// In axisymmetry every integral must carry 2 pi r, on whole and cut facets.
TEST(matrices, exact_with_ring_weights) {
  for (const auto& [from, to] : {std::pair{0.0, 1.0}, {0.13, 0.82}}) {
    auto o = straight(7, 5, from, to);
    o.analysis = Analysis::axisymmetric;
    expect_exact(o);
    const auto f = support::facing(o);
    const double a = 1.0 + 2.0 * from, b = 1.0 + 2.0 * to;
    EXPECT_NEAR(support::integrals(support::placed(f)).D.sum(), std::numbers::pi * (b * b - a * a), 1e-12);
  }
}

/// Random curved, turned states; every second one has the primary end inside the secondary side.
FacingOptions random_state(unsigned seed) {
  FacingOptions o;
  o.seed = seed;
  o.secondary = 3 + static_cast<int>(seed % 5);
  o.primary = 2 + static_cast<int>(seed % 7);
  o.angle = 0.7 * seed;
  if (seed % 2 == 0) {
    o.from = 0.17;
    o.to = 0.79;
  }
  return o;
}

// Row sums of M must be D + off to round-off, also beside cut nodes: so that forces balance.
TEST(matrices, row_sums_agree) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto f = support::facing(random_state(seed));
    auto p = support::placed(f);
    p.cut[1] = p.cut.back() = 1;
    const auto s = support::integrals(p);
    EXPECT_GT(s.off.sum(), 0.0);
    EXPECT_LT((s.D + s.off.rowwise().sum() - s.M.rowwise().sum()).lpNorm<Eigen::Infinity>(), 1e-14);
  }
}

double cross_at(const support::Facing& f, int facet, const std::array<Vec2, 2>& n, const Vec2& target, double t) {
  const auto [a, b, mid] = f.secondary.facets[facet];
  return base::cross((1 - t) * n[0] + t * n[1], target - (1 - t) * f.xs[a] - t * f.xs[b]);
}

Vec2 normal_of(const support::Facing& f, int node) {
  const auto stencil = mortar::normal_stencil(f.secondary, node, 0);
  std::array<mortar::Pair<double>, 3> x;
  for (int i = 0; i < 3; ++i)
    if (stencil.nodes[i] >= 0) x[i] = {f.xs[stencil.nodes[i]].x(), f.xs[stencil.nodes[i]].y()};
  return mortar::plain(mortar::nodal_normal(stencil, x));
}

/// Arc length on X of the secondary side up to the point whose normal meets `target`, by bisection.
double arc_of_image(const support::Facing& f, const Vec2& target) {
  double arc = 0.0;
  for (int facet = 0; facet < f.secondary.facet_count(); ++facet) {
    const auto [a, b, mid] = f.secondary.facets[facet];
    const std::array<Vec2, 2> n{normal_of(f, a), normal_of(f, b)};
    const double length = (f.secondary.X[b] - f.secondary.X[a]).norm();
    if (cross_at(f, facet, n, target, 0.0) > 0.0 && cross_at(f, facet, n, target, 1.0) <= 0.0) {
      double lo = 0.0, hi = 1.0;
      for (int i = 0; i < 60; ++i) (cross_at(f, facet, n, target, 0.5 * (lo + hi)) > 0.0 ? lo : hi) = 0.5 * (lo + hi);
      return arc + 0.5 * (lo + hi) * length;
    }
    arc += length;
  }
  return cross_at(f, 0, {normal_of(f, 0), normal_of(f, 1)}, target, 0.0) <= 0.0 ? 0.0 : arc;
}

// Segments must cover the overlap of curved surfaces without gap or overlap.
TEST(matrices, segments_cover_the_overlap_exactly) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto f = support::facing(random_state(seed));
    const double overlap = arc_of_image(f, f.xm.front()) - arc_of_image(f, f.xm.back());
    EXPECT_NEAR(support::integrals(support::placed(f)).cover.sum(), overlap, 1e-13) << seed;
  }
}

// A common rigid motion must leave D, M and the weighted gap as they are; offset and gap vectors turn with it.
TEST(matrices, rigid_motion_changes_nothing) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    auto o = random_state(seed);
    o.angle = 0.0;
    const auto f = support::facing(o);
    auto g = f;
    for (auto* side : {&g.xs, &g.xm})
      for (Vec2& x : *side) x = support::turned(x, 1.1 * seed) + Vec2(3.0, -2.0);
    const auto a = support::integrals(support::placed(f)), b = support::integrals(support::placed(g));
    const double size = a.D.lpNorm<Eigen::Infinity>();
    EXPECT_LT((a.D - b.D).lpNorm<Eigen::Infinity>(), 1e-12 * size);
    EXPECT_LT((a.M - b.M).lpNorm<Eigen::Infinity>(), 1e-12 * size);
    EXPECT_LT((a.gap - b.gap).lpNorm<Eigen::Infinity>(), 1e-12 * size);
  }
}

// D is measured on X: stretching both sides along themselves must not change it.
TEST(matrices, measure_is_that_of_X) {
  auto f = support::facing(straight(4, 4));
  for (auto* side : {&f.xs, &f.xm})
    for (Vec2& x : *side) x *= 1.3;
  EXPECT_NEAR(support::integrals(support::placed(f)).D.sum(), 2.0, 1e-14);
}

// Surfaces farther apart than the search length, or turned away from each other, must not be paired.
TEST(matrices, far_or_averted_surfaces_do_not_meet) {
  auto o = straight(3, 4);
  o.gap = 0.6;
  EXPECT_EQ(support::integrals(support::placed(support::facing(o))).cover.sum(), 0.0);
  o.gap = 0.1;
  const auto f = support::facing(o);
  auto averted = f;
  averted.primary = support::polyline({f.primary.X.rbegin(), f.primary.X.rend()});
  averted.xm = averted.primary.X;
  EXPECT_EQ(support::integrals(support::placed(averted)).cover.sum(), 0.0);
}

}  // namespace
