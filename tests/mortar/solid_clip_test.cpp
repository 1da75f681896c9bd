#include <gtest/gtest.h>

#include "support/convex_pairs.hpp"

namespace {

using namespace reye;
using base::Vec2;
using mortar::ConvexPolygon;

ConvexPolygon square(double x, double y, double side) {
  ConvexPolygon p;
  p.corners[0] = {x, y};
  p.corners[1] = {x + side, y};
  p.corners[2] = {x + side, y + side};
  p.corners[3] = {x, y + side};
  p.count = 4;
  return p;
}

// The common area of random facets, slivers, shared edges and shared corners must be what integration by slabs gives.
TEST(solid_clip, area_of_random_pairs) {
  const auto errors = test::clip_errors(10000, 7);
  EXPECT_TRUE(errors.valid);
  EXPECT_GT(errors.meeting, 3000);
  EXPECT_LT(errors.of_area, 1e-12);
  EXPECT_LT(errors.of_size, 1e-13);
}

// Facets that share an edge or a corner, or do not meet, must have nothing in common.
TEST(solid_clip, neighbours_have_nothing_in_common) {
  const auto own = square(0, 0, 1);
  for (const auto& other : {square(1, 0, 1), square(1, 1, 1), square(0.25, -0.5, 0.5), square(3, 3, 1)}) {
    EXPECT_EQ(mortar::overlap(own, other, 1e-14).count, 0);
    EXPECT_EQ(mortar::overlap(other, own, 1e-14).count, 0);
  }
}

// A facet and itself must have the facet in common, corner by corner, though rounding moves one of them.
TEST(solid_clip, coincident_facets) {
  const auto own = square(0, 0, 1);
  for (double moved : {0.0, 1e-16, -3e-15}) {
    const auto common = mortar::overlap(own, square(moved, -moved, 1), 1e-14);
    EXPECT_EQ(common.count, 4);
    EXPECT_NEAR(mortar::polygon_area(common), 1.0, 1e-13);
  }
}

ConvexPolygon triangle(const Vec2& a, const Vec2& b, const Vec2& c) {
  ConvexPolygon result;
  result.corners.fill(c);  // copied as a whole
  result.corners[0] = a;
  result.corners[1] = b;
  result.count = 3;
  return result;
}

/// Splits the unit square into triangles: each step puts a random point, at times very near to an edge, into a
/// triangle.
std::vector<ConvexPolygon> random_triangulation(std::mt19937_64& random, int steps) {
  std::uniform_real_distribution<double> number(0.0, 1.0);
  const Vec2 low(0, 0), high(1, 1);
  std::vector<ConvexPolygon> parts{triangle(low, {1, 0}, high), triangle(low, high, {0, 1})};
  for (int step = 0; step < steps; ++step) {
    const std::size_t chosen = random() % parts.size();
    const auto [a, b, c] = std::array{parts[chosen].corners[0], parts[chosen].corners[1], parts[chosen].corners[2]};
    const double r = number(random), s = (1 - r) * (step % 4 == 0 ? 1e-9 : number(random));
    const Vec2 inside = a + r * (b - a) + s * (c - a);
    parts[chosen] = triangle(a, b, inside);
    parts.insert(parts.end(), {triangle(b, c, inside), triangle(c, a, inside)});
  }
  return parts;
}

// The pieces that the facets of a mesh cut from one facet must add up to the facet, no gap, nothing twice; of slivers
// to the round-off of their corners.
TEST(solid_clip, pieces_of_a_mesh_add_up) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const auto parts = random_triangulation(random, 20), owns = random_triangulation(random, 5);
    for (const auto& own : owns) {
      double sum = 0.0;
      for (const auto& part : parts)
        sum += mortar::polygon_area(mortar::overlap(own, part, 1e-14 * test::polygon_size(own)));
      EXPECT_NEAR(sum, mortar::polygon_area(own), 1e-12 * mortar::polygon_area(own) + 1e-14);
    }
  }
}

}  // namespace
