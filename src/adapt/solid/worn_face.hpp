#pragma once
#include <string>
#include <vector>

namespace reye::adapt {

/// Volumes [mm^3] that the nodes of one face of a solid lose, one per node of mesh::nodes_of(mesh::facets_of(mesh,
/// face)); on tri6 facets those of Bernstein control points in place of mid nodes. Never negative.
struct WornFace {
  std::string face;
  std::vector<double> removed;
};

}  // namespace reye::adapt
