#include "sim/study/forecast.hpp"

#include <algorithm>
#include <chrono>

#include "base/formatted.hpp"
#include "sim/march/march.hpp"
#include "sim/march/work.hpp"
#include "sim/problem/rules.hpp"
#include "sim/problem/timer.hpp"

namespace reye::sim {

namespace {

/// The trial: the state at its last block end, and when that was.
struct Trial {
  State state;
  double seconds = 0.0;
  double increments = 0.0;  ///< those beyond the last block end included
  bool whole = false;
  std::string failure{};
};

Trial played(const Problem& problem, Cache& cache, double budget) {
  using clock = std::chrono::steady_clock;
  const auto start = clock::now();
  const auto spent = [&] { return std::chrono::duration<double>(clock::now() - start).count(); };
  Trial trial{initial_state(problem)};
  Observer observer;
  observer.block = [&](const State& state) { trial.state = state; };
  observer.frame = [](const Frame&) {};  // stress inside the bodies is part of the run
  observer.interrupted = [&] { return spent() > budget; };
  State state = trial.state;
  const Summary summary = march(problem, state, observer, cache);
  trial.seconds = spent();
  trial.increments = static_cast<double>(state.counts.increments);
  trial.whole = summary.status == RunStatus::done;
  if (summary.status == RunStatus::failed) trial.failure = summary.reason;
  return trial;
}

/// How far off the number of increments may be: not at all where all blocks are given, else the more, the longer the
/// run is beside what the trial has seen.
double spread_of(const Problem& problem, const Trial& trial) {
  if (trial.whole) return 1.2;
  const auto& steps = problem.scene.steps;
  const bool given = std::none_of(steps.begin(), steps.end(), [](const auto& step) { return under_tolerance(step); });
  return given ? 1.5 : 2.0;
}

constexpr double later = 1.2;      ///< times the pace of the trial: remeshes, a wider contact, files (results/forecast)
constexpr double companion = 1.4;  ///< times the run, where the error of the mesh is estimated

std::string duration(double s) {
  if (s < 120.0) return base::formatted(s < 10.0 ? "%.2g s" : "%.0f s", s);
  return s < 7200.0 ? base::formatted("%.0f min", s / 60.0) : base::formatted("%.2g h", s / 3600.0);
}

}  // namespace

Forecast forecast(const Problem& problem, Cache& cache, double seconds, double prepared_s) {
  const Trial trial = played(problem, cache, seconds);
  Forecast f;
  f.trial_seconds = trial.seconds;
  f.trial_increments = trial.increments;
  f.memory_MB = peak_memory_MB();
  f.whole = trial.whole;
  const Work left = trial.whole ? Work{} : work_left(problem, trial.state);
  const Counts& counts = trial.state.counts;
  f.blocks = static_cast<double>(counts.blocks) + left.blocks;
  f.cycles = static_cast<double>(counts.cycles_solved) + left.cycles;
  f.increments = static_cast<double>(counts.increments) + left.increments;
  if (!trial.failure.empty()) f.unknown = "the run fails in its first seconds: " + trial.failure;
  const double beyond = std::max(0.0, f.increments - trial.increments);
  if (trial.increments > 0.0) f.seconds = trial.seconds * (1.0 + later * beyond / trial.increments);
  if (problem.scene.output.estimate_error) f.seconds *= companion;
  f.seconds += prepared_s;
  f.spread = spread_of(problem, trial);
  return f;
}

std::vector<std::string> in_words(const Forecast& f) {
  if (!f.unknown.empty()) return {"time: unknown; " + f.unknown};
  const std::string basis =
      f.whole ? "the whole run was played for this"
              : base::formatted("judged from %.0f increments, played in %.2g s", f.trial_increments, f.trial_seconds);
  return {base::formatted("to be solved: about %.0f blocks, %.0f cycles, %.0f increments", f.blocks, f.cycles,
                          f.increments),
          "time: about " + duration(f.seconds) + ", between " + duration(f.seconds / f.spread) + " and " +
              duration(f.seconds * f.spread) + "; " + basis,
          base::formatted("memory: about %.0f MB, and up to half as much again after remeshes", f.memory_MB)};
}

}  // namespace reye::sim
