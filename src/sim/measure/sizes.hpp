#pragma once
#include "sim/problem/problem.hpp"

/// Numbers out of proportion, mostly given in a unit other than that of their key.
namespace reye::sim {

/// A load whose pressure is more than 0.3 of its body's modulus, at finite strain 3 times it, in words; empty where
/// none is.
std::string why_crushed(const Problem& problem, int body);

/// Warns of crushed bodies, of motions farther than all bodies reach, and of bodies smaller than one of their elements.
void warn_of_sizes(Problem& problem);

}  // namespace reye::sim
