#pragma once
#include <string>
#include <vector>

#include "fit/alone.hpp"

/// Whether what the fit leaves is noise.
namespace reye::fit {

/// One sentence why the fit is poor, or nothing: series that contradict each other, chi^2 of given scatter, a shape
/// that is not the model's (README (9) to (11)).
/// `together`: where all series fit best.
std::string doubt_of(const std::vector<Record>& records, const Model& model, const Unknowns& together,
                     const std::vector<Alone>& alone);

}  // namespace reye::fit
