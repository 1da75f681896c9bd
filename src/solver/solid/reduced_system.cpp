#include "solver/solid/reduced_system.hpp"

#include <map>

#include "algebra/gathered_product.hpp"
#include "base/errors.hpp"

namespace reye::solver {

namespace {

using base::SparseMatrix;
using base::Triplet;

/// Columns over the components of all points: forces per unknown, Q^T along, or rows of motion, Q^T row / covered;
/// those of wear come after those of the conditions.
struct Columns {
  SparseMatrix force, motion;
};

/// Adds factor x Q^T direction of a point as a column.
void add_column(const contact::SkinPlace& place, int point, const Vec3& direction, double factor, int column,
                std::vector<Triplet>& entries) {
  for (contact::SkinRows::InnerIterator it(place.Q, point); it; ++it)
    for (int d = 0; d < 3; ++d)
      if (direction[d] != 0.0)
        entries.emplace_back(3 * static_cast<int>(it.col()) + d, column, factor * it.value() * direction[d]);
}

Columns columns_of(const SolidSystem& system, std::span<const contact::SkinPlace> places,
                   const std::vector<ReducedRow>& rows, const std::vector<WearRow>& wear) {
  std::vector<Triplet> force, motion;
  const int size = 3 * system.points(), count = static_cast<int>(rows.size());
  for (int k = 0; k < count; ++k) {
    const auto& row = rows[k];
    const auto& place = places[row.contact];
    add_column(place, row.point, row.along, 1.0, k, force);
    add_column(place, row.point, row.row, 1.0 / place.covered[row.point], k, motion);
  }
  for (int k = 0; k < static_cast<int>(wear.size()); ++k) {
    const auto& place = places[wear[k].contact];
    add_column(place, wear[k].point, wear[k].of_motion, 1.0 / place.covered[wear[k].point], count + k, motion);
  }
  Columns columns{SparseMatrix(size, count), SparseMatrix(size, count + static_cast<int>(wear.size()))};
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

/// `balance`: the rows of J where the equations of free motions begin.
void add_free_motions(const SolidSystem& system, const Columns& columns, int balance, Matrix& J) {
  const int count = static_cast<int>(columns.force.cols()), motions = static_cast<int>(columns.motion.cols());
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const Matrix& A = system.bodies[b].A();
    if (A.cols() == 0) continue;
    const int begin = 3 * system.first_point[b], column = count + system.first_free[b];
    const int row = balance + system.first_free[b];
    const SparseMatrix motion = columns.motion.middleRows(begin, A.rows());
    const SparseMatrix force = columns.force.middleRows(begin, A.rows());
    const Matrix resultants = A.transpose() * force;
    if (system.yields[b])
      J.topLeftCorner(motions, count).noalias() += motion.transpose() * system.relief[b] * resultants;
    J.block(0, column, motions, A.cols()).noalias() += motion.transpose() * A;
    J.block(row, 0, A.cols(), count) -= resultants;
  }
}

/// The rows of wear by the tractions of their own points.
void add_wear_of_traction(const std::vector<ReducedRow>& rows, const std::vector<WearRow>& wear, Matrix& J) {
  const int count = static_cast<int>(rows.size());
  std::map<std::pair<int, int>, std::vector<int>> unknowns;
  for (int k = 0; k < count; ++k) unknowns[{rows[k].contact, rows[k].point}].push_back(k);
  for (int i = 0; i < static_cast<int>(wear.size()); ++i)
    for (const int k : unknowns[{wear[i].contact, wear[i].point}])
      J(count + i, k) += wear[i].of_traction.dot(rows[k].along);
}

/// Puts the wear, rows of J below those of the conditions, into the gaps that it opens, and takes its rows away.
Matrix worn_into(const Matrix& J, const std::vector<WearRow>& wear, int count, int free) {
  Matrix square(count + free, J.cols());
  square.topRows(count) = J.topRows(count);
  square.bottomRows(free) = J.bottomRows(free);
  for (std::size_t k = 0; k < wear.size(); ++k)
    for (const auto& [row, opening] : wear[k].opens) square.row(row) -= opening * J.row(count + static_cast<int>(k));
  return square;
}

}  // namespace

void ReducedSystem::factor(const SolidSystem& system, std::span<const contact::SkinPlace> places,
                           const std::vector<ReducedRow>& rows, const std::vector<WearRow>& wear) {
  const int count = static_cast<int>(rows.size()), size = count + system.free();
  count_ = rows.size();
  if (size == 0) return;
  const int balance = count + static_cast<int>(wear.size());
  const Columns columns = columns_of(system, places, rows, wear);
  Matrix J = Matrix::Zero(balance + system.free(), size);
  for (std::size_t b = 0; b < system.bodies.size(); ++b)
    if (system.yields[b]) subtract_compliance(system.bodies[b].C(), columns, 3 * system.first_point[b], J);
  add_free_motions(system, columns, balance, J);
  add_wear_of_traction(rows, wear, J);
  if (!wear.empty()) J = worn_into(J, wear, count, system.free());
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
