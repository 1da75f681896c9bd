#include "solver/solid/reduced_system.hpp"

#include "algebra/gathered_product.hpp"
#include "base/errors.hpp"

namespace reye::solver {

namespace {

using base::SparseMatrix;
using base::Triplet;

/// Columns over the components of all points: forces per unknown, Q^T along, or rows of motion, Q^T row / covered.
struct Columns {
  SparseMatrix force, motion;
};

Columns columns_of(const SolidSystem& system, std::span<const contact::SkinPlace> places,
                   const std::vector<ReducedRow>& rows) {
  std::vector<Triplet> force, motion;
  for (int k = 0; k < static_cast<int>(rows.size()); ++k) {
    const auto& row = rows[k];
    const auto& place = places[row.contact];
    const double share = 1.0 / place.covered[row.point];
    for (contact::SkinRows::InnerIterator it(place.Q, row.point); it; ++it)
      for (int d = 0; d < 3; ++d) {
        const int at = 3 * static_cast<int>(it.col()) + d;
        if (row.along[d] != 0.0) force.emplace_back(at, k, it.value() * row.along[d]);
        if (row.row[d] != 0.0) motion.emplace_back(at, k, it.value() * row.row[d] * share);
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
  const SparseMatrix motion = columns.motion.middleRows(begin, C.rows());
  const SparseMatrix force = columns.force.middleRows(begin, C.rows());
  J.topLeftCorner(motion.cols(), force.cols()) -= algebra::gathered_product(motion, C, force);
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
    J.block(0, column, count, A.cols()).noalias() += motion.transpose() * A;
    J.block(column, 0, A.cols(), count) -= resultants;
  }
}

}  // namespace

void ReducedSystem::factor(const SolidSystem& system, std::span<const contact::SkinPlace> places,
                           const std::vector<ReducedRow>& rows) {
  const int count = static_cast<int>(rows.size()), size = count + system.free();
  count_ = rows.size();
  if (size == 0) return;
  const Columns columns = columns_of(system, places, rows);
  Matrix J = Matrix::Zero(size, size);
  for (std::size_t b = 0; b < system.bodies.size(); ++b)
    if (system.yields[b]) subtract_compliance(system.bodies[b].C(), columns, 3 * system.first_point[b], J);
  add_free_motions(system, columns, J);
  for (int k = 0; k < count; ++k) J(k, k) += rows[k].diagonal;
  factor_.factor(J);
}

ReducedStep ReducedSystem::solve(const std::vector<ReducedRow>& rows, const Vector& imbalance) const {
  const auto count = static_cast<Eigen::Index>(rows.size());
  if (count + imbalance.size() == 0) return {Vector(), Vector()};
  Vector right(count + imbalance.size());
  for (Eigen::Index k = 0; k < count; ++k) right[k] = -rows[static_cast<std::size_t>(k)].residual;
  right.tail(imbalance.size()) = -imbalance;
  const Vector x = factor_.solve(right);
  return {x.head(count), x.tail(imbalance.size())};
}

}  // namespace reye::solver
