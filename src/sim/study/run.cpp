#include "sim/study/run.hpp"

#include <chrono>

#include "sim/march/march.hpp"
#include "sim/problem/timer.hpp"
#include "sim/solid/solid_march.hpp"
#include "sim/study/discretisation.hpp"
#include "sim/study/solid_discretisation.hpp"

namespace reye::sim {

namespace {

/// Puts the error of the mesh into the summary; a run interrupted in its companion resumes with the estimate.
template <class AnySummary, class AnyObserver>
void add_error(const DiscretisationError& error, const AnyObserver& observer, AnySummary& summary) {
  summary.error_discretisation = error.surface;
  summary.error_peak_pressure = error.peak_pressure;
  if (error.companion == RunStatus::interrupted) {
    summary.status = RunStatus::interrupted;
    summary.reason = error.reason;
  } else if (observer.log) {
    observer.log(in_words(error));
  }
}

void estimate(const Problem& problem, const State& state, const Observer& observer, Cache& cache, Summary& summary) {
  const DiscretisationError error = mesh_error(problem, state, cache, observer);
  summary.error_energy_norm = error.energy_norm;
  summary.room_seconds = cache.seconds;
  add_error(error, observer, summary);
}

void estimate(const SolidProblem& problem, const SolidRunState& state, const SolidObserver& observer,
              SolidSummary& summary) {
  const double start = cpu_seconds();
  const DiscretisationError error = mesh_error(problem, state, observer);
  summary.phase_seconds["error"] = cpu_seconds() - start;
  add_error(error, observer, summary);
}

}  // namespace

Summary run(const Problem& problem, State& state, const Observer& observer, Cache& cache) {
  using clock = std::chrono::steady_clock;
  const auto start = clock::now();
  const double cpu = cpu_seconds();
  Summary summary = march(problem, state, observer, cache);
  if (problem.scene.output.estimate_error && summary.status == RunStatus::done)
    estimate(problem, state, observer, cache, summary);
  summary.wall_s = std::chrono::duration<double>(clock::now() - start).count();
  summary.cpu_s = cpu_seconds() - cpu + cache.cpu_s;
  summary.peak_rss_MB = peak_memory_MB();
  return summary;
}

Summary run(const Problem& problem, State& state, const Observer& observer) {
  Cache cache;
  return run(problem, state, observer, cache);
}

SolidSummary run(const SolidProblem& problem, SolidRunState state, const SolidObserver& observer,
                 std::optional<SolidAssembly> assembly) {
  if (!problem.scene.estimate_error) return run_solid(problem, std::move(state), observer, std::move(assembly));
  using clock = std::chrono::steady_clock;
  const auto start = clock::now();
  const double cpu = cpu_seconds();
  SolidRunState last = state;
  SolidObserver watched = observer;
  watched.state = [&](const SolidRunState& now) {
    last = now;
    if (observer.state) observer.state(now);
  };
  SolidSummary summary = run_solid(problem, std::move(state), watched, std::move(assembly));
  if (summary.status == RunStatus::done) estimate(problem, last, observer, summary);
  summary.wall_s = std::chrono::duration<double>(clock::now() - start).count();
  summary.cpu_s = cpu_seconds() - cpu;
  summary.peak_rss_MB = peak_memory_MB();
  return summary;
}

}  // namespace reye::sim
