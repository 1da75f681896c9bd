#pragma once
#include "sim/drive.hpp"
#include "sim/run.hpp"

namespace reye::sim {

/// A state, or why there is none.
struct Outcome {
  State state;
  std::string failure;  ///< empty when the state is accepted
  bool interrupted = false;
  std::map<std::string, double> middle{};  ///< measures of the limits half way, where known
  std::vector<double> ends{};              ///< of the increments that were played, by progress
  bool remesh_due = false;                 ///< a trigger fired, and the span has put it off
};

/// The part of a step that one block plays.
struct BlockSpan {
  const scene::Step* step = nullptr;
  double jump = 1.0;   ///< cycles of this block; 1 for a load step
  bool cycles = false;
  bool last = false;   ///< no block of the step comes after it
  bool level = false;  ///< its end is shown: under a tolerance levelling cycles are its last part
  bool remesh = true;  ///< false: poor elements wait for the end of the block
  bool extrapolated = false;  ///< its wear was corrected, and the pressures not: they are no measure of the new shape
  std::vector<double> ends{};  ///< of its increments, by progress; empty: as the step has them
};

/// Zero displacement, fresh contacts.
void begin_state(const Problem& problem, State& state, Cache& cache);

/// Bodies apart and loaded by force are moved along what loads them first, rigidly and by geometry alone, until the
/// first secondary node meets its facet.
void approach(const Problem& problem, State& state, const solver::System& system);

/// True when some support fixes or imposes the motion of a body along d.
bool held_along(const Problem& problem, const solver::System& system, int body, const Vec2& d);

/// One block in full.
Outcome play_block(const Problem& problem, const State& state, Cache& cache, const BlockSpan& span, const Observer& observer);

/// What follows the increments of a block: shape step, fresh meshes, renewed references.
Outcome end_block(const Problem& problem, State state, Cache& cache, const BlockSpan& span, const Observer& observer);

/// All increments of one block, with cut-backs.
Outcome play_increments(const Problem& problem, State state, Cache& cache, const BlockSpan& span, const Observer& observer);

/// Why a body is to be meshed anew, empty: it is not; whether its outline wants other facets, too; and whether the
/// current shape becomes X.
struct RemeshReason {
  std::string text;
  bool divide = false;
  bool renew = false;
};

/// Shape evolution of all worn bodies, fresh meshes where a trigger, or `asked` (per body, or none), wants them, then
/// re-equilibration with the shear as history.
Outcome evolve_shape(const Problem& problem, State state, Cache& cache, const BlockSpan& span, const Observer& observer,
                     const std::vector<RemeshReason>& asked = {});

/// Whether the current shape of a body may become its X: it is finitely strained, does not wear (removed volumes are
/// unstressed), and nothing of it is counted on X but edges held or moved along fixed axes and pressures on whole edges.
bool can_renew(const Problem& problem, int body);

/// Bodies whose elements deformation has made poor: the current shape becomes X, meshed anew; Gauss points keep F0 and
/// plastic state, contacts their tractions; then re-equilibration with the shear as history. Waits while wear waits in
/// the gap. False: nothing was done, because there was no reason or, as the log then says, because it failed.
bool renew_references(const Problem& problem, State& state, Cache& cache, const BlockSpan& span, const Observer& observer);

/// A row of the history with only what has worn until now: largest depths and energy.
IncrementRecord wear_of(const Problem& problem, const solver::System& system, const State& state);

/// A row of the history but for where it stands: what has worn, the peak pressure and what supports feel.
IncrementRecord figures_of(const Problem& problem, const State& state, const solver::System& system,
                           const solver::Controls& controls);

/// Displacement of all mesh nodes of a body.
std::vector<Vec2> displacements(const body::Operator& op, const Vector& q, const body::Interior& interior,
                                const Vector& load_factors);
/// By how much a linear body has turned [rad].
double turned_by(const body::Operator& op, const Vector& q);

/// Everything a picture needs of a state.
Frame make_frame(const Problem& problem, const State& state, Cache& cache, const std::string& step);

/// Tells the observer of a frame, unless it has it already.
void show_frame(const Problem& problem, State& state, Cache& cache, const Observer& observer, const std::string& step);

}  // namespace reye::sim
