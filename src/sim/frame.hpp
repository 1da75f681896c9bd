#pragma once
#include "sim/observer.hpp"
#include "sim/problem.hpp"
#include "sim/records.hpp"
#include "sim/state.hpp"
#include "sim/system.hpp"

namespace reye::sim {

/// The frame of a state, with all data of a picture.
Frame make_frame(const Problem& problem, const State& state, Cache& cache, const std::string& step);

/// Passes a frame to the observer, unless it has it already.
void show_frame(const Problem& problem, State& state, Cache& cache, const Observer& observer, const std::string& step);

}  // namespace reye::sim
