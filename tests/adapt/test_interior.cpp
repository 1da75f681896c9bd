#include <gtest/gtest.h>

#include "adapt/shape/relocation.hpp"
#include "adapt/worn.hpp"
#include "mesh/quality.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::evolve;
using body::make_shape;

/// A block whose cells shrink towards the top: heights from 0.3 down to about 0.01.
Mesh graded() {
  return mapped(rectangle({.size = {2.0, 1.0}, .nx = 60, .ny = 16}),
                [](Vec2 x) { return Vec2(x.x(), (1.0 - std::exp(-3.5 * x.y())) / (1.0 - std::exp(-3.5))); });
}

double unit_scar(Vec2 x) { return scar(1.0, 1.0, 0.5)(x); }

double column_height(const Mesh& m, int i, int nx, int row) {
  return (m.X[(row + 1) * (nx + 1) + i] - m.X[row * (nx + 1) + i]).norm();
}

// Small surface elements keep their height within 5 % under wear of half an element, and all stay sound.
TEST(Interior, SurfaceElementsMoveNearlyRigidly) {
  const auto mesh = graded();
  const double height = column_height(mesh, 30, 60, 15);
  const auto result =
      evolve(make_shape(mesh), plane, {worn_by(mesh, "top", [&](Vec2 x) { return 0.5 * height * unit_scar(x); })});
  ASSERT_TRUE(result.shape) << result.failure;
  EXPECT_GT(result.min_quality, 0.9);
  for (int i = 0; i <= 60; ++i)
    EXPECT_NEAR(column_height(result.shape->mesh, i, 60, 15), column_height(mesh, i, 60, 15), 0.05 * height) << i;
}

// Elements stay sound through wear of four times their height, and those at the surface keep theirs within 12 %.
TEST(Interior, JacobiansStayPositiveUnderDeepWear) {
  const auto mesh = graded();
  const double height = column_height(mesh, 30, 60, 15);
  auto shape = make_shape(mesh);
  for (int step = 0; step < 20; ++step) {
    const auto result =
        evolve(shape, plane, {worn_by(shape->mesh, "top", [&](Vec2 x) { return 0.2 * height * unit_scar(x); })});
    ASSERT_TRUE(result.shape) << result.failure;
    shape = result.shape;
  }
  EXPECT_GT(mesh::poorest_cell(shape->mesh).scaled_jacobian, 0.5);
  for (int i = 0; i <= 60; ++i)  // the large cells below have given way; the scar edge is a kink
    EXPECT_NEAR(column_height(shape->mesh, i, 60, 15), column_height(mesh, i, 60, 15), 0.12 * height) << i;
  EXPECT_NO_THROW(mesh::check(shape->mesh));
}

// The places of inner nodes depend on the outline alone: one step or the same motion in ten gives the same interior.
TEST(Interior, PathIndependent) {
  const auto mesh = rectangle({.size = {2.0, 1.0}, .nx = 20, .ny = 8, .distortion = 0.5});
  auto ten = make_shape(mesh);
  for (int step = 0; step < 10; ++step)
    ten = evolve(ten, plane, {worn_by(ten->mesh, "top", [](Vec2) { return 0.001; })}).shape;
  const auto one = evolve(make_shape(mesh), plane, {worn_by(mesh, "top", [](Vec2) { return 0.01; })}).shape;
  for (int node = 0; node < mesh.node_count(); ++node)
    EXPECT_NEAR((ten->mesh.X[node] - one->mesh.X[node]).norm(), 0.0, 1e-14);
}

// A motion that all outline nodes share carries the inner nodes along rigidly, however distorted the cells.
TEST(Interior, CommonMotionIsRigid) {
  const auto mesh = rectangle({.nx = 6, .ny = 6, .distortion = 0.8});
  base::Points push(mesh.X.size(), Vec2(0.3, -0.2));
  for (const Vec2& moved : adapt::InteriorMotion(mesh).extend(push)) EXPECT_NEAR((moved - push[0]).norm(), 0.0, 1e-14);
}

// An affine motion of the outline is carried inside without error on a mesh of equal cells.
TEST(Interior, AffineMotionIsExactOnEqualCells) {
  for (auto kind : {CellKind::quad4, CellKind::tri3}) {
    const auto mesh = rectangle({.nx = 6, .ny = 5, .kind = kind});
    base::Points push;
    for (const Vec2& x : mesh.X) push.push_back({0.1 * x.x() - 0.3 * x.y(), 0.2 * x.x() + 0.05 * x.y()});
    const auto moved = adapt::InteriorMotion(mesh).extend(push);
    for (std::size_t j = 0; j < push.size(); ++j) EXPECT_NEAR((moved[j] - push[j]).norm(), 0.0, 1e-14);
  }
}

// The cache changes no bit: with it, without it, and after throwing it away.
TEST(Interior, CacheChangesNoBit) {
  const auto shape = make_shape(graded());
  const std::vector<WornBoundary> worn{worn_by(shape->mesh, "top", [](Vec2 x) { return 1e-3 * unit_scar(x); })};
  adapt::RelocationCache kept;
  const auto bare = evolve(shape, plane, worn);
  for (int call = 0; call < 2; ++call) {
    const auto cached = evolve(shape, plane, worn, {}, &kept);
    EXPECT_TRUE(cached.shape->mesh.X == bare.shape->mesh.X);
  }
  adapt::RelocationCache fresh;
  EXPECT_TRUE(evolve(shape, plane, worn, {}, &fresh).shape->mesh.X == bare.shape->mesh.X);
}

// A kept factor lives as long as the mesh it came from, and is found again only for that mesh.
TEST(Interior, CacheFollowsTheBornMesh) {
  adapt::RelocationCache cache;
  const auto mesh = std::make_shared<const Mesh>(rectangle({}));
  const auto motion = cache.of(mesh);
  EXPECT_EQ(cache.of(mesh), motion);
  EXPECT_NE(cache.of(std::make_shared<const Mesh>(rectangle({}))), motion);
}

// The nodes of a free side follow their sliding corner in proportion, and the side stays straight.
TEST(Interior, FreeSidesSlideInProportion) {
  const auto mesh = rectangle({.size = {2.0, 1.0}, .nx = 20, .ny = 8});
  const auto shape = evolve(make_shape(mesh), plane, {worn_by(mesh, "top", [](Vec2) { return 0.1; })}).shape;
  ASSERT_TRUE(shape);
  for (int node : mesh::nodes_of(mesh.boundaries.at("right"))) {
    EXPECT_EQ(shape->mesh.X[node].x(), 2.0);
    EXPECT_NEAR(shape->mesh.X[node].y(), 0.9 * mesh.X[node].y(), 1e-14);
  }
}

// A side that was worn itself does not slide: its nodes are where the wear left them.
TEST(Interior, WornSidesDoNotSlide) {
  const auto mesh = rectangle({.size = {2.0, 1.0}, .nx = 20, .ny = 8});
  const auto side = worn_by(mesh, "right", [](Vec2 x) { return 0.01 * x.y() * (1.0 - x.y()); });
  const auto first = evolve(make_shape(mesh), plane, {side}).shape;
  const auto second = evolve(first, plane, {worn_by(first->mesh, "top", [](Vec2) { return 0.01; })}).shape;
  ASSERT_TRUE(second);
  const auto nodes = mesh::nodes_of(mesh.boundaries.at("right"));
  for (std::size_t k = 1; k + 1 < nodes.size(); ++k) EXPECT_EQ(second->mesh.X[nodes[k]], first->mesh.X[nodes[k]]);
}

}  // namespace
}  // namespace reye
