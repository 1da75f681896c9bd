#pragma once
#include <string>
#include <vector>

#include "sim/equilibrate.hpp"
#include "sim/problem.hpp"
#include "sim/records.hpp"
#include "sim/state.hpp"
#include "sim/system.hpp"

/// Fresh meshes.
namespace reye::sim {

/// Why a body is to be remeshed, empty: it is not; whether its outline wants other facets, too; and whether the
/// current shape becomes X.
struct RemeshReason {
  std::string text;
  bool divide = false;
  bool renew = false;
};

/// A body after the wear of a block has been taken off.
struct Moved {
  body::ShapePtr shape;
  std::string poor;  ///< why its mesh cannot be used; empty when it can
};

/// Shapes that have changed and what goes with them, on the way to a new equilibrium.
struct Change {
  State next;
  std::vector<RemeshReason> reasons;  ///< per body
  std::vector<HeldTraction> held;     ///< per contact, on the nodes of `next`
};

/// What the triggers say of every body.
std::vector<RemeshReason> remesh_reasons(const Problem& problem, const State& state, const solver::System& system,
                                         const std::vector<Moved>& moved);

/// Fresh meshes for the bodies with a reason, and the state carried onto them. `state`: before the shapes moved;
/// `change.next`: its shapes moved, its wear entered in the ledger. `change.held` becomes that of the new nodes.
/// Returns a failure in words; `records` holds what was done; its jumps are filled in later.
std::string remesh_bodies(const Problem& problem, const State& state, Change& change, Cache& cache,
                          std::vector<RemeshRecord>& records);

}  // namespace reye::sim
