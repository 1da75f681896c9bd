#pragma once
#include "base/linalg.hpp"
#include "base/space.hpp"

namespace reye::body {

using base::Mat3;
using base::Matrix;
using base::SparseMatrix;
using base::Vector;

/// C of a body: the displacements of its points under forces on them, symmetric and positive semi-definite [mm/N]. Of a
/// body that deforms it is dense, of a rigid one R M R^T of its six motions.
class PointCompliance {
 public:
  PointCompliance() = default;
  /// The leading `rows` of a matrix and as many columns.
  PointCompliance(Matrix C, Eigen::Index rows);
  /// R: motions to points, rows x 6; M: what springs allow the motions.
  PointCompliance(Matrix R, Matrix M);

  Eigen::Index rows() const { return rows_; }
  bool yields() const { return largest_ > 0.0; }  ///< moves under forces
  double largest() const { return largest_; }     ///< of the diagonal
  Mat3 of_point(Eigen::Index first_row) const;    ///< the block of a point on the diagonal
  Matrix times(const Matrix& forces) const;       ///< C f of each column
  void add(const Vector& force,
           Eigen::Ref<Vector> u) const;  ///< u += C f; of a force on few points in the time of these
  /// A -= motion^T C force of sparse columns.
  void subtract_product(const SparseMatrix& motion, const SparseMatrix& force, Eigen::Ref<Matrix> A) const;
  Matrix dense() const;

 private:
  Eigen::Index rows_ = 0;
  double largest_ = 0.0;
  Matrix C_;      ///< of a body that deforms, else empty
  Matrix R_, M_;  ///< of a rigid one
};

}  // namespace reye::body
