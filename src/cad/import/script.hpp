#pragma once
#include <string>
#include <vector>

#include "base/errors.hpp"

namespace reye::cad {

/// What a gmsh script holds that a geometry file has no use for: gmsh's language also runs programs, writes, deletes
/// and reads files. Every word must be one that Reye lets a script use (`script_words`) or a variable that the script
/// sets, and every file it includes must lie below `folder` or its own, symbolic links followed, and is looked through
/// as well. One issue per place (key "geometry", value the path), with line, word and what mends it; none: the script
/// may be run.
std::vector<base::Issue> unsafe_commands(const std::string& path, const std::string& folder);

}  // namespace reye::cad
