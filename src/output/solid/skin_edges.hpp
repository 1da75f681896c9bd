#pragma once
#include <vector>

#include "mesh/solid/solid_mesh.hpp"

namespace reye::output {

/// An edge of a skin in a picture, straight: of facets of second order its two halves.
struct SkinEdge {
  int from = 0, to = 0;
  base::Vec3 left = base::Vec3::Zero(), right = base::Vec3::Zero();  ///< normals of its facets
  bool feature = false;  ///< between groups of facets, at a sharp angle, or of one facet alone
};

std::vector<SkinEdge> skin_edges(const mesh::SolidMesh& mesh);

}  // namespace reye::output
