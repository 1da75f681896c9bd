#pragma once
#include "fit/blocks.hpp"
#include "fit/covariance.hpp"

/// Whitening along a line at a cost that grows with its length alone.
namespace reye::fit {

/// L^-1 Y for V = L L^T of correlated noise along a line, and log |V|: the innovations of a Kalman filter (README (5)).
struct Whitened {
  Matrix columns;
  double log_determinant = 0.0;
};
Whitened whiten_along(const Blocks& blocks, const Noise& noise, Matrix columns);

}  // namespace reye::fit
