#pragma once
#include <string>

namespace reye::cad {

/// Absolute path of a file that belongs to this program, from the folder in which it lies: "reye-import", "../lib/...".
/// The path of the program comes from the system, so that no environment variable can replace it. Where this code is a
/// module that another program has loaded, as Python does, the folder is that of the programs it was installed with:
/// `bin` in the nearest folder above the module where that holds reye-import. Throws std::runtime_error where no folder
/// does.
std::string beside_program(const std::string& name);

}  // namespace reye::cad
