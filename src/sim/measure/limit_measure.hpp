#pragma once
#include <map>
#include <string>

#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

namespace reye::sim {

/// The value a limit watches.
double limit_measure(const scene::Limit& limit, const contact::Setup& setup, const contact::ContactState& state,
                     const std::vector<body::ShapePtr>& shapes, const PlacedContact& placed);

/// The values of all limits, by name.
std::map<std::string, double> limit_measures(const Problem& problem, const solver::System& system, const State& state);

}  // namespace reye::sim
