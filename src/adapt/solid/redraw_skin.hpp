#pragma once
#include "adapt/solid/scar_parts.hpp"

namespace reye::adapt {

/// A facet of a skin to be filled: the corners, and the facet of the worn skin whose group and names it has.
struct DrawnFacet {
  PatchTriangle corners;
  int like = -1;
  bool fresh = false;  ///< drawn again; else it is that facet
};

/// The corners of a skin that is to be filled.
struct DrawnSkin {
  Points3 X;
  std::vector<int> from;  ///< the node of the worn mesh that each point is, -1: a new one
  std::vector<DrawnFacet> facets;
};

/// The worn skin, which has triangles alone, with these parts in new ones; a part that cannot be drawn better stays.
/// Corners on borders and fixed edges stay. New corners lie in the plane of plane parts, on curved facets, and of flat
/// ones on the surface, then so that each keeps its content of it.   (README, 17)
DrawnSkin draw_skin(const mesh::SolidMesh& worn, const std::vector<ScarPart>& parts);

}  // namespace reye::adapt
