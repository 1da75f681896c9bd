#pragma once
#include <string>
#include <vector>

#include "adapt/shape/shape_step.hpp"

namespace reye::adapt {

/// Distances by which the nodes of one boundary move outwards [mm], in the order of mesh::nodes_of(boundary); at middle
/// nodes the coefficient of the Bernstein function. `free`: a motion that may be added, times one number for the whole
/// body.
struct OutlineShift {
  std::string boundary;
  std::vector<double> by, free;
};

/// Moves nodes of the outline by `by` plus the multiple of `free` that keeps the content of the body, to round-off of
/// the stored coordinates; `removed` of the result is that round-off. The interior follows as in `evolve`. A node moves
/// along the mean normal of its facets in the boundary, or, where the boundary ends in a corner of the outline, along
/// the side beyond it, so that straight sides stay straight and the axis stays the axis. Fails when no free motion can
/// restore the content, or the moved outline crosses itself.
ShapeStepResult shift_outline(const body::ShapePtr& shape, base::Analysis analysis,
                              const std::vector<OutlineShift>& shifts, RelocationCache* cache = nullptr);

}  // namespace reye::adapt
