#pragma once
#include <string>

#include "sim/problem.hpp"

namespace reye::output {

/// The state as bytes, and back: every bit that the run goes on from.
std::string state_to_bytes(const sim::State& state);
sim::State state_from_bytes(const std::string& bytes);

}  // namespace reye::output
