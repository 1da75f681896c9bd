#pragma once
#include "cad/build/drawing.hpp"

namespace reye::adapt {

/// A drawing of a mesh that came without one: its outline cut into edges at corners of more than 30 degrees and where
/// boundaries end, each a straight line or the polyline of its nodes; sizes by `wish_sizes_of`.
cad::Drawing drawing_of(const mesh::Mesh& mesh);

/// Fills in the sizes a drawing does not ask for, so that a new mesh resembles this one: far size by its largest
/// cells, and a fine zone on each edge whose facets are smaller than half of that.
void wish_sizes_of(const mesh::Mesh& mesh, cad::Drawing& drawing);

}  // namespace reye::adapt
