#include "output/state_archive.hpp"

#include <gtest/gtest.h>

using namespace reye;

// What a run has seen of its contacts, and warned of, must come back from a checkpoint, or a resumed run would warn otherwise.
TEST(StateArchive, KeepsWhatWasSeen) {
  sim::State state;
  state.warnings = {{"resolution", "contact pad", "2 elements touch.", 4.0}};
  state.watch = {{12.5, 3, {10.0, 0.1, 6.5, 0.4, 0.02, true, "face", 2.5, 1e-4}}};
  const auto back = output::state_from_bytes(output::state_to_bytes(state));
  ASSERT_EQ(back.warnings.size(), 1u);
  EXPECT_EQ(back.warnings[0].kind, "resolution");
  EXPECT_EQ(back.warnings[0].severity, 4.0);
  ASSERT_EQ(back.watch.size(), 1u);
  const auto& [force_most, slipped_most, pressed] = back.watch[0];
  EXPECT_EQ(force_most, 12.5);
  EXPECT_EQ(slipped_most, 3);
  EXPECT_EQ(pressed.across, 6.5);
  EXPECT_EQ(pressed.length_mm, 0.4);
  EXPECT_TRUE(pressed.bounded);
  EXPECT_EQ(pressed.cut, "face");
  EXPECT_EQ(pressed.facets_mm, 1e-4);
}
