#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/problem/state.hpp"

namespace reye::sim {

/// The part of a step that one block plays.
struct BlockSpan {
  const scene::Step* step = nullptr;
  double jump = 1.0;  ///< cycles of this block; 1 for a load step
  bool cycles = false;
  bool last = false;   ///< no block of the step comes after it
  bool level = false;  ///< its end is shown: under a tolerance levelling cycles are its last part
  bool moves = false;  ///< its outlines move, however little has worn
  bool remesh = true;  ///< false: poor elements wait for the end of the block
  bool extrapolated =
      false;  ///< its wear was corrected, but not the pressures, which therefore do not fit the new shape
  std::optional<Continued> continued{};
  std::vector<double> ends{};      ///< of its increments, by progress; empty: as the step has them
  double increments_of_run = 0.0;  ///< those solved before it and those that are left, by an estimate; 0: not asked for
};

/// The cycle of a progress of the span's play, which begins at cycle `start`.
inline double cycle_at(const BlockSpan& span, double start, double progress) {
  if (!span.cycles) return start;
  return start + progress * (span.continued ? span.continued->cycle - start : span.jump);
}

/// A state, or the reason of a failure.
struct Outcome {
  State state;
  std::string failure;  ///< empty when the state is accepted
  bool interrupted = false;
  std::map<std::string, double> middle{};  ///< measures of the limits half way, where known
  std::vector<double> ends{};              ///< of the increments that were played, by progress
  CourseOfWear worn{};                     ///< by the increments of a step under a tolerance
  bool remesh_due = false;                 ///< a trigger fired, and the span has put it off
};

}  // namespace reye::sim
