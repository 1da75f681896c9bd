#include <gtest/gtest.h>

#include <numbers>

#include "adapt/solid/skin_locator.hpp"
#include "adapt/solid/solid_remesh.hpp"
#include "adapt/solid/solid_triggers.hpp"
#include "adapt/solid_worn.hpp"
#include "mesh/solid/facet_control_points.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::evolve_solid;
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

/// A ball with a cap worn by a third of its height, its skin alone.
mesh::SolidMesh worn_ball(SolidKind kind, int n) {
  const auto m = skin_alone(ball(kind, n, 1.0));
  const auto cap = [](const Vec3& X) { return 0.3 * std::max(0.0, X.z() - 0.8); };
  return *adapt::evolve_solid(shared(m), m, {worn_by(m, "ball", cap)}, 1e-3).mesh;
}

/// Largest distance of nodes from a surface of the face "ball".
double distance_from(const mesh::SolidMesh& surface, const mesh::SolidMesh& m) {
  const mortar::Skin skin{surface.skin, mesh::control_points(surface.skin, surface.X)};
  const adapt::SkinLocator locator(skin);
  double largest = 0.0;
  for (const Vec3& X : m.X) largest = std::max(largest, locator.nearest(X).distance);
  return largest;
}

// A worn cap, 0.06 deep, drawn again a hundred times without wear must keep its volume and its shape: no node leaves
// the surface by more than a chord leaves its arc.
TEST(SolidRemesh, AHundredTimesWithoutWear) {
  for (auto kind : {SolidKind::tet4, SolidKind::tet10}) {
    const int n = kind == SolidKind::tet4 ? 12 : 6;
    const double sagitta = std::pow(std::numbers::pi / 2.0 / n, 2) / 8.0;
    const auto first = worn_ball(kind, n);
    auto now = first, early = first;
    for (int k = 0; k < 100; ++k) {
      const auto result = remesh_solid(now, before_wear_above(now, 0.7), {.scar = ScarRoute::redraw});
      ASSERT_TRUE(result.mesh) << result.failure;
      EXPECT_GT(result.fresh_facets, 50);
      now = *result.mesh;
      if (k == 20) early = now;
    }
    EXPECT_NEAR(mesh::volume(now), mesh::volume(first), 1e-9);
    EXPECT_NEAR(mesh::volume_centroid(now).z(), mesh::volume_centroid(first).z(), 1e-5);
    EXPECT_LT(distance_from(first, now), 2.0 * sagitta);
    EXPECT_LT(distance_from(early, now), 0.25 * sagitta);
  }
}

// Edges that slide along a curved face squeeze its facets: those are drawn again, and the face stays where it was.
TEST(SolidRemesh, MakesRoomForAnEdgeThatSlides) {
  const auto pin = support::block(SolidKind::tet4, {6, 6, 6}, Vec3(2, 2, 2), [](const Vec3& X) {
    const Vec3 p(X.x() - 1.0, X.y() - 1.0, 0.0);
    const double largest = p.cwiseAbs().maxCoeff();
    return Vec3((largest > 0.0 ? Vec3(largest * p.normalized()) : p) + X.z() * Vec3::UnitZ());
  });
  auto born = pin;
  born.faces = {{"z1", pin.faces.at("z1")}};
  for (auto& facet : born.skin)
    if (std::abs(mesh::facet_normal(born.X, facet).z()) < 0.5) facet.group = 99;
  const auto start = born;
  auto now = shared(born);
  for (int step = 0; step < 14; ++step) {
    const auto worn = evolve_solid(now, born, {worn_by(*now, "z1", [](const Vec3&) { return 0.05; })}, 1e-3);
    ASSERT_TRUE(worn.mesh) << step << worn.failure;
    now = worn.mesh;
    if (step % 2 == 0) continue;
    const auto fresh = remesh_solid(*now, born);
    ASSERT_TRUE(fresh.mesh) << fresh.failure;
    EXPECT_GT(fresh.fresh_facets, 0);
    born = *fresh.mesh;
    now = fresh.mesh;
  }
  EXPECT_NEAR(lost(start, *now), 14 * 0.05 * mesh::area(start.X, mesh::facets_of(start, "z1")), 2e-2);
  for (const auto& facet : now->skin)
    for (int a = 0; facet.group == 99 && a < 3; ++a) EXPECT_NEAR(now->X[facet.nodes[a]].head<2>().norm(), 1.0, 0.02);
}

// What cannot be remeshed must be refused with the reason: hexahedra, and a surface that crosses itself.
TEST(SolidRemesh, Refusals) {
  const auto hex = support::block(SolidKind::hex8, {2, 2, 2}, Vec3(1, 1, 1));
  EXPECT_NE(remesh_solid(hex, hex).failure.find("hexahedra"), std::string::npos);
  auto crossed = support::block(SolidKind::tet4, {2, 2, 2}, Vec3(1, 1, 1));
  const auto born = crossed;
  for (int node : mesh::nodes_of(mesh::facets_of(crossed, "z1")))
    if (crossed.X[node].x() == 0.5 && crossed.X[node].y() == 0.5) crossed.X[node].z() = -0.5;
  const auto result = remesh_solid(crossed, born, {.scar = ScarRoute::keep});
  EXPECT_FALSE(result.mesh);
  EXPECT_NE(result.failure, "");
}

// The reasons for a remesh must name what exceeds its bound, where, and by what; a mesh as it was made has none.
TEST(SolidTriggers, NameWhatIsWorn) {
  const auto [born, worn] = dented(SolidKind::tet4, 8, 0.05);
  EXPECT_EQ(adapt::why_remesh(born, born, {}), "");
  EXPECT_EQ(adapt::why_remesh(*worn, born, {}), "");
  const std::string wear = adapt::why_remesh(*worn, born, {.wear_fraction = 0.1});
  EXPECT_NE(wear.find("wear at (0.5, 0.5, 0.4"), std::string::npos) << wear;
  EXPECT_NE(wear.find("times the height of the element below, above 0.1"), std::string::npos) << wear;
  EXPECT_NEAR(adapt::measure(*worn, born).wear_fraction.value, 0.05 / 0.125, 0.01);
  const auto [flat, deep] = dented(SolidKind::tet10, 8, 0.25, 8);
  const std::string poor = adapt::why_remesh(*deep, flat, {.min_quality = 0.4, .wear_fraction = 10.0});
  EXPECT_NE(poor.find("has shape"), std::string::npos) << poor;
}

}  // namespace
}  // namespace reye
