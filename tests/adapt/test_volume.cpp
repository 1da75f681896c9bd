#include <gtest/gtest.h>

#include "adapt/worn.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::evolve;
using body::make_shape;

/// What rounding the stored coordinates may add to a strip of this length: eps per coordinate and node.
double rounding(double extent, double length) { return 1e-16 * extent * length; }

void expect_exact(const Mesh& mesh, const WornBoundary& worn, Analysis analysis = Analysis::plane_strain) {
  const auto result = evolve(make_shape(mesh), analysis, {worn});
  ASSERT_TRUE(result.shape) << result.failure;
  const double volume = sum(worn), slack = 1e-14 * volume + 20.0 * rounding(2.0, 2.0);
  EXPECT_NEAR(result.removed, volume, slack);
  EXPECT_NEAR(lost(mesh, result.shape->mesh, analysis), volume, slack);
}

Mesh block() { return rectangle({.size = {2.0, 1.0}, .nx = 20, .ny = 8}); }

// The strip between old and new outline has exactly the removed volume: a dent in a flat face.
TEST(StripVolume, FlatFace) { expect_exact(block(), worn_by(block(), "top", scar(0.015, 0.9, 0.63))); }

// The strip is exact when the face is turned against the axes and made of triangles.
TEST(StripVolume, TurnedTriangles) {
  const auto mesh = turned(rectangle({.size = {2.0, 1.0}, .nx = 20, .ny = 8, .kind = CellKind::tri3}), 0.7);
  expect_exact(mesh, worn_by(mesh, "top", [](Vec2 x) { return 0.01 * (1.0 + std::sin(5.0 * x.x())); }));
}

// The strip is exact on a convex and on a hollow arc, where the strip is not the sum of length times depth.
TEST(StripVolume, CurvedFaces) {
  const auto mesh = ring({.inner = 1.0, .outer = 2.0, .around = 24});
  const auto profile = [](Vec2 x) { return 0.01 * x.x() * x.y(); };
  expect_exact(mesh, worn_by(mesh, "right", profile));
  expect_exact(mesh, worn_by(mesh, "left", profile));
}

// The strip is exact on a sawtooth, where neighbouring normals differ by 40 degrees.
TEST(StripVolume, Sawtooth) {
  auto mesh = block();
  const auto top = mesh::nodes_of(mesh.boundaries.at("top"));
  for (std::size_t k = 1; k + 1 < top.size(); k += 2) mesh.X[top[k]].y() += 0.1 * std::tan(0.35);
  expect_exact(mesh, worn_by(mesh, "top", [](Vec2 x) { return 0.002 * x.x(); }));
}

// Volumes of revolution are exact, also where the face starts on the axis.
TEST(StripVolume, Axisymmetric) {
  for (double start : {0.0, 0.5}) {
    const auto mesh = rectangle({.corner = {start, 0.0}, .size = {2.0, 1.0}, .nx = 20, .ny = 8});
    expect_exact(mesh, worn_by(mesh, "top", scar(0.015, 0.4, 1.13), Analysis::axisymmetric), Analysis::axisymmetric);
    expect_exact(mesh,
                 worn_by(
                     mesh, "right", [](Vec2) { return 0.01; }, Analysis::axisymmetric),
                 Analysis::axisymmetric);
  }
}

// A node shared by two worn faces gives each its volume: a corner worn on both sides is cut square.
TEST(StripVolume, CornerWornOnBothSides) {
  const auto mesh = block();
  const auto top = worn_by(mesh, "top", [](Vec2) { return 2e-3; });
  const auto right = worn_by(mesh, "right", [](Vec2) { return 1e-3; });
  const auto result = evolve(make_shape(mesh), Analysis::plane_strain, {top, right});
  ASSERT_TRUE(result.shape) << result.failure;
  EXPECT_NEAR(result.removed, sum(top) + sum(right), 1e-14);
  const Vec2 corner = result.shape->mesh.X[node_at(mesh, {2.0, 1.0})];
  EXPECT_NEAR(corner.x(), 1.999, 1e-6);  // the strips overlap in a square of 2e-6, for which theta makes up
  EXPECT_NEAR(corner.y(), 0.998, 1e-6);
}

// A boundary that ends within a smooth face loses its volume too, and no more.
TEST(StripVolume, ChainEndWithinAFace) {
  auto mesh = block();
  const auto top = mesh.boundaries.at("top")[0];
  mesh.boundaries["middle"] = {{top.begin() + 5, top.begin() + 12}};
  expect_exact(mesh, worn_by(mesh, "middle", [](Vec2) { return 0.004; }));
}

// Flat uniform wear moves a face exactly parallel, sliding corners included, and needs no correction.
TEST(StripVolume, UniformWearStaysParallel) {
  const auto mesh = block();
  const auto result =
      evolve(make_shape(mesh), Analysis::plane_strain, {worn_by(mesh, "top", [](Vec2) { return 0.01; })});
  ASSERT_TRUE(result.shape) << result.failure;
  EXPECT_NEAR(result.theta, 1.0, 1e-14);
  EXPECT_EQ(result.parts, 1);
  for (int node : mesh::nodes_of(mesh.boundaries.at("top"))) {
    EXPECT_NEAR(result.shape->mesh.X[node].y(), 0.99, 1e-14);
    EXPECT_NEAR(result.shape->mesh.X[node].x(), mesh.X[node].x(), 1e-14);
  }
}

// Uniform wear stays parallel on a ring face from the axis outwards: each node has its own share of the circumference.
TEST(StripVolume, UniformWearStaysParallelOnARing) {
  const auto mesh = block();
  const auto worn = worn_by(
      mesh, "top", [](Vec2) { return 0.01; }, Analysis::axisymmetric);
  const auto result = evolve(make_shape(mesh), Analysis::axisymmetric, {worn});
  ASSERT_TRUE(result.shape) << result.failure;
  EXPECT_NEAR(result.theta, 1.0, 1e-13);
  for (int node : mesh::nodes_of(mesh.boundaries.at("top"))) EXPECT_NEAR(result.shape->mesh.X[node].y(), 0.99, 1e-14);
}

// A corner slides along a free side that leans, so that the worn face still advances by its depth.
TEST(StripVolume, CornerSlidesAlongALeaningSide) {
  const auto mesh = mapped(block(), [](Vec2 x) { return Vec2(x.x() + 0.3 * x.y() * (x.x() - 1.0), x.y()); });
  const auto result =
      evolve(make_shape(mesh), Analysis::plane_strain, {worn_by(mesh, "top", [](Vec2) { return 1e-4; })});
  ASSERT_TRUE(result.shape) << result.failure;
  const int corner = node_at(mesh, {2.3, 1.0});
  const Vec2 moved = result.shape->mesh.X[corner] - mesh.X[corner];
  EXPECT_NEAR(moved.y(), -1e-4, 1e-7);
  EXPECT_NEAR(moved.x() / moved.y(), 0.3, 1e-11);
}

// A parabola worn into a circle leaves the circle moved along its own normals, to the order of the facets.
TEST(StripVolume, ParabolaOnACircle) {
  const auto mesh = ring({.inner = 1.0, .outer = 2.0, .around = 90});
  const auto profile = [](Vec2 x) {
    return 1e-3 * std::max(0.0, 1.0 - std::pow((std::atan2(x.y(), x.x()) - 0.8) / 0.4, 2));
  };
  const auto result = evolve(make_shape(mesh), Analysis::plane_strain, {worn_by(mesh, "right", profile)});
  ASSERT_TRUE(result.shape) << result.failure;
  EXPECT_NEAR(result.theta, 1.0, 1e-3);
  for (int node : mesh::nodes_of(mesh.boundaries.at("right"))) {
    const Vec2& x = result.shape->mesh.X[node];
    EXPECT_NEAR(x.norm(), 2.0 - profile(mesh.X[node]), 1e-6);
    EXPECT_NEAR(std::atan2(x.y(), x.x()), std::atan2(mesh.X[node].y(), mesh.X[node].x()), 1e-6);
  }
}

// Two hundred small steps lose together what they lose one by one.
TEST(StripVolume, TinyStepsAddUp) {
  const auto mesh = ring({.inner = 1.0, .outer = 2.0, .around = 24});
  auto shape = make_shape(mesh);
  double asked = 0.0, removed = 0.0;
  for (int step = 0; step < 200; ++step) {
    const auto worn =
        worn_by(shape->mesh, "right", [&](Vec2 x) { return 1e-6 * (1.0 + std::sin(9.0 * x.x() + step)); });
    const auto result = evolve(shape, Analysis::plane_strain, {worn});
    ASSERT_TRUE(result.shape) << result.failure;
    asked += sum(worn);
    removed += result.removed;
    shape = result.shape;
  }
  EXPECT_NEAR(removed, asked, 1e-11 * asked);
  EXPECT_NEAR(lost(mesh, shape->mesh), asked, 1e-11 * asked);
}

// Wear that is deep against its facets is taken in parts, and loses the same volume.
TEST(StripVolume, DeepWearIsTakenInParts) {
  const auto mesh = rectangle({.size = {2.0, 1.0}, .nx = 40, .ny = 2});
  const auto worn = worn_by(mesh, "top", scar(0.1, 1.0, 0.7));
  const auto result = evolve(make_shape(mesh), Analysis::plane_strain, {worn});
  ASSERT_TRUE(result.shape) << result.failure;
  EXPECT_GE(result.parts, 8);
  EXPECT_LE(std::abs(result.theta - 1.0), 1e-2);
  EXPECT_NEAR(result.removed, sum(worn), 1e-14);
}

// No wear gives the very same shape back.
TEST(StripVolume, NoWearNoNewShape) {
  const auto shape = make_shape(block());
  const auto result = evolve(shape, Analysis::plane_strain, {worn_by(shape->mesh, "top", [](Vec2) { return 0.0; })});
  EXPECT_EQ(result.shape, shape);
  EXPECT_EQ(result.removed, 0.0);
  EXPECT_EQ(result.min_quality, 1.0);
}

}  // namespace
}  // namespace reye
