#pragma once
#include "sim/problem.hpp"

namespace reye::sim {

/// Warns of every point load and point support whose node lies farther than half an element from where the scene puts it.
void warn_of_points(Problem& problem);

}  // namespace reye::sim
