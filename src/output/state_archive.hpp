#pragma once
#include <cstdint>
#include <string>

#include "sim/problem.hpp"
#include "sim/state.hpp"

namespace reye::output {

/// The state as bytes, and back: every bit that the run resumes from. From bytes that are not of a state
/// std::runtime_error; that what they hold belongs together, sim::check_state says.
std::string state_to_bytes(const sim::State& state);
sim::State state_from_bytes(const std::string& bytes);

/// The layout of these bytes and of the Counters before them: another one wherever a type of them is.
std::uint64_t state_layout();

}  // namespace reye::output
