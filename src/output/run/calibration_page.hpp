#pragma once
#include <string>
#include <vector>

#include "output/report/plot.hpp"
#include "sim/study/calibrate.hpp"

/// What calibration has found, for readers and for programs.
namespace reye::output {

/// Measured against computed depths, one figure for each profile and two sections for each map.
std::vector<Figure> calibration_figures(const sim::Calibration& calibration);

/// One page: coefficients with their intervals, what to know about them, figures, numbers measured and computed.
std::string calibration_page(const std::string& title, const sim::Calibration& calibration);

/// calibration.json: the figures of the page.
std::string calibration_json(const std::string& title, const sim::Calibration& calibration);

}  // namespace reye::output
