#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.hpp"
#include "support/bodies.hpp"
#include "support/meshes.hpp"

namespace {

using namespace reye;
using base::Vec2;
using base::Vector;
using body::ContactIndex;
using body::Drive;
using support::fixed_edge;
using support::loaded;
using support::rectangle;

body::Support line(const std::string& edge) {
  body::Support s;
  s.name = s.edge = edge;
  s.rigid = true;
  return s;
}

body::BodyInput rigid_input() {
  auto in = support::elastic(1.0, 0.3);
  in.contact_boundaries = {"bottom"};
  in.supports = {line("top")};
  in.supports[0].y = loaded(-3.0);
  in.supports[0].rotation.drive = Drive::fixed;
  return in;
}

mesh::Mesh rigid_block() { return rectangle({.corner = {1, 2}, .size = {3, 2}, .nx = 3, .ny = 2}); }

/// Error of central differences with step h against the terms of all positions, at q.
double rigid_position_error(const body::RigidBody& b, const Vector& q, double h) {
  double error = 0.0;
  for (int k = 0; k < static_cast<int>(b.contact_nodes().size()); ++k) {
    const auto p = b.position(ContactIndex(k), q);
    for (int t = 0; t < p.count; ++t) {
      Vector plus = q, minus = q;
      plus[p.terms[t].column] += h;
      minus[p.terms[t].column] -= h;
      const Vec2 difference = (b.position(ContactIndex(k), plus).x - b.position(ContactIndex(k), minus).x) / (2 * h);
      error = std::max(error, (difference - p.terms[t].direction).norm());
    }
  }
  return error;
}

// The derivatives of positions must agree with central differences at rate 2, at a large rotation.
TEST(rigid_body, position_derivatives_have_rate_two) {
  auto in = rigid_input();
  in.supports[0].angle_deg = 25.0;
  const body::RigidBody b(body::make_shape(rigid_block()), in);
  const Vector q = Vector{{0.3, -0.2, 0.8}};
  const double coarse = rigid_position_error(b, q, 1e-2), fine = rigid_position_error(b, q, 5e-3);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.02);
}

// Distances must be kept whatever the motion, and the centre of the supported edge must move by the translation.
TEST(rigid_body, motion_is_rigid) {
  const auto m = rigid_block();
  const body::RigidBody b(body::make_shape(m), rigid_input());
  const auto u = b.recover(Vector{{0.3, -0.2, 2.1}}, {});
  for (int i = 0; i < m.node_count(); ++i)
    EXPECT_NEAR((m.X[i] + u[i] - m.X[0] - u[0]).norm(), (m.X[i] - m.X[0]).norm(), 1e-14);
  const int l = support::node_at(m, {1, 4}), r = support::node_at(m, {4, 4});
  EXPECT_LT((0.5 * (u[l] + u[r]) - Vec2{0.3, -0.2}).norm(), 1e-14);
}

// The tangent with load factors must be the derivative of the residual, at rate 2.
TEST(rigid_body, dead_load_tangent_has_rate_two) {
  auto in = rigid_input();
  in.boundary_loads = {{"p", "right", 4.0, {1.0, 2.0}, {{0.2, 1.1}}, ""}};
  in.body_forces = {{"g", "", {0.4, -1.0}, ""}};
  const body::RigidBody b(body::make_shape(rigid_block()), in);
  const Vector q{{0.1, 0.2, 0.7}}, factors{{1.5, 0.5}};
  const auto error = [&](double h) {
    Vector plus = q, minus = q;
    plus[2] += h;
    minus[2] -= h;
    const Vector d = (b.residual(plus, factors) - b.residual(minus, factors)) / (2 * h);
    return (d - b.tangent(q, factors).col(2)).norm();
  };
  EXPECT_NEAR(std::log2(error(1e-2) / error(5e-3)), 2.0, 0.02);
}

// The geometric part must be the change of the contact moment with the rotation, at rate 2.
TEST(rigid_body, geometric_part_has_rate_two) {
  const body::RigidBody b(body::make_shape(rigid_block()), rigid_input());
  const std::vector<Vec2> forces{{1, 2}, {-3, 1}, {0.5, 4}, {2, -1}};
  const auto moment = [&](const Vector& q) {
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) sum += forces[k].dot(b.position(ContactIndex(k), q).terms[2].direction);
    return sum;
  };
  const Vector q{{0.1, 0.2, 0.7}};
  const auto error = [&](double h) {
    const Vector step{{0, 0, h}};
    return std::abs((moment(q + step) - moment(q - step)) / (2 * h) - b.geometric(q, forces));
  };
  EXPECT_NEAR(std::log2(error(1e-2) / error(5e-3)), 2.0, 0.02);
}

// Loads must enter with their exact resultant and moment, with cells or from the outline alone.
TEST(rigid_body, loads_have_exact_resultants) {
  auto m = rigid_block();
  auto in = rigid_input();
  in.body_forces = {{"g", "", {0.5, -2.0}, ""}};
  in.point_loads = {{"f", "", {4.0, 2.0}, {0.0, 7.0}, ""}};
  for (bool outline_only : {false, true}) {
    if (outline_only) m.cells.clear();
    const body::RigidBody b(body::make_shape(m), in);
    const Vector r = b.residual(Vector::Zero(3), Vector::Ones(2));
    EXPECT_NEAR(r[0], -3.0, 1e-12);
    EXPECT_NEAR(r[1], 12.0 - 7.0, 1e-12);
    EXPECT_NEAR(r[2], -(7.0 * 1.5 + base::cross(Vec2{0, -1}, Vec2{3, -12})), 1e-12);
  }
}

// Supports must find their columns; a node-wise edge holds the rotation unless it only slides along itself.
TEST(rigid_body, supports_map_to_its_motions) {
  auto in = rigid_input();
  const body::RigidBody loaded_head(body::make_shape(rigid_block()), in);
  ASSERT_EQ(loaded_head.support_columns().size(), 3u);
  in.supports = {fixed_edge("clamp", "top")};
  const body::RigidBody clamped(body::make_shape(rigid_block()), in);
  EXPECT_EQ(clamped.support_columns().size(), 2u);
  EXPECT_EQ(clamped.tangent(Vector::Zero(3))(2, 2), 1.0);
  in.supports[0].y.drive = Drive::free;
  const body::RigidBody sliding(body::make_shape(rigid_block()), in);
  EXPECT_EQ(sliding.tangent(Vector::Zero(3))(2, 2), 0.0);
}

// Supports of one rigid body with different axes must be an input error.
TEST(rigid_body, mixed_axes_are_refused) {
  auto in = rigid_input();
  in.supports.push_back(line("left"));
  in.supports[1].angle_deg = 10.0;
  in.supports[1].x.drive = Drive::fixed;
  EXPECT_THROW(body::RigidBody(body::make_shape(rigid_block()), in), base::InputError);
}

// In axisymmetry only the motion along the axis must remain.
TEST(rigid_body, axisymmetric_moves_along_the_axis) {
  auto in = rigid_input();
  in.analysis = base::Analysis::axisymmetric;
  const body::RigidBody b(body::make_shape(rigid_block()), in);
  const auto p = b.position(ContactIndex(0), Vector{{5.0, 0.25, 1.0}});
  ASSERT_EQ(p.count, 1);
  EXPECT_EQ(p.terms[0].column, 1);
  EXPECT_EQ(p.x, Vec2(1.0, 2.25));
  ASSERT_EQ(b.support_columns().size(), 1u);
  EXPECT_EQ(b.support_columns()[0].column, 1);
}

}  // namespace
