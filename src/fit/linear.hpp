#pragma once
#include <vector>

#include "fit/record.hpp"

/// The model of all series as a linear one.
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

}  // namespace reye::fit
