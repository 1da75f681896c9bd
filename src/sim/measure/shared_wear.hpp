#pragma once
#include "base/errors.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

/// Boundaries that several contacts wear: each counts the volume it removes itself, and all see the sum.   (README, 4)
namespace reye::sim {

/// Wear of other contacts at the nodes of one contact; empty without any.
struct LeftByOthers {
  std::vector<double> waiting_secondary, waiting_primary;  ///< volume that waits in the gap
  std::vector<double> energy;                              ///< frictional work at the nodes of the secondary
};

/// Issues of sides of two contacts under two names that share edges, where one of them wears: the volume it removes
/// could not be passed to the other.
std::vector<base::Issue> shared_wear_issues(const Problem& problem);

/// The wear of other contacts, per contact of the scene.
std::vector<LeftByOthers> left_by_others(const Problem& problem, const State& state);

/// The volumes that contacts have removed, as `as_shown` has them.
Volumes removed_as_shown(const Problem& problem, const State& state);

/// The contacts of a state as they are shown: at each node that a contact has worn, `removed` is what all contacts have
/// taken off there. Each contact keeps its own ledger of volume and work.
std::vector<contact::ContactState> as_shown(const Problem& problem, const State& state);

/// Lines of the plan: boundaries that several contacts wear, and the meaning of depths there.
std::vector<std::string> told_shared(const Problem& problem);

/// Before the waiting wear goes into the shape, every contact stores the wear of others at its nodes.
void note_others(const Problem& problem, State& state);

}  // namespace reye::sim
