#include <gtest/gtest.h>

#include <set>

#include "adapt/curved.hpp"
#include "adapt/shape/crossing.hpp"
#include "adapt/shape/relocation.hpp"
#include "adapt/shape/shape_step.hpp"
#include "adapt/shape/triggers.hpp"
#include "mesh/quality.hpp"

/// Shape steps of meshes of second order, whose outline is made of quadratic edges.
namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::evolve;
using adapt::WornBoundary;
using base::Analysis;
using body::make_shape;
using mesh::QuadraticEdge;

void expect_exact_strip(const Mesh& mesh, const WornBoundary& worn, Analysis analysis = Analysis::plane_strain) {
  const auto result = evolve(make_shape(mesh), analysis, {worn});
  ASSERT_TRUE(result.shape) << result.failure;
  EXPECT_NEAR(result.removed / curved::sum(worn), 1.0, 1e-12);
  EXPECT_NEAR(curved::lost(mesh, result.shape->mesh, analysis) / curved::sum(worn), 1.0, 1e-12);
  EXPECT_NO_THROW(mesh::check(result.shape->mesh));
}

Mesh second_order_block(CellKind kind = CellKind::quad8) {
  return rectangle({.size = {2.0, 1.0}, .nx = 10, .ny = 4, .kind = kind});
}

/// A dent that ends at vertices of `second_order_block`, narrower than its face.
double vertex_dent(Vec2 x) { return 0.015 * std::max(0.0, 1.0 - std::pow((x.x() - 1.0) / 0.6, 2)); }

/// Position of a middle node along the chord of its edge.
double along_chord(const QuadraticEdge& e) {
  const Vec2 chord = e.last - e.first;
  return (e.mid - e.first).dot(chord) / chord.squaredNorm();
}

// The strip between the quadratic edges of the old and the new outline has exactly the removed volume: a flat face,
// also turned against the axes and made of triangles.
TEST(SecondOrderStrip, FlatFace) {
  expect_exact_strip(second_order_block(), curved::worn_by(second_order_block(), "top", vertex_dent));
  const auto mesh = turned(second_order_block(CellKind::tri6), 0.7);
  expect_exact_strip(mesh, curved::worn_by(mesh, "top", [](Vec2 x) { return 0.01 * (1.2 + std::sin(5.0 * x.x())); }));
}

// The strip is exact on a convex and on a hollow arc of few edges.
TEST(SecondOrderStrip, CurvedFaces) {
  const auto mesh = ring({.inner = 1.0, .outer = 2.0, .around = 6, .kind = CellKind::quad8});
  const auto profile = [](Vec2 x) { return 0.01 * (1.0 + x.x() * x.y()); };
  expect_exact_strip(mesh, curved::worn_by(mesh, "right", profile));
  expect_exact_strip(mesh, curved::worn_by(mesh, "left", profile));
}

// Volumes of revolution are exact: faces from the axis on, along it, and curved in the meridian.
TEST(SecondOrderStrip, Axisymmetric) {
  const auto even = [](Vec2) { return 0.015; };
  const auto leaning = [](Vec2 x) { return 0.01 * (1.0 + x.y()); };
  for (double start : {0.0, 0.5}) {
    auto mesh = second_order_block();
    for (Vec2& x : mesh.X) x.x() += start;
    expect_exact_strip(mesh, curved::worn_by(mesh, "top", even, Analysis::axisymmetric), Analysis::axisymmetric);
    expect_exact_strip(mesh, curved::worn_by(mesh, "right", leaning, Analysis::axisymmetric), Analysis::axisymmetric);
  }
  const auto mesh = ring({.inner = 1.0, .outer = 2.0, .around = 6, .kind = CellKind::tri6});
  expect_exact_strip(mesh, curved::worn_by(mesh, "right", leaning, Analysis::axisymmetric), Analysis::axisymmetric);
}

// A boundary that ends within a smooth face loses its volume too, and no more.
TEST(SecondOrderStrip, ChainEndWithinAFace) {
  auto mesh = second_order_block();
  const auto top = mesh.boundaries.at("top")[0];
  mesh.boundaries["middle"] = {{top.begin() + 4, top.begin() + 13}};
  expect_exact_strip(mesh, curved::worn_by(mesh, "middle", [](Vec2) { return 0.004; }));
}

// A parabola of depth is a parabola in the worn outline, on the whole curve and without any correction; corners slide.
TEST(SecondOrderStrip, ParabolaIsExact) {
  const auto mesh = second_order_block();
  const auto depth = [](Vec2 x) { return 0.008 * (1.0 + x.x() * (2.0 - x.x())); };
  const auto result = evolve(make_shape(mesh), Analysis::plane_strain, {curved::worn_by(mesh, "top", depth)});
  ASSERT_TRUE(result.shape) << result.failure;
  EXPECT_NEAR(result.theta, 1.0, 1e-13);
  EXPECT_EQ(result.parts, 1);
  const auto& top = mesh.boundaries.at("top")[0];
  for (std::size_t i = 0; i + 2 < top.size(); i += 2)
    for (double xi : {-1.0, -0.4, 0.0, 0.7, 1.0}) {
      const Vec2 x = curved::edge_at(result.shape->mesh, top, i).at(xi);
      EXPECT_NEAR(x.x(), curved::edge_at(mesh, top, i).at(xi).x(), 1e-14);
      EXPECT_NEAR(x.y(), 1.0 - depth(x), 1e-14);
    }
}

/// Largest error of the depth on an arc of radius 2 with n edges, in parts of the depth.
double depth_error(int n) {
  const auto mesh = ring({.inner = 1.0, .outer = 2.0, .across = 2, .around = n, .kind = CellKind::quad8});
  const double scale = 1e-5;
  const auto depth = [=](Vec2 x) { return scale * (1.5 + std::sin(4.0 * std::atan2(x.y(), x.x()))); };
  const auto result = evolve(make_shape(mesh), Analysis::plane_strain, {curved::worn_by(mesh, "right", depth)});
  EXPECT_TRUE(result.shape) << result.failure;
  const auto& arc = mesh.boundaries.at("right")[0];
  double worst = 0.0;
  for (std::size_t i = 0; i + 2 < arc.size(); i += 2)
    for (double xi = -1.0; xi < 1.1; xi += 0.25) {
      const Vec2 x = curved::edge_at(mesh, arc, i).at(xi);
      const Vec2 moved = curved::edge_at(result.shape->mesh, arc, i).at(xi) - x;
      worst = std::max(worst, std::abs(-moved.dot(x.normalized()) - depth(x)) / scale);
    }
  return worst;
}

// The depth on a circle is right to third order in the length of the edges.
TEST(SecondOrderStrip, DepthOnACircle) {
  const double coarse = depth_error(8), fine = depth_error(32);
  EXPECT_GT(std::log(coarse / fine) / std::log(4.0), 2.8);
  EXPECT_LT(fine, 2e-3);
}

// A thousand small steps lose together what they lose one by one.
TEST(SecondOrderStrip, TinyStepsAddUp) {
  for (const Analysis analysis : {Analysis::plane_strain, Analysis::axisymmetric}) {
    const auto mesh = ring({.inner = 1.0, .outer = 2.0, .across = 2, .around = 6, .kind = CellKind::quad8});
    auto shape = make_shape(mesh);
    double asked = 0.0, removed = 0.0;
    adapt::RelocationCache cache;
    for (int step = 0; step < 1000; ++step) {
      const auto worn = curved::worn_by(
          shape->mesh, "right", [&](Vec2 x) { return 1e-6 * (1.5 + std::sin(3.0 * x.x() + step)); }, analysis);
      const auto result = evolve(shape, analysis, {worn}, {}, &cache);
      ASSERT_TRUE(result.shape) << result.failure;
      asked += curved::sum(worn);
      removed += result.removed;
      shape = result.shape;
    }
    EXPECT_NEAR(removed, asked, 1e-11 * asked);
    EXPECT_NEAR(curved::lost(mesh, shape->mesh, analysis), asked, 1e-11 * asked);
  }
}

// Wear that is deep against its edges is taken in parts, and loses the same volume.
TEST(SecondOrderStrip, DeepWearIsTakenInParts) {
  const auto mesh = rectangle({.size = {2.0, 1.0}, .nx = 20, .ny = 2, .kind = CellKind::quad8});
  const auto worn = curved::worn_by(mesh, "top", [](Vec2 x) { return 7.0 * vertex_dent(x); });
  const auto result = evolve(make_shape(mesh), Analysis::plane_strain, {worn});
  ASSERT_TRUE(result.shape) << result.failure;
  EXPECT_GE(result.parts, 8);
  EXPECT_NEAR(result.removed / curved::sum(worn), 1.0, 1e-12);
}

// A middle node near an end of its edge comes back to the middle fifth of the chord when its edge wears, for no volume.
TEST(SecondOrderStrip, MiddleNodesStayInTheMiddle) {
  auto mesh = second_order_block();
  const auto& top = mesh.boundaries.at("top")[0];
  for (std::size_t i = 0; i + 2 < top.size(); i += 2)
    mesh.X[top[i + 1]] = 0.62 * mesh.X[top[i]] + 0.38 * mesh.X[top[i + 2]];
  const auto worn = curved::worn_by(mesh, "top", [](Vec2 x) { return 0.01 * (1.0 + x.x()); });
  const auto result = evolve(make_shape(mesh), Analysis::plane_strain, {worn});
  ASSERT_TRUE(result.shape) << result.failure;
  EXPECT_NEAR(result.removed / curved::sum(worn), 1.0, 1e-12);
  for (std::size_t i = 0; i + 2 < top.size(); i += 2) {
    const double s = along_chord(curved::edge_at(result.shape->mesh, top, i));
    EXPECT_GE(s, 0.4 - 1e-6);
    EXPECT_LE(s, 0.6 + 1e-6);
  }
}

// Inner edges that were straight stay so, their middle nodes half way between their ends, while the inside follows.
TEST(SecondOrderInterior, InnerEdgesStayStraight) {
  for (const CellKind kind : {CellKind::tri6, CellKind::quad8}) {
    const auto mesh = rectangle({.size = {2.0, 1.0}, .nx = 10, .ny = 4, .kind = kind, .distortion = 0.4});
    const auto worn = curved::worn_by(mesh, "top", [](Vec2 x) { return 0.02 * (1.2 + std::sin(5.0 * x.x())); });
    const auto result = evolve(make_shape(mesh), Analysis::plane_strain, {worn});
    ASSERT_TRUE(result.shape) << result.failure;
    const auto& now = result.shape->mesh;
    const std::set<int> outline(mesh.outline[0].begin(), mesh.outline[0].end());
    const int n = mesh::corners(kind);
    int moved = 0;
    for (const auto& cell : now.cells)
      for (int k = 0; k < n; ++k) {
        if (outline.contains(cell[n + k])) continue;
        const Vec2 middle = 0.5 * (now.X[cell[k]] + now.X[cell[(k + 1) % n]]);
        EXPECT_NEAR((now.X[cell[n + k]] - middle).norm(), 0.0, 1e-14);
        moved += now.X[cell[n + k]] != mesh.X[cell[n + k]];
      }
    EXPECT_GT(moved, 50);
    EXPECT_GT(result.min_quality, 0.8 * mesh::poorest_cell(mesh).scaled_jacobian);
  }
}

// Nodes of a straight free side, middle nodes too, follow its sliding corner in proportion to their place.
TEST(SecondOrderInterior, SidesFollowTheirCorner) {
  const auto mesh = second_order_block();
  const auto worn = curved::worn_by(mesh, "top", [](Vec2) { return 0.02; });
  const auto result = evolve(make_shape(mesh), Analysis::plane_strain, {worn});
  ASSERT_TRUE(result.shape) << result.failure;
  for (int node : mesh::nodes_of(mesh.boundaries.at("right"))) {
    EXPECT_NEAR(result.shape->mesh.X[node].y(), 0.98 * mesh.X[node].y(), 1e-14);
    EXPECT_EQ(result.shape->mesh.X[node].x(), 2.0);
  }
}

// Curves that cross are found although the chords between their nodes do not cross.
TEST(SecondOrderOutline, CrossingOfCurves) {
  Mesh mesh;
  mesh.kind = CellKind::quad8;
  mesh.X = {{-1, 0}, {0, -0.5}, {1, 0}, {0, 0.5}, {-0.6, 0}, {0, -0.9}, {0.6, 0}, {0, -1}};  // a lens, a dish below
  mesh.outline = {{0, 1, 2, 3, 0}, {4, 5, 6, 7, 4}};
  // The rim of the dish at x = +-0.6, where the lens is lower than the chords from (+-1, 0) to (0, -0.5).
  const double chord = -0.5 * (1.0 - 0.6), curve = -0.5 * (1.0 - 0.36);
  mesh.X[4].y() = mesh.X[6].y() = 0.5 * (chord + curve);
  EXPECT_TRUE(adapt::find_crossing(mesh));
  mesh.X[4].y() = mesh.X[6].y() = curve - 0.02;
  EXPECT_FALSE(adapt::find_crossing(mesh));
}

// The length of a facet is that between its vertices: a middle node that moves along its edge asks for no new mesh.
TEST(SecondOrderTriggers, FacetsAreWholeEdges) {
  const auto mesh = second_order_block();
  body::Shape moved = *make_shape(mesh);
  const auto& top = mesh.boundaries.at("top")[0];
  moved.mesh.X[top[1]] = 0.6 * mesh.X[top[0]] + 0.4 * mesh.X[top[2]];
  EXPECT_NEAR(adapt::measure(moved, moved.mesh.X).size_ratio.value, 1.0, 1e-12);
  moved.mesh.X[top[2]] = 0.5 * (mesh.X[top[2]] + mesh.X[top[4]]);
  EXPECT_NEAR(adapt::measure(moved, moved.mesh.X).size_ratio.value, 2.0, 1e-12);
}

}  // namespace
}  // namespace reye
