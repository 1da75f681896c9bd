#pragma once
#include <string>
#include <vector>

#include "base/errors.hpp"

namespace reye::cad {

/// The commands of a gmsh script that a geometry file does not need: gmsh's language also runs programs, writes,
/// deletes and reads files. Every word must be one that Reye lets a script use (`script_words`) or a variable that the
/// script sets, and every file it includes must lie below `folder` or its own, symbolic links followed, and is checked
/// as well. One issue per place (key "geometry", value the path), with line, word and remedy; none: the script may be
/// run.
std::vector<base::Issue> unsafe_commands(const std::string& path, const std::string& folder);

}  // namespace reye::cad
