#include "body/solid/rigid_modes.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "algebra/decompose.hpp"
#include "base/formatted.hpp"

namespace reye::body {

namespace {

/// Gauss-Jordan of rows over the columns in this order: rotations first, so that what can be a pure translation is one.
void reduce_rows(Matrix& W) {
  int done = 0;
  for (int column : {3, 4, 5, 0, 1, 2}) {
    if (done == W.rows()) return;
    Eigen::Index best = 0;
    if (W.col(column).tail(W.rows() - done).cwiseAbs().maxCoeff(&best) < 1e-6) continue;
    W.row(done).swap(W.row(done + best));
    W.row(done) /= W(done, column);
    for (int k = 0; k < W.rows(); ++k)
      if (k != done) W.row(k) -= W(k, column) * W.row(done);
    ++done;
  }
}

std::string direction_name(const Vec3& v) {
  Eigen::Index axis = 0;
  const double largest = v.cwiseAbs().maxCoeff(&axis);
  if (std::abs(largest - v.norm()) < 1e-9 * largest) return std::string(1, "xyz"[axis]);
  const Vec3 d = v / v.norm() * (v[axis] < 0.0 ? -1.0 : 1.0);
  return base::formatted("(%.3g, %.3g, %.3g)", d.x() + 0.0, d.y() + 0.0, d.z() + 0.0);
}

}  // namespace

Eigen::Matrix<double, 3, 6> modes_at(const Vec3& X, const Vec3& c) {
  Eigen::Matrix<double, 3, 6> m;
  for (int k = 0; k < 3; ++k) {
    m.col(k) = Vec3::Unit(k);
    m.col(3 + k) = Vec3::Unit(k).cross(X - c);
  }
  return m;
}

ModeRow row_of(const SolidSupport& support, int s, int m, const Vec3& support_centre, const Vec3& c) {
  ModeRow row{s, m};
  if (m < 3)
    row.row = modes_at(support_centre, c).transpose() * support.axes.col(m);
  else
    row.row.tail<3>() = support.axes.col(m - 3);
  return row;
}

std::vector<ModeRow> held_rows(const SolidInput& input, const std::vector<SolidPlace>& places, const Vec3& c,
                               bool springs) {
  std::vector<std::vector<ModeRow>> of(places.size());
  for (size_t s = 0; s < places.size(); ++s)
    for (int m = 0; m < 6 && input.supports[s].rigid; ++m) {
      const Motion& motion = motion_of(input.supports[s], m);
      if (motion.drive == Drive::fixed || motion.drive == Drive::moved || (springs && motion.stiffness > 0.0))
        of[s].push_back(row_of(input.supports[s], static_cast<int>(s), m, places[s].centre, c));
    }
  for (const auto& [node, demands] : node_demands(input, places))
    if (demands.rigid.empty() || input.rigid)
      for (const auto& [s, m, d] : demands.by_node)
        of[s].push_back({s, m, Mode(modes_at(input.mesh->X[node], c).transpose() * d)});
  std::vector<ModeRow> rows;
  for (const auto& some : of) rows.insert(rows.end(), some.begin(), some.end());
  return rows;
}

Modes free_modes(const std::vector<ModeRow>& rows, double size) {
  Mode scale = Mode::Ones();
  scale.tail<3>().setConstant(1.0 / size);
  Matrix M = Matrix::Zero(static_cast<Eigen::Index>(rows.size()) + 6, 6);  // never fewer rows than columns
  for (size_t k = 0; k < rows.size(); ++k)
    M.row(static_cast<Eigen::Index>(k)) = rows[k].row.cwiseProduct(scale).transpose();
  const auto singular = algebra::right_singular_values(M);
  const auto rank = (singular.values.array() > 1e-8).count();
  Matrix W = singular.V.rightCols(6 - rank).transpose();
  reduce_rows(W);
  Modes modes = (W * scale.asDiagonal()).transpose();
  for (int k = 0; k < modes.cols(); ++k) {
    const Vec3 turn = modes.col(k).tail<3>();
    modes.col(k) /= turn.norm() * size > 1e-8 ? turn.norm() : modes.col(k).norm();
    for (double& value : modes.col(k))
      if (std::abs(value) < 1e-12) value = 0.0;
  }
  return modes;
}

std::string mode_name(const Mode& mode) {
  const Vec3 turn = mode.tail<3>();
  if (turn.isZero(0.0)) {
    const std::string name = direction_name(mode.head<3>());
    return name.size() == 1 ? name : "along " + name;
  }
  return "rotation about " + direction_name(turn);
}

}  // namespace reye::body
