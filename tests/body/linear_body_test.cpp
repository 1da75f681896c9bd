#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "algebra/decompose.hpp"
#include "body/turning.hpp"
#include "fem/assemble_loads.hpp"
#include "fem/stiffness.hpp"
#include "support/bodies.hpp"
#include "support/meshes.hpp"

namespace {

using namespace reye;
using base::Vec2;
using base::Vector;
using body::ContactIndex;
using body::Drive;
using support::fixed_edge;
using support::moved;
using support::rectangle;

constexpr double steel_modulus = 210e3;

body::BodyInput steel(base::Analysis analysis = base::Analysis::plane_strain) {
  return support::elastic(steel_modulus, 0.3, analysis);
}

double largest(const base::Points& u) {
  double m = 0.0;
  for (const Vec2& v : u) m = std::max(m, v.norm());
  return m;
}

double difference(const base::Points& a, const base::Points& b) {
  double m = 0.0;
  for (size_t k = 0; k < a.size(); ++k) m = std::max(m, (a[k] - b[k]).norm());
  return m / largest(b);
}

/// Nodal displacements of the uncondensed problem with the nodes of an edge clamped.
base::Points clamped_reference(const mesh::Mesh& mesh, const body::BodyInput& in, const std::string& edge,
                               const Vector& f) {
  base::Matrix K = fem::stiffness(mesh, in.material, in.analysis, in.b_bar);
  Vector rhs = f;
  for (int node : mesh::nodes_of(mesh.boundaries.at(edge)))
    for (int dof : {2 * node, 2 * node + 1}) {
      K.row(dof).setZero();
      K.col(dof).setZero();
      K(dof, dof) = 1.0;
      rhs[dof] = 0.0;
    }
  const Vector u = algebra::solve_symmetric(K, rhs);
  base::Points points;
  for (int k = 0; k < mesh.node_count(); ++k) points.push_back(u.segment<2>(2 * k));
  return points;
}

// The condensed body must give the displacements of the full finite element system.
TEST(linear_body, condensed_equals_full) {
  for (auto kind : {mesh::CellKind::quad4, mesh::CellKind::tri3}) {
    const auto m = rectangle({.size = {3, 2}, .nx = 7, .ny = 5, .kind = kind, .distortion = 0.6});
    auto in = steel();
    in.supports = {fixed_edge("wall", "bottom")};
    in.contact_boundaries = {"top"};
    in.boundary_loads = {{"push", "top", 10.0, {3.0, 0.0}, {{0.4, 1.7}}, ""}};
    const body::LinearBody b(body::make_shape(m), in);
    const auto solved = support::solve_linear(b, in);
    const auto reference = clamped_reference(m, in, "bottom", fem::load_vector(m, in.analysis, in.boundary_loads[0]));
    EXPECT_LT(difference(b.recover(solved.q, solved.factors), reference), 1e-11);
  }
}

// Support reactions read from the residual must balance every load on the body, force and moment.
TEST(linear_body, reactions_balance_loads) {
  const auto m = rectangle({.corner = {1, -1}, .size = {3, 2}, .nx = 6, .ny = 5, .distortion = 0.5});
  auto in = steel();
  in.supports = {fixed_edge("wall", "left"), fixed_edge("foot", "right")};
  in.supports[0].rigid = true;
  in.supports[0].rotation.drive = Drive::fixed;
  in.supports[1].x.drive = Drive::free;
  in.contact_boundaries = {"top"};
  in.boundary_loads = {{"push", "top", 10.0, {3.0, 0.0}, {{0.4, 1.7}}, ""}};
  in.point_loads = {{"pull", "", {2.5, -1.0}, {4.0, -7.0}, ""}};
  in.body_forces = {{"weight", "", {0.5, -1.5}, ""}};
  const body::LinearBody b(body::make_shape(m), in);
  const auto s = support::solve_linear(b, in);
  Vec2 load{0, 0};
  for (const auto& f : support::load_vectors(m, in))
    for (int k = 0; k < m.node_count(); ++k) load += f.segment<2>(2 * k);
  const Vector r = b.at_supports(s.q, s.factors), all = b.residual(s.q, s.factors);
  Vec2 reaction{0, 0};
  for (const auto& c : b.support_columns()) {
    reaction += r[c.column] * c.direction;
    EXPECT_NEAR(r[c.column], all[c.column], 1e-11 * load.norm());
  }
  EXPECT_LT((reaction + load).norm(), 1e-11 * load.norm());
}

// A rigid edge loaded by a force and a moment must carry exactly these, and stay a straight line.
TEST(linear_body, rigid_edge_carries_force_and_moment) {
  const auto m = support::turned(rectangle({.size = {2, 4}, .nx = 4, .ny = 8, .distortion = 0.5}), 0.4);
  auto in = steel();
  in.supports = {fixed_edge("wall", "bottom"), {}};
  in.supports[0].rigid = true;
  in.supports[0].rotation.drive = Drive::fixed;
  auto& head = in.supports[1];
  head.name = "head";
  head.edge = "top";
  head.angle_deg = 30.0;
  head.x = {Drive::loaded, {{12.0, ""}}};
  head.y = {Drive::loaded, {{-31.0, ""}}};
  head.rotation = {Drive::loaded, {{17.0, ""}}};
  const body::LinearBody b(body::make_shape(m), in);
  ASSERT_EQ(b.dofs(), 6);
  const auto s = support::solve_linear(b, in);
  const Vector r = b.residual(s.q, s.factors);
  const auto& top = m.boundaries.at("top")[0];
  const auto& bottom = m.boundaries.at("bottom")[0];
  const Vec2 arm = 0.5 * (m.X[top.front()] + m.X[top.back()]) - 0.5 * (m.X[bottom.front()] + m.X[bottom.back()]);
  Vec2 force{0, 0}, reaction{0, 0};
  double moment = 0.0;
  for (const auto& c : b.support_columns()) {
    (c.support == 1 ? force : reaction) += r[c.column] * c.direction;
    if (c.motion == 2) moment += r[c.column];
  }
  const double angle = std::numbers::pi / 6;
  const Vec2 expected = 12.0 * Vec2{std::cos(angle), std::sin(angle)} - 31.0 * Vec2{-std::sin(angle), std::cos(angle)};
  EXPECT_LT((force - expected).norm(), 1e-11 * expected.norm());
  EXPECT_LT((force + reaction).norm(), 1e-11 * expected.norm());
  EXPECT_NEAR(moment + base::cross(arm, force), 0.0, 1e-10 * expected.norm());
  const auto u = b.recover(s.q, s.factors);
  const Vec2 chord = u[top.back()] - u[top.front()];
  for (size_t k = 1; k + 1 < top.size(); ++k) {
    const double share = (m.X[top[k]] - m.X[top.front()]).norm() / (m.X[top.back()] - m.X[top.front()]).norm();
    EXPECT_LT((u[top[k]] - u[top.front()] - share * chord).norm(), 1e-12 * largest(u));
  }
}

// A turned body on rollers along its own edges, moved along the normal, must be in uniform uniaxial stress.
TEST(linear_body, edge_normal_rollers_on_a_turned_body) {
  const double angle = 0.7, stretch = 1e-3, height = 2.0;
  const auto m = support::turned(rectangle({.size = {3, height}, .nx = 5, .ny = 4, .distortion = 0.7}), angle);
  auto in = steel(base::Analysis::plane_stress);
  for (const char* edge : {"bottom", "left", "top"}) {
    body::Support s;
    s.name = s.edge = edge;
    s.edge_axes = true;
    s.y.drive = Drive::fixed;
    in.supports.push_back(s);
  }
  in.supports[2].y = moved(stretch * height);
  const body::LinearBody b(body::make_shape(m), in);
  EXPECT_EQ(b.support_columns().size(), 3u);
  const auto s = support::solve_linear(b, in);
  const auto u = b.recover(s.q, s.factors);
  const auto stress = fem::nodal_stress(m, in.material, in.analysis, in.b_bar, u);
  const double c = std::cos(angle), d = std::sin(angle), sigma = steel_modulus * stretch;
  for (const auto& t : stress) {
    EXPECT_NEAR(t[0], sigma * d * d, 1e-10 * sigma);
    EXPECT_NEAR(t[1], sigma * c * c, 1e-10 * sigma);
    EXPECT_NEAR(t[2], -sigma * c * d, 1e-10 * sigma);
  }
  const Vector r = b.residual(s.q, s.factors);
  EXPECT_NEAR(r[b.support_columns()[2].column], sigma * 3.0, 1e-9 * sigma);
}

// On a curved edge every node must get its own column along its own normal.
TEST(linear_body, curved_edge_has_a_column_per_node) {
  const auto m = support::ring({.across = 3, .around = 6});
  auto in = steel();
  body::Support s;
  s.name = s.edge = "right";
  s.edge_axes = true;
  s.y = moved(0.01);
  in.supports = {s, fixed_edge("sym_x", "top"), fixed_edge("sym_y", "bottom")};
  in.supports[1].y.drive = Drive::free;
  in.supports[2].x.drive = Drive::free;
  const body::LinearBody b(body::make_shape(m), in);
  EXPECT_EQ(b.support_columns().size(), 7u + 2u);
  const auto solved = support::solve_linear(b, in);
  const auto u = b.recover(solved.q, solved.factors);
  for (int node : mesh::nodes_of(m.boundaries.at("right"))) {
    if (m.X[node].x() < 1e-9 || m.X[node].y() < 1e-9) continue;
    EXPECT_NEAR(u[node].dot(m.X[node].normalized()), 0.01, 1e-14);
  }
}

// A node between two oblique rollers must obey both; its reactions must be along the two held directions.
TEST(linear_body, corner_of_two_oblique_rollers) {
  const auto m = rectangle({.nx = 3, .ny = 3});
  auto in = steel();
  in.supports = {fixed_edge("a", "bottom"), fixed_edge("b", "left")};
  in.supports[0].x.drive = Drive::free;
  in.supports[0].y = moved(0.02);
  in.supports[1].y.drive = Drive::free;
  in.supports[1].angle_deg = 20.0;
  in.supports[1].x = moved(-0.01);
  in.contact_boundaries = {"bottom"};
  const body::LinearBody b(body::make_shape(m), in);
  const auto s = support::solve_linear(b, in);
  const Vec2 u = b.recover(s.q, s.factors)[0];
  const Vec2 d{std::cos(std::numbers::pi / 9), std::sin(std::numbers::pi / 9)};
  EXPECT_NEAR(u.y(), 0.02, 1e-14);
  EXPECT_NEAR(u.dot(d), -0.01, 1e-14);
  EXPECT_EQ(b.freedom(ContactIndex(0)).free, 0);
  EXPECT_EQ(b.freedom(ContactIndex(1)).free, 1);
  EXPECT_NEAR(std::abs(b.freedom(ContactIndex(1)).direction.x()), 1.0, 1e-15);
}

// Positions must be X + u of the recovered field, and their terms its exact derivative.
TEST(linear_body, positions_match_recovery) {
  const auto m = rectangle({.nx = 4, .ny = 3, .distortion = 0.4});
  auto in = steel();
  in.supports = {fixed_edge("wall", "bottom"), fixed_edge("side", "right")};
  in.supports[1].angle_deg = 15.0;
  in.supports[1].y.drive = Drive::free;
  in.contact_boundaries = {"top", "right"};
  const body::LinearBody b(body::make_shape(m), in);
  Vector q(b.dofs());
  for (int k = 0; k < q.size(); ++k) q[k] = 0.01 * std::sin(3.0 * k + 1.0);
  const auto u = b.recover(q, {});
  for (int k = 0; k < static_cast<int>(b.contact_nodes().size()); ++k) {
    const int node = b.contact_nodes()[k];
    const auto p = b.position(ContactIndex(k), q);
    EXPECT_LT((p.x - m.X[node] - u[node]).norm(), 1e-13);
    for (int t = 0; t < p.count; ++t) {
      Vector moved_q = q;
      moved_q[p.terms[t].column] += 1.0;
      EXPECT_LT((b.position(ContactIndex(k), moved_q).x - p.x - p.terms[t].direction).norm(), 1e-13);
    }
  }
}

// A body that nothing holds must condense all the same, and its rigid motions must cost no force.
TEST(linear_body, floating_body_resists_no_rigid_motion) {
  const auto m = support::turned(rectangle({.size = {2, 1}, .nx = 8, .ny = 5, .distortion = 0.5}), 0.3);
  auto in = steel();
  in.contact_boundaries = {"top", "right"};
  const body::LinearBody b(body::make_shape(m), in);
  const auto& nodes = b.contact_nodes();
  ASSERT_EQ(b.dofs(), 2 * static_cast<int>(nodes.size()) + 1);  // and the angle of its frame
  for (int motion = 0; motion < 3; ++motion) {
    Vector q = Vector::Zero(b.dofs());
    for (size_t k = 0; k < nodes.size(); ++k) {
      const Vec2 X = m.X[nodes[k]];
      q.segment<2>(2 * k) = motion == 0 ? Vec2{1, 0} : motion == 1 ? Vec2{0, 1} : Vec2{-X.y(), X.x()};
    }
    EXPECT_LT(b.residual(q, {}).head(b.dofs() - 1).norm(), 1e-12 * b.stiffness().norm());
  }
}

/// A body on an edge held node by node or as a whole, along axes that are turned with it.
body::LinearBody turned_body(bool rigid) {
  auto in = steel();
  in.supports = {fixed_edge("plate", "bottom")};
  in.supports[0].angle_deg = 20.0;
  in.supports[0].rigid = rigid;
  in.contact_boundaries = {"top", "right"};
  const auto m = rectangle({.size = {2, 1}, .nx = 8, .ny = 5, .distortion = 0.5});
  return body::LinearBody(body::make_shape(support::turned(m, std::numbers::pi / 9.0)), in);
}

// A body must cost no force where it is moved as a whole, and all its points must move with it.
TEST(linear_body, translation_is_rigid) {
  for (bool rigid : {false, true}) {
    const auto b = turned_body(rigid);
    const Vec2 a{3.7, -11.3};
    const auto q = b.translation().with(a, Vector::Zero(b.dofs()));
    for (const Vec2& u : b.recover(q.high, {})) EXPECT_LT((u - a).norm(), 1e-11);
    EXPECT_LT(b.residual(q.high, {}).norm(), 1e-12 * b.tangent(q.high).norm() * a.norm());
    EXPECT_LT((b.translation().of(q.high) - a).norm(), 1e-13 * a.norm());
  }
}

// A small deformation must cost the same force after the body has moved far, to the digits of the deformation.
TEST(linear_body, far_motion_costs_no_digits) {
  for (bool rigid : {false, true}) {
    const auto b = turned_body(rigid);
    Vector v(b.dofs());
    for (int i = 0; i < b.dofs(); ++i) v[i] = 1e-9 * std::sin(1.0 + 2.3 * i);
    if (b.turning()) v[b.turning()->angle] = 0.0;
    const Vector force = b.residual(v, {});
    const auto q = b.translation().with({3.7, -11.3}, v);
    EXPECT_LT((b.residual(b.translation().without(q), {}) - force).norm(), 1e-13 * force.norm());
    EXPECT_GT((b.residual(q.high, {}) - force).norm(), 1e-8 * force.norm());
  }
}

// A ring widens by strain: along the radius nothing is rigid.
TEST(linear_body, ring_is_rigid_along_its_axis_only) {
  auto in = steel(base::Analysis::axisymmetric);
  in.contact_boundaries = {"top"};
  const body::LinearBody b(body::make_shape(rectangle({.corner = {1, 0}, .size = {1, 1}, .nx = 3, .ny = 3})), in);
  const auto q = b.translation().with({1.0, 2.0}, Vector::Zero(b.dofs()));
  for (const Vec2& u : b.recover(q.high, {})) EXPECT_LT((u - Vec2(0.0, 2.0)).norm(), 1e-12);
}

// Nodes on the axis of symmetry must stay there without any support saying so.
TEST(linear_body, axis_of_symmetry_is_held) {
  const auto m = rectangle({.size = {2, 3}, .nx = 4, .ny = 6});
  auto in = steel(base::Analysis::axisymmetric);
  in.supports = {fixed_edge("plate", "bottom"), {}};
  in.supports[0].x.drive = Drive::free;
  auto& head = in.supports[1];
  head.name = head.edge = "top";
  head.y = {Drive::loaded, {{-50.0, ""}}};
  in.contact_boundaries = {"left"};
  const body::LinearBody b(body::make_shape(m), in);
  const auto s = support::solve_linear(b, in);
  const auto u = b.recover(s.q, s.factors);
  for (int node : mesh::nodes_of(m.boundaries.at("left"))) EXPECT_EQ(u[node].x(), 0.0);
  EXPECT_EQ(b.freedom(ContactIndex(1)).free, 1);
  const Vector r = b.residual(s.q, s.factors);
  double sum = 0.0;
  for (const auto& c : b.support_columns())
    if (c.support == 0) sum += r[c.column];
  EXPECT_NEAR(sum, 50.0, 1e-10);
}

}  // namespace
