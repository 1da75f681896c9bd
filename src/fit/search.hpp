#pragma once
#include <vector>

#include "fit/record.hpp"

/// The least squares of all series together, by the method of Levenberg and Marquardt.
namespace reye::fit {

/// Information of all series at a place: S(delta) = S - 2 g^T delta + delta^T H delta, in the order theta (all of it),
/// then the shifts of each series; levels are eliminated (README (1)).
struct Normal {
  Matrix H;
  Vector g;
  double S = 0.0;
};
Normal normal_at(const std::vector<Record>& records, const Model& model, const Unknowns& at);

struct Found {
  Unknowns at;
  double S = 0.0;  ///< weighted sum of squares
  bool converged = false;
};

/// From `start` downhill to the next minimum; theta[held] keeps its value (-1: none).
/// A start where the model is not finite is returned as it is, with an infinite S.
Found descend(const std::vector<Record>& records, const Model& model, Unknowns start, int held = -1);

/// The shifts that fit best on a grid over each series, for a given theta: protects against wrong minima.
void scan_shifts(const std::vector<Record>& records, const Model& model, Unknowns& at);

/// Scans and descents by turns until no scan finds a better place.
Found search(const std::vector<Record>& records, const Model& model, Unknowns start);

}  // namespace reye::fit
