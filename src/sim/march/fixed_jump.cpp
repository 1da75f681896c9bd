#include "sim/march/fixed_jump.hpp"

#include <algorithm>
#include <cmath>

#include "base/formatted.hpp"
#include "sim/march/block.hpp"
#include "sim/march/jump_rule.hpp"
#include "sim/march/recording.hpp"
#include "sim/march/watch_block.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

namespace {

constexpr double shorter = 0.25;  ///< of the cycles of a block that failed, for the next try
constexpr double little = 0.01;   ///< share of all plastic strain that cycles may add which are played as one

void tell(const BlockSpan& span, double wanted, const std::string& failure, State& state, const Observer& observer) {
  if (observer.log) observer.log("shortened: " + failure);
  const std::string text = base::formatted(
      "A block of %g cycles failed at cycle %g; from there on blocks have %g (the log says why). Write jump = %g, or "
      "jump = { tolerance = 0.01 }.",
      wanted, state.cycle - span.jump, span.jump, span.jump);
  warn(state, observer, {"jump", "step " + span.step->name, text, span.step->jump / span.jump});
}

}  // namespace

double next_fixed(const Problem& problem, const scene::Step& step, double whole, double done, double flow) {
  const double left = whole - done;
  if (!step.wear || !may_yield(problem) || left <= 1e-9 * whole) return whole;
  const bool first = done == 0.0, flows = flow * left > little;
  return first || flows ? std::min(std::max(unjumped, done), left) : left;
}

double next_fixed(const Problem& problem, const scene::Step& step, const State& state) {
  const double whole = state.block_cycles > 0.0 ? state.block_cycles : step.jump;
  return next_fixed(problem, step, whole, state.step_cycles, state.flow);
}

double flow_since(const State& state, double before, bool same_points) {
  const double now = mean_plastic_strain(state);
  if (now == 0.0) return 0.0;
  return same_points ? (now - before) / now : 1.0;
}

Outcome play_fixed(const Problem& problem, const State& state, Cache& cache, BlockSpan span, const Observer& observer) {
  const double wanted = span.jump;
  State start = state;
  std::string first_failure;
  while (true) {
    Recording recording;
    Outcome outcome = play_block(problem, start, cache, span, recording.observer(observer));
    if (outcome.failure.empty() || !span.cycles || !span.step->wear || span.jump <= 1.0) {
      recording.play_back(observer);
      if (span.jump < wanted && outcome.failure.empty() && !outcome.interrupted) {
        outcome.state.block_cycles = span.jump;
        tell(span, wanted, first_failure, outcome.state, observer);
      }
      return outcome;
    }
    if (first_failure.empty()) first_failure = outcome.failure;
    keep_counts(start, outcome.state.counts);
    ++start.counts.refused_blocks;
    span.jump = std::max(1.0, std::floor(shorter * span.jump));
    span.last = false;
  }
}

}  // namespace reye::sim
