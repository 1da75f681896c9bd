#pragma once
#include <cmath>
#include <limits>
#include <optional>

#include "scene/scene.hpp"
#include "sim/march/jump_rule.hpp"
#include "sim/problem/records.hpp"
#include "sim/problem/two_step.hpp"

/// The short cycles that level the end of a block where it is shown, whatever the dimension.
namespace reye::sim {

/// The change of pressures (root mean square) from one levelling cycle to the next below which they repeat: at the end
/// of a step, and where a block is shown on the way.
inline constexpr double repeated = 0.01, alike = 0.03;

/// The way a block was played before its levelling cycles.
enum class PlayedBefore { in_halves, continued };

/// The change of pressures by one play of all levelling cycles up to which they are shown on the way. Where increments
/// wear more than the bodies yield, pressures are off by as much as the play is long: of a change c, from a play of at
/// least the share b of the block to one of the share l, l / (b - l) c is left, here at most 0.05. Of what is uneven
/// less is left, some fifth of c.
constexpr double at_once(PlayedBefore before) {
  const double least = before == PlayedBefore::in_halves ? 0.5 : TwoStep{most_ratio}.played();
  return 0.05 * (least - levelling) / levelling;
}

/// A run whose end is levelled. `play`: some cycles, false where they do not come to their end; `ends`: they are the
/// last. `change`: of the pressures in the last play, unbounded where nothing is carried at the ends of cycles.
/// `restore`: undoes what was played since it was `kept`; false where the run is to end.
template <class Run>
concept Levelled = requires(Run& run, double cycles, bool ends) {
  static_cast<bool>(run.play(cycles, ends));
  static_cast<double>(run.change());
  static_cast<bool>(run.restore(run.kept()));
};

/// Plays `cycles` as short ones, each half of what is left, until pressures repeat, eight at most. Returns the last
/// change, 0 where a play did not end, unbounded where nothing is carried on the way. `first`: the change by the first
/// play.
template <Levelled Run>
double level_by_halves(double cycles, bool last, Run& run, double& first) {
  constexpr int fewest = 2, most = 8;
  double apart = 1.0;
  for (int k = fewest; k <= most && apart >= (last ? repeated : alike); ++k) {
    cycles *= 0.5;
    if (!run.play(cycles, false)) return 0.0;
    const double now = run.change();
    (k > fewest ? apart : first) = now;
    if (last || std::isfinite(now)) continue;
    apart = now;  // what carries nothing shows no pressures
    break;
  }
  return run.play(cycles, true) ? apart : 0.0;
}

/// Plays the levelling cycles: on the way all at once, and by halves where that fails or changes pressures by more than
/// `at_once`; at the end of a step by halves. `tries_at_once`: whether one play is tried on the way. After one that did
/// not serve none is tried until half of the cycles change pressures by at most half of `at_once`.
template <Levelled Run>
double level(double cycles, bool last, PlayedBefore before, Run& run, bool& tries_at_once) {
  const bool tries = !last && tries_at_once;
  if (tries) {
    const auto start = run.kept();
    if (run.play(cycles, true))
      if (const double now = run.change(); now <= at_once(before) || !std::isfinite(now)) return 0.0;
    tries_at_once = false;
    if (!run.restore(start)) return 0.0;
  }
  double first = std::numeric_limits<double>::infinity();
  const double left = level_by_halves(cycles, last, run, first);
  if (!tries && first <= 0.5 * at_once(before)) tries_at_once = true;
  return left;
}

/// What a reader must know of pressures that are shown and have changed so much in the last levelling cycle; nothing
/// where they have repeated.
std::optional<Warning> uneven(const scene::Step& step, double cycle, double change);

}  // namespace reye::sim
