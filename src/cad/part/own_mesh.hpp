#pragma once
#include "cad/part/plane.hpp"

namespace reye::cad {

/// The part of a mesh that came with its file, kept as it is apart from turning cells counter-clockwise.
/// Its outline is cut into edges at corners of more than 30 degrees and where physical names change.
Part part_with_mesh(const RawPart& raw, const Plane& plane);

}  // namespace reye::cad
