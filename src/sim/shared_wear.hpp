#pragma once
#include "base/errors.hpp"
#include "sim/problem.hpp"
#include "sim/state.hpp"

/// Boundaries that several contacts wear: each books what it takes off itself, and all see what is gone.   (README, 4)
namespace reye::sim {

/// Of one contact, what other contacts have left at its nodes; empty where they have left nothing.
struct LeftByOthers {
  std::vector<double> waiting_secondary, waiting_primary;  ///< volume that waits in the gap
  std::vector<double> energy;                              ///< frictional work at the nodes of the secondary
};

/// Sides of two contacts under two names that have edges in common, where one of them wears: the volume it removes
/// could not be passed to the other.
std::vector<base::Issue> shared_wear_issues(const Problem& problem);

/// Per contact of the scene.
std::vector<LeftByOthers> left_by_others(const Problem& problem, const State& state);

/// The contacts of a state as they are shown: at each node that a contact has worn, `removed` is what all contacts have
/// taken off there. Each contact keeps its own ledger of volume and work.
std::vector<contact::ContactState> as_shown(const Problem& problem, const State& state);

/// For the plan: boundaries that several contacts wear, and whose the depths there are.
std::vector<std::string> told_shared(const Problem& problem);

/// What waits in the gap is about to go into the shape: every contact notes what others leave at its nodes.
void note_others(const Problem& problem, State& state);

}  // namespace reye::sim
