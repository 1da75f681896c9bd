#pragma once
#include <vector>

#include "output/report/plot.hpp"
#include "output/solid/solid_run_data.hpp"

namespace reye::output {

/// Figures of history.csv: largest pressure, forces, area and energy of the contacts over the plays of the steps,
/// forces on the supports, and force over imposed motion, whose loop is what friction takes in a cycle.
std::vector<Figure> solid_history_figures(const SolidRunData& data);

}  // namespace reye::output
