#include "progress_line.hpp"

#include <unistd.h>

#include <cstdio>

#include "base/printable.hpp"
#include "sim/problem/records.hpp"

namespace reye::apps {

ProgressLine::ProgressLine(bool wanted) : wanted_(wanted), terminal_(isatty(STDERR_FILENO) != 0) {}

/// Time left, from the pace of the increments so far.
double ProgressLine::seconds_left(const sim::Progress& p) {
  if (!(p.solved > solved_before_)) return 0.0;
  const double spent = std::chrono::duration<double>(clock::now() - start_).count();
  return spent * p.to_be_solved / (p.solved - solved_before_);
}

void ProgressLine::show(const sim::Progress& p) {
  if (!wanted_) return;
  const auto now = clock::now();
  if (step_.empty()) solved_before_ = p.solved - 1.0;  // by the run that this one resumes
  step_ = p.step;
  const double pause = terminal_ ? 0.1 : 5.0;
  const bool last = p.fraction >= 1.0 - 1e-12;  // of the step
  if (!last && std::chrono::duration<double>(now - last_shown_).count() < pause) return;
  last_shown_ = now;
  std::fprintf(stderr, "%s%-16s cycle %.6g%s  increment %d/%d  newton %d  depth %.4g um  %3.0f %%  %.0f s left%s",
               terminal_ ? "\r\033[K" : "", base::printable(p.step).c_str(), p.cycle, p.cycles > 0.0 ? "" : " (load)",
               p.increment, p.increments, p.newton, 1e3 * p.depth_max_mm, 100.0 * p.fraction, seconds_left(p),
               terminal_ ? "" : "\n");
  std::fflush(stderr);
}

void ProgressLine::end() {
  if (wanted_ && terminal_ && !step_.empty()) std::fprintf(stderr, "\n");
}

}  // namespace reye::apps
