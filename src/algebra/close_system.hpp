#pragma once
#include <optional>

#include "algebra/factor.hpp"

namespace reye::algebra {

/// K x = b by conjugate gradients, preconditioned by the factor of a matrix near to it: of the same body in a shape
/// that differs little. K: symmetric, definite, upper triangle, of the leading rows of that matrix. x with a residual
/// of 1e-12 of b; none where so many iterations as would take longer than a factor do not suffice, or the factor is
/// held by several processes.
std::optional<Vector> solve_close(const SparseMatrix& K, const Vector& b, const SchurFactor& near);

}  // namespace reye::algebra
