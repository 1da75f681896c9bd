#pragma once
#include "cad/part/raw.hpp"
#include "cad/solid/raw_solid.hpp"

namespace reye::cad {

/// The meshes of a .vtu as `reye mesh` writes it: one part per body, named boundaries from its lines. Frames of a run
/// can be read, too: their bodies on X, without names of boundaries. Throws base::InputError (key "geometry") where
/// counts, offsets, node numbers or components are not those of a mesh.
std::vector<RawPart> read_vtu(const std::string& path);

/// Likewise the meshes of solids: tetrahedra of 4 or 10 nodes, hexahedra of 8; named faces from triangles and
/// quadrilaterals.
std::vector<RawSolid> read_vtu_solids(const std::string& path);

}  // namespace reye::cad
