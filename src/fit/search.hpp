#pragma once
#include <vector>

#include "fit/linear.hpp"

/// The least squares of all series together, by the method of Levenberg and Marquardt.
namespace reye::fit {

struct Found {
  Unknowns at;
  double S = 0.0;  ///< weighted sum of squares
  bool converged = false;
};

/// From `start` downhill to the next minimum; theta[held] keeps its value (-1: none). A start where the model is not
/// finite is returned as it is, with an infinite S.
Found descend(const std::vector<Record>& records, const Model& model, Unknowns start, int held = -1);

/// The shifts that fit best on a grid over each series, for a given theta: protects against wrong minima.
void scan_shifts(const std::vector<Record>& records, const Model& model, Unknowns& at);

/// Scans and descents by turns until no scan finds a better place.
Found search(const std::vector<Record>& records, const Model& model, Unknowns start);

}  // namespace reye::fit
