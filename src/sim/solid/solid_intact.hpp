#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "sim/solid/solid_state.hpp"

namespace reye::sim {

/// Whether a state that was read from a file can be one of this problem: sizes that belong together, indices within
/// their counts, finite numbers. Throws std::runtime_error with the contradiction, base::SolveError where its equations
/// cannot be set up. Returns these equations, on which the run resumes; empty where nothing has been solved yet.
std::optional<SolidAssembly> check_state(const SolidProblem& problem, const SolidRunState& state);

/// Whether the state of a run can be one of this scene, which has more cycles in its last step: the issue, under
/// `cycles_key`, where it has fewer than were begun.
std::vector<base::Issue> extend(const SolidProblem& problem, const std::string& cycles_key, const SolidRunState& state);

}  // namespace reye::sim
