#pragma once
#include <optional>

#include "algebra/factor.hpp"

namespace reye::algebra {

/// K x = b by conjugate gradients, preconditioned by the factor of a matrix near to it: of the same body in a shape
/// that differs little. K: symmetric, definite, upper triangle, of the leading rows of that matrix, its interior at
/// least. x with a residual of at most 1e-10 of b; none where thirty iterations do not bring it, or `near` does not
/// hold its factor whole.
std::optional<Vector> solve_close(const SparseMatrix& K, const Vector& b, const SchurFactor& near);

}  // namespace reye::algebra
