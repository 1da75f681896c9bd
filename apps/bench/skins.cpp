#include <benchmark/benchmark.h>

#include <cmath>

#include "mortar/solid/skin_pairs.hpp"
#include "support/skins.hpp"

/// Mortar integrals between skins of solids, and the search for pairs: a flat side over a sphere's cap, n x n cells of
/// facets each, which slides by a facet in twenty calls.
namespace {

using namespace reye;
using mesh::FacetKind;

/// The sides; the points of the primary one are moved by a part of a facet.
struct SkinSides {
  mortar::Skin secondary, primary;
  mortar::SkinOptions options{.search_mm = 0.2};

  SkinSides(FacetKind a, FacetKind b, int n, double shaken) {
    const auto cap = [](const base::Vec3& x) {
      return base::Vec3(x.x(), x.y(), 10.0 - std::sqrt(100.0 - x.head<2>().squaredNorm()));
    };
    primary = test::curved(
        test::skin_grid({.kind = b, .nx = n, .ny = n, .lo = {-1, -1}, .hi = {1, 1}, .shaken = shaken}), cap);
    secondary =
        test::skin_grid({.kind = a, .nx = n, .ny = n, .lo = {-1, -1}, .hi = {1, 1}, .height = 0.01, .up = false});
  }
};

constexpr FacetKind tri3 = FacetKind::tri3, quad4 = FacetKind::quad4, tri6 = FacetKind::tri6;

void skin_integrals(benchmark::State& run, FacetKind a, FacetKind b, double shaken) {
  SkinSides sides(a, b, static_cast<int>(run.range(0)), shaken);
  mortar::SkinPairs pairs;
  const base::Vec3 step(0.1 / static_cast<double>(run.range(0)), 0.03 / static_cast<double>(run.range(0)), 0.0);
  int calls = 0;
  for (auto _ : run) {
    const double sign = ++calls % 40 < 20 ? 1.0 : -1.0;
    for (auto& x : sides.secondary.x) x += sign * step;
    benchmark::DoNotOptimize(mortar::integrate(sides.secondary, sides.primary, sides.options, pairs).M.nonZeros());
  }
  run.counters["facets"] = static_cast<double>(sides.secondary.facets.size());
  run.counters["points"] = static_cast<double>(sides.secondary.x.size());
}
BENCHMARK_CAPTURE(skin_integrals, tri3, tri3, tri3, 0.02)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(skin_integrals, quad4, quad4, quad4, 0.02)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(skin_integrals, quad4_distorted, quad4, quad4, 0.2)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(skin_integrals, tri3_quad4, tri3, quad4, 0.02)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(skin_integrals, tri6, tri6, tri6, 0.02)->Arg(10)->Arg(20)->Unit(benchmark::kMillisecond);

void skin_search(benchmark::State& run) {
  const SkinSides sides(tri3, tri3, static_cast<int>(run.range(0)), 0.02);
  mortar::SkinPairs pairs;
  for (auto _ : run) {
    mortar::find_pairs(sides.secondary, sides.primary, sides.options.search_mm, pairs);
    benchmark::DoNotOptimize(pairs.opposite.data());
  }
}
BENCHMARK(skin_search)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);

}  // namespace
