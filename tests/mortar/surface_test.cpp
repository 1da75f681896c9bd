#include <gtest/gtest.h>

#include <numbers>

#include "support/surfaces.hpp"

namespace {

using namespace reye;
using base::Vec2;

/// Three nodes whose second facet turns by `degrees` against the first.
base::Points bent(double degrees) {
  const double a = degrees * std::numbers::pi / 180.0;
  return {{0, 0}, {1, 0}, {1 + std::cos(a), std::sin(a)}};
}

Vec2 normal_at_bend(const base::Points& x, int side) {
  const auto s = support::polyline(x);
  const auto stencil = mortar::normal_stencil(s, 1, side);
  std::array<mortar::Pair<double>, 3> at;
  for (int i = 0; i < 3; ++i)
    if (stencil.nodes[i] >= 0) at[i] = {x[stencil.nodes[i]].x(), x[stencil.nodes[i]].y()};
  return mortar::plain(mortar::nodal_normal(stencil, at));
}

// Facets must run with the body on the left: the normal of one along +x points to -y.
TEST(surface, normal_points_outwards) {
  const auto n = mortar::facet_normal(mortar::Pair<double>{0, 0}, mortar::Pair<double>{2, 0});
  EXPECT_EQ(n.x, 0.0);
  EXPECT_EQ(n.y, -1.0);
}

// A bend of 40 degrees must get the mean of both unit normals, whatever the facets' lengths.
TEST(surface, small_bend_is_averaged) {
  auto x = bent(40.0);
  x[2] += 3.0 * (x[2] - x[1]);
  const double half = 20.0 * std::numbers::pi / 180.0;
  for (int side : {0, 1}) EXPECT_LT((normal_at_bend(x, side) - Vec2(std::sin(half), -std::cos(half))).norm(), 1e-14);
}

// At a corner of 90 degrees each facet must keep its own normal.
TEST(surface, corner_is_split) {
  const auto x = bent(90.0);
  EXPECT_EQ(support::polyline(x).corner[1], 1);
  EXPECT_LT((normal_at_bend(x, 0) - Vec2(0, -1)).norm(), 1e-14);
  EXPECT_LT((normal_at_bend(x, 1) - Vec2(1, 0)).norm(), 1e-14);
}

// The integrals of a facet must not depend on the node beyond a corner, but on the one beyond a smooth bend.
TEST(surface, corner_cuts_the_dependence) {
  for (double degrees : {40.0, 90.0}) {
    support::Facing f;
    f.secondary = support::polyline({{1, 0}, {0, 0}, support::turned(Vec2(-1, 0), degrees * std::numbers::pi / 180.0)});
    f.primary = support::polyline({{0.2, 0.05}, {0.8, 0.05}});
    f.xs = f.secondary.X;
    f.xm = f.primary.X;
    const auto p = support::placed(f);
    mortar::Integrator integrator;
    auto& records = integrator.values(p);
    ASSERT_EQ(records.size(), 1u);
    integrator.differentiate(p, records[0]);
    EXPECT_EQ(records[0].dofs.size(), degrees < 50.0 ? 10u : 8u);
  }
}

// Full nodal lengths must add up to the surface: its length, or the area it sweeps round the axis.
TEST(surface, nodal_areas_add_up) {
  const base::Points X{{3, 0}, {2.2, 0}, {1, 0}};
  const auto plane = support::polyline(X), ring = support::polyline(X, base::Analysis::axisymmetric);
  EXPECT_NEAR(plane.area[0] + plane.area[1] + plane.area[2], 2.0, 1e-15);
  EXPECT_NEAR(ring.area[0] + ring.area[1] + ring.area[2], std::numbers::pi * (9.0 - 1.0), 1e-13);
  EXPECT_NEAR(ring.area[0], 2.0 * std::numbers::pi * 0.8 * (2.0 * 3.0 + 2.2) / 6.0, 1e-13);
}

// Joined surfaces must keep their own neighbours: no facet runs from one to the next.
TEST(surface, joined_surfaces_stay_apart) {
  const auto one = support::polyline({{0, 0}, {1, 0}}), two = support::polyline({{2, 0}, {3, 0}, {4, 0}});
  const auto all = mortar::joined({one, two});
  ASSERT_EQ(all.facet_count(), 3);
  EXPECT_EQ(all.facets[1], (mortar::LineFacet{2, 3, -1}));
  EXPECT_EQ(all.after[1], -1);
  EXPECT_EQ(all.before[2], -1);
  EXPECT_EQ(all.before[3], 1);
  EXPECT_EQ(all.area[3], two.area[1]);
}

// A closed chain must know the neighbours across its seam.
TEST(surface, closed_chain_has_no_ends) {
  std::vector<int> nodes;
  const base::Points X{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto s = mortar::make_surface(X, {{0, 1, 2, 3, 0}}, base::Analysis::plane_strain, nodes);
  ASSERT_EQ(s.node_count(), 4);
  ASSERT_EQ(s.facet_count(), 4);
  EXPECT_EQ(s.before[0], 3);
  EXPECT_EQ(s.after[0], 0);
  EXPECT_NEAR(s.area[0], 1.0, 1e-15);
}

}  // namespace
