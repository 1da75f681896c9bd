#include "mesh/arc.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh/outline.hpp"
#include "small_meshes.hpp"

namespace reye::mesh {

namespace {

/// A mesh that is nothing but nodes and one boundary.
Mesh with(Points X, Boundary boundary) {
  Mesh mesh;
  mesh.X = std::move(X);
  mesh.boundaries["edge"] = std::move(boundary);
  return mesh;
}

}  // namespace

// Arc length must count from the end with the smaller x, then the smaller y, whatever the chain's direction.
TEST(arc, starts_at_the_smaller_end) {
  const Points X{{3, 0}, {1, 0}, {0, 0}, {0, 5}};
  const auto backwards = arc_chains(with(X, {{0, 1, 2}}), "edge").at(0);
  EXPECT_EQ(backwards.nodes, (Chain{2, 1, 0}));
  EXPECT_EQ(backwards.arc, (std::vector<double>{0, 1, 3}));
  EXPECT_FALSE(backwards.along);
  const auto forwards = arc_chains(with(X, {{2, 1, 0}}), "edge").at(0);
  EXPECT_EQ(forwards.nodes, (Chain{2, 1, 0}));
  EXPECT_TRUE(forwards.along);
  EXPECT_EQ(arc_chains(with(X, {{3, 2}}), "edge").at(0).nodes, (Chain{2, 3}));
}

// Chains of one boundary must follow one another, the leftmost first.
TEST(arc, chains_follow_one_another) {
  const auto chains = arc_chains(with({{5, 0}, {4, 0}, {2, 0}, {0, 0}}, {{0, 1}, {2, 3}}), "edge");
  ASSERT_EQ(chains.size(), 2U);
  EXPECT_EQ(chains[0].nodes, (Chain{3, 2}));
  EXPECT_EQ(chains[1].nodes, (Chain{1, 0}));
}

// A vertical edge must keep the end it counts from when round-off, or wear, makes the other end the leftmost.
TEST(arc, the_origin_is_chosen_once) {
  Mesh mesh = with({{0, 0}, {0, 1}, {0, 2}}, {{0, 1, 2}});
  mesh.arc_origin["edge"] = arc_origins(mesh, "edge");
  mesh.X[2].x() = -1e-17;
  EXPECT_EQ(arc_chains(mesh, "edge").at(0).nodes, (Chain{0, 1, 2}));
  mesh.arc_origin.clear();
  EXPECT_EQ(arc_chains(mesh, "edge").at(0).nodes, (Chain{2, 1, 0}));
}

// A mesh that replaces another must count its boundaries from the same places, whatever the numbers and order of its
// chains.
TEST(arc, later_meshes_follow) {
  Mesh former = with({{0, 0}, {0, 1}, {3, 0}, {3, 1}}, {{1, 0}, {2, 3}});
  former.arc_origin["edge"] = {3, 1};
  Mesh mesh = with({{3.01, 1}, {3, 0.5}, {3, 0}, {0, 0.9}, {0, 0}}, {{2, 1, 0}, {3, 4}});
  follow_arc_origins(mesh, former);
  EXPECT_EQ(mesh.arc_origin.at("edge"), (std::vector<int>{0, 3}));
  const auto chains = arc_chains(mesh, "edge");
  EXPECT_EQ(chains[0].nodes, (Chain{0, 1, 2}));
  EXPECT_EQ(chains[1].nodes, (Chain{3, 4}));
}

// A ring must count once round from its origin and end there, its nodes in the order of the outline.
TEST(arc, a_ring_ends_where_it_began) {
  Mesh mesh = with({{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, {{0, 1, 2, 3, 0}});
  const int origin = farthest_from(mesh, mesh.boundaries.at("edge")[0], {{0.1, -2}});
  EXPECT_EQ(origin, 1);
  mesh.arc_origin["edge"] = {origin};
  const auto ring = arc_chains(mesh, "edge").at(0);
  EXPECT_EQ(ring.nodes, (Chain{1, 2, 3, 0, 1}));
  EXPECT_TRUE(ring.along);
  EXPECT_NEAR(ring.arc.back(), 4.0 * std::sqrt(2.0), 1e-15);
}

// With several contacts on a ring its arc length must begin amid the longest stretch between them.
TEST(arc, a_ring_begins_between_its_contacts) {
  Points corners;
  for (int i = 0; i < 12; ++i)
    corners.emplace_back(std::cos(i * std::numbers::pi / 6.0), std::sin(i * std::numbers::pi / 6.0));
  const Mesh mesh = with(corners, {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 0}});
  const auto& ring = mesh.boundaries.at("edge")[0];
  EXPECT_EQ(farthest_from(mesh, ring, {{2, 0}}), 6);
  EXPECT_EQ(farthest_from(mesh, ring, {corners[1], corners[5]}), 9);
  EXPECT_EQ(farthest_from(mesh, ring, {corners[11], corners[1], corners[5]}), 8);
  EXPECT_EQ(farthest_from(mesh, ring, {corners[10], corners[2]}), 6);
}

}  // namespace reye::mesh
