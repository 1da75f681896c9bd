#pragma once
#include "mortar/surface.hpp"

namespace reye::mortar {

/// Where the nodes and control points of a surface, now at x, would be if its body ended `by` [mm] farther inside:
/// facets go along their own normals, a node goes to where its two facets then meet, (n_1 + n_2) / (1 + n_1 . n_2). (7)
Points inset(const Surface& surface, const Points& x, double by);

}  // namespace reye::mortar
