#include <gtest/gtest.h>

#include "body/solid_uncondensed.hpp"

namespace reye::support::solids {

namespace {

/// The block of `input_of` with its top bent by so much of its height.
std::shared_ptr<const mesh::SolidMesh> bent(SolidKind kind, double share) {
  const auto shape = [&](const Vec3& X) { return Vec3(X + share * X.z() * Vec3(0, 0, std::sin(2 * X.x() + X.y()))); };
  return std::make_shared<mesh::SolidMesh>(support::block(kind, {2, 2, 2}, Vec3(1, 1.2, 0.8), shape));
}

/// Displacements in another shape against those of a body that is condensed in it; in balance where a motion is free.
void expect_as_condensed(const SolidInput& input, const std::shared_ptr<const mesh::SolidMesh>& shape) {
  const SolidBody body(input, nodes_of_face(*input.mesh, "z1"));
  SolidInput other = input;
  other.mesh = shape;
  const SolidBody there(other, body.retained());
  const Vector s = 0.1 * wave(static_cast<Eigen::Index>(body.driven().size())), a = 0.01 * wave(body.A().cols());
  const Vector f = there.A().cols() > 0 ? balanced(there, s) : wave(there.C().rows());
  const Points3 u = body.displacements_in(shape, f, s, a), exact = there.displacements(f, s, a);
  EXPECT_LT(difference(u, exact), 1e-9);
}

// Displacements in another shape must be those of a body condensed in it, whatever holds, pushes and drives the body,
// and however far the shapes are from each other.
TEST(solid_body, displacements_in_another_shape) {
  for (const auto kind : support::solid_kinds)
    for (const double share : {1e-6, 1e-3, 0.1}) {
      SCOPED_TRACE(std::to_string(static_cast<int>(kind)) + " bent by " + std::to_string(share));
      SolidInput input = input_of(kind);
      body::SolidLoad weight, push;
      weight.force_N_per_mm3 = Vec3(0.1, 0.5, -1);
      push.face = "y1";
      push.force_N = Vec3(1, 1, 1);
      input.loads = {weight, push};
      input.supports = {by_node("z0", {fixed, fixed, moved(0.1)}, turned)};
      expect_as_condensed(input, bent(kind, share));
      input.supports = {rigid_face("z0", {fixed, loaded(-3.0, 50.0), moved(0.1)}, {fixed, moved(0.02), fixed}, turned)};
      expect_as_condensed(input, bent(kind, share));
      input.supports = {rigid_face("x0", {fixed, Motion{}, Motion{}}, {Motion{}, fixed, fixed})};
      expect_as_condensed(input, bent(kind, share));
      input.supports = {};
      expect_as_condensed(input, bent(kind, share));
    }
}

// A layer of hexahedra that is held below and touched above has no node between: nothing is eliminated, and its shape
// is condensed as it stands.
TEST(solid_body, displacements_of_a_single_layer_in_another_shape) {
  SolidInput input = input_of(SolidKind::hex8);
  const auto layer = [](double top) {
    return std::make_shared<mesh::SolidMesh>(support::block(
        SolidKind::hex8, {2, 2, 1}, Vec3(1, 1, 0.3), [&](const Vec3& X) { return Vec3(X.x(), X.y(), top * X.z()); }));
  };
  input.mesh = layer(1.0);
  input.supports = {by_node("z0", {fixed, fixed, moved(0.1)})};
  expect_as_condensed(input, layer(0.99));
}

// Where contact touches a curved face of six-node facets, forces act on its control points there, too.
TEST(solid_body, displacements_of_control_points_in_another_shape) {
  SolidInput input = input_of(SolidKind::tet10);
  input.contact_faces = {"z1"};
  input.supports = {by_node("z0", {fixed, fixed, moved(0.1)})};
  expect_as_condensed(input, bent(SolidKind::tet10, 0.02));
}

// A rigid body follows its own shape.
TEST(solid_body, displacements_of_a_rigid_body_in_another_shape) {
  SolidInput input = rigid_input();
  input.supports = {rigid_face("", {fixed, moved(0.1), loaded(-5.0, 20.0)}, {fixed, moved(0.03), fixed}, turned)};
  auto skin = *bent(SolidKind::tet10, 0.05);
  skin.cells.clear();
  expect_as_condensed(input, std::make_shared<mesh::SolidMesh>(skin));
}

}  // namespace

}  // namespace reye::support::solids
