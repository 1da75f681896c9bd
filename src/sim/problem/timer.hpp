#pragma once
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
double cpu_seconds();

/// The largest memory of this program so far.
double peak_memory_MB();

SystemPtr timed_system(const Problem& problem, const State& state, Cache& cache);

}  // namespace reye::sim
