#pragma once
#include <optional>
#include <vector>

#include "scene/scene.hpp"

/// Rules of output: frames at block ends, rows of the history.
namespace reye::sim {

/// A block of cycles, or a load step, that has been played.
struct PlayedBlock {
  double cycle_before = 0.0, cycle = 0.0;  ///< at its start and end
  long number = 1;                         ///< in its step, from 1
  bool last = false;                       ///< of its step, or of the run
  bool remeshed = false;                   ///< a body was remeshed in it
  double share_before = 0.0, share = 0.0;  ///< of its step's cycles that are played at its start and end
};

/// Whether the state at the end of the block is a frame; several rules that want it make one frame.
/// per_decade: where n log10(cycle) passes a whole number; the first block from cycle 0 always does.
bool frame_due(const scene::FrameRules& rules, const PlayedBlock& block);

/// The last cycle in (from, to] at which `every_cycles` or `per_decade` ask for a frame.
std::optional<double> last_frame_cycle(const scene::FrameRules& rules, double from, double to);

/// Cycles of a block under a tolerance: so that it ends at a frame's cycle where one is near; two blocks share the
/// `left` rest of a step when one is not enough.
double fitted(const scene::FrameRules& frames, double cycle, double jump, double left);

/// Whether the blocks of a step are chosen by the error they make.
bool under_tolerance(const scene::Step& step);

/// Whether a step, one of `steps`, jumps over cycles by blocks of one size, and none after it wears: what a run with
/// such blocks shows in the end is theirs.
bool last_to_jump(const std::vector<scene::Step>& steps, const scene::Step& step);

/// Whether the increments of a step's block, counted from 1, are rows of the history.
bool history_due(int every_blocks, long number, bool last);

}  // namespace reye::sim
