#pragma once
#include <chrono>

#include "sim/problem.hpp"

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

inline const solver::System& timed_system(const Problem& problem, const State& state, Cache& cache) {
  Timer timer(cache, "body");
  return system_of(problem, state, cache);
}

}  // namespace reye::sim
