#pragma once
#include "adapt/shape/outline.hpp"

namespace reye::adapt {

/// Spreads the way a corner has slid along a straight free side over the nodes of that side, linearly between
/// the ends of the side, so that not the one cell at the corner has to take it all. The outline stays the same
/// line. Sides end where the outline of birth bends and where a named boundary ends; a side that was worn
/// itself is left alone. Counted from the mesh of birth, hence without memory.   (README, 4)
void slide_sides(mesh::Mesh& mesh, const mesh::Mesh& born, const std::vector<WornNode>& worn);

}  // namespace reye::adapt
