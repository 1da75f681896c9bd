#pragma once
#include <numbers>

#include "mesh/solid/solid_mesh.hpp"

/// The skin of a solid from its cells.
namespace reye::mesh {

/// Facets whose normals differ by less at their common edge are smooth with each other, unless CAD decides.
inline constexpr double smooth_skin_angle = 30.0 * std::numbers::pi / 180.0;

/// The nodes of face `f` (tetrahedra 0 to 3, hexahedra 0 to 5) of a cell as a facet, seen from outside; group 0.
Facet face_of(SolidKind kind, const SolidCell& cell, int f);

/// The faces that one cell alone has, in the order of cells; group 0. Throws base::MeshError where more than two cells
/// share a face.
std::vector<Facet> faces_of_one_cell(SolidKind kind, const std::vector<SolidCell>& cells);

/// Numbers the groups of a skin, from 0: facets that an edge joins smoothly are of one.
void group_by_angle(const Points3& X, std::vector<Facet>& skin, double angle = smooth_skin_angle);

/// The closed boundary of cells, grouped by angle.
std::vector<Facet> skin_of(const Points3& X, SolidKind kind, const std::vector<SolidCell>& cells,
                           double angle = smooth_skin_angle);

}  // namespace reye::mesh
