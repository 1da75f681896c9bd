#pragma once
#include <string>

#include "sim/problem/records.hpp"

namespace reye::output {

/// summary.json with the keys of the contract, in its order; unknown values and those that are not finite are null.
/// After them: life_band, and for the report room_seconds, skipped, cutback_reasons.
std::string summary_json(const sim::Summary& summary);

const char* status_name(sim::RunStatus status);

}  // namespace reye::output
