#include "body/solid/point_compliance.hpp"

#include <algorithm>
#include <utility>

#include "algebra/gathered_product.hpp"
#include "algebra/product.hpp"
#include "base/cores.hpp"

namespace reye::body {

PointCompliance::PointCompliance(Matrix C, Eigen::Index rows) : rows_(rows), C_(std::move(C)) {
  if (rows > 0) largest_ = C_.diagonal().head(rows).maxCoeff();
}

PointCompliance::PointCompliance(Matrix R, Matrix M) : rows_(R.rows()), R_(std::move(R)), M_(std::move(M)) {
  if (rows_ > 0) largest_ = algebra::product(R_, M_).cwiseProduct(R_).rowwise().sum().maxCoeff();
}

Mat3 PointCompliance::of_point(Eigen::Index first_row) const {
  if (C_.size() > 0) return C_.block<3, 3>(first_row, first_row);
  const Eigen::Matrix<double, 3, 6> R = R_.middleRows<3>(first_row);
  const Eigen::Matrix<double, 3, 6> moved = R.lazyProduct(Eigen::Matrix<double, 6, 6>(M_));
  return moved.lazyProduct(R.transpose());
}

Matrix PointCompliance::times(const Matrix& forces) const {
  if (C_.size() > 0) return algebra::product(C_.topLeftCorner(rows_, rows_), forces);
  return algebra::product(R_, algebra::product(M_, algebra::transposed_product(R_, forces)));
}

void PointCompliance::add(const Vector& force, Eigen::Ref<Vector> u) const {
  if (C_.size() == 0) {
    const Vector on_body = R_.transpose() * force, motion = M_ * on_body;
    u.noalias() += R_ * motion;
    return;
  }
  constexpr int shares = 4;  // more would be too short to be read as streams
  const int rows_at_once = std::max(1, (static_cast<int>(rows_) + shares - 1) / shares);
  base::side_by_side(static_cast<int>(rows_), rows_at_once, [&](int top, int bottom) {
    for (Eigen::Index first = 0; first < force.size(); first += 3) {  // most points are open
      Eigen::Index end = first;
      while (end < force.size() && !force.segment<3>(end).isZero(0.0)) end += 3;
      if (end > first)
        algebra::add_product(C_.block(top, first, bottom - top, end - first), force.segment(first, end - first),
                             u.segment(top, bottom - top));
      first = end;
    }
  });
}

void PointCompliance::subtract_product(const SparseMatrix& motion, const SparseMatrix& force,
                                       Eigen::Ref<Matrix> A) const {
  if (C_.size() > 0) {
    algebra::subtract_gathered_product(motion, C_, force, A);
    return;
  }
  const Matrix moved = motion.transpose() * R_, on_body = R_.transpose() * force;
  algebra::add_product(-1.0, moved, algebra::product(M_, on_body), A);
}

Matrix PointCompliance::dense() const {
  return C_.size() > 0 ? Matrix(C_.topLeftCorner(rows_, rows_))
                       : algebra::product_transposed(algebra::product(R_, M_), R_);
}

}  // namespace reye::body
