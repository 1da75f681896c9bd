#include <gtest/gtest.h>

#include "support/contacts.hpp"

namespace {

using namespace reye;
using base::Vec2;

/// A side on y = 0 whose first facet, a flank, rises from it; below lies the other side, flat.
support::ContactCase worn_block(const Vec2& top_of_flank) {
  support::Facing f;
  f.secondary = support::polyline({top_of_flank, {0.0, 0.0}, {0.3, 0.0}, {0.6, 0.0}});
  f.primary = support::polyline({{1.0, 0.0}, {0.5, 0.0}, {0.0, 0.0}, {-0.5, 0.0}, {-1.0, 0.0}});
  f.xs = f.secondary.X;
  f.xm = f.primary.X;
  return support::case_of(f, {});
}

// A corner between a worn surface and a flank must take the normal of the surface that lies on the other side, however
// long the flank is that is covered beside it.
TEST(corner, takes_the_normal_of_what_bears) {
  for (double length : {0.1, 0.2, 0.5})
    for (double angle : {0.9, 1.15, 1.4}) {
      const auto c = worn_block(length * Vec2(-std::cos(angle), std::sin(angle)));
      ASSERT_EQ(c.setup.secondary.corner[1], 1);
      const auto face = support::interface_of(c, 0);
      EXPECT_NEAR((face.normal()[1] - Vec2(0.0, -1.0)).norm(), 0.0, 1e-14) << length << " " << angle;
    }
}

}  // namespace
