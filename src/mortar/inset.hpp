#pragma once
#include "mortar/surface.hpp"

namespace reye::mortar {

/// The nodes and control points of a surface at x, if its body ended `by` [mm] farther inside: facets move along their
/// own normals, a node to the point where its two facets then meet, (n_1 + n_2) / (1 + n_1 . n_2). (7)
Points inset(const Surface& surface, const Points& x, double by);

}  // namespace reye::mortar
