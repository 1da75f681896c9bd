#pragma once
#include <string>
#include <vector>

#include "adapt/shape_step.hpp"

namespace reye::adapt {

/// How far the nodes of one boundary are to go outwards [mm], in the order of mesh::nodes_of(boundary); at middle nodes
/// the coefficient of the Bernstein function. `free`: what may be added to it, times one number for the whole body.
struct OutlineShift {
  std::string boundary;
  std::vector<double> by, free;
};

/// Moves nodes of the outline by `by` plus that multiple of `free` which leaves the body its content, to round-off of
/// the stored coordinates; `removed` of the result is what that leaves. The interior follows as in `evolve`. A node
/// goes along the mean normal of its facets in the boundary; where the boundary ends in a corner of the outline, along
/// the side beyond it, so that straight sides stay straight and the axis stays the axis. Fails when nothing is free to
/// give the content back, or the moved outline crosses itself.
ShapeStepResult shift_outline(const body::ShapePtr& shape, base::Analysis analysis,
                              const std::vector<OutlineShift>& shifts, RelocationCache* cache = nullptr);

}  // namespace reye::adapt
