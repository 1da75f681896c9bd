#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapt/drawn.hpp"
#include "adapt/redraw/correct.hpp"
#include "mesh/quality.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::remesh;
using testing::HasSubstr;

base::Points outline_points(const Mesh& m) {
  base::Points points;
  for (const auto& loop : m.outline)
    for (int node : loop) points.push_back(m.X[node]);
  return points;
}

// Without wear a remesh gives the same outline, node for node.
TEST(Remesh, WithoutWear) {
  for (auto kind : {CellKind::quad4, CellKind::tri3}) {
    const auto shape = shape_of(half_disc({.kind = kind}));
    const auto fresh = remesh(shape, plane);
    ASSERT_TRUE(fresh.shape) << fresh.failure;
    EXPECT_TRUE(outline_points(fresh.shape->mesh) == outline_points(shape->mesh));
    EXPECT_EQ(fresh.largest_correction_mm, 0.0);
  }
}

// A worn block keeps its content to the round-off of its size, its names, and the kind of its cells.
TEST(Remesh, ContentOfAWornBlock) {
  for (auto kind : {CellKind::quad4, CellKind::tri3})
    for (auto analysis : {plane, Analysis::axisymmetric}) {
      const bool ring = analysis == Analysis::axisymmetric;
      const auto born = shape_of(block_drawing({kind, 0.1, ring}));
      const auto shape = wear(born, "top", scar(0.02, 1.0, 0.55), analysis);
      const double removed = lost(born->mesh, shape->mesh, analysis);
      const auto fresh = remesh(shape, analysis, {{{}, {1.0, 0.98}, 0.8, 0.1, 0.03}});
      ASSERT_TRUE(fresh.shape) << fresh.failure;
      EXPECT_GT(std::abs(fresh.area_residue), 1e-6 * removed);  // there was something to correct
      EXPECT_NEAR(lost(born->mesh, fresh.shape->mesh, analysis), removed, ring ? 2e-14 : 2e-15);
      EXPECT_LT(fresh.largest_correction_mm, 1e-3);
      EXPECT_EQ(fresh.shape->mesh.kind, kind);
      EXPECT_EQ(fresh.shape->mesh.boundaries.size(), 4u);
      EXPECT_NO_THROW(mesh::check(fresh.shape->mesh));
      EXPECT_GT(fresh.mesh_seconds, 0.0);
    }
}

// On a worn disc the worn run keeps its content; the circles on both sides are only redivided.
TEST(Remesh, ContentOfAWornRunOnADisc) {
  const auto shape = wear(shape_of(half_disc({.far_size = 0.05})), "round", scar(0.01, 0.0, 0.3));
  const auto fresh = remesh(shape, plane, {{{}, {0.0, 1.0}, 0.4, 0.1, 0.011}});
  ASSERT_TRUE(fresh.shape) << fresh.failure;
  const auto run = [](const body::Shape& s, const cad::Edge& edge) {
    base::Points points;
    const auto& chain = s.mesh.boundaries.at("round")[0];
    const auto first = std::find_if(chain.begin(), chain.end(), [&](int n) { return s.mesh.X[n] == edge.first(); });
    const auto last = std::find_if(chain.begin(), chain.end(), [&](int n) { return s.mesh.X[n] == edge.last(); });
    for (auto n = first; n <= last; ++n) points.push_back(s.mesh.X[*n]);
    return points;
  };
  const auto& edge = fresh.shape->drawing->part.loops[0][2];
  ASSERT_TRUE(edge.worn);
  const auto before = run(*shape, edge), after = run(*fresh.shape, edge);
  EXPECT_NE(before.size(), after.size());
  EXPECT_NEAR(adapt::fan_volume(plane, before), adapt::fan_volume(plane, after), 1e-16);
}

// The curve drawn through a smooth scar approaches it at third order.
TEST(Remesh, RefitConverges) {
  const auto profile = [](double x) { return 0.05 * std::pow(std::cos(0.5 * std::numbers::pi * (x - 1.0) / 0.6), 2); };
  std::vector<double> error;
  for (double h : {0.1, 0.05, 0.025}) {
    auto shape = std::make_shared<body::Shape>(*shape_of(block_drawing({.far_size = h})));
    for (int node : mesh::nodes_of(shape->mesh.boundaries.at("top")))
      if (const double x = shape->mesh.X[node].x(); std::abs(x - 1.0) < 0.6 - 1e-9)
        shape->mesh.X[node].y() -= profile(x);
    const auto drawn = adapt::remesh(shape, plane, {{{}, {1.0, 0.95}, 0.5, 0.01, 0.37 * h}});
    ASSERT_TRUE(drawn.shape) << drawn.failure;
    double worst = 0.0;
    for (const auto& edge : drawn.shape->drawing->part.loops[0])
      for (int i = 0; edge.worn && i <= 2000; ++i) {
        const Vec2 x = cad::at(edge, edge.length() * i / 2000);
        worst = std::max(worst, std::abs(1.0 - profile(x.x()) - x.y()));
      }
    error.push_back(worst);
  }
  for (int k : {0, 1}) EXPECT_GT(std::log2(error[k] / error[k + 1]), 2.9) << error[k];
}

// Two hundred times worn and remeshed, a block has lost what its strips add up to.
TEST(Remesh, LedgerOverTwoHundredRemeshes) {
  const auto born = shape_of(block_drawing());
  auto shape = born;
  double removed = 0.0;
  for (int i = 0; i < 200; ++i) {
    const auto worn = worn_by(shape->mesh, "top", scar(1e-3, 1.0 + 0.1 * std::sin(0.3 * i), 0.5 + 0.002 * i));
    const auto step = adapt::evolve(shape, plane, {worn});
    ASSERT_TRUE(step.shape) << step.failure;
    removed += step.removed;
    const auto fresh = remesh(step.shape, plane);
    ASSERT_TRUE(fresh.shape) << i << ": " << fresh.failure;
    shape = fresh.shape;
  }
  EXPECT_NEAR(lost(born->mesh, shape->mesh), removed, 1e-12);
  EXPECT_LE(shape->drawing->part.loops[0].size(), 6u);
  EXPECT_LT(shape->mesh.node_count(), 2 * born->mesh.node_count());
}

// A scar that widens under a fine zone which follows it stays finely and evenly divided, on sound elements, and keeps
// the ledger on the flat; on the disc, too, the worn run stays one edge.
TEST(Remesh, FineZoneFollowsAScar) {
  for (const bool disc : {false, true})
    for (auto kind : {CellKind::quad4, CellKind::tri3}) {
      const DrawnOptions o{kind, 0.2, false};
      auto d = disc ? half_disc(o) : block_drawing(o, -1.0);
      const std::string face = disc ? "round" : "top";
      const double size = 0.01;
      const auto zone = [&](double half) { return cad::FineZone{{}, {0.0, 1.0}, half, 0.05, size}; };
      d.zones = {zone(0.1)};
      const auto born = shape_of(d);
      auto shape = born;
      double removed = 0.0, poorest = 1.0, finest = 1.0, coarsest = 0.0;
      for (int i = 0; i < 10; ++i) {
        const double half = 0.05 + 0.012 * i;
        const auto profile = [&](Vec2 x) {
          return 1e-3 * std::sqrt(std::max(0.0, 1.0 - x.x() * x.x() / (half * half)));
        };
        const auto step = adapt::evolve(shape, plane, {worn_by(shape->mesh, face, profile)});
        ASSERT_TRUE(step.shape) << step.failure;
        removed += step.removed;
        const auto fresh = remesh(step.shape, plane, {zone(std::max(0.1, 1.5 * half))});
        ASSERT_TRUE(fresh.shape) << i << ": " << fresh.failure;
        shape = fresh.shape;
        poorest = std::min(poorest, mesh::poorest_cell(shape->mesh).scaled_jacobian);
        const auto& chain = shape->mesh.boundaries.at(face)[0];
        for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
          const Vec2 &a = shape->mesh.X[chain[k]], &b = shape->mesh.X[chain[k + 1]];
          if (std::max(std::abs(a.x()), std::abs(b.x())) > half) continue;
          finest = std::min(finest, (b - a).norm() / size);
          coarsest = std::max(coarsest, (b - a).norm() / size);
        }
      }
      EXPECT_GT(poorest, 0.3);
      EXPECT_GT(finest, 0.6);
      EXPECT_LT(coarsest, 1.5);
      EXPECT_EQ(worn_edges(shape->drawing->part.loops[0]), 1);
      if (!disc) {
        EXPECT_NEAR(lost(born->mesh, shape->mesh), removed, 1e-13);
      }
    }
}

// A face worn all along, again and again, keeps the ledger: its sides get shorter and stay straight.
TEST(Remesh, SlidingCorners) {
  const auto born = shape_of(block_drawing({.kind = CellKind::tri3}));
  auto shape = born;
  double removed = 0.0;
  for (int i = 0; i < 20; ++i) {
    const auto step =
        adapt::evolve(shape, plane, {worn_by(shape->mesh, "top", [](Vec2 x) { return 0.01 + 0.002 * x.x(); })});
    ASSERT_TRUE(step.shape) << step.failure;
    removed += step.removed;
    const auto fresh = remesh(step.shape, plane);
    ASSERT_TRUE(fresh.shape) << fresh.failure;
    shape = fresh.shape;
    EXPECT_EQ(types(shape->drawing->part.loops[0]),
              (std::vector{cad::EdgeType::line, cad::EdgeType::line, cad::EdgeType::spline, cad::EdgeType::line}));
  }
  EXPECT_NEAR(lost(born->mesh, shape->mesh), removed, 1e-13);
  for (int node : mesh::nodes_of(shape->mesh.boundaries.at("right"))) EXPECT_NEAR(shape->mesh.X[node].x(), 2.0, 1e-12);
}

// A corner that slides along a round side, again and again, leaves that side a circle but for a short spline of two to
// three facets at its end, and sound elements.
TEST(Remesh, CornersSlideAlongACircle) {
  auto shape = shape_of(half_disc());
  for (int i = 0; i < 12; ++i) {
    const auto fresh = remesh(wear(shape, "flat", [](Vec2) { return 0.01; }), plane);
    ASSERT_TRUE(fresh.shape) << i << ": " << fresh.failure;
    shape = fresh.shape;
    const auto& loop = shape->drawing->part.loops[0];
    EXPECT_EQ(types(loop), (std::vector{cad::EdgeType::spline, cad::EdgeType::spline, cad::EdgeType::circle,
                                        cad::EdgeType::spline}));
    for (std::size_t k : {1u, 3u}) {
      EXPECT_GT(loop[k].length(), 0.15) << i;
      EXPECT_LT(loop[k].length(), 0.35) << i;
    }
    EXPECT_GT(mesh::poorest_cell(shape->mesh).scaled_jacobian, 0.4);
  }
}

// A block worn nearly through is still meshed, or refused in words.
TEST(Remesh, NearlyWornThrough) {
  auto shape = shape_of(block_drawing());
  for (int i = 0; i < 60; ++i) {
    const auto step = adapt::evolve(shape, plane, {worn_by(shape->mesh, "top", scar(0.02, 1.0, 0.6))});
    if (!step.shape) {
      EXPECT_THAT(step.failure, HasSubstr("worn through to boundary 'bottom'"));
      EXPECT_GT(i, 45);
      return;
    }
    const auto fresh = remesh(step.shape, plane);
    if (!fresh.shape) {
      EXPECT_FALSE(fresh.failure.empty());
      EXPECT_GT(i, 45);
      return;
    }
    EXPECT_GT(mesh::poorest_cell(fresh.shape->mesh).scaled_jacobian, 0.0);
    shape = fresh.shape;
  }
  FAIL() << "worn through without a word";
}

// A mesh that would be too large is refused with the number of its nodes, and the body's name.
TEST(Remesh, TooManyNodes) {
  const auto shape = wear(shape_of(block_drawing()), "top", scar(0.01, 1.0, 0.5));
  const auto fresh = remesh(shape, plane, {{{}, {1.0, 1.0}, 0.5, 0.2, 1e-4}}, {.most_nodes = 1e4});
  EXPECT_FALSE(fresh.shape);
  EXPECT_THAT(fresh.failure, HasSubstr("body 'block': a new mesh would need about "));
  EXPECT_THAT(fresh.failure, HasSubstr("(at most 10000)"));
}

// A worn run is measured from its own first point: far from the origin it keeps its digits.
TEST(Remesh, FanKeepsItsDigits) {
  const base::Points near{{0, 0}, {0.5, 1e-6}, {1, 0}};
  base::Points far = near;
  for (Vec2& x : far) x += Vec2(512.0, 0.0);
  EXPECT_NEAR(adapt::fan_volume(plane, near), -0.5e-6, 1e-20);
  EXPECT_NEAR(adapt::fan_volume(plane, far), -0.5e-6, 1e-20);
}

}  // namespace
}  // namespace reye
