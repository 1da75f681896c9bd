#pragma once
#include <array>
#include <vector>

#include "base/analysis.hpp"
#include "base/linalg.hpp"
#include "material/material.hpp"
#include "mesh/mesh.hpp"

/// Linear elastic stiffness and stress of a whole mesh, small strain on X.
namespace reye::fem {

/// K = sum over cells of int B^T C B dV, 2n x 2n, both triangles, dof = 2 * node + component [N/mm per mm of
/// thickness; N/mm for the whole ring in axisymmetry]. `b_bar`: see `strain_points`.
base::SparseMatrix stiffness(const mesh::Mesh& mesh, const material::Material& material, base::Analysis analysis,
                             bool b_bar);

/// Stress in the order (11, 22, 12, 33) [MPa].
using Stress = std::array<double, 4>;

/// Stress at the nodes for nodal displacements u: extrapolated from the Gauss points of each cell
/// (constant on tri3, linear on tri6, bilinear on quadrilaterals), then averaged over the cells of a node with their
/// volumes as weights.
std::vector<Stress> nodal_stress(const mesh::Mesh& mesh, const material::Material& material, base::Analysis analysis,
                                 bool b_bar, const base::Points& u);

/// Energies of stress in a body, int sigma : C^-1 : sigma dV [mJ per mm; mJ].
struct StressError {
  double difference = 0.0;  ///< of recovered less computed stress
  double energy = 0.0;      ///< of the computed stress
};

/// Zienkiewicz and Zhu's estimate: the stress at the nodes (`nodal_stress`), interpolated, against that of the cells.
/// Root of difference over energy is the relative error in the energy norm.
StressError recovered_error(const mesh::Mesh& mesh, const material::Material& material, base::Analysis analysis,
                            bool b_bar, const base::Points& u);

}  // namespace reye::fem
