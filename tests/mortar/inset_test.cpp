#include "mortar/inset.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace reye;
using base::Points;
using base::Vec2;

/// Part of a circle round the origin, or its outside; of second order the middle nodes lie on it, too.
mortar::Surface arc(double radius, bool convex, int order, Points& X) {
  mesh::Chain chain;
  for (int k = 0; k <= 12; ++k) {
    const double angle = (convex ? 1.0 : -1.0) * std::numbers::pi * k / 12.0;
    X.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
    chain.push_back(k);
  }
  std::vector<int> nodes;
  return mortar::make_surface(X, {chain}, base::Analysis::plane_strain, nodes, order);
}

// A corner must go into its body along both of its sides.
TEST(inset, corner) {
  const Points X{{0.0, 1.0}, {0.0, 0.0}, {1.0, 0.0}};
  std::vector<int> nodes;
  const auto s = mortar::make_surface(X, {{0, 1, 2}}, base::Analysis::plane_strain, nodes);
  const auto in = mortar::inset(s, s.X, 0.1);
  EXPECT_LT((in[0] - Vec2(0.1, 1.0)).norm(), 1e-15);
  EXPECT_LT((in[1] - Vec2(0.1, 0.1)).norm(), 1e-15);
  EXPECT_LT((in[2] - Vec2(1.0, 0.1)).norm(), 1e-15);
}

// Facets of a shaft and of a bore must all move along their own normals by the same way, of first order and of second.
TEST(inset, arcs) {
  for (bool convex : {true, false})
    for (int order : {1, 2}) {
      Points X;
      const auto s = arc(2.0, convex, order, X);
      const auto in = mortar::inset(s, s.X, 0.3);
      for (const auto& [a, b, c] : s.facets)
        for (const auto& [from, to] : {std::pair{a, c < 0 ? b : c}, std::pair{c < 0 ? a : c, b}}) {
          const Vec2 along = (s.X[to] - s.X[from]).normalized(), n(along.y(), -along.x());
          const bool end = s.before[from] < 0 || s.after[to] < 0;  // there the only facet decides
          EXPECT_NEAR((in[from] - s.X[from]).dot(n), -0.3, 1e-12);
          EXPECT_NEAR((in[to] - s.X[to]).dot(n), -0.3, 1e-12);
          EXPECT_LT(end ? 0.0 : std::abs(base::cross(along, in[to] - in[from])), 1e-12);
        }
    }
}

}  // namespace
