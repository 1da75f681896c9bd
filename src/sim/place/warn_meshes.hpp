#pragma once
#include "sim/problem/problem.hpp"
#include "solver/system.hpp"

namespace reye::sim {

/// Warns by the drawing: of a fine zone beside the place where the sides are nearest; by Hertz' closed form, where load
/// and radii are known there, fewer elements across than resolve a pressure; facets whose sagitta the load does not
/// press flat.
void warn_of_meshes(Problem& problem, const solver::System& system);

}  // namespace reye::sim
