#include "sim/march/extend.hpp"

#include <algorithm>

#include "base/formatted.hpp"
#include "scene/check.hpp"
#include "sim/measure/intact.hpp"
#include "sim/measure/limit_measure.hpp"
#include "sim/measure/limits.hpp"

namespace reye::sim {

namespace {

std::string key_of(const Problem& problem, const scene::Limit& limit) {
  const bool ring = problem.scene.analysis == base::Analysis::axisymmetric;
  return "limit." + limit.name + (limit.depth_mm ? ".depth_mm" : ring ? ".volume_mm3" : ".area_mm2");
}

/// Removes the records of limits that the scene no longer has, or has changed.
void forget_limits(const Problem& problem, const std::set<std::string>& others, State& state) {
  const auto gone = [&](const auto& known) {
    const auto& limits = problem.scene.limits;
    return others.contains(known.first) ||
           std::none_of(limits.begin(), limits.end(), [&](const auto& l) { return l.name == known.first; });
  };
  for (auto* known :
       {&state.life_cycles, &state.life_error, &state.limit_measure, &state.limit_rate, &state.last_wear.measures})
    std::erase_if(*known, gone);
}

std::string passed(double measure, double cycle) {
  return base::formatted("the run has passed it already: it stands at %.4g at cycle %.9g", measure, cycle);
}

}  // namespace

std::vector<base::Issue> extend(const Problem& problem, const std::set<std::string>& limits,
                                const std::string& cycles_key, State& state, Cache& cache) {
  const auto& last = problem.scene.steps.back();
  const bool in_last = state.step + 1 == static_cast<int>(problem.scene.steps.size());
  if (in_last && state.step_cycles > last.cycles * (1.0 + 1e-9))
    return {{cycles_key, scene::shown(last.cycles),
             "the run has played " + scene::shown(state.step_cycles) + " cycles of this step already"}};
  forget_limits(problem, limits, state);
  check_state(problem, state, cache);
  if (!state.approached) return {};
  std::vector<base::Issue> issues;
  const auto measures = limit_measures(problem, *system_of(problem, state, cache), state);
  for (const auto& limit : problem.scene.limits) {
    if (!limits.contains(limit.name)) continue;
    const double measure = measures.at(limit.name), bound = bound_of(limit);
    if (is_reached(limit, measure))
      issues.push_back({key_of(problem, limit), scene::shown(bound), passed(measure, state.cycle)});
    if (state.step_blocks > 0 || state.step > 0) state.limit_measure[limit.name] = measure;
  }
  return issues;
}

}  // namespace reye::sim
