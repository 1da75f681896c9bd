#pragma once
#include "base/linalg.hpp"

/// Columns that nearly depend on each other, as ones that do not: their Gram matrix is then well conditioned and has
/// one rank whatever the noise is.
namespace reye::fit {

using base::Matrix;

/// An orthonormal basis of what columns span beside another orthonormal basis (which may have no columns). Every column
/// counts at unit length; directions that have at most `least` of it are left out.
Matrix basis_beside(const Matrix& basis, Matrix columns, double least);

/// An orthonormal basis of what columns span, but for round-off.
Matrix basis_of(Matrix columns);

}  // namespace reye::fit
