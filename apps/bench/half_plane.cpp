#include "support/half_plane.hpp"

#include <benchmark/benchmark.h>

/// The wear of geo/partial_slip_life for two half-planes: the tests' reference, for results/partial_slip_life.
namespace {

using namespace reye;

/// range: 100 Q / mu P, 1000 alpha N [mm^3/J].
void half_plane(benchmark::State& run) {
  constexpr double P = 120.0, mu = 0.6, radius = 6.0, E_star = 200e3 / (2.0 * (1.0 - 0.3 * 0.3));
  const double share = 0.01 * static_cast<double>(run.range(0)), wear = 1e-6 * static_cast<double>(run.range(1));
  for (auto _ : run) {
    const auto grid = half_plane::make_grid(0.12, 200, E_star);
    const base::Vector shape = grid.x.array().square() / (2.0 * radius);
    const auto worn = half_plane::wear(grid, shape, {P, share * mu * P, mu}, wear, 30);
    run.counters["depth_mm"] = worn.depth.maxCoeff();
    run.counters["area_mm2"] = half_plane::area(grid, worn.depth);
  }
}

BENCHMARK(half_plane)->ArgsProduct({{60}, {2500, 25000}})->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
