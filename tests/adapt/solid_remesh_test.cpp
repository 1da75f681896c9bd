#include <gtest/gtest.h>

#include "adapt/solid/solid_remesh.hpp"
#include "adapt/solid/solid_triggers.hpp"
#include "adapt/solid_worn.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::remesh_solid;
using adapt::ScarRoute;
using mesh::SolidKind;

/// A block whose top "z1" has a spherical dent of this depth, worn in steps.
struct Dented {
  mesh::SolidMesh born;
  SolidPtr worn;
};

Dented dented(SolidKind kind, int n, double depth, int steps = 4) {
  Dented result{support::block(kind, {n, n, n / 2}, Vec3(1, 1, 0.5)), {}};
  result.worn = shared(result.born);
  for (int step = 0; step < steps; ++step) {
    const auto loss = worn_by(*result.worn, "z1", [&](const Vec3& X) {
      return depth / steps * std::max(0.0, 1.0 - 8.0 * (X - Vec3(0.5, 0.5, X.z())).squaredNorm());
    });
    const auto next = adapt::evolve_solid(result.worn, result.born, {loss}, 1e-3);
    EXPECT_TRUE(next.mesh) << next.failure;
    result.worn = next.mesh;
  }
  return result;
}

/// Names and areas of faces, numbers of groups.
void expect_same_faces(const mesh::SolidMesh& before, const mesh::SolidMesh& after, double slack) {
  std::set<int> groups, groups_after;
  for (const auto& facet : before.skin) groups.insert(facet.group);
  for (const auto& facet : after.skin) groups_after.insert(facet.group);
  EXPECT_EQ(groups, groups_after);
  ASSERT_EQ(before.faces.size(), after.faces.size());
  for (const auto& [name, facets] : before.faces)
    EXPECT_NEAR(mesh::area(after.X, mesh::facets_of(after, name)), mesh::area(before.X, mesh::facets_of(before, name)),
                slack)
        << name;
}

// A mesh made again under the worn skin must keep that node by node, with its volume, faces and groups, whatever its
// order, and be filled with sound cells.
TEST(SolidRemesh, KeepsTheWornSkin) {
  for (auto kind : {SolidKind::tet4, SolidKind::tet10}) {
    const auto [born, worn] = dented(kind, 8, 0.1);
    const auto result = remesh_solid(*worn, born, {.scar = ScarRoute::keep});
    ASSERT_TRUE(result.mesh) << result.failure;
    EXPECT_EQ(result.fresh_facets, 0);
    EXPECT_GT(result.quality, 0.1);
    ASSERT_EQ(result.mesh->skin.size(), worn->skin.size());
    for (std::size_t f = 0; f < worn->skin.size(); ++f)
      for (int a = 0; a < worn->skin[f].count(); ++a)
        EXPECT_EQ(result.mesh->X[result.mesh->skin[f].nodes[a]], worn->X[worn->skin[f].nodes[a]]);
    expect_same_faces(*worn, *result.mesh, 0.0);
  }
}

// A scar drawn again must have the volume of the worn one, its border, its creases and all that did not wear stay node
// by node, planes stay planes; the poorest facet is no worse.
TEST(SolidRemesh, DrawsTheScarAgain) {
  for (auto kind : {SolidKind::tet4, SolidKind::tet10}) {
    const auto [born, worn] = dented(kind, 12, 0.1);
    const auto result = remesh_solid(*worn, born, {.scar = ScarRoute::redraw});
    ASSERT_TRUE(result.mesh) << result.failure;
    EXPECT_GT(result.fresh_facets, 20);
    const double volume = mesh::volume(*worn);
    EXPECT_NEAR(mesh::volume(*result.mesh), volume, 1e-12 * volume);
    EXPECT_LT(std::abs(result.volume_residue), 2e-3 * lost(born, *worn));
    EXPECT_GT(result.quality, 0.1);
    expect_same_faces(*worn, *result.mesh, 2e-3);
    std::set<std::array<double, 3>> places;
    for (const Vec3& x : result.mesh->X) places.insert({x.x(), x.y(), x.z()});
    for (int node : mesh::nodes_of(worn->skin))
      if (const Vec3& x = worn->X[node]; x == born.X[node]) {
        EXPECT_TRUE(places.contains({x.x(), x.y(), x.z()}));
      }
  }
}

/// A mesh of which the nodes above this height seem to have moved since.
mesh::SolidMesh before_wear_above(mesh::SolidMesh m, double z) {
  for (Vec3& X : m.X)
    if (X.z() > z) X *= 1.001;
  return m;
}

// A worn cap drawn again a hundred times without wear must keep its volume and its shape.
TEST(SolidRemesh, AHundredTimesWithoutWear) {
  for (auto kind : {SolidKind::tet4, SolidKind::tet10}) {
  auto now = rigid(ball(kind, kind == SolidKind::tet4 ? 16 : 8, 1.0));
  now = *adapt::evolve_solid(shared(now), now, {worn_by(now, "ball", [](const Vec3& X) { return 0.3 * std::max(0.0, X.z() - 0.8); })}, 1e-3).mesh;
  const double volume = mesh::volume(now);
  for (int k = 0; k < 100; ++k) {
    const auto result = remesh_solid(now, before_wear_above(now, 0.7), {.scar = ScarRoute::redraw});
    ASSERT_TRUE(result.mesh) << result.failure;
    double top = 0.0;
    for (const Vec3& X : result.mesh->X) top = std::max(top, X.z());
    if (k % 11 == 0) printf("%d: fresh %d residue %g correction %g facets %zu top %.6f cz %.9f\n", k, result.fresh_facets, result.volume_residue, result.correction_mm, result.mesh->skin.size(), top, mesh::volume_centroid(*result.mesh).z());
    now = *result.mesh;
  }
  EXPECT_NEAR(mesh::volume(now), volume, 1e-9 * volume);
  }
}

}  // namespace
}  // namespace reye
