#pragma once
#include <functional>
#include <vector>

#include "sim/solid/solid_observer.hpp"

namespace reye::sim {

/// An observer of the calls that pass at once: progress, log lines and interruption.
SolidObserver quiet(const SolidObserver& outside);

/// Buffers the records of a block until it is accepted.
class SolidRecording {
 public:
  /// An observer that records the calls that `outside` would take; those of `quiet` pass at once.
  SolidObserver observer(const SolidObserver& outside);
  /// Reports everything to the outside, `adjust` applied to the rows of the history.
  void play_back(const SolidObserver& outside, const std::function<void(SolidIncrement&)>& adjust = {});

 private:
  std::vector<std::function<void(const SolidObserver&, const std::function<void(SolidIncrement&)>&)>> events_;
};

}  // namespace reye::sim
