#pragma once
#include "sim/problem/problem.hpp"

namespace reye::sim {

/// Whether contacts that touch as drawn hold a body against a rigid motion ("translation along y", "rotation") without
/// friction and without a load: some nodes are pressed by it, and others by the same motion backwards, as of a ring
/// between two others.
bool held_by_contact(const Problem& problem, int body, const std::string& motion);

}  // namespace reye::sim
