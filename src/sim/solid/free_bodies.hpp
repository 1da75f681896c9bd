#pragma once
#include <string>

#include "solver/solid/solid_system.hpp"

namespace reye::sim {

/// Motions that no support holds, body by body, in a sentence for a reader; empty where there are none.
std::string free_bodies_in_words(const solver::SolidSystem& system);

}  // namespace reye::sim
