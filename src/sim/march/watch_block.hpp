#pragma once
#include <string>

#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

/// Checks at the end of a block: the error of its jump, plastic strain, small strain.
namespace reye::sim {

double largest_plastic_strain(const State& state);
double mean_plastic_strain(const State& state);  ///< over all Gauss points

/// Warns of a tolerance that was missed, with its value.
void watch_tolerance(const scene::Step& step, State& state, const Observer& observer);

/// Plastic strain grows in the cycles that are played, and no cycle that is jumped adds any: warns where more than a
/// hundredth of it would be missing if each added as much. How much is missing the run cannot know: flow fades, and
/// some of it follows the wear of the whole block. `before`: the largest at the start of the block; `cycles`: that a
/// played one stands for.
void watch_plastic_strain(const scene::Step& step, double before, double cycles, State& state,
                          const Observer& observer);

/// Checks small strain at the first blocks, at every eighth later and at the last of a step.
/// Returns why the run ends, or nothing.
std::string watch_strain(const Problem& problem, State& state, const solver::System& system, bool last,
                         const Observer& observer);

}  // namespace reye::sim
