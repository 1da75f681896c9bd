#pragma once
#include <string>
#include <vector>

namespace reye::adapt {

/// Volume removed at the nodes of one boundary since the last shape step
/// [mm^2 per mm; mm^3 in axisymmetry], in the order of mesh::nodes_of(boundary). Never negative.
struct WornBoundary {
  std::string boundary;
  std::vector<double> removed;
};

}  // namespace reye::adapt
