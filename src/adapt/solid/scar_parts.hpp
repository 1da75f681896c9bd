#pragma once
#include <string>
#include <vector>

#include "adapt/solid/isotropic.hpp"
#include "cad/solid/solid_size.hpp"
#include "mesh/solid/solid_mesh.hpp"

namespace reye::adapt {

/// A part of the scar that is to be drawn again: facets of the worn skin, the edges between them that stay, and the
/// length that edges are to have [mm].
struct ScarPart {
  std::vector<int> facets;
  std::set<PatchEdge> fixed;
  double length = 0.0;
};

/// Facets that have moved since birth: those of the scar, and those of plane faces that followed.
std::vector<char> moved_facets(const mesh::SolidMesh& worn, const mesh::SolidMesh& born);

/// The plane in which facets of a skin lie, to round-off; nothing where they do not lie in one.
struct FacetsPlane {
  base::Vec3 origin, normal;
};
std::optional<FacetsPlane> plane_of(const mesh::SolidMesh& mesh, const std::vector<int>& facets);

/// The corners of a facet that is a triangle.
PatchTriangle corners_of(const mesh::Facet& facet);

/// Moved facets of one group and one set of names, of about one size, and where only the edge of a curved face has
/// moved along it two more rings of facets, which are in its way; those of which one has lost its shape or size since
/// birth, or all of them. Edges stay where facets turn by more than 20 degrees. Sizes are those at birth, or those
/// wished where these are smaller. Facets at an edge that stays and is longer than 4/3 of the length are left out.
std::vector<ScarPart> scar_parts(const mesh::SolidMesh& worn, const mesh::SolidMesh& born, const cad::SolidSize& wished,
                                 bool all);

}  // namespace reye::adapt
