#include <gtest/gtest.h>

#include "contact/solid/skin_place.hpp"

using namespace reye;
using base::Vec3;

namespace {

contact::SkinFrame frame_of(const Vec3& normal) {
  contact::SkinFrame frame;
  frame.normal = normal.normalized();
  frame.tangent[0] = frame.normal.unitOrthogonal();
  frame.tangent[1] = frame.normal.cross(frame.tangent[0]);
  return frame;
}

}  // namespace

TEST(SolidFrame, TangentsTurnNoMoreThanTheNormal) {
  // Tangents of a point whose normal turns a little must turn as little, though they are made from digits of round-off.
  const auto before = frame_of({3e-7, 1e-7, -1.0});
  for (const Vec3& normal : {Vec3(1e-14, -2e-14, -1.0), Vec3(-1e-16, 3e-9, -1.0), Vec3(1e-5, -4e-5, -1.0)}) {
    const auto frame = contact::turned_least(frame_of(normal), before);
    for (int k = 0; k < 2; ++k) {
      EXPECT_LE((frame.tangent[k] - before.tangent[k]).norm(), 1.01 * (frame.normal - before.normal).norm() + 1e-15);
      EXPECT_NEAR(frame.tangent[k].dot(frame.normal), 0.0, 1e-15);
      EXPECT_NEAR(frame.tangent[k].norm(), 1.0, 1e-15);
    }
  }
}

TEST(SolidFrame, HeldTangentsStay) {
  // Where a plane of symmetry leaves one tangent, that one must stay in the plane.
  auto held = frame_of({0.0, 0.1, 1.0});
  held.free = 1;
  const auto frame = contact::turned_least(held, frame_of({0.1, 0.0, 1.0}));
  EXPECT_EQ(frame.tangent[0], held.tangent[0]);
  EXPECT_EQ(frame.tangent[1], held.tangent[1]);
}
