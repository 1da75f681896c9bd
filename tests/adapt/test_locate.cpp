#include <gtest/gtest.h>

#include "adapt/fields.hpp"
#include "adapt/transfer/locate.hpp"
#include "base/errors.hpp"
#include "fem/element.hpp"
#include "mesh/quality.hpp"
#include "support/meshes.hpp"
#include "support/surfaces.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::Locator;

/// A unit square whose inner nodes are thrown about by up to `share` of the spacing.
Mesh shaken(double share, CellKind kind = CellKind::quad4, int n = 30) {
  auto mesh = rectangle({.nx = n, .ny = n, .kind = kind});
  std::mt19937 random(7);
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < n; ++i) mesh.X[j * (n + 1) + i] += share / n * Vec2(noise(random), noise(random));
  return mesh;
}

Vec2 weighted(const Mesh& m, int cell, const mesh::NodeValues& weights) {
  Vec2 x = Vec2::Zero();
  for (int a = 0; a < mesh::nodes_per_cell(m.kind); ++a) x += weights[a] * m.X[m.cells[cell][a]];
  return x;
}

Vec2 mapped_from(const Mesh& m, int cell, const Vec2& xi) {
  return weighted(m, cell, fem::shape_functions(m.kind, xi));
}

double quality(const Mesh& m, int cell) { return mesh::scaled_jacobian(m.X, m.kind, m.cells[cell]); }

int poor_cells(const Mesh& m, double bound) {
  int count = 0;
  for (int cell = 0; cell < m.cell_count(); ++cell) count += quality(m, cell) < bound;
  return count;
}

Vec2 inside_reference(CellKind kind, std::mt19937& random) {
  const double s = 0.5 + 0.49 * noise(random), t = 0.5 + 0.49 * noise(random);
  if (kind == CellKind::quad4) return {2.0 * s - 1.0, 2.0 * t - 1.0};
  return {s * (1.0 - t), t};
}

// The map of a sound cell is inverted: 1e4 points made from a cell and xi give back both, however poor the cells are.
TEST(Locator, CellAndReferencePointComeBack) {
  for (auto kind : linear_kinds) {
    const auto mesh = shaken(0.3, kind);
    const Locator locator(mesh);
    ASSERT_GT(poor_cells(mesh, 0.15), 1);
    ASSERT_EQ(poor_cells(mesh, 0.0), 0);  // cells would lie on one another
    std::mt19937 random(1);
    int tried = 0;
    for (int k = 0; k < 10000; ++k) {
      const int cell = static_cast<int>(random() % mesh.cells.size());
      if (quality(mesh, cell) < 0.02) continue;  // xi itself is ill posed there
      const Vec2 xi = inside_reference(kind, random);
      const auto place = locator.find(mapped_from(mesh, cell, xi));
      EXPECT_EQ(place.cell, cell);
      EXPECT_NEAR((place.xi - xi).norm(), 0.0, 1e-11);
      EXPECT_LT(place.distance, 1e-15);
      ++tried;
    }
    EXPECT_GT(tried, 9500);
  }
}

// On meshes thrown about until cells are concave and inverted, every one of 1e4 points is a convex mean of the nodes
// of its cell, and in sound cells x(xi) is the point.
TEST(Locator, RuinedMeshesStillReproduceThePoint) {
  for (auto kind : linear_kinds)
    for (double share : {0.45, 0.6, 0.9}) {
      const auto mesh = shaken(share, kind);
      const Locator locator(mesh);
      ASSERT_GT(poor_cells(mesh, share > 0.5 ? 0.0 : 0.05), 3);
      std::mt19937 random(2);
      int unmapped = 0;
      for (int k = 0; k < 10000; ++k) {
        const Vec2 p = anywhere(random);
        const auto place = locator.find(p);
        ASSERT_NEAR((weighted(mesh, place.cell, place.weights) - p).norm(), 0.0, 1e-14);
        ASSERT_NEAR(place.weights.sum(), 1.0, 1e-14);
        ASSERT_GE(place.weights.minCoeff(), 0.0);
        ASSERT_LT(place.distance, 1e-15);
        const bool reproduced = (mapped_from(mesh, place.cell, place.xi) - p).norm() < 1e-14;
        unmapped += !reproduced;
        ASSERT_TRUE(reproduced || quality(mesh, place.cell) <= 0.0);
      }
      EXPECT_LT(unmapped, 10);
    }
}

// A cell with a reflex corner, a cell squeezed to a triangle and a cell squeezed to nothing beside a sound one do not
// disturb: points in them are reproduced.
TEST(Locator, ConcaveAndFlatCells) {
  Mesh dart;
  dart.X = {{0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}};
  dart.cells = {{0, 1, 2, 3}};
  Mesh wedge = dart;
  wedge.X[2] = {0.5, 0.5};
  Mesh with_flat = wedge;
  with_flat.X.push_back({0.25, 0.75});
  with_flat.cells.push_back({3, 4, 2, 4});
  for (const auto& mesh : {dart, wedge, with_flat}) {
    const Locator locator(mesh);
    for (const Vec2& p : {Vec2(0.1, 0.1), Vec2(0.19, 0.2), Vec2(0.5, 0.05), Vec2(0.02, 0.9), Vec2(0.2, 0.19)}) {
      const auto place = locator.find(p);
      EXPECT_NEAR((mapped_from(mesh, place.cell, place.xi) - p).norm(), 0.0, 1e-14);
      EXPECT_NEAR((weighted(mesh, place.cell, place.weights) - p).norm(), 0.0, 1e-14);
    }
  }
}

// In a cell that crosses itself, where no map exists, the weights are barycentric: the point is kept, xi need not map.
TEST(Locator, CrossedCell) {
  Mesh bow;
  bow.X = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  bow.cells = {{0, 1, 2, 3}};
  const Locator locator(bow);
  std::mt19937 random(8);
  for (int k = 0; k < 1000; ++k) {
    const Vec2 p = anywhere(random);
    const auto place = locator.find(p);
    EXPECT_NEAR((weighted(bow, 0, place.weights) - p).norm(), place.distance, 1e-15);
    EXPECT_NEAR(place.weights.sum(), 1.0, 1e-15);
    EXPECT_LE(place.xi.cwiseAbs().maxCoeff(), 1.0);
  }
}

// A node is found as itself: one weight of 1, the others 0, even in a degraded mesh.
TEST(Locator, NodesAreFoundToTheBit) {
  for (auto kind : linear_kinds) {
    const auto mesh = shaken(0.9, kind);
    const Locator locator(mesh);
    for (int node = 0; node < mesh.node_count(); ++node) {
      const auto place = locator.find(mesh.X[node]);
      for (int a = 0; a < mesh::nodes_per_cell(kind); ++a)
        EXPECT_EQ(place.weights[a], mesh.cells[place.cell][a] == node ? 1.0 : 0.0);
    }
  }
}

// A point outside, beside an edge or beyond a corner, takes the closest point of the mesh and says how far that is.
TEST(Locator, PointsOutsideTakeTheClosestPoint) {
  for (auto kind : linear_kinds) {
    const auto mesh = shaken(0.3, kind);
    const Locator locator(mesh);
    std::mt19937 random(3);
    for (int k = 0; k < 1000; ++k) {
      const Vec2 p = 1.5 * (anywhere(random) - Vec2(0.5, 0.5)) + Vec2(0.5, 0.5);
      const Vec2 closest = p.cwiseMax(0.0).cwiseMin(1.0);
      const auto place = locator.find(p);
      EXPECT_NEAR(place.distance, (p - closest).norm(), 1e-15);
      EXPECT_NEAR((mapped_from(mesh, place.cell, place.xi) - closest).norm(), 0.0, 1e-14);
    }
  }
}

// Far from the origin, with small cells, nothing is lost but the round-off of the coordinates.
TEST(Locator, SmallCellsFarAway) {
  const auto mesh = mapped(shaken(0.3), [](Vec2 x) { return Vec2(Vec2(500.0, -300.0) + 0.01 * x); });
  const Locator locator(mesh);
  std::mt19937 random(4);
  for (int k = 0; k < 1000; ++k) {
    const Vec2 p = Vec2(500.0, -300.0) + 0.01 * anywhere(random);
    const auto place = locator.find(p);
    EXPECT_NEAR((mapped_from(mesh, place.cell, place.xi) - p).norm(), 0.0, 3e-13);
  }
}

// A mesh without area cannot be searched and says so.
TEST(Locator, NoAreaIsAnError) {
  Mesh flat;
  flat.kind = CellKind::tri3;
  flat.X = {{0, 0}, {1, 1}, {2, 2}};
  flat.cells = {{0, 1, 2, -1}};
  EXPECT_THROW(Locator{flat}, base::MeshError);
  EXPECT_THROW(Locator{Mesh{}}, base::MeshError);
}

// In curved cells of second order too the map is inverted, also between a curved edge and its chords.
TEST(Locator, CurvedCells) {
  for (auto kind : {CellKind::tri6, CellKind::quad8}) {
    const auto mesh = ring({1.0, 2.0, 1.5, 3, 4, kind});
    const Locator locator(mesh);
    std::mt19937 random(5);
    for (int k = 0; k < 5000; ++k) {
      const int cell = static_cast<int>(random() % mesh.cells.size());
      const Vec2 xi = inside_reference(kind == CellKind::tri6 ? CellKind::tri3 : CellKind::quad4, random);
      const auto place = locator.find(mapped_from(mesh, cell, xi));
      ASSERT_EQ(place.cell, cell);
      ASSERT_NEAR((place.xi - xi).norm(), 0.0, 1e-11);
      ASSERT_EQ(place.distance, 0.0);
      ASSERT_EQ(place.weights, fem::shape_functions(kind, place.xi));
    }
    // Off the body the place is the foot on the curve.
    for (double angle : {0.13, 0.7, 1.31})
      for (double radius : {0.9, 2.2}) {
        const Vec2 p = radius * Vec2(std::cos(angle), std::sin(angle));
        const auto place = locator.find(p);
        EXPECT_NEAR(place.distance, radius < 1.0 ? 0.1 : 0.2, 1e-4);
        EXPECT_NEAR((weighted(mesh, place.cell, place.weights) - p).norm(), place.distance, 1e-14);
      }
  }
}

}  // namespace
}  // namespace reye
