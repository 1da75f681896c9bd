#pragma once
#include <optional>
#include <vector>

#include "fit/record.hpp"

/// The model of all series as a linear one, and what is solved with it.
namespace reye::fit {

/// S(delta) = S - 2 g^T delta + delta^T H delta, in the order theta, then the shifts of each series; levels are
/// eliminated (README (1)).
struct Normal {
  Matrix H;
  Vector g;
  double S = 0.0;
};
Normal normal_at(const std::vector<Record>& records, const Model& model, const Unknowns& at, const Steps& steps);

Unknowns moved(const std::vector<Record>& records, Unknowns at, const Vector& step);

/// Where the weighted columns of the model no longer see a residual, from a place nearby.
struct Settled {
  Unknowns at;
  Steps steps;     ///< of the differences: a standard deviation of each unknown (README (8))
  Matrix inverse;  ///< of H
  double S = 0.0;
  bool converged = false;
};
Settled settle(const std::vector<Record>& records, const Model& model, Unknowns at, Steps steps);

/// theta[k] where the linear estimate of theta[k] from what the fit would leave differs by `offset` from that at
/// `settled`: README (9). Nothing where that does not exist within a factor of a thousand.
std::optional<double> bound_of(const std::vector<Record>& records, const Model& model, const Settled& settled, int k,
                               double offset);

}  // namespace reye::fit
