#include <gtest/gtest.h>

#include <cmath>

#include "sim/study/scar_family.hpp"

namespace {

using namespace reye;
using base::Vec2;
using scene::ScarAxis;
using sim::ScarFamily;

/// A parabola of depth d and half width a about x = 1.
sim::SurfaceRecord scar(double depth, double half) {
  sim::SurfaceRecord surface;
  for (int i = 0; i <= 400; ++i) {
    const double x = -3.0 + 0.02 * i;
    surface.x_mm.push_back(x);
    surface.y_mm.push_back(0.0);
    surface.arc_length_mm.push_back(x + 3.0);
    surface.wear_depth_mm.push_back(depth * std::max(0.0, 1.0 - (x - 1.0) * (x - 1.0) / (half * half)));
  }
  return surface;
}

double at(const ScarFamily& family, double cycles, double x) {
  const Vec2 place(x, 0.0);
  return family.at(cycles, std::span(&place, 1))[0];
}

// Between the ends of blocks depths of a scar that keeps its width must be linear in the cycles, before the first in
// proportion, zero where nothing wears.
TEST(scar_family, between_blocks) {
  ScarFamily family;
  family.add(100.0, profile_of(scar(1.0, 1.0), ScarAxis::x));
  family.add(200.0, profile_of(scar(1.5, 1.0), ScarAxis::x));
  EXPECT_NEAR(at(family, 100.0, 1.0), 1.0, 1e-12);
  EXPECT_NEAR(at(family, 150.0, 1.0), 1.25, 1e-12);
  EXPECT_NEAR(at(family, 150.0, 1.5), 0.75 * 1.25, 1e-12);
  EXPECT_NEAR(at(family, 50.0, 1.0), 0.5, 1e-12);
  EXPECT_EQ(at(family, 150.0, -2.5), 0.0);
  EXPECT_EQ(at(family, 150.0, 70.0), 0.0);
}

// Between the ends of two blocks far apart a scar that deepens by t^(2/3) and widens by t^(1/3) must keep its shape.
TEST(scar_family, similar_to_itself_between_blocks) {
  ScarFamily family;
  for (const double t : {0.5, 1.5}) family.add(t, profile_of(scar(std::pow(t, 2.0 / 3.0), std::cbrt(t)), ScarAxis::x));
  for (const double t : {0.6, 1.0, 1.4}) {
    for (const double x : {0.1, 0.2, 1.0, 1.5, 1.9, 2.1})
      EXPECT_NEAR(at(family, t, x), std::max(0.0, std::pow(t, 2.0 / 3.0) - (x - 1.0) * (x - 1.0)), 4e-3)
          << t << " " << x;
  }
}

// Beyond what was computed a scar that deepens by t^(2/3) and widens by t^(1/3) must continue so.
TEST(scar_family, beyond_the_last_block) {
  ScarFamily family;
  for (const double t : {0.125, 0.25, 0.5, 1.0})
    family.add(t, profile_of(scar(std::pow(t, 2.0 / 3.0), std::cbrt(t)), ScarAxis::x));
  const double t = 2.0, a = std::cbrt(t);
  for (const double x : {0.2, 1.0, 1.7})
    EXPECT_NEAR(at(family, t, x), std::pow(t, 2.0 / 3.0) * (1.0 - (x - 1.0) * (x - 1.0) / (a * a)), 2e-3);
}

// A number must grow between blocks and beyond them by the power with which it grew.
TEST(scar_family, numbers) {
  ScarFamily family;
  for (const double t : {1.0, 2.0, 4.0}) family.add(t, sim::number_of(std::sqrt(t)));
  EXPECT_NEAR(at(family, 3.0, 0.0), std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(at(family, 9.0, 0.0), 3.0, 1e-12);
}

// Of an outline that turns back only the branch with the scar must count, whichever way it runs.
TEST(scar_family, an_outline_that_turns_back) {
  sim::SurfaceRecord round;
  for (int i = 0; i <= 360; ++i) {
    const double angle = i * std::acos(-1.0) / 180.0;
    round.x_mm.push_back(std::cos(angle));
    round.y_mm.push_back(std::sin(angle));
    round.arc_length_mm.push_back(angle);
    round.wear_depth_mm.push_back(i > 260 && i < 280 ? 1.0 : i == 90 ? 0.5 : 0.0);
  }
  ScarFamily family;
  family.add(1.0, profile_of(round, ScarAxis::x));
  EXPECT_NEAR(at(family, 1.0, 0.0), 1.0, 1e-12);
  ScarFamily along;
  along.add(1.0, profile_of(round, ScarAxis::arc));
  EXPECT_NEAR(at(along, 1.0, 0.5 * std::acos(-1.0)), 0.5, 1e-12);
}

// The map of a face must be its depths seen along the third axis, on triangles, quadrilaterals and curved facets alike.
TEST(scar_family, map_of_a_face) {
  const auto plane = [](const base::Vec3& x) { return 0.2 + 0.1 * x.y() + 0.05 * x.z(); };
  sim::SkinRecord skin;
  const auto add = [&](double y, double z) {
    skin.x_mm.emplace_back(7.0 + 0.1 * y, y, z);
    skin.wear_depth_mm.push_back(plane(skin.x_mm.back()));
    skin.area_mm2.push_back(0.2);
  };
  add(0, 0), add(1, 0), add(1, 1), add(0, 1);          // a quadrilateral
  add(2, 0), add(1.5, 0), add(1.5, 0.5), add(1, 0.5);  // with rows 1 and 2 a triangle of six nodes
  skin.facets.push_back({.kind = mesh::FacetKind::quad4, .nodes = {0, 1, 2, 3, -1, -1}});
  skin.facets.push_back({.kind = mesh::FacetKind::tri6, .nodes = {1, 4, 2, 5, 6, 7}});
  const auto shape = map_of(skin, {ScarAxis::y, ScarAxis::z});
  for (const auto& p : {Vec2(0.31, 0.47), Vec2(0.9, 0.1), Vec2(1.3, 0.3), Vec2(1.05, 0.6)})
    EXPECT_NEAR(shape.depth(p), 0.2 + 0.1 * p.x() + 0.05 * p.y(), 1e-12) << p.transpose();
  EXPECT_EQ(shape.depth({5.0, 0.5}), 0.0);
  EXPECT_EQ(shape.directions, 2);
  EXPECT_GT(shape.width, 0.3);
}

}  // namespace
