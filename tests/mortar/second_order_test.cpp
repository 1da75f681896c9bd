#include <gtest/gtest.h>

#include <numbers>

#include "straight.hpp"
#include "support/surfaces.hpp"

namespace {

using namespace reye;
using base::Points;
using base::Vec2;
using base::Vector;
using support::FacingOptions;

/// Curved facets on both sides at a random, turned state.
FacingOptions curved(unsigned seed) {
  FacingOptions o;
  o.seed = seed;
  o.secondary = 3 + static_cast<int>(seed % 3);
  o.primary = 2 + static_cast<int>(seed % 4);
  o.secondary_order = o.primary_order = 2;
  o.angle = 0.7 * seed;
  if (seed % 2 == 0) {
    o.from = 0.17;
    o.to = 0.79;
  }
  return o;
}

/// Straight facets of second order that touch.
FacingOptions straight_of_order_two(int secondary, int primary) {
  FacingOptions o = support::straight(secondary, primary);
  o.secondary_order = o.primary_order = 2;
  return o;
}

/// Control points without multiplier.
std::vector<char> linear_multipliers(const mortar::Surface& s) {
  std::vector<char> cut;
  for (int j = 0; j < s.node_count(); ++j) cut.push_back(s.is_control_point(j));
  return cut;
}

// Middle nodes must become control points: a curve from (2, 0) over (1, 0.5) to (0, 0) has its own at (1, 1).
TEST(second_order, chains_become_bezier_curves) {
  const auto s = support::polyline({{2, 0}, {1, 0.5}, {0, 0}, {-1, 0}, {-2, 0}}, base::Analysis::plane_strain, 2);
  ASSERT_EQ(s.facet_count(), 2);
  EXPECT_EQ(s.facets[1], (mortar::LineFacet{2, 4, 3}));
  EXPECT_LT((s.X[1] - Vec2(1, 1)).norm(), 1e-15);
  EXPECT_TRUE(s.is_control_point(1));
  EXPECT_FALSE(s.is_control_point(2));
  EXPECT_EQ(s.corner[2], 0);  // the curve arrives at 45 degrees
  EXPECT_EQ(s.beside(0, 1), 1);
}

// Each of the three nodes of a straight facet must own a third of it; a ring owns what it sweeps.
TEST(second_order, nodal_areas) {
  const auto plane = support::polyline({{4, 0}, {2.5, 0}, {1, 0}}, base::Analysis::plane_strain, 2);
  for (double A : plane.area) EXPECT_NEAR(A, 1.0, 1e-14);
  const auto ring = support::polyline({{4, 0}, {2.5, 0}, {1, 0}}, base::Analysis::axisymmetric, 2);
  EXPECT_NEAR(ring.area[0] + ring.area[1] + ring.area[2], std::numbers::pi * 15.0, 1e-12);
}

/// A workspace with one curved facet below three primary nodes that reach from x = a to x = b.
mortar::Workspace<double> curved_facet_under(double a, double b) {
  mortar::Workspace<double> w;
  w.in.kind = mesh::LineKind::line3;
  w.in.x = {mortar::Pair<double>{2, 0}, mortar::Pair<double>{1, 0}, mortar::Pair<double>{1.45, 0.1}};
  w.in.X = w.in.x_before = w.in.x;
  w.in.n = {mortar::Pair<double>{0.1, 1.0}, mortar::Pair<double>{-0.2, 0.98}, mortar::Pair<double>{0.0, 1.0}};
  w.in.xm = {{a, 0.12}, {b, 0.14}, {0.4 * a + 0.6 * b, 0.11}};
  w.in.xm_before.assign(3, {});
  w.in.pairs = {{0, 1, 2}};
  w.in.search = 0.5;
  return w;
}

constexpr std::pair<double, double> covered_parts[] = {{0.5, 2.5},   {1.3, 2.5},  {0.5, 1.7}, {1.2, 1.6},
                                                       {1.48, 1.55}, {1.5, 1.51}, {1.9, 2.5}};

// int psi_j N_k = delta_jk int N_j must hold between the nodes that carry multipliers, and these psi add up to one:
// over whole and partly covered facets, for three, two and one of them.
TEST(second_order, biorthogonal_on_the_covered_part) {
  for (const auto& [from, to] : covered_parts)
    for (const auto& cut :
         {std::array<bool, 3>{false, false, false}, {false, false, true}, {true, false, false}, {true, false, true}}) {
      auto w = curved_facet_under(from, to);
      w.in.cut = cut;
      mortar::integrate(w);
      ASSERT_FALSE(w.points.empty());
      const auto basis = mortar::dual_basis(w.in, w.points);
      double length = 0.0;
      for (const auto& q : w.points) {
        length += q.weight;
        const auto psi = mortar::dual_functions(w.in, basis, q);
        EXPECT_NEAR(psi[0] + psi[1] + psi[2], 1.0, 1e-9) << from;
      }
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k) {
          if (cut[j] || cut[k]) continue;
          double sum = 0.0;
          for (const auto& q : w.points)
            sum += q.weight * (mortar::dual_functions(w.in, basis, q)[j] * q.N[k] - (j == k ? q.N[j] : 0.0));
          EXPECT_LT(std::abs(sum), 1e-11 * length) << from << " to " << to << ": " << j << k;
        }
    }
}

// On a whole straight facet every node must have D = L / 3; with linear multipliers each end takes half of the control
// point's share, too.
TEST(second_order, known_on_a_whole_facet) {
  const auto f = support::facing(straight_of_order_two(1, 1));
  auto p = support::placed(f);
  const auto quadratic = support::integrals(p);
  for (double D : quadratic.D) EXPECT_NEAR(D, 2.0 / 3.0, 1e-13);
  EXPECT_EQ(quadratic.off.sum(), 0.0);
  p.cut = linear_multipliers(f.secondary);
  const auto linear = support::integrals(p);
  for (int j : {0, 2}) {
    EXPECT_NEAR(linear.D[j], 2.0 / 3.0, 1e-13);
    EXPECT_NEAR(linear.off(j, 1), 1.0 / 3.0, 1e-13);
  }
  EXPECT_EQ(linear.D[1], 0.0);
}

// Row sums of M must be D + off to round-off at any state, and T must add up to the covered length.
TEST(second_order, row_sums_agree) {
  for (unsigned seed = 1; seed <= 12; ++seed)
    for (bool linear : {false, true}) {
      const auto f = support::facing(curved(seed));
      auto p = support::placed(f);
      if (linear) p.cut = linear_multipliers(f.secondary);
      p.cut.back() = 1;
      const auto s = support::integrals(p);
      EXPECT_LT((s.D + s.off.rowwise().sum() - s.M.rowwise().sum()).lpNorm<Eigen::Infinity>(), 1e-13);
      EXPECT_GE(s.cover.minCoeff(), -1e-12);
    }
}

// A pressure that is the same everywhere must load every node of both sides by that pressure times its nodal length,
// through non-matching straight facets, of equal or different order, with either kind of multipliers.
TEST(second_order, constant_pressure_passes_exactly) {
  for (const auto& [a, b] : {std::pair{2, 3}, {3, 2}, {7, 5}})
    for (const auto& [secondary, primary] : {std::pair{2, 2}, {2, 1}, {1, 2}})
      for (bool linear : {false, true}) {
        auto o = straight_of_order_two(a, b);
        o.secondary_order = secondary;
        o.primary_order = primary;
        const auto f = support::facing(o);
        auto p = support::placed(f);
        if (linear) p.cut = linear_multipliers(f.secondary);
        const auto s = support::integrals(p);
        const Vector on_secondary = s.D + s.off.colwise().sum().transpose(),
                     on_primary = s.M.colwise().sum().transpose();
        for (int j = 0; j < f.secondary.node_count(); ++j) EXPECT_NEAR(on_secondary[j], f.secondary.area[j], 1e-13);
        for (int l = 0; l < f.primary.node_count(); ++l) EXPECT_NEAR(on_primary[l], f.primary.area[l], 1e-13);
      }
}

// A common rigid motion must leave D, M, T and the weighted gap as they are.
TEST(second_order, rigid_motion_changes_nothing) {
  for (auto measure : {base::Kinematics::small, base::Kinematics::finite})
    for (unsigned seed = 1; seed <= 8; ++seed) {
      auto o = curved(seed);
      o.measure = measure;
      const auto f = support::facing(o);
      auto g = f;
      for (auto* side : {&g.xs, &g.xm})
        for (Vec2& x : *side) x = support::turned(x, 1.1 * seed) + Vec2(3.0, -2.0);
      const auto a = support::integrals(support::placed(f)), b = support::integrals(support::placed(g));
      EXPECT_LT((a.D - b.D).lpNorm<Eigen::Infinity>(), 1e-12);
      EXPECT_LT((a.M - b.M).lpNorm<Eigen::Infinity>(), 1e-12);
      EXPECT_LT((a.cover - b.cover).lpNorm<Eigen::Infinity>(), 1e-12);
      EXPECT_LT((a.gap - b.gap).lpNorm<Eigen::Infinity>(), 1e-12);
    }
}

/// Largest error of gap / D between arcs of radius 1 and 1.05 about one centre, facets of the given order.
double gap_error(int facets, int order) {
  const auto arc = [&](double radius, int count, double from, double to) {
    Points X;
    for (int i = 0; i <= count * order; ++i) {
      const double t = from + (to - from) * i / (count * order);
      X.push_back({radius * std::cos(t), radius * std::sin(t)});
    }
    return support::polyline(X, base::Analysis::plane_strain, order);
  };
  support::Facing f;
  f.secondary = arc(1.0, facets, 0.0, 1.5);
  f.primary = arc(1.05, facets + facets / 2, 1.6, -0.1);
  f.xs = f.secondary.X;
  f.xm = f.primary.X;
  const auto s = support::integrals(support::placed(f));
  return (s.gap.array() / s.D.array() - 0.05).abs().maxCoeff();
}

// The weighted gap between coaxial arcs must converge at order 2 with straight facets and at order 4 with curved ones.
TEST(second_order, gap_between_arcs) {
  EXPECT_NEAR(0.5 * std::log2(gap_error(8, 1) / gap_error(32, 1)), 2.0, 0.2);
  EXPECT_NEAR(0.5 * std::log2(gap_error(8, 2) / gap_error(32, 2)), 4.0, 0.2);
}

// Over length on x the integrals must follow a stretch; what is covered of X must not.
TEST(second_order, length_on_x_follows_a_stretch) {
  for (int order : {1, 2}) {
    auto o = straight_of_order_two(4, 5);
    o.secondary_order = o.primary_order = order;
    o.measure = base::Kinematics::finite;
    auto f = support::facing(o);
    for (auto* side : {&f.xs, &f.xm})
      for (Vec2& x : *side) x *= 1.3;
    const auto p = support::placed(f);
    EXPECT_NEAR(support::integrals(p).D.sum(), 1.3 * 2.0, 1e-13);
    mortar::Integrator integrator;
    double on_X = 0.0;
    for (const auto& r : integrator.values(p))
      for (int j = 0; j < r.count; ++j) on_X += r.value.on_X[j];
    EXPECT_NEAR(on_X, 2.0, 1e-13);
  }
}

}  // namespace
