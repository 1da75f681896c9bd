#include "sim/march/jump_rule.hpp"

#include <algorithm>
#include <cmath>

#include "base/formatted.hpp"
#include "sim/measure/limits.hpp"
#include "sim/problem/two_step.hpp"

namespace reye::sim {

namespace {

constexpr double aim = 0.85;          ///< share of the allowed error at which the next block aims
constexpr double most_early = 1.5;    ///< times the tolerance, for a block far from the end of its step
constexpr double small_error = 0.25;  ///< share of the allowed one
constexpr double most_cut = 0.3;      ///< of the cycles from one block to the next
constexpr double most_steeper =
    1.5;  ///< growth of a block's error per share that is allowed for from one block to the next
constexpr double edge_share = 1.25;  ///< times the difference where some sticks

}  // namespace

double allowed(const std::vector<scene::Limit>& limits, const std::map<std::string, double>& measure,
               const std::map<std::string, double>& reached, const scene::Step& step, double step_cycles, double end) {
  double growth = step.cycles / end;
  for (const auto& limit : limits) {
    const auto now = measure.find(limit.name);
    if (now == measure.end() || now->second <= 0.0 || reached.contains(limit.name)) continue;
    growth = std::min(growth, bound_of(limit) / now->second * step_cycles / end);
  }
  return step.jump_tolerance * std::clamp(growth, 1.0, most_early);
}

double block_error(double difference, bool slips_throughout) {
  return slips_throughout ? difference : edge_share * difference;
}

double shortened(bool too_long, double allowed, double error) {
  return too_long ? std::clamp(aim * allowed / error, most_cut, 0.7) : most_cut;
}

double after_one_cycle(double tried, bool first, bool continues) {
  if (continues) return first ? unjumped : most_ratio * std::min(unjumped, tried);
  return !first && tried > unjumped ? tried : std::max(most_growth * std::min(unjumped, tried), tried);
}

double next_jump(double jump, double share, double error, double tolerance, double rate_before) {
  const double ratio = error > 0.0 ? aim * tolerance / error : most_growth * most_growth;
  const double steeper =
      rate_before > 0.0 && share > 0.0 ? std::clamp(error / share / rate_before, 1.0, most_steeper) : 1.0;
  const double times = (ratio < 1.0 ? ratio : std::sqrt(ratio)) / steeper;  // factor of the share
  const double factor = share * times < 1.0 ? times / (1.0 - share * times) : most_growth;
  return std::max(unjumped, jump * std::clamp(factor, most_cut, most_growth));
}

double to_continue(double jump, double before, double share_of_error) {
  return std::min(jump, (share_of_error < small_error ? most_ratio : usual_ratio) * before);
}

std::optional<Warning> uneven_jump(const scene::Step& step, double cycle, double cycles, double apart) {
  constexpr double alike =
      0.02;  // pressures were off by at most 3.1 times the share, so that some 6 % are not warned of
  if (!(apart > alike)) return std::nullopt;
  return Warning{
      "pressures", "step " + step.name,
      base::formatted(
          "at cycle %g a cycle by itself wears other places than the block of %g cycles before it, by %.2g %% "
          "of all wear: in a block the first strokes do not see the wear of the later ones. Pressures are "
          "uncertain by up to three times as much (root mean square), the shape of the scar by less. Write a "
          "smaller jump, or jump = { tolerance = 0.01 }",
          cycle, cycles, 100.0 * apart),
      apart};
}

}  // namespace reye::sim
