#pragma once
#include <span>
#include <vector>

#include "base/linalg.hpp"
#include "mortar/solid/facet_functions.hpp"
#include "mortar/solid/skin.hpp"

/// Normals and areas of facets in space, control points included.
namespace reye::mortar {

/// dx/dr x dx/ds at a place of a facet: the outward normal times the area per area of the reference shape.
Vec3 area_vector_at(const mesh::Facet& facet, const Points3& x, const Vec2& xi);

/// int n dA / |int n dA| of a facet. Throws base::MeshError where it has no area.
Vec3 unit_normal(const mesh::Facet& facet, const Points3& x);

/// Unit mean normals, one per facet. Throws as `unit_normal`.
Points3 facet_normals(const Skin& skin);

/// int dA per facet [mm^2].
base::Vector facet_areas(const Skin& skin);

/// int N_j dA per point over all facets [mm^2]; the sum is the area of the skin.
base::Vector nodal_areas(const Skin& skin);

/// Unit normals per point: in each group the mean of the facets' normals at the point, weighted by the angle between
/// the facet's edges there (pi at the middle of a curved edge), then the mean of the groups that have a facet there
/// which `faces` (marked per facet), or of all where none has. Zero at points without facets.
Points3 nodal_normals(const Skin& skin, const std::vector<char>& faces);

}  // namespace reye::mortar
