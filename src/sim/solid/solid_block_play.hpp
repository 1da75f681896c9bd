#pragma once
#include <functional>

#include "sim/problem/two_step.hpp"
#include "sim/solid/solid_player.hpp"
#include "sim/solid/solid_recording.hpp"

/// The two ways to play a block of solids under a tolerance; as `march/block_play` for the plane.
namespace reye::sim {

/// One try of a block.
struct SolidTrial {
  SolidOutcome outcome;
  double cycles = 0.0;  ///< of the play
  double error = 0.0;
  bool too_long = false, throughout = false;
  bool serves = true;  ///< continued: all slides, and the wear of no side begins or stops
  SolidRecording rows, later;
  std::function<void(SolidIncrement&)> correct;  ///< makes rows that were recorded in the play those of the block
};

/// Counts of the work done continue where the state itself begins again.
void keep_work(SolidRunState& start, const SolidRunState& played);

/// Notes what a block of `cycles` from `start` has worn, for the next one to continue; not where some of a contact
/// sticks, or has come to other points.
void note_wear(const SolidProblem& problem, const SolidRunState& start, double cycles, SolidOutcome& outcome);

/// The cycles of a span's own play, without those that level its end where that is shown.
double cycles_of_play(const SolidSpan& span);

/// Plays a block in halves, with the cycles that level it where its end is shown and its error is `permitted`. False
/// where contact has outrun its points.
bool play_in_halves(const SolidProblem& problem, SolidPlayer& player, const SolidRunState& begin, const SolidSpan& span,
                    const SolidObserver& observer, double permitted, SolidTrial& trial);

/// The state that the two-step formula begins a block with; empty where some place would hold less than nothing.
std::optional<SolidRunState> begun(const SolidRunState& start, const TwoStep& formula);

/// Plays a block once, by the two-step formula. False where contact has outrun its points.
bool play_continued(const SolidProblem& problem, SolidPlayer& player, const SolidRunState& start, SolidRunState begun,
                    const TwoStep& formula, SolidSpan span, const SolidObserver& observer, double permitted,
                    SolidTrial& trial);

}  // namespace reye::sim
