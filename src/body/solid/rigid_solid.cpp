#include <Eigen/Geometry>

#include "algebra/decompose.hpp"
#include "algebra/product.hpp"
#include "body/solid/solid_matrices.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::body {

namespace {

/// A support's motion that acts on the rigid body by a force: load less spring.
struct Pushed {
  ModeRow form;
  double stiffness = 0.0;
  int driven = -1;
};

/// The equations of a rigid body's motion z with contact forces f and driven values s:
///   H z = values s (held),   R^T f + P s - K z + H^T lambda = 0
class RigidSolid {
 public:
  RigidSolid(const SolidInput& input, const std::vector<SolidPlace>& places, SolidMatrices& out)
      : input_(input), places_(places), out_(out), size_(mesh::box_diagonal(input.mesh->X)) {
    scale_.setOnes();
    scale_.tail<3>().setConstant(1.0 / size_);
    collect_held();
    collect_pushed();
    add_loads();
  }

  RigidMotion condense(const std::vector<int>& retained) {
    const Matrix R = motion_of_points(retained);
    const Modes all_left = free_modes(rows_, size_);
    const Matrix M = compliance(all_left);
    const Matrix moved = imposed();
    const Matrix rest = P_ - K_ * moved;
    RigidMotion z{algebra::product_transposed(M, R), moved + algebra::product(M, rest)};
    out_.modes = free_modes(held_rows(input_, places_, out_.centre, true), size_);
    out_.U = algebra::product(R, z.of_s);
    out_.A = algebra::product(R, out_.modes);
    out_.B = algebra::transposed_product(out_.modes, P_);
    set_resultants(R, z);
    out_.C = PointCompliance(R, M);
    return z;
  }

 private:
  void collect_held() {
    Matrix basis(6, 0);
    for (const auto& row : held_rows(input_, places_, out_.centre, false)) {
      const Mode form = row.row.cwiseProduct(scale_);
      const Vector rest = form - basis * (basis.transpose() * form);
      if (rest.norm() < 1e-6) continue;
      basis.conservativeResize(6, basis.cols() + 1);
      basis.rightCols<1>() = rest.normalized();
      rows_.push_back(row);
    }
    H_.resize(static_cast<Eigen::Index>(rows_.size()), 6);
    for (size_t k = 0; k < rows_.size(); ++k) H_.row(static_cast<Eigen::Index>(k)) = rows_[k].row.transpose();
  }

  void collect_pushed() {
    K_.setZero();
    P_ = Matrix::Zero(6, static_cast<Eigen::Index>(out_.driven.size()));
    for (int s = 0; s < static_cast<int>(places_.size()); ++s)
      for (int m = 0; m < 6 && input_.supports[s].rigid; ++m) {
        const Motion& motion = body::motion_of(input_.supports[s], m);
        if (motion.drive != Drive::loaded) continue;
        const Pushed pushed{row_of(input_.supports[s], s, m, places_[s].centre, out_.centre), motion.stiffness,
                            driven_motion(out_.driven, s, m)};
        K_ += pushed.stiffness * pushed.form.row * pushed.form.row.transpose();
        if (pushed.driven >= 0) P_.col(pushed.driven) += pushed.form.row;
        pushed_.push_back(pushed);
      }
  }

  void add_loads() {
    for (int k = 0; k < static_cast<int>(out_.driven.size()); ++k)
      if (const int load = out_.driven[k].load; load >= 0) P_.col(k) += out_.load_resultant[load];
  }

  Matrix motion_of_points(const std::vector<int>& retained) const {
    const Points3 points = contact_points(input_);
    Matrix R(3 * static_cast<Eigen::Index>(retained.size()), 6);
    for (size_t k = 0; k < retained.size(); ++k)
      R.middleRows<3>(3 * static_cast<Eigen::Index>(k)) = modes_at(points[retained[k]], out_.centre);
    return R;
  }

  /// z of imposed values alone, rotations and translations weighed alike: 6 x driven.
  Matrix imposed() const {
    Matrix values = Matrix::Zero(H_.rows(), P_.cols());
    for (size_t k = 0; k < rows_.size(); ++k) {
      const int driven = driven_motion(out_.driven, rows_[k].support, rows_[k].motion);
      if (driven >= 0) values(static_cast<Eigen::Index>(k), driven) = 1.0;
    }
    const Matrix scaled = H_ * scale_.asDiagonal();
    const Matrix motions = algebra::transposed_product(scaled, normal_inverse(values));
    return scale_.asDiagonal() * motions;
  }

  /// (H H^T)^-1 of columns, rotations scaled.
  Matrix normal_inverse(const Matrix& columns) const {
    if (rows_.empty()) return columns;
    const Matrix scaled = H_ * scale_.asDiagonal();
    return algebra::solve_symmetric(algebra::product_transposed(scaled, scaled), columns);
  }

  /// The motion that springs allow: N (N^T K N)^+ N^T on the motions N that nothing holds. Motions without a spring
  /// stay out of it: they are free.
  Matrix compliance(const Modes& N) const {
    if (pushed_.empty() || N.cols() == 0) return Matrix::Zero(6, 6);
    Matrix scaled = N;
    for (int k = 0; k < scaled.cols(); ++k) scaled.col(k) /= scaled.col(k).cwiseQuotient(scale_).norm();
    const Matrix pushed = K_ * scaled;
    const auto eigen = algebra::eigenpairs(algebra::transposed_product(scaled, pushed));
    const double largest = eigen.values.cwiseAbs().maxCoeff();
    const Vector inverse = eigen.values.unaryExpr([&](double v) { return v > 1e-12 * largest ? 1.0 / v : 0.0; });
    const Matrix W = algebra::product(scaled, eigen.vectors);
    const Matrix weighed = W * inverse.asDiagonal();
    return algebra::product_transposed(weighed, W);
  }

  /// r = what held motions take, lambda H, and what acts on loaded ones, all about the supports' centres.
  void set_resultants(const Matrix& R, const RigidMotion& z) {
    const auto supports = static_cast<Eigen::Index>(places_.size());
    const Matrix weighed = H_ * scale_.cwiseAbs2().asDiagonal();
    const auto lambda_of = [&](const Matrix& rest) { return normal_inverse(algebra::product(weighed, rest)); };
    const Matrix of_f = lambda_of(K_ * z.of_f - R.transpose()), of_s = lambda_of(K_ * z.of_s - P_);
    out_.F = Matrix::Zero(6 * supports, R.rows());
    out_.G = Matrix::Zero(6 * supports, P_.cols());
    for (size_t k = 0; k < rows_.size(); ++k)
      add_wrench(rows_[k], of_f.row(static_cast<Eigen::Index>(k)), of_s.row(static_cast<Eigen::Index>(k)));
    for (const auto& [form, stiffness, driven] : pushed_) {
      Eigen::RowVectorXd load = -stiffness * (form.row.transpose() * z.of_s);
      if (driven >= 0) load[driven] += 1.0;
      add_wrench(form, -stiffness * (form.row.transpose() * z.of_f), load);
    }
  }

  void add_wrench(const ModeRow& form, const Eigen::RowVectorXd& of_f, const Eigen::RowVectorXd& of_s) {
    Mode wrench = form.row;
    wrench.tail<3>() -= (places_[form.support].centre - out_.centre).cross(Vec3(wrench.head<3>()));
    out_.F.middleRows<6>(6 * form.support) += wrench * of_f;
    out_.G.middleRows<6>(6 * form.support) += wrench * of_s;
  }

  const SolidInput& input_;
  const std::vector<SolidPlace>& places_;
  SolidMatrices& out_;
  double size_;
  Mode scale_;
  std::vector<ModeRow> rows_;  ///< independent held ones
  Matrix H_, P_;
  Eigen::Matrix<double, 6, 6> K_;
  std::vector<Pushed> pushed_;
};

}  // namespace

RigidMotion condense_rigid(const SolidInput& input, const std::vector<SolidPlace>& places,
                           const std::vector<int>& retained, SolidMatrices& out) {
  return RigidSolid(input, places, out).condense(retained);
}

}  // namespace reye::body
