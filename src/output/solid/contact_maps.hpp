#pragma once
#include <string>
#include <vector>

#include "output/report/plot.hpp"
#include "output/solid/solid_run_data.hpp"

namespace reye::output {

/// Maps and profiles of one contact: of its last frame under pressure, and shear, slip and status of the frame with the
/// largest tangential force where that is another. None where there are no frames for ParaView, or nothing touched.
std::vector<Figure> contact_maps(const SolidRunData& data, const std::string& contact);

/// Depth of each side that has worn, of the last frame.
std::vector<Figure> depth_maps(const SolidRunData& data, const std::string& contact);

/// Pressure on the secondary side, and depth of each side that has worn, over at most 40 frames, evenly chosen. None
/// where there are fewer than two.
std::vector<Figure> moving_maps(const SolidRunData& data, const std::string& contact);

}  // namespace reye::output
