#pragma once
#include <string>

#include "sim/solid/solid_records.hpp"

namespace reye::output {

/// summary.json of a run of solids; unknown values and those that are not finite are null. Keys that mean the same have
/// the names of the plane.
std::string solid_summary_json(const sim::SolidSummary& summary);

}  // namespace reye::output
