#pragma once
#include <string>

namespace reye::cad {

/// Absolute path of a file that belongs to this program, from the folder in which it lies: "reye-import", "../lib/...".
/// The path of the program comes from the system, so that no environment variable can replace it.
std::string beside_program(const std::string& name);

}  // namespace reye::cad
