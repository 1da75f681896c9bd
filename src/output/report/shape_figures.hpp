#pragma once
#include <string>
#include <vector>

#include "output/report/plot.hpp"
#include "output/report/run_data.hpp"

namespace reye::output {

/// Per contact, from the frames in the folder: the shape of both sides before and after the run, stress-free, true to
/// scale and, where that shows too little, with wear magnified by the factor in the title; then the von Mises stress
/// about the contact in the last frame under pressure. None where there are no frames for ParaView. Throws
/// base::InputError when a frame cannot be read.
std::vector<Figure> shape_figures(const RunData& run, const std::string& dir);

}  // namespace reye::output
