#pragma once
#include "cad/part/raw.hpp"

namespace reye::cad {

/// Refuses (base::InputError, key "geometry") a file that does not begin as files of its format do, or a .msh with
/// sections that a mesh does not need: gmsh recognises files by their content and would run a script of any name.
void check_content(const std::string& path, Format format);

}  // namespace reye::cad
