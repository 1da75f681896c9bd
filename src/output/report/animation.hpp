#pragma once
#include <string>
#include <vector>

#include "output/report/plot.hpp"
#include "output/report/run_data.hpp"

namespace reye::output {

/// The run as moving figures from its folder, at most 60 frames, evenly chosen, the first and last among them: outlines
/// and nearest element edges of the bodies about all contacts, deformed as they are; per contact pressure and wear
/// depth along the surface. None when there are fewer than two frames. Throws std::runtime_error when a frame cannot
/// be read.
std::vector<Figure> moving_figures(const RunData& run, const std::string& dir);

}  // namespace reye::output
