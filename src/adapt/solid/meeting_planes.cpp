#include "adapt/solid/meeting_planes.hpp"

#include <cmath>

#include "algebra/decompose.hpp"
#include "algebra/product.hpp"

namespace reye::adapt {

namespace {

/// Sine of the angle below which a direction counts as lying in those before it.
constexpr double least_sine = 0.05;

/// What is left of v beside orthonormal directions.
Vec3 beside_all(Vec3 v, const std::vector<Vec3>& directions) {
  for (const Vec3& q : directions) v -= v.dot(q) * q;
  return v;
}

void add_direction(const Vec3& v, std::vector<Vec3>& directions) {
  const Vec3 rest = beside_all(v, directions);
  if (rest.norm() > least_sine) directions.push_back(unit_on_axis(rest));
}

/// The shortest d with p_k . d = -depth_k in the sense of least squares: a sum of the rows p_k, so that a component
/// which is zero in all of them is zero in d.
Vec3 shortest(const Eigen::Matrix3Xd& rows, const Eigen::VectorXd& depths) {
  if (rows.cols() == 1) return -depths[0] / rows.col(0).squaredNorm() * rows.col(0);
  const auto [lambda, vectors] = algebra::eigenpairs(algebra::transposed_product(rows, rows));
  Eigen::VectorXd shares = -(vectors.transpose() * depths);
  for (int k = 0; k < lambda.size(); ++k)
    shares[k] = lambda[k] > least_sine * least_sine * lambda[lambda.size() - 1] ? shares[k] / lambda[k] : 0.0;
  const Eigen::VectorXd weights = vectors * shares;
  return rows * weights;
}

}  // namespace

Vec3 unit_on_axis(const Vec3& v) {
  constexpr double round_off = 1e-12;
  const Vec3 n = v.normalized();
  for (int c = 0; c < 3; ++c)
    if ((n - n[c] * Vec3::Unit(c)).norm() < round_off) return std::copysign(1.0, n[c]) * Vec3::Unit(c);
  return n;
}

Vec3 where_planes_meet(const std::vector<RecedingPlane>& planes, const Vec3& along) {
  std::vector<Vec3> held;
  const auto is_axis = [](const Vec3& n) { return unit_on_axis(n).cwiseAbs().maxCoeff() == 1.0; };
  for (bool on_axis : {true, false})  // those along axes first: what is exact in them stays exact
    for (const RecedingPlane& plane : planes)
      if (plane.depth == 0.0 && is_axis(plane.normal) == on_axis) add_direction(plane.normal, held);
  Eigen::Matrix3Xd rows(3, static_cast<int>(planes.size()));
  Eigen::VectorXd depths(static_cast<int>(planes.size()));
  int count = 0;
  for (const RecedingPlane& plane : planes) {
    const Vec3 row = beside_all(plane.normal, held);
    if (plane.depth == 0.0 || !(row.norm() > least_sine)) continue;
    rows.col(count) = row;
    depths[count++] = plane.depth;
  }
  Vec3 d = Vec3::Zero();
  if (count > 0) d = shortest(rows.leftCols(count), depths.head(count));
  if (along.isZero(0.0)) return d;
  for (int k = 0; k < count; ++k) add_direction(rows.col(k), held);
  return d + beside_all(along, held);
}

}  // namespace reye::adapt
