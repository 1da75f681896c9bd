#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "base/linalg.hpp"

using namespace reye::base;

// An input error must hold all issues, and say each on a line of its own: key, value where there is one, rule.
TEST(Errors, OneLinePerIssue) {
  const InputError error({{"material.steel.nu", "0.5", "must lie in (-1, 0.5)"}, {"body", "", "missing"}});
  EXPECT_STREQ(error.what(), "material.steel.nu = 0.5: must lie in (-1, 0.5)\nbody: missing");
  ASSERT_EQ(error.issues().size(), 2U);
  EXPECT_EQ(error.issues()[1].key, "body");
}

// A text given with the issues must be what is shown: the room that knows the file adds its lines.
TEST(Errors, LocatedText) {
  const InputError error({{"body", "", "missing"}}, "scene.toml:1: body: missing");
  EXPECT_STREQ(error.what(), "scene.toml:1: body: missing");
  EXPECT_EQ(error.issues().front().rule, "missing");
}

// The three kinds must stay apart: bad input, an unusable mesh, a solve that failed.
TEST(Errors, Kinds) {
  EXPECT_THROW(throw MeshError("m"), std::runtime_error);
  EXPECT_THROW(throw SolveError("s"), std::runtime_error);
  EXPECT_FALSE((std::is_base_of_v<MeshError, SolveError>));
  EXPECT_FALSE((std::is_base_of_v<InputError, MeshError>));
}

// With the body on the left of an edge, the edge turned by -90 degrees must point out of it.
TEST(Linalg, OutwardNormal) {
  const Vec2 along_the_bottom(2.0, 0.0), up_the_right(0.0, 3.0);
  EXPECT_EQ(right_of(along_the_bottom), Vec2(0.0, -2.0));
  EXPECT_EQ(right_of(up_the_right), Vec2(3.0, 0.0));
  EXPECT_EQ(cross(along_the_bottom, up_the_right), 6.0);
}
