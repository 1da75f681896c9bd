#include "mesh/second_order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "mesh/arc.hpp"
#include "mesh/measure.hpp"
#include "mesh/quadratic_edge.hpp"
#include "mesh/quality.hpp"
#include "mesh/shape.hpp"
#include "small_meshes.hpp"
#include "support/meshes.hpp"

namespace {

using namespace reye;
using namespace reye::mesh;

constexpr double pi = std::numbers::pi;

// Shape functions must be 1 at their own node and 0 at the others, and their gradients those of central differences.
TEST(shape, nodal_basis_with_its_gradients) {
  for (CellKind kind : {CellKind::tri3, CellKind::quad4, CellKind::tri6, CellKind::quad8}) {
    for (int a = 0; a < nodes_per_cell(kind); ++a)
      EXPECT_LT((shape_functions(kind, reference_node(kind, a)) - NodeValues::Unit(a)).norm(), 1e-15);
    const Vec2 xi(0.23, 0.31);
    constexpr double h = 1e-5;
    for (int i = 0; i < 2; ++i) {
      const Vec2 step = h * Vec2::Unit(i);
      const NodeValues d = (shape_functions(kind, xi + step) - shape_functions(kind, xi - step)) / (2.0 * h);
      EXPECT_LT((d - shape_gradients(kind, xi).col(i)).norm(), 1e-10);
    }
  }
}

// Functions of second order must reproduce every quadratic of the reference coordinates.
TEST(shape, second_order_is_complete_to_degree_two) {
  const auto quadratic = [](const Vec2& x) {
    return 1 + x[0] - 2 * x[1] + x[0] * x[0] + 3 * x[0] * x[1] - x[1] * x[1];
  };
  for (CellKind kind : {CellKind::tri6, CellKind::quad8}) {
    const Vec2 xi(0.17, 0.42);
    double sum = 0.0;
    for (int a = 0; a < nodes_per_cell(kind); ++a)
      sum += shape_functions(kind, xi)[a] * quadratic(reference_node(kind, a));
    EXPECT_NEAR(sum, quadratic(xi), 1e-14);
  }
}

/// The length of an edge by very many chords.
double by_chords(const QuadraticEdge& e, double from, double to) {
  constexpr int n = 20000;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) sum += (e.at(from + (to - from) * (i + 1) / n) - e.at(from + (to - from) * i / n)).norm();
  return sum;
}

// Length of a quadratic edge must be exact, bent strongly, hardly or not at all, with its mid node off the centre.
TEST(quadratic_edge, length) {
  for (const Vec2& mid :
       {Vec2(0.5, -0.4), Vec2(0.4, 0.1), Vec2(0.5, -1e-9), Vec2(0.5, 0.0), Vec2(0.6, 0.0), Vec2(0.5 + 1e-13, 0.0)}) {
    const QuadraticEdge e{{0, 0}, mid, {1, 0}};
    EXPECT_NEAR(e.length(), by_chords(e, -1.0, 1.0), 3e-9);
    EXPECT_NEAR(e.length(-0.3, 0.8), by_chords(e, -0.3, 0.8), 3e-9);
    EXPECT_NEAR(e.length(-1.0, 0.2) + e.length(0.2, 1.0), e.length(), 1e-15);
    EXPECT_NEAR(e.length(-1.0, e.parameter_at(0.3)), 0.3, 1e-14);
  }
  EXPECT_EQ((QuadraticEdge{{0, 0}, {1.5, 2}, {3, 4}}.length()), 5.0);
  // y = x^2 from 0 to 1: length sqrt(5)/2 + asinh(2)/4.
  EXPECT_NEAR((QuadraticEdge{{0, 0}, {0.5, 0.25}, {1, 1}}.length()), std::sqrt(5.0) / 2 + std::asinh(2.0) / 4, 1e-15);
}

/// A ring sector of second order, a quarter by default, its edges through the circles.
Mesh sector(int n, CellKind kind) { return support::ring({1.0, 2.0, pi / 2, n, n, kind}); }

// Area and lengths of circles must converge at fourth order, and the cells must fill the outline to round-off.
TEST(second_order, circles_at_fourth_order) {
  for (CellKind kind : {CellKind::tri6, CellKind::quad8}) {
    double last_area = 0.0, last_length = 0.0;
    for (int n : {2, 4, 8}) {
      const Mesh m = sector(n, kind);
      check(m);
      EXPECT_NEAR(area(m), enclosed_area(m.X, m.outline[0], 2), 1e-14);
      const double area_error = std::abs(area(m) - 0.75 * pi);
      const double length_error = std::abs(length(m.X, m.boundaries.at("right"), 2) - pi);
      if (n > 2) {
        EXPECT_GT(std::log2(last_area / area_error), 3.8);
        EXPECT_GT(std::log2(last_length / length_error), 3.8);
      }
      last_area = area_error;
      last_length = length_error;
    }
  }
}

// Arc lengths must grow along the curve through vertices and mid nodes, and nodal lengths add up to the length.
TEST(second_order, arc_lengths_and_nodal_lengths) {
  const Mesh m = sector(8, CellKind::quad8);
  const Boundary& outer = m.boundaries.at("right");
  const auto chains = arc_chains(m, "right");
  ASSERT_EQ(chains.size(), 1U);
  const auto& [nodes, arc, along] = chains.front();
  ASSERT_EQ(nodes.size(), 17U);
  const double short_by = pi - length(m.X, outer, 2);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double exact = 2.0 * std::atan2(m.X[nodes[i]].x(), m.X[nodes[i]].y());
    EXPECT_NEAR(arc[i], exact - short_by * exact / pi, 1e-12);  // on a circle all edges are short alike
  }
  double sum = 0.0;
  for (double share : nodal_lengths(m.X, outer, 2)) sum += share;
  EXPECT_NEAR(sum, length(m.X, outer, 2), 1e-12);
  const Mesh straight = to_second_order(squares(1));
  const auto shares =
      nodal_lengths(straight.X, Boundary{{straight.outline[0][0], straight.outline[0][1], straight.outline[0][2]}}, 2);
  EXPECT_NEAR(shares[0], 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(shares[1], 4.0 / 6.0, 1e-15);
}

// Inserted mid nodes must leave a sound mesh with the same area, every chain through them; taken out, the old mesh.
TEST(second_order, to_and_fro) {
  Mesh mesh = squares(3, {4});
  mesh.boundaries["all"] = {mesh.outline[0]};
  const Mesh second = to_second_order(mesh);
  check(second);
  EXPECT_EQ(second.node_count(), 16 + 24);
  EXPECT_EQ(second.outline[0].size(), 25U);
  EXPECT_EQ(second.boundaries.at("all")[0], second.outline[0]);
  EXPECT_DOUBLE_EQ(area(second), 8.0);
  EXPECT_EQ(poorest_cell(second).scaled_jacobian, poorest_cell(mesh).scaled_jacobian);
  const Mesh back = to_first_order(second);
  EXPECT_EQ(back.cells, mesh.cells);
  EXPECT_EQ(back.X, mesh.X);
  EXPECT_EQ(back.outline, mesh.outline);
  EXPECT_EQ(back.boundaries, mesh.boundaries);
}

// A cell whose bent edge folds it over must be refused, as must a boundary that ends in the middle of an edge.
TEST(second_order, broken_promises_are_named) {
  Mesh folded = to_second_order(squares(2));
  const int mid = folded.outline[0][1];
  folded.X[mid] += Vec2(0.0, 1.2);
  EXPECT_LT(poorest_cell(folded).scaled_jacobian, 0.0);
  EXPECT_THROW(check(folded), base::MeshError);
  Mesh half = to_second_order(squares(2));
  half.boundaries["half"] = {{half.outline[0][0], half.outline[0][1]}};
  EXPECT_THROW(check(half), base::MeshError);
  Mesh torn = to_second_order(squares(2));
  torn.X.push_back(torn.X[torn.cells[0][5]]);
  torn.cells[0][5] = torn.node_count() - 1;
  EXPECT_THROW(outline_of(torn.X, torn.kind, torn.cells), base::MeshError);
}

}  // namespace
