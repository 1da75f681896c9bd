#include "cad/build/turned_zone.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace reye;
using cad::Vec2;

namespace {

constexpr double pi = std::numbers::pi;

/// A disc of radius 10 about the origin.
cad::Part disc() {
  base::Points knots, tangents;
  for (int i = 0; i <= 400; ++i) {
    const double angle = 2.0 * pi * i / 400;
    knots.emplace_back(10.0 * std::cos(angle), 10.0 * std::sin(angle));
    tangents.emplace_back(-std::sin(angle), std::cos(angle));
  }
  cad::Part part;
  part.loops = {{cad::make_edge(cad::EdgeType::circle, knots, tangents)}};
  return part;
}

cad::FineZone zone_below() {
  cad::FineZone zone;
  zone.centre_mm = {0.0, -10.0};
  zone.half_width_mm = 1.0;
  zone.depth_mm = 0.5;
  zone.size_mm = 0.1;
  return zone;
}

}  // namespace

// A body that hardly turns must keep its zone as it was asked for.
TEST(TurnedZone, StaysWhereNothingTurns) {
  const auto zone = cad::turned_zone(disc(), zone_below(), {{0.0, 0.0}, -0.004, 0.004}, 1500);
  EXPECT_FALSE(zone.turns);
  EXPECT_EQ(zone.half_width_mm, 1.0);
}

// What comes under the zone of a body that turns to one side lies on the other: by half the angle, and as far.
TEST(TurnedZone, LiesWhereTheContactWillBe) {
  const auto zone = cad::turned_zone(disc(), zone_below(), {{0.0, 0.0}, 0.0, 0.6}, 1500);
  EXPECT_TRUE(zone.turns);
  EXPECT_NEAR(zone.centre_mm.x(), 10.0 * std::sin(-0.3), 1e-12);
  EXPECT_NEAR(zone.centre_mm.y(), -10.0 * std::cos(0.3), 1e-12);
  EXPECT_NEAR(zone.angle_deg, -0.3 * 180.0 / pi, 1e-12);
  EXPECT_NEAR(zone.half_width_mm, 10.0 * std::sin(0.3 + std::asin(0.1)), 1e-12);
  EXPECT_EQ(zone.size_mm, 0.1);
}

// A body that turns all round must get a ring, and elements that keep the number of nodes on it.
TEST(TurnedZone, RingWithinItsNumberOfNodes) {
  const auto ring = cad::turned_zone(disc(), zone_below(), {{0.0, 0.0}, 0.0, 2.0 * pi}, 1500);
  EXPECT_GT(ring.half_width_mm, 20.0);
  EXPECT_EQ(ring.size_mm, 0.1);
  const auto capped = cad::turned_zone(disc(), zone_below(), {{0.0, 0.0}, 0.0, 2.0 * pi}, 300);
  EXPECT_NEAR(capped.size_mm, 20.0 * pi / 300, 1e-3);
}
