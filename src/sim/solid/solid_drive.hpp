#pragma once
#include <map>
#include <string>
#include <vector>

#include "sim/solid/solid_assembly.hpp"

namespace reye::sim {

/// The cycles that a block stands for: `cycle` before it, `jump` of them.
struct SolidCycles {
  double cycle = 0.0, jump = 1.0;
  std::optional<Continued> continued{};
};

/// What an increment asks for at the given factors; `from`, `to`: its part of the step's play.
solver::SolidTarget target_at(const SolidProblem& problem, const solver::SolidSystem& system,
                              const solver::SolidState& state, const std::map<std::string, double>& factors,
                              const scene::Step& step, const SolidCycles& cycles, double from, double to);

}  // namespace reye::sim
