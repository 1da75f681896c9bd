#include "sim/solid/solid_limits.hpp"

#include <algorithm>
#include <numeric>

#include "sim/solid/skin_depth.hpp"

namespace reye::sim {

namespace {

double measure_of(const scene::Limit& limit, const contact::SkinSetup& setup, const contact::SkinWear& wear,
                  Side side) {
  if (limit.depth_mm) return deepest_worn(setup, wear, side);
  const auto& removed = side == Side::secondary ? wear.removed_secondary : wear.removed_primary;
  return std::accumulate(removed.begin(), removed.end(), 0.0);
}

}  // namespace

std::map<std::string, double> solid_limit_measures(const SolidProblem& problem, const solver::SolidSystem& system,
                                                   const SolidRunState& state) {
  std::map<std::string, double> measures;
  for (const auto& limit : problem.scene.limits)
    for (std::size_t c = 0; c < system.contacts.size(); ++c) {
      const auto& setup = system.contacts[c];
      if (setup.options.name != limit.contact) continue;
      const auto& wear = state.solution.wear[c];
      const double secondary = measure_of(limit, setup, wear, Side::secondary);
      const double primary = measure_of(limit, setup, wear, Side::primary);
      measures[limit.name] = limit.side == "secondary" ? secondary
                             : limit.side == "primary" ? primary
                                                       : secondary + primary;
    }
  return measures;
}

bool watch_solid_limits(const SolidProblem& problem, const solver::SolidSystem& system, double cycle_before,
                        const std::map<std::string, double>& middle, SolidRunState& state) {
  return note_limits(problem.scene.limits, solid_limit_measures(problem, system, state),
                     {cycle_before, state.cycle, state.jump_error}, middle,
                     {state.life_cycles, state.life_error, state.limit_measure, state.limit_rate});
}

std::optional<LimitEnd> solid_block_end(const SolidProblem& problem, const solver::SolidSystem& system,
                                        const SolidRunState& before, const SolidRunState& after,
                                        const std::map<std::string, double>& middle, double tolerance, bool again) {
  auto cycles = before.life_cycles;
  auto error = before.life_error;
  auto measure = before.limit_measure;
  auto rate = before.limit_rate;
  return end_at_limit(problem.scene.limits, solid_limit_measures(problem, system, after), {before.cycle, after.cycle},
                      middle, tolerance, again, {cycles, error, measure, rate});
}

}  // namespace reye::sim
