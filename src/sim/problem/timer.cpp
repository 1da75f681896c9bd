#include "sim/problem/timer.hpp"

#include <sys/resource.h>

namespace reye::sim {

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto s = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
  return s(usage.ru_utime) + s(usage.ru_stime);
}

double peak_memory_MB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

SystemPtr timed_system(const Problem& problem, const State& state, Cache& cache) {
  Timer timer(cache, "body");
  return system_of(problem, state, cache);
}

}  // namespace reye::sim
