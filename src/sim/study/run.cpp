#include "sim/study/run.hpp"

#include <chrono>

#include "base/formatted.hpp"
#include "sim/march/march.hpp"
#include "sim/problem/timer.hpp"
#include "sim/study/discretisation.hpp"

namespace reye::sim {

namespace {

std::string in_words(const DiscretisationError& error) {
  if (!error.surface) return "no estimate of the mesh's error: " + error.reason;
  std::string words = base::formatted("estimated error of the mesh %.3g %%", 100.0 * *error.surface);
  if (!error.peak_pressure) return words;
  return words + base::formatted(", of the peak pressure %.3g %%", 100.0 * *error.peak_pressure);
}

/// The error of the mesh; a run interrupted here resumes with the estimate.
void estimate(const Problem& problem, const State& state, const Observer& observer, Cache& cache, Summary& summary) {
  const DiscretisationError error = mesh_error(problem, state, cache, observer);
  summary.error_discretisation = error.surface;
  summary.error_peak_pressure = error.peak_pressure;
  summary.error_energy_norm = error.energy_norm;
  summary.room_seconds = cache.seconds;
  if (error.companion == RunStatus::interrupted) {
    summary.status = RunStatus::interrupted;
    summary.reason = error.reason;
  } else if (observer.log) {
    observer.log(in_words(error));
  }
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

}  // namespace reye::sim
