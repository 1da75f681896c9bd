#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <cmath>

#include "algebra/decompose.hpp"
#include "base/errors.hpp"
#include "fem/solid/solid_loads.hpp"
#include "fem/solid/solid_stiffness.hpp"
#include "fem/solid/solid_stress.hpp"
#include "support/solid_blocks.hpp"

namespace {

using namespace reye;
using base::Mat3;
using base::Points3;
using base::SparseMatrix;
using base::Vec3;
using base::Vector;
using mesh::SolidKind;
using support::block;
using support::distort;

const material::Material iron = material::LinearElastic{210e3, 0.3};

Vector stacked(const Points3& u) {
  Vector v(3 * u.size());
  for (size_t k = 0; k < u.size(); ++k) v.segment<3>(3 * k) = u[k];
  return v;
}

Points3 unstacked(const Vector& v) {
  Points3 u(v.size() / 3);
  for (size_t k = 0; k < u.size(); ++k) u[k] = v.segment<3>(3 * k);
  return u;
}

/// K u = f with the dofs of `held` at the values of `given`.
Vector solve_held(const SparseMatrix& K, const Vector& f, const std::vector<char>& held, const Vector& given) {
  std::vector<int> number(held.size(), -1);
  int n = 0;
  for (size_t k = 0; k < held.size(); ++k)
    if (!held[k]) number[k] = n++;
  std::vector<base::Triplet> entries;
  Vector rhs(n);
  const Vector pushed = f - K * given;
  for (int j = 0; j < K.cols(); ++j) {
    if (number[j] < 0) continue;
    rhs[number[j]] = pushed[j];
    for (SparseMatrix::InnerIterator it(K, j); it; ++it)
      if (number[it.row()] >= 0) entries.emplace_back(number[it.row()], number[j], it.value());
  }
  SparseMatrix reduced(n, n);
  reduced.setFromTriplets(entries.begin(), entries.end());
  const Vector x = Eigen::SimplicialLDLT<SparseMatrix>(reduced).solve(rhs);
  Vector u = given;
  for (size_t k = 0; k < held.size(); ++k)
    if (number[k] >= 0) u[k] = x[number[k]];
  return u;
}

/// Marks the dofs of a face's nodes.
void hold(const mesh::SolidMesh& m, const std::string& face, std::initializer_list<int> components,
          std::vector<char>& held) {
  for (int node : mesh::nodes_of(mesh::facets_of(m, face)))
    for (int c : components) held[3 * node + c] = 1;
}

// Where the skin of distorted cells moves linearly the inside must, too, with a stress that is constant: the patch
// test.
TEST(solid_stiffness, patch_of_distorted_cells) {
  Mat3 H;
  H << 1.0, 0.2, -0.3, 0.5, -0.7, 0.4, 0.1, 0.6, 0.9;
  H *= 1e-3;
  for (auto kind : support::solid_kinds) {
    // Of tet10 the edges stay straight: quadrature of degree two asks for it.
    auto m = block(kind == SolidKind::tet10 ? SolidKind::tet4 : kind, {3, 3, 3}, Vec3(1, 1, 1), distort);
    if (kind == SolidKind::tet10) {
      m.kind = kind;
      support::detail::add_middle_nodes(m);
      m.skin = mesh::skin_of(m.X, kind, m.cells);
    }
    const SparseMatrix K = fem::stiffness(m, iron);
    std::vector<char> held(3 * m.X.size(), 0);
    for (int node : mesh::nodes_of(m.skin))
      for (int c = 0; c < 3; ++c) held[3 * node + c] = 1;
    Vector exact(3 * m.X.size());
    for (int k = 0; k < m.node_count(); ++k) exact.segment<3>(3 * k) = H * m.X[k];
    Vector given = exact;
    for (size_t k = 0; k < held.size(); ++k)
      if (!held[k]) given[k] = 0.0;
    const Vector u = solve_held(K, Vector::Zero(K.rows()), held, given);
    EXPECT_LT((u - exact).lpNorm<Eigen::Infinity>(), 1e-12 * exact.lpNorm<Eigen::Infinity>());
    const Mat3 strain = 0.5 * (H + H.transpose());
    const double mu = 210e3 / 2.6, lambda = 210e3 * 0.3 / (1.3 * 0.4);
    const Mat3 s = 2.0 * mu * strain + lambda * strain.trace() * Mat3::Identity();
    for (const auto& stress : fem::nodal_stress(m, iron, unstacked(u)))
      EXPECT_LT((Eigen::Matrix<double, 6, 1>(stress.data()) -
                 Eigen::Matrix<double, 6, 1>{s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(2, 0)})
                    .norm(),
                1e-11 * s.norm());
    const auto error = fem::recovered_error(m, iron, unstacked(u));
    EXPECT_LT(error.difference, 1e-20 * error.energy);
    const double volume = mesh::volume(m);
    EXPECT_NEAR(error.energy, volume * s.cwiseProduct(strain).sum(), 1e-10 * error.energy);
  }
}

// Rigid motions of curved cells must cost no force, and nothing else may: six zero eigenvalues of one cell.
TEST(solid_stiffness, rigid_motions_cost_nothing) {
  for (auto kind : support::solid_kinds) {
    const auto m = block(kind, {2, 2, 1}, Vec3(1, 1, 1), distort);
    const SparseMatrix K = fem::stiffness(m, iron);
    EXPECT_EQ((K - SparseMatrix(K.transpose())).norm(), 0.0);
    for (int k = 0; k < 6; ++k) {
      Points3 u;
      for (const Vec3& X : m.X) u.push_back(k < 3 ? Vec3(Vec3::Unit(k)) : Vec3(Vec3::Unit(k - 3).cross(X)));
      EXPECT_LT((K * stacked(u)).norm(), 1e-13 * K.norm());
    }
    const base::Vector values = algebra::eigenpairs(K).values;
    EXPECT_LT(values[5], 1e-12 * values.maxCoeff());
    EXPECT_GT(values[6], 1e-6 * values.maxCoeff());
  }
}

// The stiffness in independent dofs must be T^T K T, whatever nodes are special: turned, tied, control points.
TEST(solid_stiffness, of_independent_dofs) {
  for (auto kind : {SolidKind::tet10, SolidKind::hex8}) {
    const auto m = block(kind, {2, 2, 2}, Vec3(1, 1, 1), distort);
    fem::SolidDofs dofs = fem::plain_dofs(m.node_count());
    dofs.own = 0;
    dofs.shared = 3;
    for (int k = m.node_count() - 1; k >= 0; --k) {  // an order of its own
      dofs.first[k] = dofs.own;
      dofs.count[k] = k % 5 == 0 ? k % 3 : 3;
      dofs.own += dofs.count[k];
      if (k % 5 != 0) continue;
      dofs.special[k] = static_cast<int>(dofs.nodes.size());
      fem::SpecialNode node;
      node.basis = Eigen::AngleAxisd(0.3 * k, Vec3(1, 2, 3).normalized()).toRotationMatrix();
      node.shared = {{0, Vec3(0.3, 0.1 * k, -1)}, {2, Vec3(1, 0.5, 0.2)}, {0, Vec3(0, 0, 0.1)}};
      dofs.nodes.push_back(node);
    }
    for (const auto& cell : m.cells)
      for (int e = 0; kind == SolidKind::tet10 && e < 6; ++e)
        if (cell[4 + e] % 2 == 0) {
          const auto [i, j] = mesh::edge_of(kind, e);
          dofs.between[cell[4 + e]] = {cell[i], cell[j]};
        }
    const SparseMatrix T = fem::expansion(dofs);
    base::Matrix expected = T.transpose() * fem::stiffness(m, iron) * T;
    const SparseMatrix K = fem::upper_stiffness(m, iron, dofs);
    expected.triangularView<Eigen::StrictlyLower>().setZero();
    EXPECT_LT((base::Matrix(K) - expected).norm(), 1e-13 * expected.norm());
    for (int j = 0; j < K.cols(); ++j)
      for (int at = K.outerIndexPtr()[j] + 1; at < K.outerIndexPtr()[j + 1]; ++at)
        ASSERT_LT(K.innerIndexPtr()[at - 1], K.innerIndexPtr()[at]);
  }
}

// A cantilever must bend as Timoshenko's beam does: w = P l^3 / (3 E I) + P l / (k G A), to a per cent.
TEST(solid_stiffness, bends_a_cantilever) {
  for (auto kind : {SolidKind::tet10, SolidKind::hex8}) {
    const double l = 10.0, b = 1.0, h = 1.0, E = 210e3;
    const material::Material soft = material::LinearElastic{E, 0.0};
    const auto m = block(kind, kind == SolidKind::hex8 ? std::array{80, 1, 8} : std::array{16, 1, 2}, Vec3(l, b, h));
    std::vector<char> held(3 * m.X.size(), 0);
    hold(m, "x0", {0, 1, 2}, held);
    const Vector f = fem::face_force(m, mesh::facets_of(m, "x1"), Vec3(0, 0, 1.0));
    const Vector u = solve_held(fem::stiffness(m, soft), f, held, Vector::Zero(f.size()));
    double w = 0.0;
    const auto end = mesh::nodes_of(mesh::facets_of(m, "x1"));
    for (int node : end) w += u[3 * node + 2] / static_cast<double>(end.size());
    const double exact = l * l * l / (3.0 * E * b * h * h * h / 12.0) + l / (5.0 / 6.0 * (E / 2.0) * b * h);
    EXPECT_NEAR(w / exact, 1.0, 0.012) << static_cast<int>(kind);
  }
}

// B-bar must not lock: a cantilever of hexahedra at nu = 0.4999 bends by as much as theory says, one with all strains
// taken at their points would by less than half.
TEST(solid_stiffness, does_not_lock_when_incompressible) {
  const double l = 10.0, E = 210e3;
  for (double nu : {0.3, 0.499, 0.4999}) {
    const material::Material rubber = material::LinearElastic{E, nu};
    const auto m = block(SolidKind::hex8, {40, 4, 4}, Vec3(l, 1, 1));
    std::vector<char> held(3 * m.X.size(), 0);
    hold(m, "x0", {0}, held);
    for (int node : mesh::nodes_of(mesh::facets_of(m, "x0"))) {  // the section may contract
      if (std::abs(m.X[node].y() - 0.5) < 1e-9) held[3 * node + 1] = 1;
      if (std::abs(m.X[node].z() - 0.5) < 1e-9) held[3 * node + 2] = 1;
    }
    const Vector f = fem::face_force(m, mesh::facets_of(m, "x1"), Vec3(0, 0, 1.0));
    const Vector u = solve_held(fem::stiffness(m, rubber), f, held, Vector::Zero(f.size()));
    double w = 0.0;
    const auto end = mesh::nodes_of(mesh::facets_of(m, "x1"));
    for (int node : end) w += u[3 * node + 2] / static_cast<double>(end.size());
    const double exact = l * l * l / (3.0 * E / 12.0) + l * 2.0 * (1.0 + nu) / (5.0 / 6.0 * E);
    EXPECT_NEAR(w / exact, 1.0, 0.04) << nu;
  }
}

// Loads must have their resultants, force and moment, on curved and distorted bodies: a pressure on the whole skin
// none.
TEST(solid_loads, have_their_resultants) {
  for (auto kind : support::solid_kinds) {
    const auto m = block(kind, {2, 3, 2}, Vec3(1, 2, 1), distort);
    const auto resultant = [&](const Vector& f) {
      Eigen::Matrix<double, 6, 1> r = Eigen::Matrix<double, 6, 1>::Zero();
      for (int k = 0; k < m.node_count(); ++k) {
        r.head<3>() += f.segment<3>(3 * k);
        r.tail<3>() += m.X[k].cross(Vec3(f.segment<3>(3 * k)));
      }
      return r;
    };
    EXPECT_LT(resultant(fem::face_load(m, m.skin, 7.0, Vec3::Zero())).norm(), 1e-12);
    const Vec3 force(1, -2, 3), b(0.1, 0.2, -0.4);
    const auto top = mesh::facets_of(m, "z1");
    EXPECT_LT((resultant(fem::face_force(m, top, force)).head<3>() - force).norm(), 1e-12);
    const Vec3 c = mesh::area_centroid(m.X, top);
    EXPECT_LT((resultant(fem::face_force(m, top, force)).tail<3>() - c.cross(force)).norm(), 1e-12);
    const double V = mesh::volume(m);
    EXPECT_LT((resultant(fem::body_load(m, b)).head<3>() - V * b).norm(), 1e-12);
    EXPECT_LT((resultant(fem::body_load(m, b)).tail<3>() - V * mesh::volume_centroid(m).cross(b)).norm(), 1e-12);
  }
}

// A cell that is folded over must be named.
TEST(solid_stiffness, names_a_folded_cell) {
  auto m = block(SolidKind::hex8, {2, 2, 2}, Vec3(1, 1, 1));
  m.X[13] = Vec3(0.5, 0.5, 5.0);
  EXPECT_THROW(fem::stiffness(m, iron), base::MeshError);
}

}  // namespace
