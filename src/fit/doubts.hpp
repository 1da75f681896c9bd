#pragma once
#include <string>
#include <vector>

#include "fit/evidence.hpp"

/// Whether what the fit leaves is noise.
namespace reye::fit {

/// One sentence why the fit is poor, or nothing: series that contradict each other, chi^2 of given scatter, a shape
/// that is not the model's (README (9) to (11)).
std::string doubt_of(const std::vector<Record>& records, const Model& model, const Unknowns& at,
                     const std::vector<Scores>& scores, const std::vector<Belief>& beliefs);

}  // namespace reye::fit
