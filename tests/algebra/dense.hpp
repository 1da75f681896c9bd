#pragma once
#include "algebra/decompose.hpp"
#include "base/linalg.hpp"

/// What the tests of sparse factors compare with and load.
namespace reye::support {

/// The Schur complement on the last c rows and columns, by dense elimination.
inline base::Matrix dense_schur(const base::SparseMatrix& K, int c) {
  const base::Matrix D = K;
  const int i = static_cast<int>(D.rows()) - c;
  if (i == 0) return D;
  return D.bottomRightCorner(c, c) -
         D.bottomLeftCorner(c, i) * algebra::least_squares(D.topLeftCorner(i, i), D.topRightCorner(i, c));
}

inline base::Vector wave(Eigen::Index n) { return base::Vector::LinSpaced(n, 0.0, 9.0).array().sin() + 0.3; }

}  // namespace reye::support
