#pragma once
#include <string>
#include <vector>

#include "fit/evidence.hpp"

/// What data cannot give.
namespace reye::fit {

/// One sentence why the series do not suffice for any fit, or nothing.
std::string refusal_of(const std::vector<Series>& series, Eigen::Index parameters);

/// One sentence naming parameters that the series do not determine near the fit, or nothing.
std::string undetermined(const std::vector<Scores>& scores, const std::vector<std::string>& names);

/// One sentence on a parameter that no bound was found for.
std::string unbounded(const std::string& name, bool below);

}  // namespace reye::fit
