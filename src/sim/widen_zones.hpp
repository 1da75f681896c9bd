#pragma once
#include "sim/problem.hpp"

/// Fine zones on bodies that turn.
namespace reye::sim {

/// Makes the fine zones of bodies that turn as wide as what comes under them, and meshes those bodies again. A body
/// that a support turns does so by its histories; one that is led turns by the longest way of a support over its
/// radius. Preconditions: supports and contacts are placed.
void widen_zones(Problem& problem);

/// What `plan` says of the widened zones of a body, a line each.
std::vector<std::string> widened_zones(const Problem& problem, int body);

}  // namespace reye::sim
