#include "sim/measure/limits.hpp"

#include <algorithm>
#include <cmath>

#include "base/formatted.hpp"
#include "sim/measure/correction.hpp"
#include "sim/measure/limit_measure.hpp"

namespace reye::sim {

namespace {

constexpr double at_limit = 1e-3;  ///< of a bound: nearer than this a run ends at it

std::optional<double> found(const std::map<std::string, double>& measures, const std::string& name) {
  const auto at = measures.find(name);
  return at == measures.end() ? std::nullopt : std::optional(at->second);
}

/// A limit's measure over a block whose cycles go from 0 to 1.
struct Course {
  double before, after;
  std::optional<double> middle;  ///< half way
  std::optional<double> rate;    ///< before the block, by which the measure would grow over it

  Course(const Lives& lives, const std::string& name, const std::map<std::string, double>& half_way, double now,
         const LimitSpan& span)
      : before(found(lives.measure, name).value_or(0.0)), after(now), middle(found(half_way, name)) {
    if (const auto per_cycle = found(lives.rate, name)) rate = *per_cycle * (span.after - span.before);
  }

  /// Where it passes a bound: on a straight line, or on the parabola through its value half way.
  double crossing(double bound) const {
    if (!middle || after < bound) return (bound - before) / (after - before);
    const auto value = [&](double t) {
      return before * (1.0 - t) * (1.0 - 2.0 * t) + *middle * 4.0 * t * (1.0 - t) + after * t * (2.0 * t - 1.0);
    };
    double low = 0.0, high = 1.0;
    for (int k = 0; k < 60; ++k) (value(0.5 * (low + high)) < bound ? low : high) = 0.5 * (low + high);
    return 0.5 * (low + high);
  }

  /// Where it would pass a bound if it grew on from the last value below it as it grew there. A measure whose
  /// growth changes at once, as where a coating is worn through, passes it between here and `crossing`.
  double growing_on(double bound) const {
    const bool second_half = middle && *middle < bound;
    const std::optional<double> slope = second_half ? 2.0 * (*middle - before) : rate;
    if (!slope) return crossing(bound);
    const double from = second_half ? 0.5 : 0.0, left = bound - (second_half ? *middle : before);
    return left < *slope * (1.0 - from) ? from + std::max(left, 0.0) / *slope : 1.0;
  }

  /// Growth over the block by which an error of the measure is one of the life: the least of what is known about the
  /// bound, for where the growth changes at once it is the slow part that leads to the bound.
  double growth_about(double bound) const {
    const bool second_half = middle && *middle < bound;
    const double mean = after - before, came = second_half ? 2.0 * (*middle - before) : rate.value_or(mean);
    return came > 0.0 ? std::min(mean, came) : mean;
  }

  double growth_at_end() const { return middle ? 2.0 * (after - *middle) : after - before; }
};

}  // namespace

double bound_of(const scene::Limit& limit) { return limit.depth_mm ? *limit.depth_mm : *limit.area_mm2; }

bool is_reached(const scene::Limit& limit, double measure) {
  return measure >= (limit.stop ? 1.0 - at_limit : 1.0) * bound_of(limit);
}

std::string block_repeated(const scene::Step& step, double cycle, double cycles, const LimitEnd& end) {
  return base::formatted("step \"%s\", cycle %g: block repeated over %g cycles, to end at limit %s", step.name.c_str(),
                         cycle, cycles, end.limit.c_str());
}

bool any_limit_ahead(const std::vector<scene::Limit>& limits, const std::map<std::string, double>& reached) {
  return std::any_of(limits.begin(), limits.end(), [&](const auto& limit) { return !reached.contains(limit.name); });
}

std::optional<LimitEnd> end_at_limit(const std::vector<scene::Limit>& limits,
                                     const std::map<std::string, double>& measures, const LimitSpan& span,
                                     const std::map<std::string, double>& middle, double tolerance, bool again,
                                     const Lives& lives) {
  constexpr double near_end = 0.99;  // of a block, beyond which another play would be of the same block
  std::optional<LimitEnd> end;
  for (const auto& limit : limits) {
    const double now = measures.at(limit.name), bound = bound_of(limit);
    if (lives.cycles.contains(limit.name) || now < bound) continue;
    const Course course(lives, limit.name, middle, now, span);
    const double cycles = span.after - span.before, at = course.crossing(bound), growing_on = course.growing_on(bound);
    const double likely = again || growing_on >= near_end ? 0.5 * (at + growing_on) : growing_on;
    const bool doubtful = tolerance > 0.0 && likely < near_end &&
                          std::abs(at - growing_on) * cycles > tolerance * (span.before + at * cycles);
    const bool stops = limit.stop && now > (1.0 + at_limit) * bound;
    const double share = stops ? at : likely;
    if ((stops || doubtful) && (!end || share < end->share)) end = LimitEnd{share, stops, limit.name};
  }
  return end;
}

std::optional<LimitEnd> block_end(const Problem& problem, const State& before, const State& after,
                                  const solver::System& system, const std::map<std::string, double>& middle,
                                  double tolerance, bool again) {
  auto cycles = before.life_cycles;
  auto error = before.life_error;
  auto measure = before.limit_measure;
  auto rate = before.limit_rate;
  return end_at_limit(problem.scene.limits, limit_measures(problem, system, after), {before.cycle, after.cycle}, middle,
                      tolerance, again, {cycles, error, measure, rate});
}

bool note_limits(const std::vector<scene::Limit>& limits, const std::map<std::string, double>& measures,
                 const LimitSpan& span, const std::map<std::string, double>& middle, Lives lives) {
  bool stop = false;
  const double cycles = span.after - span.before;
  for (const auto& limit : limits) {
    const double now = measures.at(limit.name), bound = bound_of(limit);
    const Course course(lives, limit.name, middle, now, span);
    lives.measure[limit.name] = now;
    if (cycles > 0.0) lives.rate[limit.name] = course.growth_at_end() / cycles;
    if (!is_reached(limit, now) || lives.cycles.contains(limit.name)) continue;
    const double at = course.crossing(bound);
    lives.cycles[limit.name] = span.before + cycles * at;
    if (span.jump_error)
      lives.error[limit.name] =
          std::max(*span.jump_error / (1.0 - settled) * bound * cycles / course.growth_about(bound),
                   std::abs(course.growing_on(bound) - at) * cycles);
    stop = stop || limit.stop;
  }
  return stop;
}

bool watch_limits(const Problem& problem, State& state, const solver::System& system, double cycle_before,
                  const std::map<std::string, double>& middle) {
  return note_limits(problem.scene.limits, limit_measures(problem, system, state),
                     {cycle_before, state.cycle, state.jump_error}, middle,
                     {state.life_cycles, state.life_error, state.limit_measure, state.limit_rate});
}

}  // namespace reye::sim
