#pragma once
#include "sim/problem/observer.hpp"
#include "sim/problem/records.hpp"

namespace reye::sim {

/// Only what passes at once: progress, log lines and interruption.
Observer quiet(const Observer& outside);

/// Keeps what a block that may be dropped reports, until it is accepted.
class Recording {
 public:
  /// Reports to the recording what `outside` would take; what is quiet passes at once.
  Observer observer(const Observer& outside);
  /// Reports everything to the outside, `adjust` applied to the rows of the history.
  void play_back(const Observer& outside, const std::function<void(IncrementRecord&)>& adjust = {});

 private:
  std::vector<std::function<void(const Observer&, const std::function<void(IncrementRecord&)>&)>> events_;
};

}  // namespace reye::sim
