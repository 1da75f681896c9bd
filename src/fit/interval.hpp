#pragma once
#include <vector>

#include "fit/evidence.hpp"
#include "fit/search.hpp"

/// Intervals on the curve that a nonlinear model makes of them.
namespace reye::fit {

/// Scores of all series at a place.
std::vector<Scores> scores_at(const std::vector<Record>& records, const Model& model, const Unknowns& at);

/// theta[k] whose score, all other unknowns fitted again, is `z` standard deviations from zero (README (8)); it is
/// sought from `best` outwards, first at z `deviation`. Infinite where that does not exist within a factor of a
/// thousand.
double bound_of(const std::vector<Record>& records, const Model& model, const std::vector<Belief>& beliefs,
                const Unknowns& best, int k, double z, double deviation);

}  // namespace reye::fit
