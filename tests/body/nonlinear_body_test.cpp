#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "algebra/decompose.hpp"
#include "base/errors.hpp"
#include "body/columns.hpp"
#include "body/operator.hpp"
#include "fem/finite.hpp"
#include "fem/follower.hpp"
#include "solids.hpp"
#include "support/bodies.hpp"
#include "support/meshes.hpp"
#include "support/tangent.hpp"

namespace {

using namespace reye;
using base::Analysis;
using base::Kinematics;
using base::Matrix;
using base::Vec2;
using base::Vector;
using body::ContactIndex;
using body::Drive;
using body::NonlinearBody;
using support::fixed_edge;
using support::made_of;
using support::metal;
using support::moved;
using support::rectangle;
using support::rubber;

body::Support rigid_edge(const std::string& name, const std::string& edge, body::Motion x, body::Motion y,
                         body::Motion turn) {
  body::Support s;
  s.name = name;
  s.edge = edge;
  s.rigid = true;
  s.x = x;
  s.y = y;
  s.rotation = turn;
  return s;
}

double largest_difference(const base::Points& a, const base::Points& b) {
  double m = 0.0;
  for (size_t k = 0; k < a.size(); ++k) m = std::max(m, (a[k] - b[k]).norm());
  return m;
}

/// A body with a contact boundary, a node-wise support, a rigid edge and loads of every sort.
body::BodyInput busy(const material::Material& m, Kinematics kinematics) {
  auto in = made_of(m, kinematics);
  in.supports = {rigid_edge("grip", "left", {}, {}, moved(0.2)), fixed_edge("foot", "bottom")};
  in.supports[0].x.drive = in.supports[0].y.drive = Drive::fixed;
  in.supports[1].x.drive = Drive::free;
  in.contact_boundaries = {"top", "right"};
  in.boundary_loads = {{"push", "top", 0.5, {0.2, 0.0}, {{0.4, 1.7}}, ""}};
  in.point_loads = {{"pull", "", {2.0, 1.0}, {0.3, -0.2}, ""}};
  in.body_forces = {{"weight", "", {0.05, -0.1}, ""}};
  return in;
}

/// A state (y, q) off equilibrium.
struct State {
  body::Interior before;
  Vector y, q, factors;
};

State off_equilibrium(const NonlinearBody& b) {
  State s{b.start(), {}, {}, Vector::Constant(static_cast<int>(b.loads().size()), 0.7)};
  const auto wave = [](Eigen::Index n, double k) { return Vector(0.02 * Vector::LinSpaced(n, 0.0, k).array().sin()); };
  s.y = wave(s.before.y.size(), 9.0);
  s.q = wave(b.dofs(), 5.0);
  for (const auto& c : b.support_columns())
    if (c.motion == 2) s.q[c.column] = 0.3;
  return s;
}

// A nonlinear body of an elastic material at small strain must be what a linear body is, reactions included.
TEST(nonlinear_body, small_elastic_equals_linear_body) {
  const auto m = rectangle({.size = {3, 2}, .nx = 6, .ny = 5, .distortion = 0.5});
  const auto in = busy(material::LinearElastic{300.0, 0.3}, Kinematics::small);
  const body::LinearBody linear(body::make_shape(m), in);
  const NonlinearBody b(body::make_shape(m), in);
  ASSERT_EQ(b.dofs(), linear.dofs());
  const auto expected = support::solve_linear(linear, in);
  const auto s = support::solve_nonlinear(b, in);
  EXPECT_LT((s.q - expected.q).norm(), 1e-10 * expected.q.norm());
  EXPECT_LT(largest_difference(b.recover(s.q, s.state.y), linear.recover(expected.q, expected.factors)), 1e-10);
  const Vector r = linear.residual(expected.q, expected.factors);
  EXPECT_LT((b.retained_residual(b.start(), s.state.y, s.q, s.factors) - r).norm(), 1e-10 * r.norm());
  for (size_t k = 0; k < b.contact_nodes().size(); ++k)
    EXPECT_LT((b.position(ContactIndex(k), s.q).x - linear.position(ContactIndex(k), s.q).x).norm(), 1e-14);
}

class nonlinear_body : public testing::TestWithParam<std::tuple<Kinematics, bool>> {
 protected:
  mesh::Mesh mesh_ = rectangle({.size = {3, 2}, .nx = 6, .ny = 5, .distortion = 0.5});
  body::BodyInput input_ = busy(std::get<1>(GetParam()) ? metal : rubber, std::get<0>(GetParam()));
  NonlinearBody body_{body::make_shape(mesh_), input_};
  State s_ = off_equilibrium(body_);

  fem::Solid solid() const { return {input_.material, input_.analysis, input_.kinematics, input_.b_bar}; }
  bool linear() const { return input_.kinematics == Kinematics::small && !std::get<1>(GetParam()); }

  static Vector as_vector(const base::Points& points) {
    Vector u(2 * points.size());
    for (size_t k = 0; k < points.size(); ++k) u.segment<2>(2 * k) = points[k];
    return u;
  }

  /// All loads at factor one on the nodes; at finite strain the pressure follows the surface.
  Vector loads(const Vector& u) const {
    auto in = input_;
    Vector f = Vector::Zero(u.size());
    if (in.kinematics == Kinematics::finite) {
      fem::FollowerPressure(mesh_, in.analysis, in.boundary_loads[0]).add_force(1.0, mesh_, u, f);
      in.boundary_loads[0].pressure_MPa = 0.0;
    }
    for (const auto& dead : support::load_vectors(mesh_, in)) f += dead;
    return f;
  }

  /// Residual on all unknowns [y; q], from nodal forces and the positions of nodes alone.
  Vector residual(const Vector& unknowns) const {
    const auto in = static_cast<Eigen::Index>(s_.y.size());
    const Vector u = as_vector(body_.recover(unknowns.tail(body_.dofs()), unknowns.head(in)));
    fem::InternalForce f;
    fem::internal_force(mesh_, solid(), u, s_.before.history, f);
    f.total -= 0.7 * loads(u);
    Vector r = Vector::Zero(unknowns.size());
    const double h = 1e-6;  // virtual displacements by central differences: r = (du/dy)^T f
    for (int j = 0; j < unknowns.size(); ++j) {
      Vector a = unknowns, b = unknowns;
      a[j] += h, b[j] -= h;
      const auto ua = body_.recover(a.tail(body_.dofs()), a.head(in)),
                 ub = body_.recover(b.tail(body_.dofs()), b.head(in));
      for (int k = 0; k < mesh_.node_count(); ++k) r[j] += f.total.segment<2>(2 * k).dot(ua[k] - ub[k]) / (2 * h);
    }
    return r;
  }

  Vector unknowns() const {
    Vector both(s_.y.size() + s_.q.size());
    both << s_.y, s_.q;
    return both;
  }
};

// What the retained dofs carry must be the virtual work of all nodal forces.
TEST_P(nonlinear_body, retained_residual_is_virtual_work) {
  const Vector r = residual(unknowns());
  const Vector carried = body_.retained_residual(s_.before, s_.y, s_.q, s_.factors);
  EXPECT_LT((r.tail(body_.dofs()) - carried).norm(), 1e-7 * carried.norm());
}

// What supports carry must be the retained residual in their columns, and nothing stands in the others.
TEST_P(nonlinear_body, supports_carry_their_share_of_the_residual) {
  const Vector all = body_.retained_residual(s_.before, s_.y, s_.q, s_.factors);
  const Vector carried = body_.at_supports(s_.before, s_.y, s_.q, s_.factors);
  Vector expected = Vector::Zero(all.size());
  ASSERT_FALSE(body_.support_columns().empty());
  for (const auto& support : body_.support_columns()) expected[support.column] = all[support.column];
  EXPECT_GT(expected.norm(), 0.0);
  EXPECT_LT((carried - expected).norm(), 1e-14 * all.norm());
}

// The condensed step must be the step of the full sparse system, supports imposed.
TEST_P(nonlinear_body, condensed_step_equals_full_step) {
  const auto columns = body::number_columns(mesh_, input_);
  for (const auto& c : columns.supports) s_.q[c.column] = 0.0;  // where B is that of the columns
  NonlinearBody::Linearised lin;
  body_.linearise(s_.before, s_.y, s_.q, s_.factors, lin);

  const base::SparseMatrix B = columns.expansion();
  const fem::Pattern pattern(mesh_);
  auto sparse = support::tangent(mesh_, solid(), B * unknowns(), s_.before.history, pattern);
  fem::InternalForce f;
  fem::internal_force(mesh_, solid(), B * unknowns(), s_.before.history, f);
  f.total -= 0.7 * loads(B * unknowns());
  if (input_.kinematics == Kinematics::finite)
    fem::FollowerPressure(mesh_, input_.analysis, input_.boundary_loads[0])
        .add_tangent(-0.7, mesh_, B * unknowns(), pattern, sparse);
  Matrix K = B.transpose() * (sparse * B);
  Vector rhs = -(B.transpose() * f.total), condensed = -lin.r;
  for (const auto& c : columns.supports) {
    for (auto [A, b, row] :
         {std::tuple{&K, &rhs, columns.interior + c.column}, std::tuple{&lin.S, &condensed, c.column}}) {
      A->row(row).setZero();
      (*A)(row, row) = 1000.0;
      (*b)[row] = 1000.0 * 0.01 * (1 + c.column % 3);
    }
  }
  const Vector full = algebra::least_squares(K, rhs), dq = algebra::least_squares(lin.S, condensed);
  EXPECT_LT((full.tail(body_.dofs()) - dq).norm(), 1e-10 * full.norm());
  EXPECT_LT((full.head(columns.interior) - body_.interior_step(lin, dq)).norm(), 1e-10 * full.norm());
}

// Along a condensed step the residual of all unknowns must change as S and the interior equations say, at rate 2.
TEST_P(nonlinear_body, condensed_step_is_the_derivative) {
  NonlinearBody::Linearised lin;
  body_.linearise(s_.before, s_.y, s_.q, s_.factors, lin);
  const Vector r = residual(unknowns()), r_c = body_.retained_residual(s_.before, s_.y, s_.q, s_.factors);
  EXPECT_NEAR(lin.interior_residual, r.head(s_.y.size()).cwiseAbs().maxCoeff(), 1e-6 * lin.force_scale);
  // Along any dq the whole residual changes by r(z + h dz) = r + h (0 - r_i; S dq + r_hat - r_c) + O(h^2).
  const Vector dq = 0.1 * Vector::LinSpaced(body_.dofs(), 1.0, 8.0).array().cos();
  const Vector dy = body_.interior_step(lin, dq);
  Vector predicted(r.size());
  predicted << -r.head(s_.y.size()), lin.S * dq + lin.r - r_c;
  const auto error = [&](double h) {
    Vector step(r.size());
    step << dy, dq;
    return ((residual(unknowns() + h * step) - residual(unknowns() - h * step)) / (2 * h) - predicted).norm() /
           predicted.norm();
  };
  const double coarse = error(4e-3), fine = error(1e-3);
  if (!linear()) {
    EXPECT_GT(std::log(coarse / fine) / std::log(4.0), 1.8) << coarse << " " << fine;
  }
  EXPECT_LT(fine, linear() ? 1e-8 : 1e-3);
}

// A second linearisation on the same memory must give what a fresh one gives.
TEST_P(nonlinear_body, memory_changes_nothing) {
  NonlinearBody::Linearised used, fresh;
  body_.linearise(s_.before, 0.5 * s_.y, 0.3 * s_.q, s_.factors, used);
  body_.linearise(s_.before, s_.y, s_.q, s_.factors, used);
  body_.linearise(s_.before, s_.y, s_.q, s_.factors, fresh);
  EXPECT_EQ((used.S - fresh.S).norm(), 0.0);
  EXPECT_EQ((used.r - fresh.r).norm(), 0.0);
}

// Newton of a body alone must end quadratically.
TEST_P(nonlinear_body, newton_ends_quadratically) {
  const auto s = support::solve_nonlinear(body_, input_, 4);
  ASSERT_LT(s.table.back(), 1e-11);
  ASSERT_LE(s.table.size(), linear() ? 3u : 8u);
  const size_t k = s.table.size() - 2;
  if (!linear()) {
    EXPECT_LT(s.table[k], 30 * std::pow(s.table[k - 1], 1.8)) << s.table[k - 1] << " " << s.table.back();
  }
}

// At equilibrium reactions must balance the loads.
TEST_P(nonlinear_body, reactions_balance_loads) {
  const auto s = support::solve_nonlinear(body_, input_, 4);
  Vec2 load{0, 0}, reaction{0, 0};
  const Vector f = loads(as_vector(body_.recover(s.q, s.state.y)));
  for (int k = 0; k < mesh_.node_count(); ++k) load += f.segment<2>(2 * k);
  const Vector r = body_.retained_residual(s.state, s.state.y, s.q, s.factors);
  for (const auto& c : body_.support_columns()) reaction += r[c.column] * c.direction;
  EXPECT_LT((reaction + load).norm(), 1e-8 * r.cwiseAbs().maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(all, nonlinear_body,
                         testing::Combine(testing::Values(Kinematics::small, Kinematics::finite), testing::Bool()));

// A rigid edge turned by 60 degrees must carry a free body with it, unstrained and without force.
TEST(nonlinear_body, rigid_edge_turns_the_body) {
  const double angle = std::numbers::pi / 3;
  const auto m = rectangle({.size = {2, 1}, .nx = 6, .ny = 3, .distortion = 0.5});
  auto in = made_of(rubber, Kinematics::finite);
  in.supports = {rigid_edge("grip", "left", moved(0.5), moved(-0.2), moved(angle))};
  in.contact_boundaries = {"left"};
  const NonlinearBody b(body::make_shape(m), in);
  const auto s = support::solve_nonlinear(b, in, 4);
  const Eigen::Matrix2d R{{std::cos(angle), -std::sin(angle)}, {std::sin(angle), std::cos(angle)}};
  const Vec2 centre{0.0, 0.5};
  const auto u = b.recover(s.q, s.state.y);
  for (int k = 0; k < m.node_count(); ++k) {
    const Vec2 x = centre + Vec2{0.5, -0.2} + R * (m.X[k] - centre);
    EXPECT_LT((m.X[k] + u[k] - x).norm(), 1e-9);
  }
  EXPECT_LT(b.retained_residual(s.state, s.state.y, s.q, s.factors).cwiseAbs().maxCoeff(), 1e-8);
}

// Positions of contact nodes on a turning edge must have the derivatives they give, the second one included.
TEST(nonlinear_body, positions_on_a_turning_edge_are_differentiated) {
  const auto m = rectangle({.size = {2, 1}, .nx = 3, .ny = 3});
  auto in = made_of(rubber, Kinematics::finite);
  in.supports = {rigid_edge("grip", "left", {}, {}, moved(1.0))};
  in.contact_boundaries = {"left"};
  const NonlinearBody b(body::make_shape(m), in);
  Vector q(3);
  q << 0.1, -0.2, 0.8;
  const double h = 1e-4;
  std::vector<Vec2> forces;
  double second = 0.0;
  for (int k = 0; k < 4; ++k) {
    const auto p = b.position(ContactIndex(k), q);
    const Vec2 plus = b.position(ContactIndex(k), q + h * Vector::Unit(3, 2)).x,
               minus = b.position(ContactIndex(k), q - h * Vector::Unit(3, 2)).x;
    for (int t = 0; t < p.count; ++t)
      if (p.terms[t].column == 2) {
        EXPECT_LT((p.terms[t].direction - (plus - minus) / (2 * h)).norm(), 1e-7);
      }
    forces.push_back({1.0 + k, -2.0 * k});
    second += forces.back().dot(plus - 2 * p.x + minus) / (h * h);
  }
  EXPECT_NEAR(b.geometric(q, forces)[2], second, 1e-5 * std::abs(second));
}

// A small deformation must cost the same force after a body has moved far, to the digits of the deformation.
TEST(nonlinear_body, far_motion_costs_no_digits) {
  const auto m = rectangle({.size = {3, 2}, .nx = 6, .ny = 5, .distortion = 0.5});
  for (auto kinematics : {Kinematics::small, Kinematics::finite}) {
    auto in = busy(rubber, kinematics);
    in.boundary_loads.clear();
    in.point_loads.clear();
    in.body_forces.clear();
    const NonlinearBody b(body::make_shape(m), in);
    const auto start = b.start();
    const auto wave = [](Eigen::Index n, double k) {
      return Vector(1e-9 * Vector::LinSpaced(n, 1.0, k).array().sin());
    };
    const Vector v = wave(b.dofs(), 50.0), w = wave(start.y.size(), 90.0);
    const Vector near = b.retained_residual(start, w, v, {});

    const Vec2 a{4.0, -8.0};
    base::TwoPart q = b.translation().with(a, Vector::Zero(b.dofs())), y = start.y;
    b.seat(std::vector<Vec2>(m.X.size(), a), q.high, y);
    q += v;
    y += w;
    EXPECT_LT((b.retained_residual(start, y, q, {}) - near).norm(), 1e-13 * near.norm());
    EXPECT_GT((b.retained_residual(start, y.high, q.high, {}) - near).norm(), 1e-8 * near.norm());
    // Stress is linear in what is so small.
    EXPECT_LT((b.retained_residual(start, 2.0 * w, 2.0 * v, {}) - 2.0 * near).norm(), 1e-8 * near.norm());
    EXPECT_LT((b.retained_residual(start, 1e-6 * w, 1e-6 * v, {}) - 1e-6 * near).norm(), 1e-6 * 1e-8 * near.norm());

    NonlinearBody::Linearised lin;
    b.linearise(start, y, q, {}, lin);
    EXPECT_LT((lin.S * b.translation().with(a, Vector::Zero(b.dofs())).high).norm(), 1e-12 * lin.S.norm() * a.norm());
    EXPECT_LT(lin.deformation, 1e-8);
  }
}

// A failure of the material must name the body.
TEST(nonlinear_body, failures_name_the_body) {
  const auto m = rectangle({.nx = 2, .ny = 2});
  auto in = made_of(rubber, Kinematics::finite);
  in.name = "pin";
  in.supports = {fixed_edge("wall", "left")};
  const NonlinearBody b(body::make_shape(m), in);
  Vector y = b.start().y.high;
  y[4] = -3.0;
  NonlinearBody::Linearised lin;
  try {
    b.linearise(b.start(), y, Vector::Zero(b.dofs()), {}, lin);
    FAIL() << "no error";
  } catch (const base::SolveError& error) {
    EXPECT_EQ(std::string(error.what()).find("body pin, cell "), 0u) << error.what();
  }
}

}  // namespace
