#pragma once
#include <string>
#include <vector>

#include "sim/block.hpp"

/// What the shape step and the making of a fresh mesh share.
namespace reye::sim {

/// Tractions of the secondary nodes as forces, times A_j, before the shape moves.
struct HeldTraction {
  std::vector<double> normal, tangential;
};

std::vector<HeldTraction> held_tractions(const solver::System& system, const State& state);

/// Equilibrium on the state's shapes with the shear as given load, its nodal resultant kept; a failure in words.
std::string re_equilibrate(const Problem& problem, State& state, Cache& cache, const BlockSpan& span,
                           const std::vector<HeldTraction>& held);

/// Equilibrium with all tractions held: springs stand in the gaps, too soft to change a pressure. A failure in words.
std::string equilibrate_on_springs(const Problem& problem, State& state, Cache& cache, const BlockSpan& span,
                                   const std::vector<HeldTraction>& held);

/// A body after the wear of a block has been taken off.
struct Moved {
  body::ShapePtr shape;
  std::string poor;  ///< why its mesh can not be used; empty when it can
};

/// Displacement of all nodes of a body.
base::Points recovered(const Problem& problem, const State& state, const solver::System& system, int body);
/// The same in the frame of a linear body that turns: what strain is made of.
base::Points recovered_in_frame(const Problem& problem, const State& state, const solver::System& system, int body);

/// Shapes that have changed and what goes with them, on the way to a new equilibrium.
struct Change {
  State next;
  std::vector<RemeshReason> reasons;  ///< per body
  std::vector<HeldTraction> held;     ///< per contact, on the nodes of `next`
};

/// Fresh meshes where asked for and re-equilibration; the state before it where that fails.
Outcome settle(const Problem& problem, State state, Change change, Cache& cache, const BlockSpan& span,
               const Observer& observer);

/// What the triggers say of every body.
std::vector<RemeshReason> remesh_reasons(const Problem& problem, const State& state, const solver::System& system,
                                        const std::vector<Moved>& moved);

/// Fresh meshes for the bodies with a reason, and the state carried onto them. `state`: before the shapes moved;
/// `change.next`: its shapes moved, its wear booked. `change.held` becomes that of the new nodes. Returns a failure in
/// words; `records` tells what was done, jumps still open.
std::string remesh_bodies(const Problem& problem, const State& state, Change& change, Cache& cache,
                          std::vector<RemeshRecord>& records);

/// What the equilibria before and after a remesh are compared by.
struct Balance {
  std::vector<Vec2> force;        ///< on the secondary side of each contact
  std::vector<double> energy;     ///< strain energy of each body [mJ per mm; mJ]
};
Balance balance_of(const Problem& problem, const State& state, const solver::System& system);

/// Root mean square over the contact of p - p0, over that of p0; p0 the pressures that were carried over.
double pressure_jump(const contact::Setup& setup, const contact::ContactState& state, const HeldTraction& carried);

/// Largest |p - p0| over the largest p0, without the outermost twentieth of the loaded nodes at either end of each run of them.
double peak_jump(const contact::Setup& setup, const contact::ContactState& state, const HeldTraction& carried);

}  // namespace reye::sim
