#pragma once
#include "cad/solid/raw_solid.hpp"
#include "cad/solid/triangles.hpp"

/// The closed boundary of a solid's mesh.
namespace reye::cad {

FacetCorners sorted_corners(const mesh::Facet& facet);

/// The facets of cells that no other cell shares, outward; their group is that of the facet in `mesh.facets` with the
/// same corners, or -1 where there is none. Throws base::MeshError where three cells share a facet.
std::vector<mesh::Facet> skin_of_cells(const RawSolidMesh& mesh);

/// Turns the facets of a closed surface without cells outward, and those of cavities in it inward to the cavity.
/// Throws base::MeshError where the surface is not closed or has one side only.
void turn_outward(const Points3& X, std::vector<mesh::Facet>& skin);

/// Throws base::MeshError where an edge of the skin does not belong to exactly two facets.
void check_closed(const Points3& X, const std::vector<mesh::Facet>& skin);

/// Gives facets that are joined by edges of less than 30 degrees, and have the same names, one group. Returns the names
/// of each group.
std::vector<std::set<std::string>> group_by_angle(const RawSolidMesh& mesh, std::vector<mesh::Facet>& skin);

/// Pairs of groups, the smaller first, whose facets meet at less than 25 degrees on average along their common edges.
std::set<std::pair<int, int>> smooth_joints(const Points3& X, const std::vector<mesh::Facet>& skin);

/// Flat triangles over the facets: one of a tri3, two of a quad4, four of a tri6.
std::vector<Triangle> triangles_of(const Points3& X, const std::vector<mesh::Facet>& facets);

/// (1/3) int x . n dA over the skin, by quadrature of the curved facets [mm^3].
double enclosed_volume(const Points3& X, const std::vector<mesh::Facet>& skin);

/// int dA over facets, by quadrature of the curved ones [mm^2].
double facets_area(const Points3& X, const std::vector<mesh::Facet>& skin, const std::vector<int>& which);

}  // namespace reye::cad
