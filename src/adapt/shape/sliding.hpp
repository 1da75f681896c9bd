#pragma once
#include "adapt/shape/outline.hpp"

namespace reye::adapt {

/// Spreads the displacement of a corner along a straight free side over the nodes of that side, linearly between its
/// ends, so that the cell at the corner does not take all of it. The outline stays the same line. Sides end where the
/// outline of birth bends and where a named boundary ends; a side that was worn itself is left alone. Displacements
/// count from the mesh of birth, hence without memory.   (README, 4)
void slide_sides(mesh::Mesh& mesh, const mesh::Mesh& born, const std::vector<WornNode>& worn);

}  // namespace reye::adapt
