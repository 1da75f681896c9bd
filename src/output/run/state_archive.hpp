#pragma once
#include <cstdint>
#include <string>

#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

namespace reye::output {

/// The state as bytes, and back: every bit that the run resumes from. Throws std::runtime_error for bytes that are not
/// of a state; sim::check_state checks that their content is consistent.
std::string state_to_bytes(const sim::State& state);
sim::State state_from_bytes(const std::string& bytes);

/// The layout of these bytes and of the Counters before them, which changes with any of their types.
std::uint64_t state_layout();

}  // namespace reye::output
