#include "sim/measure/sides.hpp"

#include <algorithm>

namespace reye::sim {

bool lies_on(const PlacedContact& joint, int body) {
  const auto here = [&](const contact::BoundaryRef& ref) { return ref.body == body; };
  return here(joint.secondary) || std::any_of(joint.primary.begin(), joint.primary.end(), here);
}

std::vector<int> side_nodes(const std::vector<body::ShapePtr>& shapes, const contact::BoundaryRef& ref) {
  return mesh::nodes_of(shapes[ref.body]->mesh.boundaries.at(ref.boundary));
}

}  // namespace reye::sim
