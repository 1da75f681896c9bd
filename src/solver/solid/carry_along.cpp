#include "solver/solid/carry_along.hpp"

#include "algebra/decompose.hpp"

namespace reye::solver {

namespace {

using contact::SkinStatus;

/// Motion of all points by the twists of their frames, of bodies that keep their direction by what is driven.
Vector driven_motion(const SolidSystem& system, const SolidState& old, const std::vector<body::SolidPose>& old_poses,
                     const std::vector<body::SolidPose>& poses, const Vector& moved) {
  Vector v = moved - old.u;
  const Vector x = positions(system, old.u);
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (!system.turning[b]) continue;
    const auto twist = body::relative_twist(old_poses[b], poses[b], {}, {});
    for (int p = system.first_point[b]; p < system.first_point[b + 1]; ++p)
      v.segment<3>(3 * p) = twist.at(x.segment<3>(3 * p));
  }
  return v;
}

/// Motion of all points per free motion of bodies that turn, rotations by 1 / their size; columns of zeros for those of
/// others.
Matrix free_fields(const SolidSystem& system, const SolidState& old, const std::vector<body::SolidPose>& old_poses,
                   const Vector& scale) {
  Matrix fields = Matrix::Zero(3 * system.points(), system.free());
  const Vector x = positions(system, old.u);
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (!system.turning[b]) continue;
    const auto twists = body::twists_of(*system.turning[b], old_poses[b], Vector::Zero(system.turning[b]->count()));
    for (std::size_t k = 0; k < twists.size(); ++k) {
      const int column = system.first_free[b] + static_cast<int>(k);
      for (int p = system.first_point[b]; p < system.first_point[b + 1]; ++p)
        fields.col(column).segment<3>(3 * p) = scale[column] * twists[k].at(x.segment<3>(3 * p));
    }
  }
  return fields;
}

/// Directions in which a closed point is to stay: its normal, and across it where it sticks and no slip is imposed,
/// which no motion of a body makes.
std::vector<Vec3> kept_directions(const contact::SkinFrame& frame, SkinStatus status, double friction,
                                  const Vec3& imposed) {
  std::vector<Vec3> kept;
  if (status == SkinStatus::open) return kept;
  kept.push_back(frame.normal);
  for (int k = 0; k < frame.free && status == SkinStatus::stick && friction > 0.0 && imposed.isZero(0.0); ++k)
    kept.push_back(frame.tangent[k]);
  return kept;
}

struct Rows {
  std::vector<Eigen::RowVectorXd> of_free;
  std::vector<double> right;
};

void add_kept_rows(const contact::SkinPlace& place, int j, const Vec3& direction, const Vector& driven,
                   const Matrix& fields, Rows& rows) {
  const double weight = std::sqrt(place.covered[j]);
  Eigen::RowVectorXd of_free = Eigen::RowVectorXd::Zero(fields.cols());
  double sum = 0.0;
  for (contact::SkinRows::InnerIterator it(place.Q, j); it; ++it) {
    const Vec3 row = weight * it.value() / place.covered[j] * direction;
    sum += row.dot(driven.segment<3>(3 * it.col()));
    of_free += row.transpose() * fields.middleRows<3>(3 * it.col());
  }
  rows.of_free.push_back(std::move(of_free));
  rows.right.push_back(-sum);
}

/// The least change of the free motions that keeps closed points in place.
Vector least_change(const SolidSystem& system, const Rows& rows) {
  Matrix J(static_cast<Eigen::Index>(rows.right.size()), system.free());
  Vector right(J.rows());
  for (Eigen::Index k = 0; k < J.rows(); ++k) {
    J.row(k) = rows.of_free[k];
    right[k] = rows.right[k];
  }
  return algebra::least_squares(J, right, 1e-6);
}

}  // namespace

Vector carried_along_motions(const SolidSystem& system, const SolidState& old, const SolidTarget& target,
                             const std::vector<body::SolidPose>& poses, const Vector& moved,
                             std::span<const contact::SkinPlace> places) {
  const auto old_poses = poses_of(system, old);
  const Vector scale = motion_scale(system);
  const Vector driven = driven_motion(system, old, old_poses, poses, moved);
  const Matrix fields = free_fields(system, old, old_poses, scale);
  Rows rows;
  for (std::size_t c = 0; c < places.size(); ++c)
    for (int j = 0; j < places[c].count(); ++j) {
      if (!places[c].carries[j]) continue;
      for (const Vec3& direction :
           kept_directions(places[c].frame[j], old.status[c][j], target.friction[c], target.slip[c][j]))
        add_kept_rows(places[c], j, direction, driven, fields, rows);
    }
  if (rows.right.empty()) return old.a;
  const Vector change = scale.cwiseProduct(least_change(system, rows));
  Vector a = old.a;
  for (std::size_t b = 0; b < system.bodies.size(); ++b)
    if (system.turning[b]) {
      const auto& turning = *system.turning[b];
      const int first = system.first_free[b];
      a.segment(first, turning.count()) +=
          body::along_screw(turning, old_poses[b], poses[b], system.of_free(change, b));
    }
  return a;
}

}  // namespace reye::solver
