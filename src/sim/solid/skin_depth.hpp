#pragma once
#include <vector>

#include "contact/solid/skin_wear.hpp"
#include "sim/problem/records.hpp"

namespace reye::sim {

/// Area of each point of a side on its present shape, int N_j over all its facets [mm^2].
std::vector<double> point_areas(const contact::SkinSide& side);

/// Worn depth at each node of a side since the start [mm]: what shape steps have moved, and what waits in the gaps.
std::vector<double> worn_depths(const contact::SkinSetup& setup, const contact::SkinWear& wear, Side side);

/// The largest of them; 0 where there are none.
double deepest_worn(const contact::SkinSetup& setup, const contact::SkinWear& wear, Side side);

/// Depth at each node of a side by volumes of its points on the present shape: V / A, of mid nodes of tri6 facets the
/// value of the Bernstein functions there [mm].
std::vector<double> skin_depths(const contact::SkinSide& side, const std::vector<double>& removed);

/// The largest of them; 0 where there are none.
double deepest_of(const contact::SkinSide& side, const std::vector<double>& removed);

}  // namespace reye::sim
