#pragma once
#include <map>
#include <optional>
#include <string>

#include "sim/solid/solid_measure.hpp"

namespace reye::sim {

/// The part of a step that one block plays.
struct SolidSpan {
  const scene::Step* step = nullptr;
  double jump = 1.0;  ///< cycles of this block; 1 for a load step
  bool cycles = false;
  bool last = false;     ///< no block of the step comes after it
  bool recorded = true;  ///< its increments are rows of the history
  std::optional<Continued> continued{};
  bool level = false;  ///< its end is shown: under a tolerance levelling cycles are its last part
};

/// A state, or the reason of a failure.
struct SolidOutcome {
  SolidRunState state;
  std::string failure;  ///< empty when the state is accepted
  bool interrupted = false;
  double cycle = 0.0, progress = 1.0;      ///< that a failed play has come to
  CourseOfWear worn{};                     ///< by the increments of a step under a tolerance
  std::map<std::string, double> middle{};  ///< measures of the limits half way, where known
};

}  // namespace reye::sim
