#pragma once
#include <array>
#include <cmath>
#include <ostream>
#include <vector>

#include "algebra/unsymmetric.hpp"
#include "fem/element.hpp"
#include "fem/finite.hpp"
#include "support/meshes.hpp"
#include "support/tangent.hpp"

/// Solids, uniform states and a plain Newton for tests of the internal force.
namespace reye::fem_tests {

using base::Analysis;
using base::Kinematics;
using base::Vec2;
using base::Vector;
using mesh::CellKind;
using mesh::Mesh;

inline const material::Material rubber = material::NeoHookean{300.0, 0.4, material::Volumetric::log_squared};
inline const material::Material metal = material::HenckyJ2{300.0, 0.3, material::LinearHardening{1.0, 20.0}};

inline const char* name_of(CellKind kind) {
  return kind == CellKind::tri3    ? "tri3"
         : kind == CellKind::quad4 ? "quad4"
         : kind == CellKind::tri6  ? "tri6"
                                   : "quad8";
}

inline const char* name_of(Analysis analysis) {
  return analysis == Analysis::plane_strain   ? "plane_strain"
         : analysis == Analysis::plane_stress ? "plane_stress"
                                              : "axisymmetric";
}

/// A kind of cell and what it is made of.
struct Case {
  CellKind kind = CellKind::quad4;
  fem::Solid solid;
};

inline void PrintTo(const Case& c, std::ostream* out) {
  *out << name_of(c.kind) << " " << name_of(c.solid.analysis)
       << (c.solid.kinematics == Kinematics::finite ? " finite" : " small") << (c.solid.cure ? " cured" : "")
       << (c.solid.has_history() ? " plastic" : "");
}

inline const std::array kinds{CellKind::tri3, CellKind::quad4, CellKind::tri6, CellKind::quad8};

/// Every kind, idealisation, strain measure, cure and two materials.
inline std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (auto kind : kinds)
    for (auto analysis : {Analysis::plane_strain, Analysis::plane_stress, Analysis::axisymmetric})
      for (auto kinematics : {Kinematics::small, Kinematics::finite})
        for (const auto& m : {rubber, metal})
          for (bool cure : {true, false})
            if (cure || kind == CellKind::quad4) cases.push_back({kind, {m, analysis, kinematics, cure}});
  return cases;
}

/// A distorted patch, away from the axis.
inline Mesh patch_mesh(CellKind kind) {
  return support::rectangle({.corner = {4, 1}, .size = {3, 2}, .nx = 4, .ny = 3, .kind = kind, .distortion = 0.6});
}

/// u = H X; in axisymmetry a radius may only scale.
inline Eigen::Matrix2d uniform_gradient(Analysis analysis) {
  if (analysis == Analysis::axisymmetric) return Eigen::Matrix2d{{0.13, 0.0}, {0.0, -0.17}};
  return Eigen::Matrix2d{{0.13, 0.21}, {-0.08, -0.17}};
}

template <class Field>
Vector nodal(const Mesh& mesh, Field field) {
  Vector u(2 * mesh.node_count());
  for (int k = 0; k < mesh.node_count(); ++k) u.segment<2>(2 * k) = field(mesh.X[k]);
  return u;
}

/// A displacement that strains every cell of `patch_mesh` differently, well into the plastic range.
inline Vector bent(const Mesh& mesh) {
  return nodal(mesh, [](const Vec2& X) {
    return Vec2{0.15 * X.x() + 0.1 * std::sin(X.x() + 2 * X.y()), -0.2 * X.y() + 0.08 * std::cos(2 * X.x() - X.y())};
  });
}

/// Newton from u with the dofs of `held` kept, under the forces f; the residual of every iteration.
inline std::vector<double> newton(const Mesh& mesh, const fem::Solid& solid, const std::vector<int>& held,
                                  const Vector& f, Vector& u) {
  const fem::Pattern pattern(mesh);
  fem::InternalForce internal;
  std::vector<double> table;
  for (int iteration = 0; iteration < 25; ++iteration) {
    fem::internal_force(mesh, solid, u, fem::virgin(mesh, solid), internal);
    auto K = support::tangent(mesh, solid, u, fem::virgin(mesh, solid), pattern);
    Vector r = internal.total - f;
    for (int node : held) r.segment<2>(2 * node).setZero();
    table.push_back(r.norm() / internal.largest);
    if (table.back() < 1e-11) break;
    std::vector<char> fixed(static_cast<size_t>(u.size()), 0);
    for (int node : held) fixed[2 * node] = fixed[2 * node + 1] = 1;
    K.prune([&](int row, int column, double) { return row == column || (!fixed[row] && !fixed[column]); });
    for (int node : held)
      for (int dof : {2 * node, 2 * node + 1}) K.coeffRef(dof, dof) = 1.0;
    K.makeCompressed();
    u -= algebra::UnsymmetricSchur(K, 0).recover(r, Vector(0));
  }
  return table;
}

/// All nodes of the outline.
inline std::vector<int> outline_nodes(const Mesh& mesh) {
  std::vector<int> nodes;
  for (const auto& [name, boundary] : mesh.boundaries)
    for (int node : mesh::nodes_of(boundary)) nodes.push_back(node);
  return nodes;
}

}  // namespace reye::fem_tests
