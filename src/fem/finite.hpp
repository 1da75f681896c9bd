#pragma once
#include <array>
#include <span>
#include <vector>

#include "base/analysis.hpp"
#include "base/linalg.hpp"
#include "fem/pattern.hpp"
#include "fem/solid.hpp"
#include "fem/stiffness.hpp"
#include "material/elastic_part.hpp"
#include "mesh/mesh.hpp"

/// Internal force and consistent tangent of a whole mesh on X, at small or finite strain, with plastic history.
/// Displacements u and forces have dof = 2 * node + component [mm; N per mm; N on the whole ring in axisymmetry].
/// X need not be unstressed: at finite strain each Gauss point may know the deformation F0 from unstressed to X.
namespace reye::fem {

/// Plastic state of every Gauss point, cell by cell in the order of `stiffness_rule`; empty without history.
using History = std::vector<material::PlasticState>;
History virgin(const mesh::Mesh& mesh, const Solid& solid);

/// F0 = dX/d(unstressed) of every Gauss point in the same order, (11, 12, 21, 22, 33); empty: X is unstressed.
using Prestrain = std::vector<material::Gradient<double>>;

/// State of the Gauss points before an increment, as a view.
struct GaussState {
  std::span<const material::PlasticState> history;  ///< plastic metric of the unstressed material
  std::span<const material::Gradient<double>> F0;   ///< empty at small strain; det F0 > 0; F0_33 = 1 in plane stress

  GaussState() = default;
  GaussState(const History& states, const Prestrain& deformations = {}) : history(states), F0(deformations) {}
};

/// Forces that the cells exert on their nodes.
struct InternalForce {
  base::Vector total;
  double largest = 0.0;  ///< single entry of a single cell: the size against which the sum is in balance
};

/// f = sum int P : Grad v dV (finite) or int sigma : eps(v) dV (small), from the state before the increment; with F0, P
/// on X is 1/det(F0) P(F) F0^T at F = (I + Grad u) F0.
/// Throws base::SolveError naming cell, Gauss point and its place on X where the material cannot take the deformation.
/// `yields`, if given: per cell, whether a Gauss point of it yields at u. Of all cells or of those with `wanted`.
void internal_force(const mesh::Mesh& mesh, const Solid& solid, const base::Vector& u, const GaussState& before,
                    InternalForce& f, std::vector<char>* yields = nullptr, std::span<const char> wanted = {});

/// Tangents df_e/du_e of single cells, of which some may be those of another state: a cell in each column of the
/// matrix, column by column.
base::Matrix cell_tangents(const mesh::Mesh& mesh);  ///< zero
/// Makes those of all cells, or of those with `wanted`, at u. Errors as above.
void renew(const mesh::Mesh& mesh, const Solid& solid, const base::Vector& u, const GaussState& before,
           std::span<const char> wanted, base::Matrix& of_cells);
/// K = df/du of all cells, or of those with `wanted`, on the places of `pattern.zero()`; nothing is allocated. The
/// pattern may be that of a mesh of them alone.
void assemble(const mesh::Mesh& mesh, const base::Matrix& of_cells, std::span<const char> wanted,
              const Pattern& pattern, base::SparseMatrix& K);

/// History after the deformation u; errors as above.
History updated(const mesh::Mesh& mesh, const Solid& solid, const base::Vector& u, const GaussState& before);

/// The elastic states, on which stress and yielding of an accepted state depend, per Gauss point; empty without
/// history.
using ElasticStates = std::vector<material::ElasticState>;
ElasticStates elastic_states(const mesh::Mesh& mesh, const Solid& solid, const base::Vector& u, const GaussState& now);

/// The history with which the deformation u leaves these elastic states (material::plastic_state).
History compatible(const mesh::Mesh& mesh, const Solid& solid, const base::Vector& u, const Prestrain& F0,
                   const ElasticStates& states);

/// Stored elastic energy of an accepted state [mJ per mm; mJ on the whole ring in axisymmetry].
double strain_energy(const mesh::Mesh& mesh, const Solid& solid, const base::Vector& u, const GaussState& now);

/// F from unstressed to x = X + u as the law uses it (F-bar where that is active), the new F0 when x becomes the new X.
/// On the same mesh that leaves every stress and nodal force as it is. Finite strain only; F33 = 1 in plane stress.
Prestrain deformation(const mesh::Mesh& mesh, const Solid& solid, const base::Vector& u, const Prestrain& F0);

/// Cauchy stress (11, 22, 12, 33) [MPa] and accumulated plastic strain at the nodes: extrapolated from the Gauss points
/// of each cell, then averaged over the cells of a node with their unstressed volumes as weights.
struct NodalState {
  std::vector<Stress> stress;
  std::vector<double> plastic_strain;
};
NodalState nodal_state(const mesh::Mesh& mesh, const Solid& solid, const base::Vector& u, const GaussState& state);

}  // namespace reye::fem
