#include <gtest/gtest.h>

#include "adapt/shape/shift_outline.hpp"
#include "adapt/worn.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::OutlineShift;
using adapt::shift_outline;
using body::make_shape;

/// Moves of a boundary at x, and what is free.
OutlineShift shift_by(const Mesh& m, const std::string& boundary, const std::function<double(Vec2)>& by,
                      const std::function<double(Vec2)>& free) {
  OutlineShift shift{boundary, {}, {}};
  for (int node : mesh::nodes_of(m.boundaries.at(boundary))) {
    shift.by.push_back(by(m.X[node]));
    shift.free.push_back(free(m.X[node]));
  }
  return shift;
}

double one(Vec2) { return 1.0; }

}  // namespace

// Whatever the moves, on flat, convex and hollow faces and of a body of revolution, content stays to round-off.
TEST(ShiftOutline, KeepsContent) {
  const auto wavy = [](Vec2 x) { return 1e-3 * std::sin(7.0 * x.x()) + 4e-4; };
  const auto block = rectangle({.size = {2.0, 1.0}, .nx = 20, .ny = 8});
  const auto arcs = ring({.inner = 1.0, .outer = 2.0, .around = 24});
  for (auto analysis : {Analysis::plane_strain, Analysis::axisymmetric})
    for (const auto& [mesh, boundary] : {std::pair{block, "top"}, std::pair{arcs, "right"}, std::pair{arcs, "left"}}) {
      const auto result = shift_outline(make_shape(mesh), analysis, {shift_by(mesh, boundary, wavy, one)});
      ASSERT_TRUE(result.shape) << result.failure;
      EXPECT_LT(std::abs(result.removed), 1e-14) << boundary;
      EXPECT_LT(std::abs(lost(mesh, result.shape->mesh, analysis)), 2e-14) << boundary;
      EXPECT_NE(result.shape->mesh.X, mesh.X);
    }
}

// Of a straight face whose moves cancel each node goes by its own move along the normal, the ends along the sides.
TEST(ShiftOutline, AlongNormalsAndSides) {
  const auto mesh = rectangle({.size = {2.0, 1.0}, .nx = 20, .ny = 8});
  const auto odd = [](Vec2 x) { return 1e-4 * (x.x() - 1.0); };
  const auto result = shift_outline(make_shape(mesh), Analysis::plane_strain, {shift_by(mesh, "top", odd, one)});
  ASSERT_TRUE(result.shape) << result.failure;
  for (int node : mesh::nodes_of(mesh.boundaries.at("top"))) {
    EXPECT_EQ(result.shape->mesh.X[node].x(), mesh.X[node].x());
    EXPECT_NEAR(result.shape->mesh.X[node].y() - mesh.X[node].y(), odd(mesh.X[node]), 1e-15);
  }
}

// Content that nothing is free to give back is a failure in words.
TEST(ShiftOutline, NothingFree) {
  const auto mesh = rectangle({.size = {2.0, 1.0}, .nx = 20, .ny = 8});
  const auto none = [](Vec2) { return 0.0; };
  const auto result = shift_outline(make_shape(mesh), Analysis::plane_strain,
                                    {shift_by(
                                        mesh, "top", [](Vec2) { return 1e-4; }, none)});
  EXPECT_FALSE(result.shape);
  EXPECT_FALSE(result.failure.empty());
}

}  // namespace reye
