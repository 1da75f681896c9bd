#pragma once
#include <string>

namespace reye::cad {

/// Absolute path of a file that belongs to this program, from the folder in which it lies: "reye-import", "../lib/...".
/// The program itself is asked of the system, so that nothing in the surroundings can put another in its place.
std::string beside_program(const std::string& name);

}  // namespace reye::cad
