#include "solver/solid/reduced_system.hpp"

#include <Eigen/SVD>
#include <cmath>

#include "algebra/factor.hpp"
#include "base/errors.hpp"

namespace reye::solver {

namespace {

using base::SparseMatrix;
using base::Triplet;

/// Columns over the components of all points, in the frames of their bodies: forces per unknown, Q^T along, or rows of
/// motion, Q^T row / covered.
struct Columns {
  SparseMatrix force, motion;
};

std::vector<int> bodies_of_points(const SolidSystem& system) {
  std::vector<int> body(static_cast<std::size_t>(system.points()));
  for (std::size_t b = 0; b < system.bodies.size(); ++b)
    for (int p = system.first_point[b]; p < system.first_point[b + 1]; ++p) body[p] = static_cast<int>(b);
  return body;
}

/// The direction in which the place of a point of a body counts: slip seen from a body that turns turns along.
Vec3 counted(const ReducedRow& row, const ReducedState& state, int body) {
  const auto& twist = state.standing.twist[row.contact];
  return row.slides && !twist.empty() ? Vec3(row.row - twist[body].turn.cross(row.row)) : row.row;
}

Columns columns_of(const SolidSystem& system, const ReducedState& state, const std::vector<ReducedRow>& rows) {
  std::vector<Triplet> force, motion;
  const auto body_of = bodies_of_points(system);
  for (int k = 0; k < static_cast<int>(rows.size()); ++k) {
    const auto& place = state.places[rows[k].contact];
    const double share = 1.0 / place.covered[rows[k].point];
    for (contact::SkinRows::InnerIterator it(place.Q, rows[k].point); it; ++it) {
      const int b = body_of[it.col()];
      Vec3 along = rows[k].along, row = counted(rows[k], state, b);
      if (system.turning[b]) {
        along = state.standing.poses[b].R.transpose() * along;
        row = state.standing.poses[b].R.transpose() * row;
      }
      for (int d = 0; d < 3; ++d) {
        const int at = 3 * static_cast<int>(it.col()) + d;
        if (along[d] != 0.0) force.emplace_back(at, k, it.value() * along[d]);
        if (row[d] != 0.0) motion.emplace_back(at, k, it.value() * row[d] * share);
      }
    }
  }
  const int size = 3 * system.points(), count = static_cast<int>(rows.size());
  Columns columns{SparseMatrix(size, count), SparseMatrix(size, count)};
  columns.force.setFromTriplets(force.begin(), force.end());
  columns.motion.setFromTriplets(motion.begin(), motion.end());
  return columns;
}

/// J -= motion^T C force of one body.
void subtract_compliance(const Matrix& C, const Columns& columns, int begin, Matrix& J) {
  const int end = begin + static_cast<int>(C.rows());
  const int count = static_cast<int>(columns.force.cols());
  Vector moved(C.rows());
  for (int k = 0; k < count; ++k) {
    moved.setZero();
    bool any = false;
    for (SparseMatrix::InnerIterator it(columns.force, k); it; ++it)
      if (it.row() >= begin && it.row() < end) {
        moved.noalias() += it.value() * C.col(it.row() - begin);
        any = true;
      }
    if (!any) continue;
    for (int i = 0; i < count; ++i) {
      double sum = 0.0;
      for (SparseMatrix::InnerIterator it(columns.motion, i); it; ++it)
        if (it.row() >= begin && it.row() < end) sum += it.value() * moved[it.row() - begin];
      J(i, k) -= sum;
    }
  }
}

void add_free_motions(const SolidSystem& system, const Columns& columns, Matrix& J) {
  const int count = static_cast<int>(columns.force.cols());
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const Matrix& A = system.bodies[b].A();
    if (A.cols() == 0) continue;
    const int begin = 3 * system.first_point[b], column = count + system.first_free[b];
    const SparseMatrix motion = columns.motion.middleRows(begin, A.rows());
    const SparseMatrix force = columns.force.middleRows(begin, A.rows());
    const Matrix resultants = A.transpose() * force;
    if (system.yields[b]) J.topLeftCorner(count, count).noalias() += motion.transpose() * system.relief[b] * resultants;
    if (system.turning[b]) continue;
    J.block(0, column, count, A.cols()).noalias() += motion.transpose() * A;
    J.block(column, 0, A.cols(), count) -= resultants;
  }
}

/// What the unknown motions of bodies that turn do to each row.
void add_motion_of_turning(const SolidSystem& system, const ReducedState& state, const std::vector<ReducedRow>& rows,
                           Matrix& J) {
  const auto body_of = bodies_of_points(system);
  const int count = static_cast<int>(rows.size());
  for (int k = 0; k < count; ++k) {
    const auto& place = state.places[rows[k].contact];
    const Matrix& seen = state.tangent.seen[rows[k].contact];
    auto change = J.row(k).tail(system.free());
    for (contact::SkinRows::InnerIterator it(place.Q, rows[k].point); it; ++it) {
      const double share = it.value() / place.covered[rows[k].point];
      const Vec3 row = share * counted(rows[k], state, body_of[it.col()]);
      const auto at = 3 * it.col();
      change.noalias() += row.transpose() * state.tangent.places.middleRows<3>(at);
      if (rows[k].slides && seen.size() > 0)
        change.noalias() += share * rows[k].row.transpose() * seen.middleRows<3>(at);
    }
  }
}

void add_turning(const SolidSystem& system, const ReducedState& state, const std::vector<ReducedRow>& rows,
                 const Columns& columns, Matrix& J) {
  const auto count = static_cast<Eigen::Index>(rows.size());
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (!system.turning[b]) continue;
    const int begin = 3 * system.first_point[b];
    const Matrix directions = body::balance_directions(*system.turning[b], state.standing.poses[b]);
    const SparseMatrix force = columns.force.middleRows(begin, directions.rows());
    J.block(count + system.first_free[b], 0, directions.cols(), count) -= directions.transpose() * force;
  }
  J.bottomRightCorner(system.free(), system.free()) += state.tangent.balance;
  add_motion_of_turning(system, state, rows, J);
}

Matrix matrix_of(const SolidSystem& system, const ReducedState& state, const std::vector<ReducedRow>& rows) {
  const int count = static_cast<int>(rows.size()), size = count + system.free();
  const Columns columns = columns_of(system, state, rows);
  Matrix J = Matrix::Zero(size, size);
  for (std::size_t b = 0; b < system.bodies.size(); ++b)
    if (system.yields[b]) subtract_compliance(system.bodies[b].C(), columns, 3 * system.first_point[b], J);
  add_free_motions(system, columns, J);
  if (system.turns()) add_turning(system, state, rows, columns, J);
  for (int k = 0; k < count; ++k) J(k, k) += rows[k].diagonal;
  return J;
}

/// Tractions first, then the motions that cost force; the others stay. `scale` makes motions comparable.
ReducedStep solve_beside_neutral(Matrix J, const Vector& right, const Vector& scale, double forces) {
  const auto free = scale.size(), count = right.size() - free;
  algebra::DenseFactor factor;
  const Matrix of_free = J.topRightCorner(count, free) * scale.asDiagonal();
  const Matrix resultants = scale.asDiagonal() * J.bottomLeftCorner(free, count);
  Matrix stiffness = scale.asDiagonal() * J.bottomRightCorner(free, free) * scale.asDiagonal();
  Vector left = scale.cwiseProduct(right.tail(free)), z0 = Vector::Zero(count);
  Matrix by_free = Matrix::Zero(count, free);
  if (count > 0) {
    Matrix tractions = J.topLeftCorner(count, count);
    factor.factor(tractions);
    for (Eigen::Index k = 0; k < free; ++k) by_free.col(k) = factor.solve(of_free.col(k));
    z0 = factor.solve(right.head(count));
  }
  stiffness -= resultants * by_free;
  left -= resultants * z0;
  const Eigen::JacobiSVD<Matrix> svd(stiffness, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vector& values = svd.singularValues();
  ReducedStep step{Vector(), Vector::Zero(free)};
  for (Eigen::Index k = 0; k < free; ++k) {
    const double along = svd.matrixU().col(k).dot(left);
    if (values[k] > 1e-10 * values[0])
      step.a += along / values[k] * svd.matrixV().col(k);
    else if (std::abs(along) > 1e-3 * forces)
      throw base::SolveError("nothing holds a body against what acts on it");
    else
      step.neutral = true;
  }
  step.z = z0 - by_free * step.a;
  step.a = scale.cwiseProduct(step.a);
  return step;
}

}  // namespace

ReducedStep solve_reduced(const SolidSystem& system, const ReducedState& state, const std::vector<ReducedRow>& rows) {
  const int count = static_cast<int>(rows.size()), size = count + system.free();
  if (size == 0) return {Vector(), Vector()};
  Vector right(size);
  for (int k = 0; k < count; ++k) right[k] = -rows[k].residual;
  right.tail(system.free()) = -state.imbalance;
  Matrix J = matrix_of(system, state, rows);
  algebra::DenseFactor factor;
  try {
    factor.factor(J);
  } catch (const base::SolveError&) {
    if (!system.turns() || system.unheld == 0) throw;
    return solve_beside_neutral(matrix_of(system, state, rows), right, motion_scale(system), state.forces);
  }
  const Vector x = factor.solve(right);
  return {x.head(count), x.tail(system.free())};
}

}  // namespace reye::solver
