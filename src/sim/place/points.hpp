#pragma once
#include "base/errors.hpp"
#include "sim/problem/problem.hpp"

namespace reye::sim {

/// A point load, point support or probe that lies outside of its body by more than a quarter of the element there: with
/// the nearest place of the body. Nearer points are moved onto the body.
std::vector<base::Issue> points_outside(const Problem& problem);

/// Warns of every point load and point support inside a mesh that came with its file whose node lies farther than half
/// an element from its place in the scene. In meshes that Reye makes such points are nodes.
void warn_of_points(Problem& problem);

}  // namespace reye::sim
