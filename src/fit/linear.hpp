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
Normal normal_at(const std::vector<Record>& records, const Model& model, const Unknowns& at);

Unknowns moved(const std::vector<Record>& records, Unknowns at, const Vector& step);

/// theta[k] where the linear estimate of theta[k] from what the fit would leave differs by `offset` from that at
/// `best`: README (9). Nothing where that does not exist within a factor of a thousand.
std::optional<double> bound_of(const std::vector<Record>& records, const Model& model, const Unknowns& best, int k,
                               double offset);

}  // namespace reye::fit
