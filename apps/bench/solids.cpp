#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>

#include "algebra/factor.hpp"
#include "cores.hpp"
#include "factorisations.hpp"
#include "patch_last.hpp"
#include "scene/solid/solid_scene.hpp"
#include "support/solid_slip_limit.hpp"

/// What solids cost: condensing in plain factorisations, and cycles of gross slip; and how Cattaneo's and Mindlin's
/// balls come out, as they are and worn. CPU time.
namespace {

using namespace reye;

double seconds_of_cpu() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// CPU seconds of a factor that keeps so many rows; one node alone is a plain factorisation.
double factorising(const base::SparseMatrix& K, int retained) {
  const double start = seconds_of_cpu();
  const algebra::SchurFactor factor(K, retained, {}, algebra::Ordering::nested_dissection);
  benchmark::DoNotOptimize(factor);
  return seconds_of_cpu() - start;
}

void condensing_solid(benchmark::State& run) {
  const auto K = bench::patch_last(
      {static_cast<int>(run.range(0)), static_cast<int>(run.range(0)), static_cast<int>(run.range(1))},
      static_cast<int>(run.range(2)));
  const int retained = 3 * static_cast<int>(run.range(2) * run.range(2));
  std::vector<double> plain, condensed;
  for (auto _ : run) {
    plain.push_back(factorising(K, 3));
    condensed.push_back(factorising(K, retained));
  }
  run.counters["dofs"] = static_cast<double>(K.rows());
  run.counters["retained"] = static_cast<double>(retained / 3);
  run.counters["factorisation_s"] = bench::median(plain);
  run.counters["condensing_in_factorisations"] = bench::median(condensed) / bench::median(plain);
}

/// Median factor by which an error falls in an iteration, where it is below 1e-3 and above round-off.
double median_fall(const std::vector<sim::SolidIncrement>& rows) {
  std::vector<double> falls;
  for (const auto& row : rows)
    for (std::size_t i = 0; i + 1 < row.errors.size(); ++i)
      if (row.errors[i] < 1e-3 && row.errors[i + 1] > 1e-12) falls.push_back(row.errors[i + 1] / row.errors[i]);
  return falls.empty() ? 0.0 : bench::median(falls);
}

void tell_phases(benchmark::State& run, const support::PlayedSolids& played, double cycle_s) {
  const auto& s = played.summary;
  const auto cycles = static_cast<double>(
      std::count_if(played.rows.begin(), played.rows.end(), [](const auto& row) { return row.cycle > 0.0; }));
  double iterations = 0.0;
  for (const auto& row : played.rows)
    if (row.cycle > 0.0) iterations += row.newton;
  run.counters["dofs"] = s.size.dofs;
  run.counters["kept_nodes"] = s.size.retained;
  run.counters["increments"] = cycles;
  run.counters["iterations_an_increment"] = iterations / cycles;
  run.counters["cutbacks"] = static_cast<double>(s.counts.cutbacks);
  run.counters["fall_of_errors"] = median_fall(played.rows);
  run.counters["balance"] = s.balance;
  run.counters["cycle_s"] = cycle_s;
  run.counters["factors_s"] = s.phase_seconds.at("stiffness and factors");
  run.counters["mortar_s"] = s.phase_seconds.at("mortar");
  run.counters["interface_s"] = s.phase_seconds.at("interface");
}

void require_done(const sim::SolidSummary& summary) {
  if (summary.status != sim::RunStatus::done) throw std::runtime_error(summary.reason);
}

void tell_stick_radius(benchmark::State& run, double radius, double exact, const support::HertzCase& c) {
  run.counters["stick_radius_over_exact"] = radius / exact;
  run.counters["stick_radius_error_in_elements"] = (radius - exact) / (c.a_mm / c.elements);
}

/// geo/sliding_ball with facets of so many micrometres: 0 as it is, 1 its flat secondary, 2 its ball rigid as well.
sim::SolidProblem sliding_ball_of(long facet_um, long variant) {
  auto scene = scene::read_solid(std::string(REYE_SOURCE_DIR) + "/geo/sliding_ball/scene.toml");
  for (auto& zone : scene.geometry.fine_zones) zone.size_mm = 1e-3 * static_cast<double>(facet_um);
  if (facet_um > 100)  // 1e5 dofs for both patches: this one has less of them
    for (auto& body : scene.geometry.bodies) body.mesh.far_size_mm = 5.0;
  if (variant > 0) {
    auto& contact = scene.contacts.front();
    std::swap(contact.secondary, contact.primary.front());
    for (auto& body : scene.geometry.bodies) body.rigid = variant == 2 && body.name == "ball";
  }
  return sim::prepare_solid(std::move(scene));
}

/// A cycle of 40 increments in gross slip. range(0), range(1): of `sliding_ball_of`; range(2): 1 where both sides wear.
void sliding_ball(benchmark::State& run) {
  auto problem = sliding_ball_of(run.range(0), run.range(1));
  if (run.range(2) == 1) {
    auto& law = problem.contacts.front().options.wear;
    law.kind = wear::LawKind::energy;
    law.secondary = law.primary = 1e-7;  // 1/MPa; 1e-4 mm^3/J
  }
  for (auto _ : run) {
    support::PlayedSolids played;
    double start = 0.0;
    sim::SolidObserver observer;
    observer.increment = [&](const sim::SolidIncrement& row) {
      if (row.cycle == 0.0) start = seconds_of_cpu();
      played.rows.push_back(row);
    };
    played.summary = sim::run_solid(problem, observer);
    require_done(played.summary);
    tell_phases(run, played, seconds_of_cpu() - start);
  }
}

/// Wall time of press and cycle on one core and on two, and what the number of cores changes.
void cores_sliding_ball(benchmark::State& run) {
  const auto problem = sliding_ball_of(run.range(0), 0);
  std::vector<double> one, two;
  std::array<double, 2> energy{};
  double dofs = 0.0;
  const auto played = [&](double& dissipated) {
    const auto summary = support::play(problem).summary;
    require_done(summary);
    dofs = summary.size.dofs;
    dissipated = summary.contacts[0].dissipated_energy_mJ;
  };
  for (auto _ : run) {
    one.push_back(bench::wall_on(1, [&] { played(energy[0]); }));
    two.push_back(bench::wall_on(2, [&] { played(energy[1]); }));
  }
  run.counters["dofs"] = dofs;
  run.counters["change_of_energy"] = std::abs(energy[1] / energy[0] - 1.0);
  bench::tell_cores(run, one, two);
}

/// range(0): q = Q / (mu P) in per cent; range(1): hexahedra per radius.
void two_balls(benchmark::State& run) {
  support::HertzCase c;
  c.nu = 0.0;
  c.mu = 0.5;
  c.half = c.two_balls = true;
  c.elements = static_cast<double>(run.range(1));
  c.fine = 1.1;
  c.fine_depth = 0.3;
  c.growth = 1.6;
  for (auto _ : run) {
    const auto mindlin = support::play_mindlin(0.01 * static_cast<double>(run.range(0)), c, 40);
    require_done(mindlin.played.summary);
    tell_stick_radius(run, mindlin.stick_radius, mindlin.exact.stick_radius(), c);
    run.counters["loop_over_exact"] = mindlin.loop / mindlin.exact.loop();
    tell_phases(run, mindlin.played, mindlin.played.summary.cpu_s);
  }
}

/// Two balls of which one wears until nothing slips any more, each cycle a twentieth of the way to the limit at first.
/// range(0): q in per cent; range(1): hexahedra per radius.
void worn_balls(benchmark::State& run) {
  support::SlipLimitCase c;
  c.q = 0.01 * static_cast<double>(run.range(0));
  c.elements = static_cast<double>(run.range(1));
  const bool near_full_slip = c.q > 0.5;
  c.fine = near_full_slip ? 1.35 : 1.2;
  c.layer = near_full_slip ? 0.25 : 1.0;
  c.way = 3.0;
  c.jump = 1.0;
  c.increments = 2;
  c.implicit_wear = false;
  c.R_mm = 200.0;  // where the normals of X differ by 0.1 % from those of half-spaces
  const double exact = c.mindlin().stick_radius();
  for (auto _ : run) {
    const auto worn = support::play_slip_limit(c);
    const auto& summary = worn.played.summary;
    require_done(summary);
    tell_stick_radius(run, worn.stick_radius, exact, c.hertz());
    const auto limit = c.limit(exact).depth_and_volume(), own = c.limit(worn.stick_radius).depth_and_volume(),
               punch = c.limit(worn.punch_radius).depth_and_volume();
    run.counters["depth_over_limit"] = worn.depth / limit[0];
    run.counters["volume_over_limit"] = worn.volume / limit[1];
    run.counters["depth_over_limit_of_own_radius"] = worn.depth / own[0];
    run.counters["volume_over_limit_of_own_radius"] = worn.volume / own[1];
    run.counters["punch_radius_over_exact"] = worn.punch_radius / exact;
    run.counters["depth_over_limit_of_punch_radius"] = worn.depth / punch[0];
    run.counters["volume_over_limit_of_punch_radius"] = worn.volume / punch[1];
    run.counters["dofs"] = summary.size.dofs;
    run.counters["cycles_solved"] = static_cast<double>(summary.counts.cycles_solved);
    run.counters["estimated_error"] = summary.error_cycle_jump.value_or(0.0);
    run.counters["cutbacks"] = static_cast<double>(summary.counts.cutbacks);
    run.counters["cpu_s"] = summary.cpu_s;
  }
}

/// A run that fails is not a measurement: reported, and the other benchmarks continue.
template <void (*measure)(benchmark::State&)>
void reported(benchmark::State& run) {
  try {
    measure(run);
  } catch (const std::exception& error) {
    run.SkipWithError(error.what());
  }
}

BENCHMARK(reported<condensing_solid>)
    ->Name("condensing_solid")
    ->Args({31, 31, 20})
    ->Args({45, 44, 20})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK(reported<sliding_ball>)
    ->Name("sliding_ball")
    ->Args({190, 0, 0})
    ->Args({190, 1, 0})
    ->Args({94, 0, 0})
    ->Args({94, 2, 0})
    ->Args({190, 0, 1})
    ->Args({94, 0, 1})
    ->Args({94, 2, 1})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK(reported<cores_sliding_ball>)->Name("cores_ball")->Arg(94)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK(reported<two_balls>)
    ->Name("two_balls")
    ->Args({25, 10})
    ->Args({50, 10})
    ->Args({75, 10})
    ->Args({25, 20})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK(reported<worn_balls>)
    ->Name("worn_balls")
    ->ArgsProduct({{50, 75}, {8, 12, 16, 24}})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
