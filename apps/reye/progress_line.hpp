#pragma once
#include <chrono>

#include "sim/problem/records.hpp"

namespace reye::apps {

/// One line that is rewritten on a terminal; elsewhere a plain line now and then.
class ProgressLine {
 public:
  explicit ProgressLine(bool wanted);
  void show(const sim::Progress& progress);
  void end();

 private:
  using clock = std::chrono::steady_clock;
  double seconds_left(const sim::Progress& progress);

  bool wanted_, terminal_;
  std::string step_;
  double solved_before_ = 0.0;
  clock::time_point start_ = clock::now(), last_shown_{};
};

}  // namespace reye::apps
