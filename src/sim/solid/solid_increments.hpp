#pragma once
#include <vector>

#include "scene/solid/solid_scene.hpp"

namespace reye::sim {

/// Ends of the increments of a step: equal parts, every corner of the histories it plays, and more between them where a
/// support would turn its body by more than 0.3 rad.
std::vector<double> solid_increment_ends(const scene::SolidScene& scene, const scene::Step& step);

/// Their number, which may be beyond all memory.
double solid_increments_of(const scene::SolidScene& scene, const scene::Step& step);

}  // namespace reye::sim
