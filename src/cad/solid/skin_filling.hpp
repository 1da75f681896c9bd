#pragma once
#include "cad/solid/skin_surface.hpp"

namespace reye::cad {

/// The points of a surface, which keep their places, then those inside; and the cells, whose skin is the given
/// triangles. gmsh runs in a process of its own. Throws base::MeshError with the reason why there is no mesh.
RawSolidMesh fill_skin(const SkinFilling& filling);

}  // namespace reye::cad
