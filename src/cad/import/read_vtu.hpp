#pragma once
#include "cad/part/raw.hpp"

namespace reye::cad {

/// The meshes of a .vtu as `reye mesh` writes it: one part per body, named boundaries from its lines. Frames of a run
/// can be read, too: their bodies on X, without names of boundaries. Throws base::InputError (key "geometry") where
/// counts, offsets, node numbers or components are not those of a mesh.
std::vector<RawPart> read_vtu(const std::string& path);

}  // namespace reye::cad
