#pragma once
#include "cad/solid/raw_solid.hpp"

namespace reye::cad {

/// Completes a solid whose mesh came with its file: turns its cells right side out, finds its skin, divides that into
/// faces at angles above 30 degrees and where names change, and answers the probes. Throws base::MeshError where the
/// mesh is not that of a solid.
void complete_own_solid(RawSolid& solid, const Points3& probes);

}  // namespace reye::cad
