#pragma once
#include <benchmark/benchmark.h>

#include <chrono>

#include "base/cores.hpp"
#include "factorisations.hpp"

/// Common parts of the benches of several cores.
namespace reye::bench {

/// Wall time of the work on so many cores [s].
template <class Work>
double wall_on(int count, Work work) {
  const base::Cores cores(count);
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

inline void tell_cores(benchmark::State& run, const std::vector<double>& one, const std::vector<double>& all) {
  run.counters["cores"] = base::physical_cores();
  run.counters["one_core_s"] = median(one);
  run.counters["all_cores_s"] = median(all);
  run.counters["times_faster"] = median(one) / median(all);
}

}  // namespace reye::bench
