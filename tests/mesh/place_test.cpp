#include <gtest/gtest.h>

#include "mesh/place.hpp"

using namespace reye;

namespace {

/// A square of 4 mm with a square hole of 2 mm in its middle.
mesh::Mesh ring() {
  mesh::Mesh ring;
  ring.X = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {1, 3}, {3, 3}, {3, 1}};
  ring.outline = {{0, 1, 2, 3, 0}, {4, 5, 6, 7, 4}};
  return ring;
}

}  // namespace

// A point must be inside a body only where material is, and its distance must be that from the nearest edge, of a hole,
// too.
TEST(Place, AgainstARing) {
  const auto in = mesh::place_of(ring(), {0.25, 2.0});
  EXPECT_TRUE(in.inside);
  EXPECT_DOUBLE_EQ(in.distance, 0.25);
  const auto hole = mesh::place_of(ring(), {2.0, 2.5});
  EXPECT_FALSE(hole.inside);
  EXPECT_DOUBLE_EQ(hole.distance, 0.5);
  EXPECT_EQ(hole.nearest, base::Vec2(2.0, 3.0));
  EXPECT_DOUBLE_EQ(hole.facet, 2.0);
  const auto out = mesh::place_of(ring(), {7.0, 8.0});
  EXPECT_FALSE(out.inside);
  EXPECT_DOUBLE_EQ(out.distance, 5.0);
  EXPECT_EQ(out.nearest, base::Vec2(4.0, 4.0));
}
