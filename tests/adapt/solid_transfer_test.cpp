#include <gtest/gtest.h>

#include "adapt/solid/skin_locator.hpp"
#include "adapt/solid/skin_transfer.hpp"
#include "adapt/solid_worn.hpp"
#include "mesh/solid/facet_control_points.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::SurfaceField;
using adapt::SurfaceKind;
using mesh::SolidKind;

/// A face as a surface of its own numbering, control points in place of mid nodes.
mortar::Skin skin_of_face(const mesh::SolidMesh& m, const std::string& face) {
  mortar::Skin skin{mesh::facets_of(m, face), {}};
  const auto nodes = mesh::nodes_of(skin.facets);
  const auto control = mesh::control_points(skin.facets, m.X);
  for (int node : nodes) skin.x.push_back(control[node]);
  for (auto& facet : skin.facets)
    for (int a = 0; a < facet.count(); ++a)
      facet.nodes[a] = static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), facet.nodes[a]) - nodes.begin());
  return skin;
}

mesh::SolidMesh bent_block(SolidKind kind, int n) { return support::block(kind, {n, n, 1}, Vec3(1, 1, 1), distort); }

// The nearest place to a point of a surface must be that point, and to one above it the foot of its normal.
TEST(SolidLocator, FindsFeetOfNormals) {
  for (auto kind : solid_kinds) {
    const auto skin = skin_of_face(bent_block(kind, 3), "z1");
    const adapt::SkinLocator locator(skin);
    for (int f = 0; f < static_cast<int>(skin.facets.size()); ++f) {
      const base::Vec2 xi(0.31, 0.24);
      const Vec3 at = adapt::place_on(skin, f, xi);
      const double h = 1e-6;
      const Vec3 r = adapt::place_on(skin, f, xi + h * base::Vec2::UnitX()) - at,
                 s = adapt::place_on(skin, f, xi + h * base::Vec2::UnitY()) - at;
      const auto foot = locator.nearest(at + 0.01 * r.cross(s).normalized());
      EXPECT_EQ(foot.facet, f);
      EXPECT_NEAR(foot.distance, 0.01, 1e-8);
      EXPECT_LT((foot.at - at).norm(), 1e-5);
      EXPECT_LT(locator.nearest(at).distance, 1e-12);
    }
  }
}

// Onto the same surface every field must come to itself, to round-off.
TEST(SolidTransfer, OntoItself) {
  for (auto kind : solid_kinds) {
    const auto skin = skin_of_face(bent_block(kind, 3), "z1");
    std::vector<double> values, labels;
    for (std::size_t j = 0; j < skin.x.size(); ++j) {
      values.push_back(1.0 + std::sin(7.0 * static_cast<double>(j)));
      labels.push_back(static_cast<double>(j % 3));
    }
    const auto result = adapt::carry(skin,
                                     {{"p", SurfaceKind::interpolated, values},
                                      {"V", SurfaceKind::summed, values},
                                      {"status", SurfaceKind::nearest, labels}},
                                     skin);
    for (std::size_t j = 0; j < skin.x.size(); ++j) {
      EXPECT_NEAR(result.fields[0].values[j], values[j], 1e-7);
      EXPECT_NEAR(result.fields[1].values[j], values[j], 1e-7);
      EXPECT_EQ(result.fields[2].values[j], labels[j]);
    }
    EXPECT_LT(result.largest_distance, 1e-12);
  }
}

// Onto another mesh of a flat face affine fields must be exact, an even density too, and sums kept to round-off.
TEST(SolidTransfer, AffineFieldsAndSums) {
  for (auto kind : solid_kinds) {
    const auto from = skin_of_face(support::block(kind, {5, 4, 1}, Vec3(1, 1, 1)), "z1"),
               to = skin_of_face(support::block(kind, {3, 7, 1}, Vec3(1, 1, 1)), "z1");
    const auto affine = [](const Vec3& X) { return 2.0 + X.x() - 3.0 * X.y(); };
    std::vector<double> values;
    for (const Vec3& X : from.x) values.push_back(affine(X));
    const auto even = nodal_areas(support::block(kind, {5, 4, 1}, Vec3(1, 1, 1)), "z1"),
               evenly = nodal_areas(support::block(kind, {3, 7, 1}, Vec3(1, 1, 1)), "z1");
    auto scar = even;
    for (std::size_t j = 0; j < scar.size(); ++j) scar[j] *= std::max(0.0, 0.3 - from.x[j].x());
    const auto result = adapt::carry(from,
                                     {{"p", SurfaceKind::interpolated, values},
                                      {"V", SurfaceKind::summed, even},
                                      {"scar", SurfaceKind::summed, scar}},
                                     to);
    double before = 0.0, after = 0.0;
    for (std::size_t k = 0; k < to.x.size(); ++k) {
      EXPECT_NEAR(result.fields[0].values[k], affine(to.x[k]), 1e-12);
      EXPECT_NEAR(result.fields[1].values[k], evenly[k], 1e-12);
      EXPECT_GE(result.fields[2].values[k], 0.0);
      after += result.fields[2].values[k];
    }
    for (double v : scar) before += v;
    EXPECT_NEAR(after, before, 1e-15);
  }
}

// A sum at one node alone, which coarse points do not resolve, must be given to the facet it lies on.
TEST(SolidTransfer, ASumAtOneNode) {
  const auto from = skin_of_face(support::block(SolidKind::tet4, {12, 12, 1}, Vec3(1, 1, 1)), "z1"),
             to = skin_of_face(support::block(SolidKind::tet4, {2, 2, 1}, Vec3(1, 1, 1)), "z1");
  std::vector<double> one(from.x.size(), 0.0);
  for (std::size_t j = 0; j < one.size(); ++j)
    if ((from.x[j] - Vec3(0.25, 0.75, 1.0)).norm() < 1e-9) one[j] = 1.0;
  const auto result = adapt::carry(from, {{"V", SurfaceKind::summed, one}}, to);
  double sum = 0.0;
  for (double v : result.fields[0].values) sum += v;
  EXPECT_NEAR(sum, 1.0, 1e-15);
}

}  // namespace
}  // namespace reye
