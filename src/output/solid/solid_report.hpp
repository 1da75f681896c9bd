#pragma once
#include <string>

namespace reye::output {

/// Makes report.html and figures/*.svg of a run of solids from its folder, finished or not. The page is one file
/// without outside resources and scripts; with `animation` pressure and depth move over the cycles. Throws
/// base::InputError when `dir` holds no such run, or a file of it is damaged.
void write_solid_report(const std::string& dir, bool animation = false);

}  // namespace reye::output
