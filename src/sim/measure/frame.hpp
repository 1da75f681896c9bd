#pragma once
#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/records.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// The frame of a state, with all data of a picture.
Frame make_frame(const Problem& problem, const State& state, Cache& cache, const std::string& step);

/// Passes a frame to the observer, unless it has it already.
void show_frame(const Problem& problem, State& state, Cache& cache, const Observer& observer, const std::string& step);

}  // namespace reye::sim
