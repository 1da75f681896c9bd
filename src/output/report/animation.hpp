#pragma once
#include <string>
#include <vector>

#include "output/report/plot.hpp"
#include "output/report/run_data.hpp"

namespace reye::output {

/// The run as moving figures from its folder, at most 60 frames (fewer where several contacts share them), evenly
/// chosen, the first and last among them. Per contact: the bodies about it, deformed as they are, coloured by von Mises
/// stress, with wear magnified by the factor in the title; pressure and wear depth along the surface. None when there
/// are fewer than two frames. Throws base::InputError when a frame cannot be read.
std::vector<Figure> moving_figures(const RunData& run, const std::string& dir);

}  // namespace reye::output
