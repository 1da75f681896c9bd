#pragma once
#include <vector>

#include "fit/evidence.hpp"
#include "fit/search.hpp"

/// Series one by one.
namespace reye::fit {

/// A series fitted alone: what it takes, its noise, and what it says of theta are those of its own best fit, so that a
/// series that contradicts others does not pass for a noisy one.
struct Alone {
  Unknowns at;
  Matrix taken;  ///< README (6)
  Belief belief;
  Scores scores;
};
/// Each from the place where all together fit best.
std::vector<Alone> each_alone(const std::vector<Record>& records, const Model& model, const Unknowns& together);

}  // namespace reye::fit
