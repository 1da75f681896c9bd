#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapt/shape/crossing.hpp"
#include "adapt/worn.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::evolve;
using body::make_shape;
using testing::HasSubstr;
using testing::MatchesRegex;

// A mesh that wear has degraded is reported with the element, its place, its quality and the cause; the moved shape is
// there, because its outline is sound.
TEST(Refusal, PoorElementIsNamed) {
  const auto mesh = rectangle({.size = {2.0, 1.0}, .nx = 8, .ny = 4});
  auto shape = make_shape(mesh);
  adapt::ShapeStepResult result;
  for (int step = 0; step < 40; ++step) {
    result = evolve(shape, plane,
                    {worn_by(shape->mesh, "top", [](Vec2 x) { return std::abs(x.x() - 1.0) < 0.1 ? 0.03 : 0.0; })},
                    {.min_scaled_jacobian = 0.5});
    if (!result.poor.empty()) break;
    shape = result.shape;
  }
  EXPECT_TRUE(result.shape);
  EXPECT_EQ(result.failure, "");
  EXPECT_LT(result.min_quality, 0.5);
  EXPECT_THAT(result.poor,
              MatchesRegex("element [0-9]+ at \\([0-9.]+, [0-9.]+\\) mm has scaled Jacobian -?[0-9.]+, below 0.5: wear "
                           "since the mesh was made is [0-9.]+ times the height of the element below"));
}

// The cause counts wear from the birth of the mesh in heights of the element below, over several steps.
TEST(Refusal, CauseCountsFromBirth) {
  const auto mesh = rectangle({.size = {2.0, 1.0}, .nx = 8, .ny = 4});
  auto shape = make_shape(mesh);
  for (int step = 0; step < 4; ++step)
    shape = evolve(shape, plane, {worn_by(shape->mesh, "top", [](Vec2) { return 0.025; })}).shape;
  const auto result =
      evolve(shape, plane, {worn_by(shape->mesh, "top", [](Vec2) { return 0.025; })}, {.min_scaled_jacobian = 1.1});
  EXPECT_THAT(result.poor, HasSubstr("is 0.5 times the height of the element below"));
}

// A wall worn through from both sides is refused: the body would be two.
TEST(Refusal, OutlineCrossingItself) {
  const auto mesh = rectangle({.size = {2.0, 0.2}, .nx = 20, .ny = 1});
  const auto dent = [](Vec2 x) { return 0.11 * std::max(0.0, 1.0 - std::pow((x.x() - 1.0) / 0.6, 2)); };
  const auto result = evolve(make_shape(mesh), plane, {worn_by(mesh, "top", dent), worn_by(mesh, "bottom", dent)});
  EXPECT_FALSE(result.shape);
  EXPECT_THAT(result.failure, HasSubstr("the body is worn into two pieces at ("));
  EXPECT_THAT(result.failure, HasSubstr("times the height of the element below"));
}

// A wall worn through from one side is refused with the name of the other, or without where it has none.
TEST(Refusal, WornThroughToABoundary) {
  auto mesh = rectangle({.size = {2.0, 0.2}, .nx = 20, .ny = 1});
  const auto dent = [](Vec2 x) { return 0.22 * std::max(0.0, 1.0 - std::pow((x.x() - 1.0) / 0.6, 2)); };
  EXPECT_THAT(evolve(make_shape(mesh), plane, {worn_by(mesh, "top", dent)}).failure,
              HasSubstr("worn through to boundary 'bottom' at ("));
  mesh.boundaries.erase("bottom");
  EXPECT_THAT(evolve(make_shape(mesh), plane, {worn_by(mesh, "top", dent)}).failure,
              HasSubstr("worn through to the unworn outline at ("));
}

// A face that folds onto itself crosses itself, whatever lies elsewhere; a hole that is reached is named.
TEST(Refusal, MeaningOfCrossings) {
  Mesh born;
  born.X = {{0, 0}, {4, 0}, {4, 4}, {3, 4}, {2, 4}, {1, 4}, {0, 4}, {1, 1}, {1, 2}, {2, 2}, {2, 1}};
  born.outline = {{0, 1, 2, 3, 4, 5, 6, 0}, {7, 8, 9, 10, 7}};
  born.boundaries = {{"top", {{2, 3, 4, 5, 6}}}, {"hole", {{7, 8, 9, 10, 7}}}};
  Mesh now = born;
  now.X[4] = {3.5, 3};  // beyond its neighbour
  now.X[3] = {2.5, 3};
  auto crossing = adapt::find_crossing(now);
  ASSERT_TRUE(crossing);
  EXPECT_EQ(adapt::meaning(*crossing, now, born), "the worn outline crosses itself");
  now = born;
  now.X[4] = {1.8, 1.5};
  crossing = adapt::find_crossing(now);
  ASSERT_TRUE(crossing);
  EXPECT_EQ(adapt::meaning(*crossing, now, born), "worn through to boundary 'hole'");
}

// Crossings are found within a loop and between loops, and neighbours do not count as crossing.
TEST(Refusal, CrossingsOfLoops) {
  Mesh plate;
  plate.X = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {1, 2}, {2, 2}, {2, 1}};
  plate.outline = {{0, 1, 2, 3, 0}, {4, 5, 6, 7, 4}};
  EXPECT_FALSE(adapt::find_crossing(plate));
  plate.X[6] = {5, 2};
  EXPECT_TRUE(adapt::find_crossing(plate));
  plate.X[6] = {1.5, 0.5};
  EXPECT_TRUE(adapt::find_crossing(plate));
  plate.X[6] = {1, 1.5};  // folded back onto its neighbour
  EXPECT_TRUE(adapt::find_crossing(plate));
}

// Wear far beyond the size of the body is refused in words, not by a crash or endless parts.
TEST(Refusal, WearBeyondTheBody) {
  const auto mesh = rectangle({.size = {2.0, 1.0}, .nx = 8, .ny = 4});
  for (double depth : {1.5, 1e6}) {
    const auto result = evolve(make_shape(mesh), plane, {worn_by(mesh, "top", [&](Vec2) { return depth; })});
    EXPECT_FALSE(result.shape);
    EXPECT_FALSE(result.failure.empty());
  }
}

// A loss that is negative or not a number is refused with its node.
TEST(Refusal, LossThatIsNone) {
  const auto mesh = rectangle({});
  for (double bad : {-1e-9, std::nan("")}) {
    auto worn = worn_by(mesh, "top", [](Vec2) { return 0.01; });
    worn.removed[2] = bad;
    const auto result = evolve(make_shape(mesh), plane, {worn});
    EXPECT_FALSE(result.shape);
    EXPECT_THAT(result.failure, HasSubstr("node 2 of boundary 'top'"));
  }
}

}  // namespace
}  // namespace reye
