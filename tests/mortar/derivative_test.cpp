#include <gtest/gtest.h>

#include "support/surfaces.hpp"

namespace {

using namespace reye;
using base::Vec2;
using base::Vector;
using support::FacingOptions;

/// Derivative of all integrals along a direction of the surface dofs, from `differentiate`.
support::Sums slope_along(const mortar::Placement& p, const Vector& direction) {
  mortar::Integrator integrator;
  auto& records = integrator.values(p);
  for (auto& record : records) integrator.differentiate(p, record);
  return support::added(p, records, [&](const mortar::FacetRecord& r) {
    std::vector<double> v(r.outputs(), 0.0);
    for (int output = 0; output < r.outputs(); ++output)
      for (std::size_t i = 0; i < r.dofs.size(); ++i) v[output] += r.row(output)[i] * direction[r.dofs[i]];
    return v;
  });
}

/// log2 of the fall of the error of central differences when their step is halved.
double rate(const mortar::Placement& p, unsigned seed) {
  const Vector direction = support::random_direction(p.dofs(), seed), slope = slope_along(p, direction).flat();
  const auto error = [&](double h) -> double {
    const Vector plus = support::integrals(support::moved_along(p, direction, h)).flat();
    const Vector minus = support::integrals(support::moved_along(p, direction, -h)).flat();
    return ((plus - minus) / (2 * h) - slope).norm();
  };
  EXPECT_LT(error(1e-5), 1e-6 * (1.0 + slope.norm()));
  return std::log2(error(4e-4) / error(2e-4));
}

FacingOptions state(unsigned seed) {
  FacingOptions o;
  o.seed = seed;
  o.secondary = 4 + static_cast<int>(seed % 3);
  o.primary = 3 + static_cast<int>(seed % 5);
  o.angle = 0.9 * seed;
  return o;
}

/// The state with motion in the increment, so that drift is no zero.
mortar::Placement in_motion(const support::Facing& f, unsigned seed) {
  auto p = support::placed(f);
  const auto before = support::moved_along(p, support::random_direction(p.dofs(), seed + 100), 0.05);
  p.xs_before = before.xs;
  p.xm_before = before.xm;
  return p;
}

// Every derivative must agree with central differences at rate 2 at random curved, turned states.
TEST(derivative, whole_facets) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const auto f = support::facing(state(seed));
    EXPECT_NEAR(rate(in_motion(f, seed), seed), 2.0, 0.1) << seed;
  }
}

// Derivatives must be exact where the primary side ends inside facets: the dual basis itself changes there.
TEST(derivative, partly_covered_facets) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    auto o = state(seed);
    o.from = 0.23;
    o.to = 0.71;
    const auto f = support::facing(o);
    EXPECT_NEAR(rate(in_motion(f, seed), seed), 2.0, 0.1) << seed;
  }
}

// Derivatives must be exact with cut nodes and ring weights.
TEST(derivative, cut_nodes_and_ring_weights) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    auto o = state(seed);
    o.to = 0.8;
    o.analysis = base::Analysis::axisymmetric;
    const auto f = support::facing(o);
    auto p = in_motion(f, seed);
    p.cut[0] = p.cut[2] = 1;
    EXPECT_NEAR(rate(p, seed), 2.0, 0.1) << seed;
  }
}

// Derivatives must be exact where one facet meets so many primary ones that they are taken in several passes.
TEST(derivative, many_primary_nodes_under_one_facet) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    auto o = state(seed);
    o.secondary = 2;
    o.primary = 21;
    o.strain = 0.004;
    o.from = 0.1;
    const auto f = support::facing(o);
    const auto p = in_motion(f, seed);
    mortar::Integrator integrator;
    auto& records = integrator.values(p);
    integrator.differentiate(p, records[0]);
    ASSERT_GT(records[0].dofs.size(), 16u);
    EXPECT_NEAR(rate(p, seed), 2.0, 0.1) << seed;
  }
}

/// Orders of the two sides: curved against curved, curved against straight, straight against curved.
constexpr std::pair<int, int> orders[] = {{2, 2}, {2, 1}, {1, 2}};

// Derivatives must be exact with curved facets on either side or both, whole and partly covered.
TEST(derivative, curved_facets) {
  for (const auto& [secondary, primary] : orders)
    for (double from : {-0.1, 0.23})
      for (unsigned seed = 1; seed <= 4; ++seed) {
        auto o = state(seed);
        o.secondary_order = secondary;
        o.primary_order = primary;
        o.from = from;
        const auto f = support::facing(o);
        EXPECT_NEAR(rate(in_motion(f, seed), seed), 2.0, 0.1)
            << secondary << primary << " from " << from << " seed " << seed;
      }
}

// Derivatives must be exact where control points carry no multiplier, and where nodes are cut beside them.
TEST(derivative, curved_facets_with_linear_multipliers_and_cut_nodes) {
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (bool linear : {true, false}) {
      auto o = state(seed);
      o.secondary_order = o.primary_order = 2;
      o.to = 0.8;
      const auto f = support::facing(o);
      auto p = in_motion(f, seed);
      for (int j = 0; j < f.secondary.node_count(); ++j) p.cut[j] = linear && f.secondary.is_control_point(j);
      p.cut[2] = 1;
      EXPECT_NEAR(rate(p, seed), 2.0, 0.1) << seed << linear;
    }
}

// Derivatives must be exact over length on x, where the measure itself moves, with and without ring weights.
TEST(derivative, length_on_x) {
  for (int order : {1, 2})
    for (auto analysis : {base::Analysis::plane_strain, base::Analysis::axisymmetric})
      for (unsigned seed = 1; seed <= 4; ++seed) {
        auto o = state(seed);
        o.secondary_order = o.primary_order = order;
        o.measure = base::Kinematics::finite;
        o.analysis = analysis;
        o.angle = 0.1 * seed;
        o.to = seed % 2 == 0 ? 0.8 : 1.1;
        const auto f = support::facing(o);
        EXPECT_NEAR(rate(in_motion(f, seed), seed), 2.0, 0.1) << order << " " << seed;
      }
}

}  // namespace
