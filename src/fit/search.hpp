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

/// The shifts that fit best on a grid of 0.75 extents to either side of those given, for a given theta; returns the S
/// of all series there.
double scan_shifts(const std::vector<Record>& records, const Model& model, Unknowns& at);

/// Descends from the best of many starts: theta as given, and with each parameter or all of them raised and lowered by
/// factors from e to e^4, and lowered by e^6, too; shifts are scanned for each. A scar that fills what was measured has
/// wrong minima.
Found search(const std::vector<Record>& records, const Model& model, const Unknowns& start);

}  // namespace reye::fit
