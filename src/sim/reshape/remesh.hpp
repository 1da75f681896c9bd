#pragma once
#include <string>
#include <vector>

#include "sim/problem/problem.hpp"
#include "sim/problem/records.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"
#include "sim/reshape/equilibrate.hpp"

/// Fresh meshes.
namespace reye::sim {

/// Why a body is to be remeshed (empty: it is not), whether its outline needs other facets, too, and whether the
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

/// Changed shapes and the fields carried with them, before the new equilibrium.
struct Change {
  State next;
  std::vector<RemeshReason> reasons;  ///< per body
  std::vector<HeldTraction> held;     ///< per contact, on the nodes of `next`
};

/// The triggers of every body.
std::vector<RemeshReason> remesh_reasons(const Problem& problem, const State& state, const solver::System& system,
                                         const std::vector<Moved>& moved);

/// Remeshes the bodies with a reason, and carries the state onto the fresh meshes. `state`: before the shapes moved;
/// `change.next`: its shapes moved, its wear entered in the ledger. `change.held` becomes that of the new nodes.
/// Returns a failure in words; `records` holds what was done; its jumps are filled in later.
std::string remesh_bodies(const Problem& problem, const State& state, Change& change, Cache& cache,
                          std::vector<RemeshRecord>& records);

}  // namespace reye::sim
