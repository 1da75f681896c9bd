#include "adapt/redraw/redraw.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapt/drawn.hpp"
#include "adapt/redraw/own_outline.hpp"
#include "adapt/shape/fit.hpp"
#include "mesh/outline.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::redraw;
using cad::EdgeType;
using testing::ElementsAre;
using testing::HasSubstr;

/// Ends of loops meet exactly.
void expect_closed(const cad::Drawing& d) {
  for (const auto& loop : d.part.loops)
    for (std::size_t k = 0; k < loop.size(); ++k) EXPECT_EQ(loop[k].last(), loop[(k + 1) % loop.size()].first()) << k;
}

int count(const cad::Drawing& d, const std::string& name) {
  const auto& chosen = d.boundaries.at(name).at(0);
  EXPECT_EQ(chosen.size(), d.part.loops[0].size());
  return static_cast<int>(std::count(chosen.begin(), chosen.end(), true));
}

// Without wear the drawing stays what it was, knot for knot.
TEST(Redraw, NoWearNoChange) {
  const auto shape = shape_of(half_disc());
  const auto drawn = redraw(*shape);
  EXPECT_EQ(drawn.failure, "");
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_TRUE(drawn.drawing.part.loops[0][k].knots == shape->drawing->part.loops[0][k].knots);
}

// A scar within a straight face leaves lines on both sides of one worn spline, with the face's name on all three, and
// the spline starts and ends at the nodes where the scar does.
TEST(Redraw, ScarOnAStraightFace) {
  for (auto kind : {CellKind::quad4, CellKind::tri3}) {
    const auto shape = wear(shape_of(block_drawing({.kind = kind})), "top", scar(0.02, 1.0, 0.55));
    const auto drawn = redraw(*shape);
    ASSERT_EQ(drawn.failure, "");
    const auto& loop = drawn.drawing.part.loops[0];
    EXPECT_THAT(types(loop), ElementsAre(EdgeType::line, EdgeType::line, EdgeType::line, EdgeType::spline,
                                         EdgeType::line, EdgeType::line));
    EXPECT_TRUE(loop[3].worn);
    EXPECT_EQ(count(drawn.drawing, "top"), 3);
    EXPECT_EQ(count(drawn.drawing, "left"), 1);
    expect_closed(drawn.drawing);
    EXPECT_NEAR(loop[3].first().x(), 1.6, 1e-12);
    EXPECT_NEAR(loop[3].last().x(), 0.4, 1e-12);
  }
}

// On a round face what has not worn is still a circle, and lies on it.
TEST(Redraw, ScarOnADisc) {
  const auto shape = wear(shape_of(half_disc({.far_size = 0.05})), "round", scar(0.01, 0.0, 0.3));
  const auto drawn = redraw(*shape);
  ASSERT_EQ(drawn.failure, "");
  const auto& loop = drawn.drawing.part.loops[0];
  EXPECT_THAT(types(loop), ElementsAre(EdgeType::line, EdgeType::circle, EdgeType::spline, EdgeType::circle));
  for (std::size_t k : {1u, 3u})
    for (int i = 0; i <= 100; ++i) EXPECT_NEAR(cad::at(loop[k], loop[k].length() * i / 100).norm(), 1.0, 1e-11);
  EXPECT_EQ(count(drawn.drawing, "round"), 3);
  expect_closed(drawn.drawing);
}

// The outline turns at a scar's end as the profile does there: the fit does not round the kink off.
TEST(Redraw, KinkAtTheScarEndStays) {
  const double depth = 0.02, half = 0.5;
  const auto shape = wear(shape_of(block_drawing({.far_size = 0.02})), "top", scar(depth, 1.0, half));
  const auto loop = redraw(*shape).drawing.part.loops[0];
  const auto spline = std::find_if(loop.begin(), loop.end(), [](const cad::Edge& e) { return e.worn; });
  ASSERT_NE(spline, loop.end());
  EXPECT_NEAR(cad::kink(*(spline - 1), *spline), 2.0 * depth / half, 2e-3);
  EXPECT_NEAR(cad::kink(*spline, *(spline + 1)), 2.0 * depth / half, 2e-3);
  EXPECT_EQ(cad::tangent_at(*(spline - 1), 0.1).y(), 0.0);
}

// The spline through the points of a smooth line approaches it at third order, on uneven points too.
TEST(Redraw, FitConverges) {
  const auto line = [](double x) { return Vec2(x, 0.1 * std::sin(3.0 * x) + 0.05 * x * x); };
  std::vector<double> error;
  for (int n : {20, 40, 80}) {
    base::Points p;
    for (int i = 0; i <= n; ++i) p.push_back(line(2.0 * (i + 0.3 * std::sin(2.0 * i)) / n));
    p.front() = line(0.0);
    p.back() = line(2.0);
    const auto edge = adapt::fit(EdgeType::spline, p, 1.0);
    double worst = 0.0;
    for (int i = 0; i <= 4000; ++i) {
      const Vec2 x = cad::at(edge, edge.length() * i / 4000);
      worst = std::max(worst, std::abs(x.y() - line(x.x()).y()));
    }
    error.push_back(worst);
  }
  for (int k : {0, 1}) EXPECT_GT(std::log2(error[k] / error[k + 1]), 2.9) << error[k];
}

// Points on a circle give the circle back, to the error of its Hermite pieces.
TEST(Redraw, FitKeepsCircles) {
  base::Points p;
  for (double angle : {0.0, 0.05, 0.12, 0.2, 0.25, 0.35}) p.emplace_back(std::cos(angle), std::sin(angle));
  const auto tangents = adapt::smooth_tangents(p, false);
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_NEAR(tangents[i].dot(p[i]), 0.0, 1e-12);
  EXPECT_NEAR(adapt::fit_error(p, false), 0.0, 1e-12);
}

// No spline leaves its chords by more than 0.14 of their length, however rough the points.
TEST(Redraw, FitDoesNotOvershoot) {
  base::Points p;
  for (int i = 0; i < 60; ++i) p.emplace_back(0.1 * i + 0.06 * std::sin(7.0 * i), 0.03 * std::cos(11.0 * i * i));
  const auto edge = adapt::fit(EdgeType::spline, p, 1.0);
  ASSERT_FALSE(edge.straight);
  for (std::size_t i = 0; i + 1 < p.size(); ++i)
    for (int k = 0; k <= 10; ++k) {
      const Vec2 x = cad::at(edge, edge.arc[i] + (edge.arc[i + 1] - edge.arc[i]) * k / 10.0), chord = p[i + 1] - p[i];
      EXPECT_LE(std::abs(base::cross(chord.normalized(), x - p[i])), 0.14 * chord.norm()) << i;
    }
}

// A run too rough for the tolerance is drawn from node to node.
TEST(Redraw, RoughRunsAreStraight) {
  const auto shape = shape_of(block_drawing({.far_size = 0.05}));
  const auto saw = wear(shape, "top", [](Vec2 x) {
    return std::abs(x.x() - 1.0) < 0.5 ? 4e-3 * (2.0 + std::cos(x.x() / 0.05 * std::numbers::pi)) : 0.0;
  });
  const auto straight = [](const adapt::Redrawn& r) {
    return std::any_of(r.drawing.part.loops[0].begin(), r.drawing.part.loops[0].end(),
                       [](const cad::Edge& e) { return e.worn && e.straight; });
  };
  EXPECT_TRUE(straight(redraw(*saw, 1e-3)));
  EXPECT_FALSE(straight(redraw(*saw, 1e-1)));
  EXPECT_TRUE(straight(redraw(*saw)));
}

// A face worn all along makes its free sides shorter: they stay lines, with their present ends.
TEST(Redraw, CornersSlide) {
  const auto shape = wear(shape_of(block_drawing()), "top", [](Vec2) { return 0.03; });
  const auto drawn = redraw(*shape);
  ASSERT_EQ(drawn.failure, "");
  const auto& loop = drawn.drawing.part.loops[0];
  EXPECT_THAT(types(loop), ElementsAre(EdgeType::line, EdgeType::line, EdgeType::spline, EdgeType::line));
  EXPECT_EQ(loop[1].last(), shape->mesh.X[node_at(shape->mesh, {2.0, 0.97})]);
  EXPECT_NEAR(loop[1].length(), 0.97, 1e-12);
  expect_closed(drawn.drawing);
}

// A corner worn on both sides is still a corner: two splines meet in it.
TEST(Redraw, CornerWornOnBothSides) {
  auto shape = wear(shape_of(block_drawing()), "top", [](Vec2 x) { return 0.01 * x.x() / 2.0; });
  shape = wear(shape, "right", [](Vec2 x) { return 0.01 * x.y(); });
  const auto loop = redraw(*shape).drawing.part.loops[0];
  ASSERT_EQ(loop.size(), 4u);
  EXPECT_EQ(worn_edges(loop), 2);
  EXPECT_GT(cad::kink(loop[1], loop[2]), 1.4);
}

// A scar that ends within a facet of a corner takes that facet in: no edge is shorter than about two facets.
TEST(Redraw, ShortFreshRunsAreTakenIn) {
  const auto shape = wear(shape_of(block_drawing()), "top", scar(0.01, 1.0, 0.85));
  const auto loop = redraw(*shape).drawing.part.loops[0];
  EXPECT_THAT(types(loop), ElementsAre(EdgeType::line, EdgeType::line, EdgeType::spline, EdgeType::line));
  const auto wide = wear(shape_of(block_drawing()), "top", scar(0.01, 1.0, 0.75));
  EXPECT_EQ(redraw(*wide).drawing.part.loops[0].size(), 6u);
}

// A scar that grows past its old ends stays one spline: edges do not pile up over remeshes.
TEST(Redraw, GrowingScarStaysOneEdge) {
  auto shape = shape_of(block_drawing({.far_size = 0.05}));
  for (int i = 0; i < 8; ++i) {
    shape = wear(shape, "top", scar(0.004, 1.0, 0.3 + 0.05 * i));
    const auto fresh = adapt::remesh(shape, Analysis::plane_strain);
    ASSERT_TRUE(fresh.shape) << fresh.failure;
    shape = fresh.shape;
    EXPECT_EQ(shape->drawing->part.loops[0].size(), 6u) << i;
    EXPECT_EQ(worn_edges(shape->drawing->part.loops[0]), 1) << i;
  }
}

// A scar beside an older one leaves the older spline as it is.
TEST(Redraw, UntouchedScarStays) {
  auto shape = wear(shape_of(block_drawing({.far_size = 0.05})), "top", scar(0.01, 0.5, 0.3));
  shape = adapt::remesh(shape, Analysis::plane_strain).shape;
  ASSERT_TRUE(shape);
  const auto& before = shape->drawing->part.loops[0];
  const auto old = *std::find_if(before.begin(), before.end(), [](const cad::Edge& e) { return e.worn; });
  const auto loop = redraw(*wear(shape, "top", scar(0.01, 1.5, 0.3))).drawing.part.loops[0];
  EXPECT_EQ(worn_edges(loop), 2);
  EXPECT_TRUE(
      std::any_of(loop.begin(), loop.end(), [&](const cad::Edge& e) { return e.worn && e.knots == old.knots; }));
}

// A scar round a whole disc becomes one closed smooth edge.
TEST(Redraw, WornAllRound) {
  cad::Drawing disc = drawing({arc({0, 0}, 1.0, 0.0, 2.0 * std::numbers::pi)}, {"round"}, {.far_size = 0.2});
  const auto shape = wear(shape_of(disc), "round", [](Vec2 x) { return 0.01 * (1.5 + x.y()); });
  const auto drawn = redraw(*shape);
  ASSERT_EQ(drawn.failure, "");
  ASSERT_EQ(drawn.drawing.part.loops[0].size(), 1u);
  EXPECT_LT(cad::kink(drawn.drawing.part.loops[0][0], drawn.drawing.part.loops[0][0]), 1e-12);
  const auto fresh = adapt::remesh(shape, Analysis::plane_strain);
  ASSERT_TRUE(fresh.shape) << fresh.failure;
  EXPECT_NEAR(lost(shape->mesh, fresh.shape->mesh), 0.0, 1e-14);
}

// A scar across the place where a closed edge starts and ends is one spline.
TEST(Redraw, ScarAcrossASeam) {
  cad::Drawing disc = drawing({arc({0, 0}, 1.0, 0.0, 2.0 * std::numbers::pi)}, {"round"}, {.far_size = 0.1});
  const auto shape = wear(shape_of(disc), "round", [](Vec2 x) { return x.x() > 0.8 ? 0.05 * (x.x() - 0.8) : 0.0; });
  const auto drawn = redraw(*shape);
  ASSERT_EQ(drawn.failure, "");
  EXPECT_EQ(drawn.drawing.part.loops[0].size(), 2u);
  EXPECT_EQ(worn_edges(drawn.drawing.part.loops[0]), 1);
  EXPECT_EQ(count(drawn.drawing, "round"), 2);
  expect_closed(drawn.drawing);
}

// A mesh without a drawing is drawn from its outline: sides stay sides, names stay names, sizes are those it had.
TEST(Redraw, MeshWithoutDrawing) {
  const auto mesh = rectangle({.size = {2.0, 1.0}, .nx = 20, .ny = 10});
  const auto drawn = redraw(*wear(body::make_shape(mesh), "top", scar(0.01, 1.0, 0.4)));
  ASSERT_EQ(drawn.failure, "");
  EXPECT_EQ(drawn.drawing.part.loops[0].size(), 6u);
  EXPECT_NEAR(drawn.drawing.options.mesh.far_size_mm, 0.1, 1e-12);
  EXPECT_EQ(count(drawn.drawing, "top"), 3);
  const auto sector = ring({.inner = 1.0, .outer = 2.0, .around = 24});
  const auto fresh = adapt::remesh(body::make_shape(sector), Analysis::plane_strain);
  ASSERT_TRUE(fresh.shape) << fresh.failure;
  EXPECT_NEAR(mesh::length(fresh.shape->mesh.X, fresh.shape->mesh.boundaries.at("right")), std::numbers::pi, 2e-3);
}

// A mesh that came without drawing and with a fine face is remeshed with about as many elements there.
TEST(Redraw, FineFacesStayFine) {
  const auto mesh = mapped(rectangle({.size = {2.0, 1.0}, .nx = 40, .ny = 16}), [](Vec2 x) {
    return Vec2(1.0 + (x.x() - 1.0) * (0.2 + 0.8 * std::pow(std::abs(x.x() - 1.0), 2)), x.y());
  });
  const auto worn = wear(body::make_shape(mesh), "top", scar(1e-3, 1.0, 0.2));
  const auto fresh = adapt::remesh(worn, Analysis::plane_strain);
  ASSERT_TRUE(fresh.shape) << fresh.failure;
  const double before = static_cast<double>(mesh::nodes_of(mesh.boundaries.at("top")).size());
  const double after = static_cast<double>(mesh::nodes_of(fresh.shape->mesh.boundaries.at("top")).size());
  EXPECT_GT(after / before, 0.6);
  EXPECT_LT(after / before, 2.0);
}

// A mesh that came with its file is no longer used once it has worn, and is used as it is before.
TEST(Redraw, OwnMesh) {
  cad::Drawing own = block_drawing();
  own.part.mesh = rectangle({.size = {2.0, 1.0}, .nx = 20, .ny = 10});
  const auto shape = shape_of(own);
  EXPECT_TRUE(redraw(*shape).drawing.part.mesh);
  EXPECT_FALSE(redraw(*wear(shape, "top", scar(0.01, 1.0, 0.4))).drawing.part.mesh);
}

// A boundary that has worn away is reported by its name.
TEST(Redraw, VanishedBoundary) {
  const auto shape = shape_of(block_drawing());
  auto gone = std::make_shared<body::Shape>(*shape);
  for (Vec2& x : gone->mesh.X) x.y() *= 1e-5;
  EXPECT_EQ(redraw(*gone).failure, "boundary 'left' of body 'block' has vanished by wear");
}

// A drawing of another body is refused with the place where it does not fit.
TEST(Redraw, ForeignDrawing) {
  auto shape = *wear(shape_of(block_drawing()), "top", scar(0.01, 1.0, 0.4));
  shape.drawing = std::make_shared<const cad::Drawing>(block_drawing({}, 0.03));
  EXPECT_THAT(redraw(shape).failure, HasSubstr("the drawing is not that of the mesh at (0.03, 0) mm"));
}

}  // namespace
}  // namespace reye
