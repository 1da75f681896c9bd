#pragma once
#include <vector>

#include "sim/problem/problem.hpp"

/// The sides of contacts and bonds on their bodies.
namespace reye::sim {

/// Whether one side of a contact or a bond lies on the body.
bool lies_on(const PlacedContact& joint, int body);

/// The mesh nodes of a side, in its own order.
std::vector<int> side_nodes(const std::vector<body::ShapePtr>& shapes, const contact::BoundaryRef& ref);

}  // namespace reye::sim
