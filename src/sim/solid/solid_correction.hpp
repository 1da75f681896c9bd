#pragma once
#include "sim/problem/two_step.hpp"
#include "sim/solid/solid_state.hpp"

/// The correction of a block's wear, from playing it once as a whole and once in two halves; as `measure/correction`
/// for the plane.
namespace reye::sim {

/// A block that was played twice on the same points: its start, its end as a whole, and its contacts after the first of
/// two halves.
struct SolidTwice {
  const SolidRunState& start;
  const SolidRunState& once;
  const std::vector<contact::SkinWear>& middle;
};

/// Secondary points of each contact whose path of slip has grown from one state to another.
std::vector<std::vector<char>> slid_between(const std::vector<contact::SkinWear>& before,
                                            const std::vector<contact::SkinWear>& after);

/// Error of the end of a block that was played twice: per contact and side that wears, the larger of `side_difference`.
double skin_wear_difference(const solver::SolidSystem& system, const SolidTwice& twice, const SolidRunState& halves);

/// Error of the end of a block that the two-step formula has continued from `start` (`continued_difference`).
std::optional<double> continued_skin_difference(const solver::SolidSystem& system, const SolidRunState& start,
                                                const TwoStep& formula, const SolidRunState& end);

/// Whether no contact that slid in a block has a point under pressure that did not.
bool slides_throughout(const SolidRunState& start, const SolidRunState& end);

/// Adds the difference between the two halves and the whole once more, as far as it is trusted; volumes, work and
/// energy alike.
void extrapolate_skins(const solver::SolidSystem& system, const SolidTwice& twice, SolidRunState& halves);

}  // namespace reye::sim
