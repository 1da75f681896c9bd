#pragma once
#include <csignal>

/// Handling of signals that end a run. Ctrl-C, SIGTERM and SIGHUP ask it to stop where everything can be written; a
/// second Ctrl-C or SIGTERM ends it at once. A closed terminal sends SIGHUP more than once, so any number of them
/// counts as one.
namespace reye::apps {

/// Counts the signals that ask for an end during its lifetime; signals that were ignored before, like SIGHUP under
/// nohup, stay ignored.
class StopSignals {
 public:
  /// `twice_ends`: a second Ctrl-C or SIGTERM ends the program at once.
  explicit StopSignals(bool twice_ends);
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  static int count();  ///< since the last one was made

 private:
  struct sigaction before_[3]{};
};

/// Makes output that nobody reads any more, as in `reye run ... | head -1`, no error; a file that may not grow any more
/// is an error with a reason.
void ignore_lost_output();

}  // namespace reye::apps
