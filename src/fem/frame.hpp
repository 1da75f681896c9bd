#pragma once
#include <array>

#include "base/linalg.hpp"

/// Fields of a body that has turned, transformed to a frame that turns with it and back.
namespace reye::fem {

/// Displacements in a frame that has turned by `angle`: w = R^T (X + u) - X, but for a translation.
base::Points in_frame(const base::Points& X, const base::Points& u, double angle);

/// R s R^T of a stress s in the frame, in the order (11, 22, 12, 33).
std::array<double, 4> turned(const std::array<double, 4>& s, double angle);

}  // namespace reye::fem
