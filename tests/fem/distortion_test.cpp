#include "fem/distortion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.hpp"

using namespace reye;
using base::Vec2;

namespace {

mesh::Mesh block() { return support::rectangle({.corner = {1, 0}, .size = {2, 1}, .nx = 4, .ny = 3}); }

base::Points moved(const mesh::Mesh& mesh, const Eigen::Matrix2d& H) {
  base::Points u;
  for (const Vec2& X : mesh.X) u.push_back(H * X);
  return u;
}

}  // namespace

// A uniform displacement gradient must give its largest principal strain and its rotation, in axisymmetry the hoop's
// strain where it is larger.
TEST(distortion, uniform_gradient) {
  const auto mesh = block();
  Eigen::Matrix2d H;
  H << 1e-3, 4e-3, 0.0, -5e-3;  // eps_12 = 2e-3, omega = -2e-3
  const double largest = 2e-3 + std::hypot(3e-3, 2e-3);
  for (auto analysis : {base::Analysis::plane_strain, base::Analysis::plane_stress, base::Analysis::axisymmetric}) {
    const auto d = fem::distortion(mesh, analysis, moved(mesh, H));
    EXPECT_NEAR(d.strain, largest, 1e-15);
    EXPECT_NEAR(d.rotation, 2e-3, 1e-15);
    EXPECT_NEAR(d.error(), 2.0 * (largest + 2e-3), 1e-15);
  }
  H << 0.0, 0.0, 0.0, 1e-3;
  auto u = moved(mesh, H);
  for (Vec2& v : u) v.x() += 8e-3;  // hoop strain 8e-3 / r
  EXPECT_GT(fem::distortion(mesh, base::Analysis::axisymmetric, u).strain, 8e-3 / 3.0);
  EXPECT_NEAR(fem::distortion(mesh, base::Analysis::plane_strain, u).strain, 1e-3, 1e-15);
}

// A body that only moves along must have none; one that turns, its rotation.
TEST(distortion, rigid_motion) {
  const auto mesh = block();
  const auto still = fem::distortion(mesh, base::Analysis::plane_strain, base::Points(mesh.X.size(), Vec2(0.0, 0.0)));
  EXPECT_EQ(still.error(), 0.0);
  Eigen::Matrix2d H;
  H << 1e-6, -0.02, 0.02, 0.0;
  const auto turned = fem::distortion(mesh, base::Analysis::plane_strain, moved(mesh, H));
  EXPECT_NEAR(turned.rotation, 0.02, 1e-12);
  EXPECT_NEAR(turned.strain, 1e-6, 1e-12);
}

// Where a strip is strained and the rest is not, the strained part alone must count.
TEST(distortion, counts_where_energy_is) {
  const auto mesh = block();
  base::Points u;
  for (const Vec2& X : mesh.X) u.push_back({X.x() > 2.5 ? 0.01 * (X.x() - 2.5) : 0.0, 0.0});
  EXPECT_NEAR(fem::distortion(mesh, base::Analysis::plane_strain, u).strain, 0.01, 1e-15);
}
