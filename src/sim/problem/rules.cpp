#include "sim/problem/rules.hpp"

#include <algorithm>
#include <cmath>

namespace reye::sim {

namespace {

/// Whether a whole number lies in (before, after]; within round-off after counts as reaching it.
bool passes_whole(double before, double after) { return std::floor(after + 1e-9) > std::floor(before + 1e-9); }

}  // namespace

bool frame_due(const scene::FrameRules& rules, const PlayedBlock& block) {
  if (block.last || rules.every_increment || (rules.at_remeshes && block.remeshed)) return true;
  if (rules.every_blocks > 0 && block.number % rules.every_blocks == 0) return true;
  if (passes_whole(rules.per_step * block.share_before, rules.per_step * block.share)) return true;
  const double before = block.cycle_before, after = block.cycle;
  if (rules.every_cycles > 0.0 && passes_whole(before / rules.every_cycles, after / rules.every_cycles)) return true;
  return rules.per_decade > 0 && after > before &&
         passes_whole(rules.per_decade * std::log10(before), rules.per_decade * std::log10(after));
}

std::optional<double> last_frame_cycle(const scene::FrameRules& rules, double from, double to) {
  double last = 0.0;
  if (rules.every_cycles > 0.0) last = rules.every_cycles * std::floor(to / rules.every_cycles + 1e-9);
  if (const double n = rules.per_decade; n > 0.0 && to > 0.0)
    last = std::max(last, std::pow(10.0, std::floor(n * std::log10(to) + 1e-9) / n));
  return last > from * (1.0 + 1e-9) ? std::optional(last) : std::nullopt;
}

double fitted(const scene::FrameRules& frames, double cycle, double jump, double left) {
  if (jump >= left) return left;
  if (left < 2.0 * jump) jump = 0.5 * left;
  const auto at = last_frame_cycle(frames, cycle, cycle + 1.1 * jump);
  return at && *at - cycle > 0.75 * jump ? *at - cycle : jump;
}

bool under_tolerance(const scene::Step& step) { return step.cycles > 0.0 && step.jump_tolerance > 0.0 && step.wear; }

bool last_to_jump(const std::vector<scene::Step>& steps, const scene::Step& step) {
  if (!step.wear || !(step.cycles > 1.0) || !(step.jump > 1.0) || under_tolerance(step)) return false;
  return std::none_of(&step + 1, steps.data() + steps.size(),
                      [](const scene::Step& later) { return later.wear && later.cycles > 0.0; });
}

bool history_due(int every_blocks, long number, bool last) { return number == 1 || last || number % every_blocks == 0; }

}  // namespace reye::sim
