#include "sim/measure/limits.hpp"

#include <algorithm>

#include "sim/measure/correction.hpp"
#include "sim/measure/limit_measure.hpp"

namespace reye::sim {

namespace {

constexpr double at_limit = 1e-3;  ///< of a bound: nearer than this a run ends at it

std::optional<double> found(const std::map<std::string, double>& measures, const std::string& name) {
  const auto at = measures.find(name);
  return at == measures.end() ? std::nullopt : std::optional(at->second);
}

/// Where between 0 and 1 a measure passes a bound: linear, or the parabola through its value half way.
double crossing(double bound, double before, std::optional<double> middle, double after) {
  if (!middle || after < bound) return (bound - before) / (after - before);
  const auto value = [&](double t) {
    return before * (1.0 - t) * (1.0 - 2.0 * t) + *middle * 4.0 * t * (1.0 - t) + after * t * (2.0 * t - 1.0);
  };
  double low = 0.0, high = 1.0;
  for (int k = 0; k < 60; ++k) (value(0.5 * (low + high)) < bound ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

}  // namespace

double bound_of(const scene::Limit& limit) { return limit.depth_mm ? *limit.depth_mm : *limit.area_mm2; }

bool is_reached(const scene::Limit& limit, double measure) {
  return measure >= (limit.stop ? 1.0 - at_limit : 1.0) * bound_of(limit);
}

bool any_stop_ahead(const Problem& problem, const State& state) {
  const auto& limits = problem.scene.limits;
  return std::any_of(limits.begin(), limits.end(),
                     [&](const auto& limit) { return limit.stop && !state.life_cycles.contains(limit.name); });
}

std::optional<double> share_to_limit(const std::vector<scene::Limit>& limits,
                                     const std::map<std::string, double>& measures,
                                     const std::map<std::string, double>& middle, const Lives& lives) {
  std::optional<double> share;
  for (const auto& limit : limits) {
    const double now = measures.at(limit.name), bound = bound_of(limit);
    if (!limit.stop || lives.cycles.contains(limit.name) || now <= (1.0 + at_limit) * bound) continue;
    const auto then = lives.measure.find(limit.name);
    const double at = crossing(bound, then == lives.measure.end() ? 0.0 : then->second, found(middle, limit.name), now);
    share = std::min(share.value_or(1.0), at);
  }
  return share;
}

std::optional<double> share_to_stop(const Problem& problem, const State& before, const State& after,
                                    const solver::System& system, const std::map<std::string, double>& middle) {
  auto cycles = before.life_cycles;
  auto error = before.life_error;
  auto measure = before.limit_measure;
  return share_to_limit(problem.scene.limits, limit_measures(problem, system, after), middle, {cycles, error, measure});
}

bool note_limits(const std::vector<scene::Limit>& limits, const std::map<std::string, double>& measures,
                 const LimitSpan& span, const std::map<std::string, double>& middle, Lives lives) {
  bool stop = false;
  for (const auto& limit : limits) {
    const double now = measures.at(limit.name), before = lives.measure[limit.name];
    const double bound = bound_of(limit);
    lives.measure[limit.name] = now;
    if (!is_reached(limit, now) || lives.cycles.contains(limit.name)) continue;
    const double cycles = span.after - span.before, at = crossing(bound, before, found(middle, limit.name), now);
    lives.cycles[limit.name] = span.before + cycles * at;
    if (span.jump_error) lives.error[limit.name] = *span.jump_error / (1.0 - settled) * bound * cycles / (now - before);
    stop = stop || limit.stop;
  }
  return stop;
}

bool watch_limits(const Problem& problem, State& state, const solver::System& system, double cycle_before,
                  const std::map<std::string, double>& middle) {
  return note_limits(problem.scene.limits, limit_measures(problem, system, state),
                     {cycle_before, state.cycle, state.jump_error}, middle,
                     {state.life_cycles, state.life_error, state.limit_measure});
}

}  // namespace reye::sim
