#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <functional>
#include <numbers>

#include "fem/assemble_loads.hpp"
#include "fem/element.hpp"
#include "fem/stiffness.hpp"
#include "finite_support.hpp"
#include "material/stress.hpp"
#include "mesh/measure.hpp"
#include "mesh/quadratic_edge.hpp"
#include "steel.hpp"
#include "support/meshes.hpp"

namespace {

using namespace reye;
using base::Analysis;
using base::Vec2;
using base::Vector;
using fem_tests::nodal;
using fem_tests::Steel;
using fem_tests::steel;
using mesh::CellKind;
using mesh::Mesh;
using FieldOf = std::function<Vec2(const Vec2&)>;

std::vector<bool> on_outline(const Mesh& m) {
  std::vector<bool> held(m.X.size(), false);
  for (const auto& loop : m.outline)
    for (int node : loop) held[node] = true;
  return held;
}

/// Largest component of r at the nodes that are not on the outline.
double inner_size(const Mesh& m, const Vector& r) {
  const auto held = on_outline(m);
  double largest = 0.0;
  for (int k = 0; k < m.node_count(); ++k)
    if (!held[k]) largest = std::max(largest, r.segment<2>(2 * k).cwiseAbs().maxCoeff());
  return largest;
}

/// T6 with straight edges, distorted; Q8 as parallelograms: serendipity functions hold all quadratics of x, y there.
Mesh straight(CellKind kind) {
  if (kind == CellKind::tri6) return support::rectangle({.size = {3, 2}, .kind = kind, .distortion = 0.9});
  return support::mapped(support::rectangle({.size = {3, 2}, .kind = kind}),
                         [](const Vec2& x) { return Vec2(x.x() + 0.4 * x.y(), 0.9 * x.y() - 0.1 * x.x()); });
}

Vec2 quadratic(const Vec2& x) {
  return {x[0] * x[0] - 0.5 * x[0] * x[1] + 2 * x[1] * x[1] + x[0], -x[0] * x[0] + 3 * x[0] * x[1] + 0.5 * x[1] * x[1]};
}

// A quadratic displacement must be in balance with its constant body force, to round-off.
TEST(second_order, quadratic_field_is_exact) {
  // div u = 2 x - y/2 + 3 x + y, Laplace u = (2 + 4, -2 + 1).
  const Vec2 b = -(Steel::lambda + Steel::mu) * Vec2(5.0, 0.5) - Steel::mu * Vec2(6.0, -1.0);
  for (CellKind kind : {CellKind::tri6, CellKind::quad8}) {
    const Mesh m = straight(kind);
    const auto K = fem::stiffness(m, steel, Analysis::plane_strain, false);
    const Vector f = fem::load_vector(m, Analysis::plane_strain, fem::BodyForce{"b", "", b, ""});
    const Vector Ku = K * nodal(m, quadratic);
    EXPECT_LT(inner_size(m, Ku - f), 1e-12 * Ku.cwiseAbs().maxCoeff());
    EXPECT_GT(inner_size(m, f), 1.0);
  }
}

// The linear stress of a quadratic displacement must be recovered at every node.
TEST(second_order, linear_stress_is_recovered) {
  for (CellKind kind : {CellKind::tri6, CellKind::quad8}) {
    const Mesh m = straight(kind);
    base::Points u;
    for (const Vec2& x : m.X) u.push_back(quadratic(x));
    const auto stress = fem::nodal_stress(m, steel, Analysis::plane_strain, false, u);
    for (int k = 0; k < m.node_count(); ++k) {
      const Vec2& x = m.X[k];
      const material::Voigt<double> strain{2 * x[0] - 0.5 * x[1] + 1, 3 * x[0] + x[1],
                                           -0.5 * x[0] + 4 * x[1] - 2 * x[0] + 3 * x[1], 0.0};
      const auto exact = material::stress(steel, Analysis::plane_strain, strain);
      for (int i = 0; i < 4; ++i) EXPECT_NEAR(stress[k][i], exact[i], 1e-9);
    }
  }
}

// Uniform strain must be in balance inside curved cells too, and under pressure on curved edges at every node.
TEST(second_order, patch_of_curved_cells) {
  const Eigen::Matrix2d G{{1.3e-3, 0.4e-3}, {-1.1e-3, -0.7e-3}};
  for (CellKind kind : {CellKind::tri6, CellKind::quad8})
    for (auto analysis : {Analysis::plane_strain, Analysis::plane_stress}) {
      const Mesh m = support::ring({1.0, 2.0, 1.3, 3, 4, kind});
      const auto K = fem::stiffness(m, steel, analysis, false);
      const Vector Ku = K * nodal(m, [&](const Vec2& x) { return Vec2(G * x); });
      EXPECT_LT(inner_size(m, Ku), 1e-12 * Ku.cwiseAbs().maxCoeff());
      const double stretch = 1e-3;
      const double pressure = -material::stress(steel, analysis, material::Voigt<double>{stretch, stretch, 0, 0})[0];
      Vector f = Vector::Zero(2 * m.node_count());
      for (const auto& [name, boundary] : m.boundaries)
        f += fem::load_vector(m, analysis, {name, name, pressure, {0, 0}, {}, ""});
      const Vector swollen = K * nodal(m, [&](const Vec2& x) { return Vec2(stretch * x); });
      EXPECT_LT((swollen - f).norm(), 1e-12 * f.norm());
    }
}

// Pressure on a part of a curved edge must have the resultant of its chord, and a traction that of its length.
TEST(second_order, curved_interval_has_exact_resultant) {
  const Mesh m = support::ring({1.0, 2.0, 1.5, 2, 3, CellKind::quad8});
  const auto& chain = m.boundaries.at("right").front();  // from the x axis upwards: arc length counts from its end
  const double total = mesh::length(m.X, chain, 2), from = 0.4, to = 2.1;
  const auto point = [&](double s) {
    std::size_t k = 0;
    while (true) {
      const mesh::QuadraticEdge e{m.X[chain[k]], m.X[chain[k + 1]], m.X[chain[k + 2]]};
      if (s <= e.length()) return e.at(e.parameter_at(s));
      s -= e.length();
      k += 2;
    }
  };
  const auto resultant = [](const Vector& f) {
    Vec2 sum{0, 0};
    for (int k = 0; k < f.size(); k += 2) sum += f.segment<2>(k);
    return sum;
  };
  const Vec2 chord = point(total - from) - point(total - to);
  const Vector p = fem::load_vector(m, Analysis::plane_strain, {"p", "right", 8.0, {0, 0}, {{from, to}}, ""});
  EXPECT_LT((resultant(p) + 8.0 * base::right_of(chord)).norm(), 1e-12);
  const Vector t = fem::load_vector(m, Analysis::plane_strain, {"t", "right", 0.0, {3, -4}, {{from, to}}, ""});
  EXPECT_LT((resultant(t) - Vec2(3, -4) * (to - from)).norm(), 1e-7);
  const Vector ring = fem::load_vector(m, Analysis::axisymmetric, {"p", "right", 8.0, {0, 0}, {}, ""});
  EXPECT_NEAR(resultant(ring).y(), -8.0 * std::numbers::pi * (4.0 - std::pow(2.0 * std::cos(1.5), 2)), 1e-10);
}

/// A displacement field with its gradient (and u_r / r) and the body force that holds it.
struct Manufactured {
  Analysis analysis;
  FieldOf u, b;
  std::function<material::Voigt<double>(const Vec2&)> strain;
};

Manufactured plane() {
  using std::cos, std::sin;
  return {Analysis::plane_strain, [](const Vec2& x) { return Vec2(sin(x[0]) * cos(x[1]), cos(x[0]) * sin(2 * x[1])); },
          [](const Vec2& x) {
            const double s = sin(x[0]), c = cos(x[0]);
            const Vec2 grad_div(-s * cos(x[1]) - 2 * s * cos(2 * x[1]), -c * sin(x[1]) - 4 * c * sin(2 * x[1]));
            return Vec2(-(Steel::lambda + Steel::mu) * grad_div -
                        Steel::mu * Vec2(-2 * s * cos(x[1]), -5 * c * sin(2 * x[1])));
          },
          [](const Vec2& x) {
            return material::Voigt<double>{cos(x[0]) * cos(x[1]), 2 * cos(x[0]) * cos(2 * x[1]),
                                           -sin(x[0]) * sin(x[1]) - sin(x[0]) * sin(2 * x[1]), 0.0};
          }};
}

/// u_r = r^2 cos z, u_z = r sin z.
Manufactured ring() {
  using std::cos, std::sin;
  return {Analysis::axisymmetric, [](const Vec2& x) { return Vec2(x[0] * x[0] * cos(x[1]), x[0] * sin(x[1])); },
          [](const Vec2& x) {
            const double r = x[0], s = sin(x[1]), c = cos(x[1]);
            const Vec2 laplace((3 - r * r) * c, s / r - r * s);  // the radial one with - u_r / r^2
            return Vec2(-(Steel::lambda + Steel::mu) * Vec2(4 * c, -4 * r * s) - Steel::mu * laplace);
          },
          [](const Vec2& x) {
            const double r = x[0], s = sin(x[1]), c = cos(x[1]);
            return material::Voigt<double>{2 * r * c, r * c, s - r * r * s, r * c};
          }};
}

/// Displacements under the body force with the outline held where the exact field has it.
Vector solved(const Mesh& m, const Manufactured& exact) {
  const auto K = fem::stiffness(m, steel, exact.analysis, false);
  Vector f = Vector::Zero(2 * m.node_count());
  for (int cell = 0; cell < m.cell_count(); ++cell)
    for (const auto& p : fem::volume_points(m, cell, exact.analysis)) {
      Vec2 x = Vec2::Zero();
      for (int a = 0; a < mesh::nodes_per_cell(m.kind); ++a) x += p.N[a] * m.X[m.cells[cell][a]];
      for (int a = 0; a < mesh::nodes_per_cell(m.kind); ++a)
        f.segment<2>(2 * m.cells[cell][a]) += p.N[a] * p.volume * exact.b(x);
    }
  const auto held = on_outline(m);
  Vector u = nodal(m, exact.u);
  std::vector<int> number(2 * m.node_count(), -1);
  int count = 0;
  for (int k = 0; k < 2 * m.node_count(); ++k)
    if (held[k / 2])
      f -= u[k] * K.col(k);
    else
      number[k] = count++;
  std::vector<base::Triplet> entries;
  Vector rest(count);
  for (int k = 0; k < K.outerSize(); ++k) {
    if (number[k] < 0) continue;
    rest[number[k]] = f[k];
    for (base::SparseMatrix::InnerIterator it(K, k); it; ++it)
      if (number[it.row()] >= 0) entries.emplace_back(number[it.row()], number[k], it.value());
  }
  base::SparseMatrix inner(count, count);
  inner.setFromTriplets(entries.begin(), entries.end());
  const Vector solution = Eigen::SimplicialLDLT<base::SparseMatrix>(inner).solve(rest);
  for (int k = 0; k < u.size(); ++k)
    if (number[k] >= 0) u[k] = solution[number[k]];
  return u;
}

/// Norms of the error: L2 of displacements, and energy.
std::array<double, 2> errors(const Mesh& m, const Manufactured& exact, const Vector& u) {
  const auto C = material::tangent(steel, exact.analysis);
  double l2 = 0.0, energy = 0.0;
  for (int cell = 0; cell < m.cell_count(); ++cell)
    for (const auto& at : fem::volume_rule(m.kind)) {
      const auto N = fem::shape_functions(m.kind, at.xi);
      const auto dN_dxi = fem::shape_gradients(m.kind, at.xi);
      Eigen::Matrix2d J = Eigen::Matrix2d::Zero(), U = Eigen::Matrix2d::Zero();  // dx / dxi, du / dxi
      Vec2 x = Vec2::Zero(), uh = Vec2::Zero();
      for (int a = 0; a < mesh::nodes_per_cell(m.kind); ++a) {
        const int node = m.cells[cell][a];
        x += N[a] * m.X[node];
        uh += N[a] * u.segment<2>(2 * node);
        J += m.X[node] * dN_dxi.row(a);
        U += u.segment<2>(2 * node) * dN_dxi.row(a);
      }
      const Eigen::Matrix2d grad = U * J.inverse();
      const bool hoop = exact.analysis == Analysis::axisymmetric;
      const auto strain = exact.strain(x);
      const Eigen::Vector4d e(grad(0, 0) - strain[0], grad(1, 1) - strain[1], grad(0, 1) + grad(1, 0) - strain[2],
                              hoop ? uh.x() / x.x() - strain[3] : 0.0);
      const double volume = at.weight * J.determinant() * base::out_of_plane(exact.analysis, x.x());
      l2 += volume * (uh - exact.u(x)).squaredNorm();
      energy += volume * e.dot(C * e);
    }
  return {std::sqrt(l2), std::sqrt(energy)};
}

// On smoothly curved meshes displacements must converge at third order in L2, at second in energy, straight meshes of
// first order at second and first: plane strain and axisymmetry.
TEST(second_order, convergence) {
  const auto bent = [](const Vec2& x) {
    return Vec2(1.0 + x[0] + 0.15 * std::sin(2.0 * x[1] + x[0]), x[1] + 0.1 * std::sin(3.0 * x[0]));
  };
  for (const Manufactured& exact : {plane(), ring()})
    for (CellKind kind : {CellKind::quad4, CellKind::tri6, CellKind::quad8}) {
      std::array<double, 2> last{};
      for (int n : {8, 16, 32}) {
        const Mesh m = support::mapped(support::rectangle({.nx = n, .ny = n, .kind = kind}), bent);
        const auto error = errors(m, exact, solved(m, exact));
        if (n > 8) {
          EXPECT_GT(std::log2(last[0] / error[0]), mesh::order(kind) + 0.9) << static_cast<int>(kind) << " L2";
          EXPECT_GT(std::log2(last[1] / error[1]), mesh::order(kind) - 0.1) << static_cast<int>(kind) << " energy";
        }
        last = error;
      }
      RecordProperty(
          "finest_" + std::to_string(static_cast<int>(kind)) + "_" + std::to_string(static_cast<int>(exact.analysis)),
          std::to_string(last[0]) + " " + std::to_string(last[1]));
    }
}

/// Displacements under f with some dofs held by very stiff springs.
Vector held_at(base::SparseMatrix K, const Vector& f, const std::vector<int>& dofs) {
  for (int k : dofs) K.coeffRef(k, k) += 1e13;
  return Eigen::SimplicialLDLT<base::SparseMatrix>(K).solve(f);
}

// A slender cantilever of one layer of cells must bend as Timoshenko's beam.
TEST(second_order, cantilever) {
  const double timoshenko = 1000.0 / 3 * 12 / Steel::E + 1.2 * 10 / Steel::mu;
  for (CellKind kind : {CellKind::tri6, CellKind::quad8}) {
    const Mesh m = support::rectangle({.size = {10, 1}, .nx = 10, .ny = 1, .kind = kind});
    const auto K = fem::stiffness(m, steel, Analysis::plane_stress, false);
    std::vector<int> held;
    for (int node : m.boundaries.at("left").front()) held.insert(held.end(), {2 * node, 2 * node + 1});
    const fem::BoundaryLoad shear{"f", "right", 0.0, {0.0, 1.0}, {}, ""};
    const Vector u = held_at(K, fem::load_vector(m, Analysis::plane_stress, shear), held);
    EXPECT_NEAR(u[2 * support::node_at(m, {10, 0.5}) + 1] / timoshenko, 1.0, 0.01);
  }
}

// A pipe under inner pressure must widen as Lame says, of nearly incompressible Q8 too: reduced integration keeps them
// from locking.
TEST(second_order, pipe) {
  const Mesh m = support::ring({1.0, 2.0, std::numbers::pi / 2, 3, 4, CellKind::quad8});
  for (double poisson : {0.3, 0.4999}) {
    const auto K = fem::stiffness(m, material::LinearElastic{Steel::E, poisson}, Analysis::plane_strain, false);
    std::vector<int> held;
    for (int node : m.boundaries.at("bottom").front()) held.push_back(2 * node + 1);
    for (int node : m.boundaries.at("top").front()) held.push_back(2 * node);
    const fem::BoundaryLoad pressure{"p", "left", 3.0, {0, 0}, {}, ""};
    const Vector u = held_at(K, fem::load_vector(m, Analysis::plane_strain, pressure), held);
    for (const char* edge : {"left", "right"})
      for (int node : m.boundaries.at(edge).front()) {
        const double r = m.X[node].norm(),
                     exact = (1 + poisson) / Steel::E * 3.0 / 3.0 * ((1 - 2 * poisson) * r + 4.0 / r);
        EXPECT_NEAR(u.segment<2>(2 * node).dot(m.X[node]) / r / exact, 1.0, 2e-3) << poisson;
      }
  }
}

}  // namespace
