#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "body/turning.hpp"
#include "support/bodies.hpp"
#include "support/meshes.hpp"

namespace {

using namespace reye;
using base::Vec2;
using base::Vector;
using body::ContactIndex;
using body::Drive;
using support::loaded;
using support::moved;
using support::rectangle;

enum class Guide { edge, edge_axes, point, contact };
constexpr Guide all_guides[] = {Guide::edge, Guide::edge_axes, Guide::point, Guide::contact};

mesh::Mesh block(mesh::CellKind kind = mesh::CellKind::quad4) {
  return rectangle({.corner = {1, 2}, .size = {3, 2}, .nx = 5, .ny = 4, .kind = kind, .distortion = 0.4});
}

/// A block that can turn, under loads of every kind.
body::BodyInput input(Guide guide) {
  auto in = support::elastic(1000.0, 0.3);
  in.contact_boundaries = {"bottom"};
  in.centre = {2.0, 2.5};
  in.boundary_loads = {{"p", "right", 4.0, {1.0, 2.0}, {{0.2, 1.1}}, ""}};
  in.body_forces = {{"g", "", {0.4, -1.0}, ""}};
  if (guide == Guide::contact) return in;
  body::Support s;
  s.name = "guide";
  s.x = moved(0.2);
  s.y = loaded(-3.0);
  if (guide == Guide::point) {
    s.point_mm = Vec2{2.2, 3.0};
  } else {
    s.edge = "top";
    s.edge_axes = guide == Guide::edge_axes;
    s.rotation = moved(1.3);
  }
  in.supports = {s};
  return in;
}

/// Some state that is far turned and strained a little.
Vector some(const body::LinearBody& b) {
  Vector q(b.dofs());
  for (int i = 0; i < b.dofs(); ++i) q[i] = 0.03 * std::sin(7.0 * i + 1.0);
  q[b.turning()->angle] = 2.3;
  return q;
}

/// Error of central differences of step h.
double tangent_error(const body::LinearBody& b, const Vector& factors, double h) {
  const Vector q = some(b);
  const base::Matrix K = b.tangent(q, factors);
  double error = 0.0;
  for (int k = 0; k < b.dofs(); ++k) {
    Vector plus = q, minus = q;
    plus[k] += h;
    minus[k] -= h;
    const Vector difference = (b.residual(plus, factors) - b.residual(minus, factors)) / (2.0 * h);
    error = std::max(error, (difference - K.col(k)).norm());
  }
  return error;
}

// The tangent of a body that turns must be the derivative of its residual, loads and moment row included: rate 2.
TEST(turning, tangent_has_rate_two) {
  for (Guide guide : all_guides) {
    const body::LinearBody b(body::make_shape(block()), input(guide));
    ASSERT_TRUE(b.turning());
    const Vector factors{{1.5, 0.5}};
    const double coarse = tangent_error(b, factors, 2e-2), fine = tangent_error(b, factors, 1e-2);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.02) << static_cast<int>(guide);
  }
}

double position_error(const body::LinearBody& b, double h) {
  const Vector q = some(b);
  double error = 0.0;
  for (int k = 0; k < static_cast<int>(b.contact_nodes().size()); ++k) {
    const auto p = b.position(ContactIndex(k), q);
    base::Matrix slope = base::Matrix::Zero(2, b.dofs());
    for (int t = 0; t < p.count; ++t) slope.col(p.terms[t].column) += p.terms[t].direction;
    slope.col(p.angle) += p.swing;
    for (int i = 0; i < b.dofs(); ++i) {
      Vector plus = q, minus = q;
      plus[i] += h;
      minus[i] -= h;
      error = std::max(
          error,
          ((b.position(ContactIndex(k), plus).x - b.position(ContactIndex(k), minus).x) / (2.0 * h) - slope.col(i))
              .norm());
    }
  }
  return error;
}

// Derivatives of positions must agree with central differences at rate 2, also those of control points and of nodes
// that belong to the edge the body turns with.
TEST(turning, position_derivatives_have_rate_two) {
  for (auto kind : {mesh::CellKind::quad4, mesh::CellKind::quad8})
    for (Guide guide : all_guides) {
      auto in = input(guide);
      in.contact_boundaries.push_back("right");  // shares a corner with the edge on top
      const body::LinearBody b(body::make_shape(block(kind)), in);
      const double coarse = position_error(b, 1e-2), fine = position_error(b, 5e-3);
      EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.02) << static_cast<int>(guide);
    }
}

// Turning by any angle and moving must cost neither force nor energy, and must move every node rigidly.
TEST(turning, rigid_motion_costs_nothing) {
  for (Guide guide : all_guides) {
    auto in = input(guide);
    in.boundary_loads.clear();
    in.body_forces.clear();
    const auto m = block();
    const body::LinearBody b(body::make_shape(m), in);
    const double angle = 40.0 * std::numbers::pi + 1.1;
    const Vec2 way{0.7, -0.4}, pivot = b.turning()->centre;
    Vector q = Vector::Zero(b.dofs());
    q[b.turning()->angle] = angle;
    for (const auto& s : b.support_columns())
      if (s.motion < 2) q[s.column] = s.direction.dot(way);
    const std::vector<Vec2> w(b.contact_nodes().size(), Vec2(body::rotation(-angle) * way));
    body::seat(b, w, q);
    EXPECT_LT(b.residual(q, {}).norm(), 1e-9) << static_cast<int>(guide);
    EXPECT_LT(b.strain_energy(q), 1e-11);  // mJ per mm; moving so far unrigidly would take 650
    const auto u = b.recover(q, {});
    for (int i = 0; i < m.node_count(); ++i)
      EXPECT_LT((m.X[i] + u[i] - pivot - way - body::rotation(angle) * (m.X[i] - pivot)).norm(), 1e-12);
  }
}

// A body that is turned with its dead loads must be strained as it was, and its reactions must have turned with it.
TEST(turning, is_objective) {
  constexpr double angle = 2.0;
  const Eigen::Matrix2d R = body::rotation(angle);
  const auto solved = [&](double turn) {
    auto in = input(Guide::edge);
    in.supports[0].y = in.supports[0].x = {Drive::fixed};
    in.supports[0].rotation = moved(turn);
    const Vec2 traction = turn == 0.0 ? Vec2{1.0, 2.0} : Vec2(R * Vec2{1.0, 2.0});
    in.boundary_loads = {{"p", "right", 4.0, traction, {{0.2, 1.1}}, ""}};
    const Vec2 force = turn == 0.0 ? Vec2{0.4, -1.0} : Vec2(R * Vec2{0.4, -1.0});
    in.body_forces = {{"g", "", force, ""}};
    const body::LinearBody b(body::make_shape(block()), in);
    auto s = support::solve_linear(b, in);
    return std::tuple(b.recover_in_frame(s.q, s.factors), Vector(b.at_supports(s.q, s.factors)), b.support_columns());
  };
  const auto [w, r, columns] = solved(0.0);
  const auto [w_turned, r_turned, same] = solved(angle);
  double largest = 0.0, difference = 0.0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    largest = std::max(largest, w[i].norm());
    difference = std::max(difference, (w[i] - w_turned[i]).norm());
  }
  EXPECT_LT(difference, 1e-12 * largest);
  Vec2 force{0, 0}, turned{0, 0};
  for (const auto& c : columns) {
    force += r[c.column] * c.direction;
    turned += r_turned[c.column] * c.direction;
    if (c.motion == 2) {
      EXPECT_NEAR(r[c.column], r_turned[c.column], 1e-11 * std::abs(r[c.column]));
    }
  }
  EXPECT_LT((R * force - turned).norm(), 1e-11 * force.norm());
}

// A body must turn where its supports let it, and nowhere else; where one of fixed direction stands in the way it is
// named.
TEST(turning, is_decided_by_supports) {
  const auto m = block();
  const auto turns = [&](const body::BodyInput& in) { return body::pivot_of(m, in).has_value(); };
  for (Guide guide : all_guides) EXPECT_TRUE(turns(input(guide)));
  auto held = input(Guide::edge);
  held.supports[0].rotation = {Drive::fixed};
  EXPECT_FALSE(turns(held));
  EXPECT_EQ(body::keeps_direction(m, held), "");
  auto clamped = input(Guide::edge);
  clamped.supports.push_back(support::fixed_edge("wall", "left"));
  EXPECT_FALSE(turns(clamped));
  EXPECT_EQ(body::keeps_direction(m, clamped), "");
  auto roller = input(Guide::contact);
  body::Support guide;
  guide.name = "roller";
  guide.point_mm = Vec2{2.2, 3.0};
  guide.x.drive = Drive::fixed;
  roller.supports = {guide};
  EXPECT_FALSE(turns(roller));
  EXPECT_EQ(body::keeps_direction(m, roller), "roller");
  auto ring = input(Guide::contact);
  ring.analysis = base::Analysis::axisymmetric;
  EXPECT_FALSE(turns(ring));
}

}  // namespace
