#pragma once
#include "scene/check.hpp"
#include "scene/entry.hpp"
#include "scene/scene.hpp"

/// Rules of scenes whose contacts wear, the same for the plane and for solids.
namespace reye::scene {

/// What a law needs the speed of slip for; empty: it does not need it.
std::string needs_speed(const wear::Law& law);

/// Why lives do not scale as 1 / (wear coefficient) with this law, or with these steps; empty when they do. With a
/// fixed jump of N cycles a run depends on coefficient x N alone: coefficients times c and jumps over c give the same
/// states, each at 1 / c of the cycles.
std::string no_band_by_law(const std::string& contact, const wear::Law& law);
std::string no_band_by_steps(const std::vector<Step>& steps);

/// Bands of limits: their factors in order, and `why` there can be none.
void check_bands(const Entry& root, const std::string& why, Issues& issues);

}  // namespace reye::scene
