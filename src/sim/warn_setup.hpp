#pragma once
#include "base/errors.hpp"
#include "sim/problem.hpp"

/// What can be known to be wrong, or worth a word, before a run.
namespace reye::sim {

/// Supports that ask different things of one place: those that are refused, and, as warnings, those that lose a corner.
std::vector<base::Issue> support_conflicts(Problem& problem);

/// Steps whose cycles do not count, play nothing or are too coarse in time; limits without cycles.
void warn_of_steps(const scene::Scene& scene, std::vector<Warning>& warnings);

/// On the drawing: a fine zone beside the place where the sides are nearest; by Hertz' closed form, where load and radii
/// are known there, fewer elements across than tell a pressure; facets whose sagitta the load does not press flat.
void warn_of_meshes(Problem& problem, const solver::System& system);

}  // namespace reye::sim
