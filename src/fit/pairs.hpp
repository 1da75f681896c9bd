#pragma once
#include <vector>

#include "fit/noise.hpp"

/// What correlated noise does to sums of values.
namespace reye::fit {

/// Products u_i u_j^T of the rows of weights u, added up by the distance of their places, so that u^T V u of any
/// correlation is one sum over distances: README (5).
struct Pairs {
  double width = 1.0;         ///< of a step of distance [mm]
  std::vector<Matrix> apart;  ///< by distance; a pair between two steps is divided between them
  Matrix own;                 ///< of each place with itself, over its count
};
Pairs pairs_of(const Blocks& blocks, const Matrix& u);

/// u^T V u.
Matrix variance_of(const Pairs& pairs, const Noise& noise);

}  // namespace reye::fit
