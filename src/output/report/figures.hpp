#pragma once
#include <vector>

#include "output/report/plot.hpp"
#include "output/report/run_data.hpp"

namespace reye::output {

/// The figures that the data of a run allow, in reading order: per contact the worn profiles of both sides over
/// cycles, pressure over cycles, pressure and shear of the last frame, depth and worn amount against cycles;
/// then energy against cycles and the forces on the supports through the last load cycle.
std::vector<Figure> figures(const RunData& run);

/// A play of a step in the history: its rows [begin, end).
struct Play {
  std::size_t begin = 0, end = 0;
};

/// The plays of steps that count cycles, in the order of the history.
std::vector<Play> plays_of(const Table& history);

/// The part of them that comes from history.csv: largest pressures, energy and support forces.
std::vector<Figure> history_figures(const RunData& run);

}  // namespace reye::output
