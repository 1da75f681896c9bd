#include "sim/problem/records.hpp"
#include "support/scene_words.hpp"
#include "wear_scene.hpp"

/// A curved body, pressed on by a force, that slides far and wears both sides.
namespace reye::verification {

namespace {

// Where a block of a million strokes begins to wear a worn contact back from a reversal, an iteration of Newton opens
// all of it; the body is pressed on all the same, so that no increment may be cut for it.
TEST(Cam, IsPressedOnWhereAnIterationOpensAllContact) {
  const auto cam = played(scene_text("cam_on_follower", {{"size_mm = 0.05", "size_mm = 0.1"},
                                                         {"increments = 200", "increments = 60"},
                                                         {"cycles     = 1.0e6", "cycles     = 4.0e5"},
                                                         {"jump       = { tolerance = 0.02 }", R"(jump       = 4.0e4

[[step]]
name       = "long"
play       = ["stroke"]
increments = 60
cycles     = 1.0e6
jump       = 1.0e6
)"}}));
  ASSERT_EQ(cam.summary.status, sim::RunStatus::done) << cam.summary.reason;
  EXPECT_EQ(cam.summary.counts.cutbacks, 0);
  EXPECT_LT(cam.contact().ledger_relative_error.value(), 1e-9);
}

}  // namespace

}  // namespace reye::verification
