#pragma once
#include "sim/problem/problem.hpp"

namespace reye::sim {

/// Warns of every start profile that the elements of its boundary are too long for: between their nodes its heights lie
/// off the facets by more than a fifth of all the heights that it has.
void warn_of_profiles(Problem& problem);

}  // namespace reye::sim
