#include <gtest/gtest.h>

#include <numeric>

#include "adapt/curved.hpp"
#include "adapt/drawn.hpp"
#include "adapt/graphs.hpp"
#include "adapt/redraw/remesh.hpp"
#include "adapt/transfer/surface_transfer.hpp"
#include "mesh/quality.hpp"
#include "support/surfaces.hpp"

/// Bodies of second order remeshed, and fields of their surfaces carried over.
namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::SurfaceKind;
using mortar::Surface;

body::ShapePtr block_of_second_order(CellKind kind, Analysis analysis) {
  auto drawing = block_drawing({kind, 0.1, analysis == Analysis::axisymmetric});
  drawing.options.mesh.order = 2;
  return shape_of(drawing);
}

/// Losses that follow a profile; the control points of facets in which it ends lose nothing rather than less.
adapt::WornBoundary losses(const mesh::Mesh& mesh, const curved::Depth& profile, Analysis analysis) {
  auto worn = curved::worn_by(mesh, "top", profile, analysis);
  for (double& v : worn.removed) v = std::max(v, 0.0);
  return worn;
}

/// A worn block has lost `removed` after it was remeshed, whether its outline keeps its nodes or is redivided.
void expect_content_kept(CellKind kind, Analysis analysis) {
  const auto born = block_of_second_order(kind, analysis);
  const auto worn = losses(born->mesh, scar(0.02, 1.0, 0.55), analysis);
  const auto step = adapt::evolve(born, analysis, {worn});
  ASSERT_TRUE(step.shape) << step.failure;
  for (bool keep : {true, false}) {
    const auto fresh = adapt::remesh(step.shape, analysis, {{{}, {1.0, 0.98}, 0.8, 0.1, 0.06}}, {.keep_nodes = keep});
    ASSERT_TRUE(fresh.shape) << fresh.failure;
    const auto& mesh = fresh.shape->mesh;
    EXPECT_EQ(mesh::order(mesh.kind), 2);
    EXPECT_EQ(keep, fresh.area_residue == 0.0);
    EXPECT_NEAR(curved::lost(born->mesh, mesh, analysis), curved::sum(worn), 1e-11 * curved::sum(worn));
    EXPECT_LT(fresh.largest_correction_mm, 1e-3);
    EXPECT_NO_THROW(mesh::check(mesh));
    EXPECT_EQ(keep, mesh::nodes_of(mesh.boundaries.at("top")).size() == worn.removed.size());
  }
}

Surface curved_graph(int n, unsigned seed, double (*height)(double), Analysis analysis = Analysis::plane_strain) {
  return graph(n, seed, height, analysis, 2);
}

/// Coefficients that give the field f at all vertices and in the middle of all facets.
template <class F>
Values coefficients(const Surface& s, F f) {
  Values values(s.X.size());
  for (const auto& [a, b, c] : s.facets) {
    values[a] = f(s.X[a]);
    values[b] = f(s.X[b]);
    values[c] = 2.0 * f(0.25 * (s.X[a] + s.X[b]) + 0.5 * s.X[c]) - 0.5 * (values[a] + values[b]);
  }
  return values;
}

template <class F>
Values curved_shares(const Surface& s, F density) {
  auto values = coefficients(s, density);
  for (std::size_t j = 0; j < values.size(); ++j) values[j] *= s.area[j];
  return values;
}

}  // namespace

// A worn body of second order keeps its content through a remesh, to round-off of its size.
TEST(SecondOrderRemesh, ContentOfAWornBlock) { expect_content_kept(CellKind::quad4, Analysis::plane_strain); }
TEST(SecondOrderRemesh, ContentOfTriangles) { expect_content_kept(CellKind::tri3, Analysis::plane_strain); }
TEST(SecondOrderRemesh, ContentOfARing) { expect_content_kept(CellKind::quad4, Analysis::axisymmetric); }

// Remeshed again and again, the worn outline does not drift.
TEST(SecondOrderRemesh, TenTimes) {
  const auto born = block_of_second_order(CellKind::quad4, Analysis::plane_strain);
  const auto profile = scar(0.02, 1.0, 0.55);
  const auto worn = losses(born->mesh, profile, Analysis::plane_strain);
  auto shape = adapt::evolve(born, Analysis::plane_strain, {worn}).shape;
  for (int k = 0; k < 10; ++k) {
    const auto fresh = adapt::remesh(shape, Analysis::plane_strain, {{{}, {1.0, 0.98}, 0.8, 0.1, k % 2 ? 0.06 : 0.05}});
    ASSERT_TRUE(fresh.shape) << fresh.failure;
    shape = fresh.shape;
  }
  const double removed = curved::sum(worn);
  EXPECT_NEAR(curved::lost(born->mesh, shape->mesh), removed, 1e-11 * removed);
  for (int node : mesh::nodes_of(shape->mesh.boundaries.at("top"))) {
    const Vec2& x = shape->mesh.X[node];
    EXPECT_NEAR(x.y(), 1.0 - profile(x), 0.1 * 0.02);
  }
}

// On the same surface all fields come back to round-off.
TEST(SecondOrderSurfaceTransfer, Identity) {
  std::mt19937 random(3);
  const auto surface = curved_graph(20, 1, wavy, Analysis::axisymmetric);
  const auto values = coefficients(surface, [&](const Vec2&) { return noise(random); });
  for (auto kind : {SurfaceKind::interpolated, SurfaceKind::summed, SurfaceKind::nearest})
    EXPECT_LT(largest_difference(carried(surface, kind, values, surface), values), 1e-12);
}

// Along a straight side quadratic fields are exact, as values and as densities of sums.
TEST(SecondOrderSurfaceTransfer, QuadraticFieldsAreExact) {
  const auto field = [](const Vec2& x) { return 3.0 + (x.x() - 1.7) * (x.x() - 1.7); };
  for (int n : {5, 13, 40}) {
    const auto from = curved_graph(11, 1, level), to = curved_graph(n, 2, level);
    const auto values = carried(from, SurfaceKind::interpolated, coefficients(from, field), to);
    EXPECT_LT(largest_difference(values, coefficients(to, field)), 1e-12);
    const auto sums = carried(from, SurfaceKind::summed, curved_shares(from, field), to);
    EXPECT_LT(largest_difference(sums, curved_shares(to, field)), 1e-12);
  }
}

// Between two meshes of a curved outline a smooth field loses at third order.
TEST(SecondOrderSurfaceTransfer, ThirdOrder) {
  const auto smooth = [](const Vec2& x) { return 2.0 + std::sin(4.0 * x.x()) + x.y(); };
  Values error;
  for (int n : {80, 320}) {
    const auto from = curved_graph(n, 1, wavy), to = curved_graph(5 * n / 4, 2, wavy);
    error.push_back(largest_difference(carried(from, SurfaceKind::interpolated, coefficients(from, smooth), to),
                                       coefficients(to, smooth)));
  }
  EXPECT_GT(std::log(error[0] / error[1]) / std::log(4.0), 2.7);
}

// Sums are kept to round-off, coarser and finer, and removed volume is never negative.
TEST(SecondOrderSurfaceTransfer, SumsAreKept) {
  const auto from = curved_graph(40, 1, wavy, Analysis::axisymmetric);
  auto values = curved_shares(from, bump);
  for (double& v : values) v = std::max(v, 0.0);
  for (int n : {7, 30, 200}) {
    const auto there = carried(from, SurfaceKind::summed, values, curved_graph(n, 2, wavy, Analysis::axisymmetric));
    const double total = std::accumulate(values.begin(), values.end(), 0.0);
    EXPECT_NEAR(std::accumulate(there.begin(), there.end(), 0.0), total, 1e-13 * total);
    for (double v : there) EXPECT_GE(v, 0.0);
  }
}

}  // namespace reye
