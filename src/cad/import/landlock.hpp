#pragma once
#include <string>
#include <vector>

namespace reye::cad {

/// Landlock: from here on this process reads only below these folders and where programs are installed, writes and runs
/// nothing. True where the kernel has it; the process must have given up new privileges.
bool restrict_paths(const std::vector<std::string>& folders);

}  // namespace reye::cad
