#include "mesh/quality.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/errors.hpp"
#include "small_meshes.hpp"

namespace {

using namespace reye;
using namespace reye::mesh;

/// Text of the MeshError that check throws, "" if it does not.
std::string refusal(const Mesh& mesh) {
  try {
    check(mesh);
    return "";
  } catch (const base::MeshError& error) {
    return error.what();
  }
}

// Scaled Jacobian and angle must be those of the textbook for known shapes and negative for folded ones.
TEST(quality, known_shapes) {
  const Points X{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, std::sqrt(0.75)}, {0.8, 0.1}};
  EXPECT_DOUBLE_EQ(scaled_jacobian(X, CellKind::quad4, {0, 1, 2, 3}), 1.0);
  EXPECT_NEAR(scaled_jacobian(X, CellKind::tri3, {0, 1, 4, -1}), std::sqrt(0.75), 1e-15);
  EXPECT_NEAR(smallest_angle(X, CellKind::tri3, {0, 1, 2, -1}), std::numbers::pi / 4, 1e-15);
  EXPECT_LT(scaled_jacobian(X, CellKind::quad4, {0, 1, 5, 3}), 0.0);
  EXPECT_LT(smallest_angle(X, CellKind::quad4, {0, 1, 5, 3}), 0.0);
}

// The poorest cell must be found.
TEST(quality, poorest_cell) {
  Mesh mesh = squares(2);
  mesh.X[mesh.cells[3][2]] += Vec2(0.0, 0.5);
  EXPECT_EQ(poorest_cell(mesh).cell, 3);
  EXPECT_LT(poorest_cell(mesh).scaled_jacobian, 1.0);
}

// A sound mesh must pass the check, with its boundaries and without cells.
TEST(check, sound_meshes_pass) {
  Mesh mesh = squares(3, {4});
  mesh.boundaries["all"] = {mesh.outline[0]};
  EXPECT_EQ(refusal(mesh), "");
  Mesh rigid;
  rigid.X = {{0, 0}, {1, 0}, {0, 1}};
  rigid.outline = {{0, 1, 2, 0}};
  EXPECT_EQ(refusal(rigid), "");
}

// Each broken promise must be reported with the cell or node and its place.
TEST(check, broken_promises_are_named) {
  const Mesh sound = squares(2);
  Mesh mesh = sound;
  mesh.X[0] = {2.5, 2.5};
  EXPECT_NE(refusal(mesh).find("cell 0 at (2.5, 2.5)"), std::string::npos) << refusal(mesh);
  mesh = sound;
  mesh.X.emplace_back(7, 8);
  EXPECT_EQ(refusal(mesh), "node 9 at (7, 8) belongs to no cell");
  mesh = sound;
  mesh.X[2].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(mesh), "node 2 has no finite position");
  mesh = sound;
  mesh.outline[0].pop_back();
  EXPECT_EQ(refusal(mesh), "loop 0 of the outline is not closed");
  mesh = sound;
  std::reverse(mesh.outline[0].begin(), mesh.outline[0].end());
  EXPECT_EQ(refusal(mesh), "loop 0 of the outline at (0, 0) does not have the body on its left");
  mesh = sound;
  mesh.cells[0][0] = 99;
  EXPECT_EQ(refusal(mesh), "a cell names node 99, which does not exist");
}

// A boundary against the direction of the outline, or across the body, must be refused.
TEST(check, boundaries_follow_the_outline) {
  Mesh mesh = squares(2);
  Chain chain(mesh.outline[0].begin(), mesh.outline[0].begin() + 3);
  mesh.boundaries["face"] = {chain};
  EXPECT_EQ(refusal(mesh), "");
  std::reverse(chain.begin(), chain.end());
  mesh.boundaries["face"] = {chain};
  EXPECT_NE(refusal(mesh).find("boundary 'face' leaves the outline at node"), std::string::npos);
}

}  // namespace
