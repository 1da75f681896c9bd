#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/command.hpp"

using namespace reye;

namespace {

/// A scene made by `reye new`, run to its end.
class LikeTest : public testing::TestWithParam<const char*> {};

}  // namespace

// A scene to start from must run to its end in a minute of one core, without a warning, wear and reach its limit.
TEST_P(LikeTest, RunsInAMinute) {
  const test::Place place;
  ASSERT_EQ(place.reye({"new", "part", "--like", GetParam()}).code, 0);
  const auto told = place.reye({"run", "part/scene.toml", "--out", "out", "--threads", "1", "--quiet"});
  ASSERT_EQ(told.code, 0) << told.err;
  EXPECT_EQ(told.err, "");
  const auto summary = nlohmann::ordered_json::parse(test::read(place / "out/summary.json"));
  EXPECT_LT(summary["cpu_s"].get<double>(), 60.0);
  EXPECT_TRUE(summary["warnings"].empty());
  EXPECT_GT(summary["contacts"].front()["secondary"]["max_depth_mm"].get<double>(), 0.0);
  EXPECT_TRUE(summary["life_cycles"].front().is_number()) << "the limit lies within the run";
}

INSTANTIATE_TEST_SUITE_P(Kinds, LikeTest,
                         testing::Values("ball_on_flat", "bearing", "block_on_ring", "dovetail", "fretting", "hip_cup",
                                         "pin_on_disc", "seal"),
                         [](const auto& kind) { return std::string(kind.param); });
