#pragma once
#include "base/linalg.hpp"
#include "fem/solid/solid_dofs.hpp"
#include "material/material.hpp"
#include "mesh/solid/solid_mesh.hpp"

/// Linear elastic stiffness of a solid, small strain on X.
namespace reye::fem {

/// K = sum over cells of int B^T C B dV, 3n x 3n, both triangles, dof = 3 * node + component [N/mm]. hex8 takes its
/// mean dilatation (B-bar). Of every law E and nu count. Throws base::MeshError naming a cell that is folded over.
base::SparseMatrix stiffness(const mesh::SolidMesh& mesh, const material::Material& material);

/// T^T K T of independent dofs, its upper triangle alone; every diagonal entry of shared dofs is present.
base::SparseMatrix upper_stiffness(const mesh::SolidMesh& mesh, const material::Material& material,
                                   const SolidDofs& dofs);

/// Which nodes share a cell, n x n, upper triangle in the order of `place` (a permutation: node -> row), values 1.
base::SparseMatrix node_graph(const mesh::SolidMesh& mesh, const std::vector<int>& place);

}  // namespace reye::fem
