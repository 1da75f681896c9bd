#pragma once
#include "sim/problem/problem.hpp"

/// Fine zones on bodies that turn.
namespace reye::sim {

/// Widens the fine zones of bodies that turn to the arc that passes under the contact, and remeshes those bodies. A
/// body that a support turns follows its histories; one that is led turns by the longest motion of a support over its
/// radius. Preconditions: supports and contacts are placed.
void widen_zones(Problem& problem);

/// Lines of the plan on the widened zones of a body.
std::vector<std::string> widened_zones(const Problem& problem, int body);

}  // namespace reye::sim
