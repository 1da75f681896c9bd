#pragma once
#include <vector>

#include "output/report/plot.hpp"
#include "output/solid/solid_run_data.hpp"

namespace reye::output {

/// Maps and profiles of one contact: of its last frame under pressure, and shear, slip and status of the frame with the
/// largest tangential force where that is another. None where there are no frames for ParaView, or nothing touched.
std::vector<Figure> contact_maps(const SolidRunData& data, const std::string& contact);

}  // namespace reye::output
