#pragma once
#include <array>
#include <vector>

#include "base/linalg.hpp"

namespace reye::output {

/// A closed polygon: its last point joins the first.
using Loop = base::Points;

/// The regions between neighbouring levels of a value that is linear on triangles: per band k the loops round
/// levels[k] <= value <= levels[k + 1], counter-clockwise outside and clockwise round holes; values beyond the levels
/// count to the first and last band. Edges inside a band are left out, so that a region is one loop however fine its
/// triangles. `x`, `value`: per node; `triangles`: counter-clockwise; `levels`: 2 to 255, increasing.
std::vector<std::vector<Loop>> isobands(const base::Points& x, const std::vector<double>& value,
                                        const std::vector<std::array<int, 3>>& triangles,
                                        const std::vector<double>& levels);

}  // namespace reye::output
