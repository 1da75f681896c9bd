#pragma once
#include <string>

#include "cad/part/part.hpp"
#include "cad/part/select.hpp"

/// Mirror symmetry about the axis x = 0.
namespace reye::cad {

/// Whether two parts are mirror images of one another about the axis.
bool are_mirrored(const Part& left, const Part& right);

/// The sizes in which the two halves of a part that crosses the axis differ, in words; empty where they mirror each
/// other.
std::string asymmetry(const Part& part);

/// A chosen edge at x < 0 whose mirror image is not chosen, in words; empty where there is none, so that the half
/// contains the whole choice.
std::string chosen_on_one_side(const Part& part, const EdgeChoice& choice);

}  // namespace reye::cad
