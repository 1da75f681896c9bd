#pragma once
#include "sim/problem/observer.hpp"
#include "sim/problem/records.hpp"

namespace reye::sim {

/// An observer of the calls that pass at once: progress, log lines and interruption.
Observer quiet(const Observer& outside);

/// Buffers the records of a block until it is accepted.
class Recording {
 public:
  /// An observer that records the calls that `outside` would take; those of `quiet` pass at once.
  Observer observer(const Observer& outside);
  /// Reports everything to the outside, `adjust` applied to the rows of the history.
  void play_back(const Observer& outside, const std::function<void(IncrementRecord&)>& adjust = {});

 private:
  std::vector<std::function<void(const Observer&, const std::function<void(IncrementRecord&)>&)>> events_;
};

}  // namespace reye::sim
