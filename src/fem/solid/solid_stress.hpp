#pragma once
#include <array>
#include <vector>

#include "fem/stiffness.hpp"
#include "material/material.hpp"
#include "mesh/solid/solid_mesh.hpp"

/// Stress of solids from nodal displacements.
namespace reye::fem {

/// In the order (11, 22, 33, 12, 23, 31) [MPa].
using SolidStress = std::array<double, 6>;

/// Stress at the nodes for nodal displacements u (nodes themselves, not control points): extrapolated from the points
/// of each cell (constant on tet4, linear on tet10, trilinear on hex8), then averaged over the cells of a node with
/// their volumes as weights.
std::vector<SolidStress> nodal_stress(const mesh::SolidMesh& mesh, const material::Material& material,
                                      const base::Points3& u);

/// Zienkiewicz and Zhu's estimate, as in the plane: the stress at the nodes, interpolated, against that of the cells
/// [mJ].
StressError recovered_error(const mesh::SolidMesh& mesh, const material::Material& material, const base::Points3& u);

}  // namespace reye::fem
