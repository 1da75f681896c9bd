#include <gtest/gtest.h>

#include <cmath>

#include "body/conflicts.hpp"
#include "support/bodies.hpp"
#include "support/meshes.hpp"

namespace {

using namespace reye;
using body::Drive;
using body::Motion;
using body::Support;
using support::fixed_edge;
using support::loaded;
using support::moved;
using support::rectangle;

Support named(const std::string& name, const std::string& edge, Motion x, Motion y = {}, Motion rotation = {}) {
  Support s;
  s.name = name;
  s.edge = edge;
  s.x = x;
  s.y = y;
  s.rotation = rotation;
  return s;
}

const Motion fixed{Drive::fixed};

body::BodyInput beam(std::vector<Support> supports, base::Analysis analysis = base::Analysis::plane_strain) {
  auto in = support::elastic(1000.0, 0.3, analysis);
  in.supports = std::move(supports);
  return in;
}

std::vector<body::SupportConflict> of(const body::BodyInput& in, base::Vec2 corner = {0, 0}) {
  return body::support_conflicts(rectangle({.corner = corner, .size = {20, 2}}), in);
}

void expect_refused(const std::vector<Support>& supports, int support, const std::string& motion,
                    const std::string& named) {
  const auto found = of(beam(supports));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].support, support);
  EXPECT_EQ(found[0].motion, motion);
  EXPECT_TRUE(found[0].refused);
  EXPECT_NE(found[0].text.find(named), std::string::npos) << found[0].text;
}

// Two motions, or a motion and a force, on one edge along one direction must be refused, naming both supports.
TEST(conflicts, one_edge_twice) {
  const Support wall = fixed_edge("l", "left");
  expect_refused({wall, named("r", "right", moved(0.1)), named("r2", "right", moved(0.05))}, 2, "x", "\"r\"");
  expect_refused({wall, named("r", "right", moved(0.1)), named("r2", "right", loaded(5.0))}, 1, "x", "\"r2\"");
}

// A support all of whose nodes move with a rigid edge does nothing and must be refused, on an edge as at a point.
TEST(conflicts, on_a_rigid_edge) {
  const Support wall = fixed_edge("l", "left"), rigid = named("r", "right", moved(0.1), {}, fixed);
  expect_refused({wall, rigid, named("r2", "right", {}, moved(0.1))}, 2, "y", "\"r\"");
  Support point = named("r2", "", {}, moved(0.1));
  point.point_mm = base::Vec2{20, 2};
  expect_refused({wall, rigid, point}, 2, "y", "\"r\"");
}

// Edges that share a corner and move it differently must be refused whatever their order.
TEST(conflicts, corner_in_either_order) {
  const Support wall = fixed_edge("l", "left"), lid = named("t", "top", moved(0.1));
  expect_refused({wall, lid}, 1, "x", "\"l\"");
  expect_refused({lid, wall}, 1, "x", "\"t\"");
}

// Two rigid edges cannot share a node unless both are fixed.
TEST(conflicts, two_rigid_edges) {
  const Support still = named("a", "left", fixed, fixed, fixed);
  expect_refused({still, named("b", "top", moved(0.1), {}, fixed)}, 1, "", "\"a\"");
  EXPECT_TRUE(of(beam({still, named("b", "top", fixed, fixed, fixed)})).empty());
}

// What agrees is no conflict: rollers that meet, fixed beside fixed, one history of one amplitude, a third direction
// that follows.
TEST(conflicts, what_agrees_stands) {
  EXPECT_TRUE(of(beam({named("a", "left", fixed), named("b", "bottom", {}, fixed)})).empty());
  EXPECT_TRUE(of(beam({fixed_edge("a", "left"), fixed_edge("b", "bottom")})).empty());
  EXPECT_TRUE(of(beam({named("a", "left", moved(0.1)), named("b", "bottom", moved(0.1))})).empty());
  EXPECT_TRUE(of(beam({named("a", "left", fixed), named("b", "top", fixed, loaded(-1.0), fixed)})).empty());
  Support oblique = named("c", "bottom", moved(0.1 * std::sqrt(0.5)));
  oblique.angle_deg = 45.0;
  EXPECT_TRUE(of(beam({named("a", "left", moved(0.1), fixed), oblique})).empty());
  oblique.x = moved(0.1);
  EXPECT_EQ(of(beam({named("a", "left", moved(0.1), fixed), oblique})).size(), 1u);
}

// A held edge whose corner belongs to a rigid edge that is free there acts but for the corner: reported, not refused;
// where the rigid edge is pushed along it, refused.
TEST(conflicts, free_rigid_corner_is_told) {
  const Support symmetry = named("s", "left", fixed);
  const auto told = of(beam({symmetry, named("pull", "top", {}, loaded(4.0))}));
  ASSERT_EQ(told.size(), 1u);
  EXPECT_FALSE(told[0].refused);
  EXPECT_EQ(told[0].support, 0);
  expect_refused({symmetry, named("pull", "top", loaded(1.0), loaded(4.0), fixed)}, 0, "x", "loaded");
}

// In axisymmetry an edge that turns, and an edge at the axis that moves along the radius, must be refused.
TEST(conflicts, axisymmetry) {
  const auto ring = base::Analysis::axisymmetric;
  const auto turned = of(beam({named("t", "right", {}, fixed, moved(0.1))}, ring), {1, 0});
  ASSERT_EQ(turned.size(), 1u);
  EXPECT_EQ(turned[0].motion, "rotation");
  EXPECT_EQ(of(beam({named("b", "bottom", moved(0.1), fixed)}, ring)).size(), 1u);
  EXPECT_TRUE(of(beam({named("b", "bottom", moved(0.1), fixed)}, ring), {1, 0}).empty());
  EXPECT_TRUE(of(beam({named("b", "bottom", fixed, fixed)}, ring)).empty());
}

// A rigid ring cannot be moved or pushed along the radius, nor turned; held there it may be.
TEST(conflicts, rigid_ring) {
  const auto ring = base::Analysis::axisymmetric;
  const auto m = rectangle({.corner = {1, 0}});
  for (const Motion& motion : {moved(-0.01), loaded(-1e4)}) {
    const auto found = body::rigid_support_conflicts(m, beam({named("jaw", "left", motion, fixed, fixed)}, ring));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].motion, "x");
  }
  EXPECT_EQ(body::rigid_support_conflicts(m, beam({named("jaw", "left", fixed, fixed, moved(0.1))}, ring)).size(), 1u);
  EXPECT_TRUE(body::rigid_support_conflicts(m, beam({named("jaw", "left", fixed, moved(0.1), fixed)}, ring)).empty());
}

// A rigid body has one of each motion: a second support that drives it another way must be refused.
TEST(conflicts, rigid_body_driven_twice) {
  const auto m = rectangle({});
  const auto count = [&](const std::vector<Support>& supports) {
    return body::rigid_support_conflicts(m, beam(supports)).size();
  };
  const Support head = named("head", "top", fixed, loaded(-3.0), moved(0.1));
  Support point = named("p", "", {}, moved(0.2));
  point.point_mm = base::Vec2{0, 0};
  EXPECT_EQ(count({head, point}), 1u);
  point.y = {};
  point.x = fixed;
  EXPECT_EQ(count({head, point}), 0u);
  EXPECT_EQ(count({head, named("side", "left", fixed)}), 1u);  // every node of an edge: it cannot turn
}

}  // namespace
