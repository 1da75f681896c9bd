#pragma once
#include <sys/resource.h>

#include <chrono>

#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

namespace reye::sim {

/// Adds the wall time of a scope to one room's account.
class Timer {
 public:
  Timer(Cache& cache, const char* room) : seconds_(cache.seconds[room]), start_(clock::now()) {}
  ~Timer() { seconds_ += std::chrono::duration<double>(clock::now() - start_).count(); }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

 private:
  using clock = std::chrono::steady_clock;
  double& seconds_;
  clock::time_point start_;
};

/// Processor time of this program so far, all its threads [s].
inline double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto s = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
  return s(usage.ru_utime) + s(usage.ru_stime);
}

/// The largest memory of this program so far.
inline double peak_memory_MB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

inline SystemPtr timed_system(const Problem& problem, const State& state, Cache& cache) {
  Timer timer(cache, "body");
  return system_of(problem, state, cache);
}

}  // namespace reye::sim
