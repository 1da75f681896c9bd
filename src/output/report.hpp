#pragma once
#include <string>

namespace reye::output {

/// Makes report.html and figures/*.svg from what the folder holds (summary.json, history.csv and the surface
/// tables, each as far as it is there), so that it also works on an interrupted or running case.
/// The page is one file without outside resources. Throws std::runtime_error when `dir` holds no run.
void write_report(const std::string& dir);

}  // namespace reye::output
