#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "base/errors.hpp"
#include "cad/solid/skin_filling.hpp"
#include "support/solid_blocks.hpp"

namespace {

using namespace reye;

cad::SkinFilling surface_of_block(int n) {
  const auto block = support::block(mesh::SolidKind::tet4, {n, n, n}, base::Vec3(1, 1, 1));
  cad::SkinFilling filling{{}, {}, 0.5, 1.3, {}, {}};
  const auto nodes = mesh::nodes_of(block.skin);
  for (int node : nodes) filling.X.push_back(block.X[node]);
  for (const auto& facet : block.skin) {
    auto& triangle = filling.triangles.emplace_back();
    for (int k = 0; k < 3; ++k)
      triangle[k] = static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), facet.nodes[k]) - nodes.begin());
    filling.points.push_back({block.X[facet.nodes[0]], 1.0 / n});
  }
  return filling;
}

// A closed surface must be filled with tetrahedra whose skin is that surface, point by point, of the same volume; the
// same again in a second run.
TEST(solid_filling, keeps_the_surface) {
  const auto filling = surface_of_block(4);
  const auto mesh = cad::fill_skin(filling);
  ASSERT_GT(mesh.nodes.size(), filling.X.size());
  for (std::size_t k = 0; k < filling.X.size(); ++k) EXPECT_EQ(mesh.nodes[k], filling.X[k]);
  double volume = 0.0;
  for (const auto& c : mesh.cells) {
    const auto& X = mesh.nodes;
    volume += (X[c[1]] - X[c[0]]).cross(X[c[2]] - X[c[0]]).dot(X[c[3]] - X[c[0]]) / 6.0;
  }
  EXPECT_NEAR(volume, 1.0, 1e-14);
  EXPECT_EQ(mesh.nodes, cad::fill_skin(filling).nodes);
}

// A surface with a hole, which holds no volume, must be refused with a reason.
TEST(solid_filling, refuses_an_open_surface) {
  auto filling = surface_of_block(2);
  filling.triangles.pop_back();
  EXPECT_THROW(cad::fill_skin(filling), base::MeshError);
}

}  // namespace
