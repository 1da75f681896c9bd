#pragma once
#include "base/linalg.hpp"
#include "mesh/solid/solid_mesh.hpp"

/// Nodal forces of loads on solids, 3n entries, dof = 3 * node + component [N].
namespace reye::fem {

using base::Vec3;

/// int N (t - p n) dA over facets: pressure p > 0 pushes on the body, traction t [MPa].
base::Vector face_load(const mesh::SolidMesh& mesh, const std::vector<mesh::Facet>& facets, double pressure_MPa,
                       const Vec3& traction_MPa);

/// A force [N] spread evenly over the area of facets.
base::Vector face_force(const mesh::SolidMesh& mesh, const std::vector<mesh::Facet>& facets, const Vec3& force_N);

/// int N b dV with b [N/mm^3]. The mesh has cells.
base::Vector body_load(const mesh::SolidMesh& mesh, const Vec3& force_N_per_mm3);

}  // namespace reye::fem
