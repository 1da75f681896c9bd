#pragma once
#include <string>

namespace reye::output {

/// Makes report.html and figures/*.svg from the folder (summary.json, history.csv and the surface
/// tables, each as far as it is there), so that it also works on an interrupted or running case.
/// The page is one file without outside resources. With `animation` it also shows bodies, pressure and wear moving from
/// frame to frame. Throws std::runtime_error when `dir` holds no run, or a frame to be shown cannot be read.
void write_report(const std::string& dir, bool animation = false);

}  // namespace reye::output
