#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "elastic.hpp"
#include "fem/finite.hpp"
#include "support/assembly.hpp"

namespace {

using namespace reye;
using base::Vec2;
using contact::ContactStatus;
using mesh::CellKind;
using support::Elastic;
using support::rubber;
using Tensor = Eigen::Matrix2d;

/// Cauchy stress in the plane: J sigma = mu (F F^T - I) + lambda ln J I.
Tensor cauchy(const Tensor& F) {
  const double J = F.determinant();
  return (material::shear_modulus(rubber) * (F * F.transpose() - Tensor::Identity()) +
          material::lame_lambda(rubber) * std::log(J) * Tensor::Identity()) /
         J;
}

/// Height shrinks to `height`, the sides are free: the width for which sigma_11 = 0, by Newton.
Tensor pressed(double height) {
  const double mu = material::shear_modulus(rubber), lambda = material::lame_lambda(rubber);
  double a = 1.0;
  for (int k = 0; k < 30; ++k) a -= (mu * (a * a - 1.0) + lambda * std::log(a * height)) / (2.0 * mu * a + lambda / a);
  return Vec2(a, height).asDiagonal();
}

Tensor sheared(double width, double shear, double height) { return (Tensor() << width, shear, 0.0, height).finished(); }

/// The lower block is [0, width] x [-1, 0], the upper one [a, b] x [0, 1]; both take on the same F.
struct FinitePatch {
  Tensor F = pressed(0.85);
  double friction = 0.0;
  double a = 0.0, b = 2.0, width = 2.0;
  double angle = 0.0;  ///< [rad] of the whole scene
  int upper = 3, lower = 2;
  CellKind lower_kind = CellKind::quad4, upper_kind = CellKind::quad4;
  contact::DualOrder dual = contact::DualOrder::quadratic;
  bool upper_secondary = true;

  Vec2 turned(const Vec2& v) const { return Eigen::Rotation2Dd(angle) * v; }
  double degrees() const { return angle * 180.0 / std::numbers::pi; }
  Tensor nominal() const { return F.determinant() * cauchy(F) * F.inverse().transpose(); }
  Vec2 displacement(const Vec2& X) const { return (F - Tensor::Identity()) * (X - Vec2(0.0, -1.0)); }
};

/// The dead traction P N on an edge with outward normal N on X.
fem::BoundaryLoad nominal_load(const FinitePatch& s, const std::string& edge, const Vec2& N) {
  fem::BoundaryLoad l;
  l.name = l.edge = edge;
  l.traction_MPa = s.turned(s.nominal() * N);
  return l;
}

body::BodyInput input_of(const FinitePatch& s) {
  auto in = support::elastic(Elastic::E, Elastic::nu);
  in.material = rubber;
  in.kinematics = base::Kinematics::finite;
  in.boundary_loads = {nominal_load(s, "right", {1, 0}), nominal_load(s, "left", {-1, 0})};
  return in;
}

body::BodyInput lower_input(const FinitePatch& s) {
  auto in = input_of(s);
  in.supports = {support::guide("floor", "bottom", 'y', {body::Drive::fixed}, s.degrees()),
                 support::pin("pin", s.turned({0, -1}), {body::Drive::fixed}, s.degrees())};
  in.boundary_loads.push_back(nominal_load(s, "bottom", {0, -1}));
  for (const auto& [from, to] : {std::pair{0.0, s.a}, {s.b, s.width}}) {
    if (to <= from) continue;
    in.boundary_loads.push_back(nominal_load(s, "top", {0, 1}));
    in.boundary_loads.back().interval_mm = {from, to};
  }
  return in;
}

/// The pin holds nothing in the end: on the way there, or without friction, it keeps the upper block in its place.
body::BodyInput upper_input(const FinitePatch& s) {
  auto in = input_of(s);
  const Vec2 corner(s.a, 1.0);
  in.supports = {support::pin("pin", s.turned(corner), support::moved(s.displacement(corner).x()), s.degrees())};
  in.boundary_loads.push_back(nominal_load(s, "top", {0, 1}));
  return in;
}

support::Assembly assembly(const FinitePatch& s) {
  support::Assembly a;
  const auto block = [&](const Vec2& corner, double width, int nx, CellKind kind) {
    return support::turned(
        support::rectangle({.corner = corner, .size = {width, 1}, .nx = nx, .ny = 2, .kind = kind, .distortion = 0.4}),
        s.angle);
  };
  a.meshes = {block({0, -1}, s.width, s.lower, s.lower_kind), block({s.a, 0}, s.b - s.a, s.upper, s.upper_kind)};
  a.inputs = {lower_input(s), upper_input(s)};
  contact::ContactOptions o;
  o.friction = s.friction;
  o.dual = s.dual;
  support::touch_either(a, o, s.upper_secondary, {1, "bottom"}, {0, "top"});
  return a;
}

/// Displacement and stress of a body must be those of F at each node.
void expect_homogeneous(const FinitePatch& s, const body::BodyInput& in, const mesh::Mesh& mesh,
                        const body::NonlinearBody& body, const base::Vector& q, const body::Interior& interior) {
  const auto u = body.recover(q, interior.y);
  base::Vector all(2 * static_cast<Eigen::Index>(u.size()));
  for (std::size_t i = 0; i < u.size(); ++i) {
    all.segment<2>(2 * static_cast<Eigen::Index>(i)) = u[i];
    const Vec2 X = Eigen::Rotation2Dd(-s.angle) * mesh.X[i];
    EXPECT_LT((u[i] - s.turned(s.displacement(X))).norm(), 1e-10) << "node " << i;
  }
  const auto state = fem::nodal_state(mesh, {in.material, in.analysis, in.kinematics, in.b_bar}, all, interior.history);
  const Tensor Q = Eigen::Rotation2Dd(s.angle).toRotationMatrix();
  const Tensor sigma = Q * cauchy(s.F) * Q.transpose();
  for (const auto& at : state.stress) {
    const Tensor found = (Tensor() << at[0], at[2], at[2], at[1]).finished();
    EXPECT_LT((found - sigma).norm(), 1e-10 * sigma.norm());
  }
}

/// Every active node must carry the Cauchy traction to 1e-10 of the pressure (in second order D falls with the cube of
/// the covered share, and the rounding of its node's force counts A / D times); returns how many there are.
int expect_patch(const FinitePatch& s, ContactStatus status) {
  const auto a = assembly(s);
  const auto system = support::system_of(a);
  solver::Newton newton({.max_iterations = 30, .force_tolerance = 1e-12, .condition_tolerance = 1e-11});
  const auto result = newton.solve(system, support::fresh(system), support::controls_of(a, system));
  EXPECT_TRUE(result.report.converged) << result.report.reason;
  if (!result.report.converged) return 0;
  for (int b = 0; b < 2; ++b)
    expect_homogeneous(s, a.inputs[b], a.meshes[b], std::get<body::NonlinearBody>(system.bodies[b]),
                       system.part(result.state.q.high, b), result.state.interiors[b]);
  const Tensor sigma = cauchy(s.F);
  const double pressure = -sigma(1, 1), shear = std::abs(sigma(0, 1));
  const auto& setup = system.contacts[0];
  const auto& state = result.state.contacts[0];
  int active = 0;
  for (int j = 0; j < setup.secondary_count(); ++j) {
    if (state.status[j] == ContactStatus::inactive) continue;
    ++active;
    const Vec2 t = support::traction(setup, state, j);
    const double rounding = setup.secondary.order == 1 ? 1.0 : setup.secondary.area[j] / state.reference[j].D;
    EXPECT_NEAR(t.x(), pressure, 1e-10 * pressure * rounding) << "node " << j;
    EXPECT_NEAR(std::abs(t.y()), shear, 1e-10 * pressure * rounding) << "node " << j;
    EXPECT_EQ(state.status[j], status) << "node " << j;
  }
  return active;
}

/// All four kinds of cells against each other, both kinds of multipliers on those of second order, both sides
/// secondary, upright and turned; wholly and partly covered.
void every_pairing(FinitePatch s, ContactStatus status) {
  const std::pair<CellKind, CellKind> kinds[] = {{CellKind::quad4, CellKind::quad4}, {CellKind::tri3, CellKind::quad4},
                                                 {CellKind::quad8, CellKind::quad8}, {CellKind::quad8, CellKind::tri6},
                                                 {CellKind::tri6, CellKind::quad4},  {CellKind::tri3, CellKind::quad8}};
  for (const auto& [lower, upper] : kinds)
    for (const bool partly : {false, true})
      for (const bool upper_secondary : {true, false})
        for (const double angle : {0.0, std::numbers::pi / 6.0})
          for (const auto dual : {contact::DualOrder::quadratic, contact::DualOrder::linear}) {
            s.lower_kind = lower;
            s.upper_kind = upper;
            s.upper_secondary = upper_secondary;
            s.angle = angle;
            s.dual = dual;
            if (mesh::order(upper_secondary ? upper : lower) == 1 && dual == contact::DualOrder::linear) continue;
            std::tie(s.a, s.b, s.width) = partly ? std::tuple{0.7, 2.23, 3.1} : std::tuple{0.0, 2.0, 2.0};
            SCOPED_TRACE(std::to_string(static_cast<int>(lower)) + " below " + std::to_string(static_cast<int>(upper)) +
                         (partly ? ", partly covered, " : ", ") + (upper_secondary ? "upper" : "lower") +
                         " secondary, " + std::to_string(s.degrees()) + " degrees, dual " +
                         std::to_string(static_cast<int>(dual)));
            EXPECT_GE(expect_patch(s, status), 3);
          }
}

// Blocks pressed to 85 % of their height must carry the closed form's stress everywhere, without friction and with.
TEST(finite_patch, pressed) {
  every_pairing({}, ContactStatus::slip);
  every_pairing({.friction = 0.3}, ContactStatus::stick);
}

// Blocks pressed and sheared, held together by friction alone, must do so.
TEST(finite_patch, sheared) { every_pairing({.F = sheared(1.04, 0.05, 0.88), .friction = 0.5}, ContactStatus::stick); }

}  // namespace
