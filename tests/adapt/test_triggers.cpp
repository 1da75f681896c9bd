#include "adapt/shape/triggers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/meshes.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::measure;
using adapt::why_remesh;
using testing::HasSubstr;

/// A block of square cells of side 0.1 whose nodes have moved since birth.
template <class Map>
body::Shape moved_block(Map map) {
  const auto mesh = rectangle({.size = {2.0, 1.0}, .nx = 20, .ny = 10});
  auto shape = *body::make_shape(mesh);
  shape.mesh = mapped(shape.mesh, map);
  return shape;
}

body::Shape sheared(double angle) {
  return moved_block([=](Vec2 x) { return Vec2(x.x() + x.y() * std::tan(angle), x.y()); });
}

/// Bounds that nothing but the one under test exceeds.
constexpr adapt::Triggers lax{
    .min_scaled_jacobian = 0.0, .min_angle_deg = 0.0, .size_ratio = 1e9, .wear_fraction = 1e9};

// A mesh as it was made is fit, even if its quality is below the bounds.
TEST(Triggers, BirthIsNoReason) {
  const auto poor = *body::make_shape(mapped(rectangle({}), [](Vec2 x) { return Vec2(x.x() + 8.0 * x.y(), x.y()); }));
  EXPECT_EQ(why_remesh(poor, nullptr, {}), "");
}

// A poor element is a reason below its bound and not before, in the words of the failure.
TEST(Triggers, ScaledJacobian) {
  auto bounds = lax;
  bounds.min_scaled_jacobian = 0.3;
  EXPECT_EQ(why_remesh(sheared(std::acos(0.301)), nullptr, bounds), "");
  EXPECT_THAT(why_remesh(sheared(std::acos(0.299)), nullptr, bounds),
              HasSubstr("has scaled Jacobian 0.299, below 0.3"));
  EXPECT_NEAR(measure(sheared(1.2), sheared(1.2).mesh.X).scaled_jacobian.value, std::cos(1.2), 1e-12);
}

// A mesh born poorer than the bound is a reason only once it has lost three tenths of that.
TEST(Triggers, RelativeToBirth) {
  auto bounds = lax;
  bounds.min_scaled_jacobian = 0.5;
  auto shape = sheared(std::acos(0.4));
  shape.born = std::make_shared<const Mesh>(shape.mesh);
  shape.mesh = sheared(std::acos(0.281)).mesh;
  EXPECT_EQ(why_remesh(shape, nullptr, bounds), "");
  shape.mesh = sheared(std::acos(0.279)).mesh;
  EXPECT_NE(why_remesh(shape, nullptr, bounds), "");
}

// A sharp corner is a reason below its bound and not before.
TEST(Triggers, Angle) {
  auto bounds = lax;
  bounds.min_angle_deg = 15.0;
  const double degree = std::acos(-1.0) / 180.0;
  EXPECT_EQ(why_remesh(sheared(74.9 * degree), nullptr, bounds), "");
  EXPECT_THAT(why_remesh(sheared(75.1 * degree), nullptr, bounds), HasSubstr("has a corner of 14.9 degrees, below 15"));
}

// A facet that has grown or shrunk by the factor is a reason, either way.
TEST(Triggers, SizeRatio) {
  auto bounds = lax;
  bounds.size_ratio = 2.5;
  for (double factor : {2.49, 1.0 / 2.49})
    EXPECT_EQ(why_remesh(moved_block([=](Vec2 x) -> Vec2 { return factor * x; }), nullptr, bounds), "");
  for (double factor : {2.51, 1.0 / 2.51})
    EXPECT_THAT(why_remesh(moved_block([=](Vec2 x) -> Vec2 { return factor * x; }), nullptr, bounds),
                HasSubstr("has changed its length by the factor 2.51, above 2.5"));
}

// Wear counts in heights of the element below since birth, at the node where it is largest.
TEST(Triggers, WearFraction) {
  auto bounds = lax;
  bounds.wear_fraction = 0.5;
  const auto worn = [](double depth) {
    return moved_block(
        [=](Vec2 x) { return x.y() > 0.99 && std::abs(x.x() - 1.2) < 0.01 ? Vec2(x.x(), 1.0 - depth) : x; });
  };
  EXPECT_EQ(why_remesh(worn(0.049), nullptr, bounds), "");
  EXPECT_EQ(why_remesh(worn(0.051), nullptr, bounds),
            "wear at (1.2, 0.949) mm since the mesh was made is 0.51 times the height of the element below, above 0.5");
}

// The current shape is measured when it is given, and named; wear is that of X.
TEST(Triggers, CurrentShape) {
  const auto shape = moved_block([](Vec2 x) { return x; });
  const auto current = sheared(std::acos(0.2)).mesh.X;
  auto bounds = lax;
  bounds.min_scaled_jacobian = 0.3;
  EXPECT_EQ(why_remesh(shape, nullptr, {}), "");
  EXPECT_EQ(why_remesh(shape, &shape.mesh.X, {}), "");
  EXPECT_THAT(why_remesh(shape, &current, bounds), HasSubstr("has scaled Jacobian 0.2 when deformed, below 0.3"));
}

// Of several reasons the one that exceeds its bound by the largest factor is reported.
TEST(Triggers, WorstReason) {
  const auto shape =
      moved_block([](Vec2 x) { return Vec2(x.x() + 4.0 * x.y(), x.y()); });  // 0.243; 14.04 degrees; 4.12
  EXPECT_THAT(why_remesh(shape, nullptr, {.wear_fraction = 1e9}), HasSubstr("above 2.5"));
  EXPECT_THAT(why_remesh(shape, nullptr, {.min_scaled_jacobian = 0.9, .wear_fraction = 1e9}),
              HasSubstr("scaled Jacobian"));
  EXPECT_THAT(why_remesh(shape, nullptr, {}), HasSubstr("wear at"));
}

}  // namespace
}  // namespace reye
