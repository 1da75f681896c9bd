#pragma once
#include <benchmark/benchmark.h>

#include <chrono>

#include "base/cores.hpp"
#include "factorisations.hpp"

/// Common parts of the benches of one core and two.
namespace reye::bench {

/// Wall time of the work on so many cores [s].
template <class Work>
double wall_on(int count, Work work) {
  const base::Cores cores(count);
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

inline void tell_cores(benchmark::State& run, const std::vector<double>& one, const std::vector<double>& two) {
  run.counters["one_core_s"] = median(one);
  run.counters["two_cores_s"] = median(two);
  run.counters["times_faster"] = median(one) / median(two);
}

}  // namespace reye::bench
