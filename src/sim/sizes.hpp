#pragma once
#include "sim/problem.hpp"

/// Numbers that are out of proportion: mostly given in another unit than that of their key.
namespace reye::sim {

/// A load whose pressure is more than 0.3 of its body's modulus, at finite strain 3 times it, in words; empty where
/// none is.
std::string why_crushed(const Problem& problem, int body);

/// Warns of such bodies, of motions farther than all bodies reach, and of bodies smaller than one of their elements.
void warn_of_sizes(Problem& problem);

}  // namespace reye::sim
