#pragma once
#include <array>
#include <span>
#include <vector>

#include "base/analysis.hpp"
#include "base/linalg.hpp"
#include "fem/pattern.hpp"
#include "fem/stiffness.hpp"
#include "material/material.hpp"
#include "mesh/mesh.hpp"

/// Internal force and consistent tangent of a whole mesh on X, at small or finite strain, with plastic history.
/// Displacements u and forces have dof = 2 * node + component [mm; N per mm; N on the whole ring in axisymmetry].
namespace reye::fem {

/// What the cells of a mesh are made of and how they deform.
struct Solid {
  material::Material material;
  base::Analysis analysis = base::Analysis::plane_strain;
  base::Kinematics kinematics = base::Kinematics::small;
  bool cure = true;  ///< quad4 in plane strain and axisymmetry: B-bar at small strain, F-bar at finite; else ignored

  bool has_history() const;
  /// Whether the tangent is symmetric: always but with F-bar.
  bool symmetric(mesh::CellKind kind) const;
};

/// Plastic state of every Gauss point, cell by cell in the order of `stiffness_rule`; empty without history.
using History = std::vector<material::PlasticState>;
History virgin(const mesh::Mesh& mesh, const Solid& solid);

/// Forces that the cells exert on their nodes.
struct InternalForce {
  base::Vector total;
  double largest = 0.0;  ///< single entry of a single cell: the size against which the sum is in balance
};

/// f = sum int P : Grad v dV (finite) or int sigma : eps(v) dV (small), from the history before the increment.
/// Throws base::SolveError naming cell, Gauss point and its place on X where the material cannot take the deformation.
void internal_force(const mesh::Mesh& mesh, const Solid& solid, const base::Vector& u, const History& before,
                    InternalForce& f);

/// The same with K = df/du, made by `pattern.zero()`; nothing is allocated.
void tangent(const mesh::Mesh& mesh, const Solid& solid, const base::Vector& u, const History& before,
             const Pattern& pattern, InternalForce& f, base::SparseMatrix& K);

/// History after the deformation u; errors as above.
History updated(const mesh::Mesh& mesh, const Solid& solid, const base::Vector& u, const History& before);

/// Cauchy stress (11, 22, 12, 33) [MPa] and accumulated plastic strain at the nodes: extrapolated from the Gauss points
/// of each cell, then averaged over the cells of a node with their volumes on X as weights.
struct NodalState {
  std::vector<Stress> stress;
  std::vector<double> plastic_strain;
};
NodalState nodal_state(const mesh::Mesh& mesh, const Solid& solid, const base::Vector& u, const History& history);

}  // namespace reye::fem
