#pragma once
#include <vector>

#include "fit/blocks.hpp"
#include "fit/covariance.hpp"

/// Kinds of noise, and what series are worth under each.
namespace reye::fit {

/// White noise, and correlated noise of each order, of lengths from the distance of blocks to a quarter of the series,
/// with nuggets from none to where they hide the correlation: README (4).
std::vector<Noise> candidates(const Blocks& blocks, bool map);

/// Y^T V^-1 Y of columns Y with a row per block, and log |V|, where blocks of `count` values have nugget / count.
struct Weighed {
  Matrix gram;
  double log_determinant = 0.0;
};
Weighed weigh(const Blocks& blocks, bool map, const Noise& noise, const Matrix& columns);

/// Eliminates the first `count` columns of a Gram matrix: what is left is that of the others beside them. Columns that
/// depend on those before them are left out. Returns the rank and the logarithm of the pivots' product.
struct Eliminated {
  int rank = 0;
  double log_pivots = 0.0;
};
Eliminated eliminate(Matrix& gram, int count);

}  // namespace reye::fit
