#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mesh/solid/solid_mesh.hpp"

namespace reye::adapt {

/// Two facets of a skin that meet although they are not neighbours, or neighbours folded onto each other.
struct SkinCrossing {
  int first = -1, second = -1;         ///< facets of the skin, the first one moved
  mesh::Vec3 at = mesh::Vec3::Zero();  ///< centre of the first
};

/// The first place where `moved` facets of a skin meet any others; exact, n log^2 n. Quadrilaterals count as two
/// triangles, curved facets as four between their nodes.
std::optional<SkinCrossing> find_crossing(const mesh::SolidMesh& mesh, const std::vector<int>& moved);

/// The first of these facets whose normal has turned by more than a right angle since `before`.
std::optional<SkinCrossing> find_fold(const mesh::Points3& before, const mesh::SolidMesh& mesh,
                                      const std::vector<int>& moved);

/// What a crossing means for the body: "worn through to face "bottom"" (or "to the unworn surface") where the other
/// facet has not moved since birth, else "the worn surface crosses itself".
std::string meaning(const SkinCrossing& crossing, const mesh::SolidMesh& now, const mesh::SolidMesh& born);

}  // namespace reye::adapt
