#pragma once
#include <cmath>
#include <optional>

#include "scene/scene.hpp"
#include "sim/problem/records.hpp"

/// The short cycles that level the end of a block where it is shown, whatever the dimension.
namespace reye::sim {

/// The change of pressures (root mean square) from one levelling cycle to the next below which they repeat: at the end
/// of a step, and where a block is shown on the way.
inline constexpr double repeated = 0.01, alike = 0.03;

/// Plays `cycles` as short ones, each half of what is left, until pressures repeat, eight at most. `play(cycles,
/// ends)`: one of them, false where it does not come to its end; `change()`: of the pressures in the last of
/// them, unbounded where nothing is carried at the ends of cycles. Returns the last change; 0 where a play did not
/// end.
template <class Play, class Change>
double level_by_halves(double cycles, bool last, const Play& play, const Change& change) {
  constexpr int fewest = 2, most = 8;
  double apart = 1.0;
  for (int k = fewest; k <= most && apart >= (last ? repeated : alike); ++k) {
    cycles *= 0.5;
    if (!play(cycles, false)) return 0.0;
    const double now = change();
    if (k > fewest) apart = now;
    if (!last && !std::isfinite(now)) break;  // what carries nothing shows no pressures
  }
  return play(cycles, true) ? apart : 0.0;
}

/// What a reader must know of pressures that are shown and have changed so much in the last levelling cycle; nothing
/// where they have repeated.
std::optional<Warning> uneven(const scene::Step& step, double cycle, double change);

}  // namespace reye::sim
