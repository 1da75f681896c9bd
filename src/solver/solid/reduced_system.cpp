#include "solver/solid/reduced_system.hpp"

#include <cmath>
#include <map>

#include "algebra/decompose.hpp"
#include "algebra/product.hpp"
#include "base/errors.hpp"

namespace reye::solver {

namespace {

using base::SparseMatrix;
using base::Triplet;

/// A motion that a row of the system counts: that of a condition, or what a point wears off by sliding.
struct Counted {
  int contact = 0, point = 0;
  Vec3 row = Vec3::Zero();
  bool slides = false;
};

std::vector<Counted> counted_motions(const std::vector<ReducedRow>& rows, const std::vector<WearRow>& wear) {
  std::vector<Counted> all;
  all.reserve(rows.size() + wear.size());
  for (const auto& row : rows) all.push_back({row.contact, row.point, row.row, row.slides});
  for (const auto& row : wear) all.push_back({row.contact, row.point, row.of_motion, true});
  return all;
}

/// How each equation of the system counts the motions, rows x counted: its own, and where it is a gap the wear that
/// opens it.
SparseMatrix shares_of(const std::vector<WearRow>& wear, int count) {
  std::vector<Triplet> entries;
  for (int k = 0; k < count; ++k) entries.emplace_back(k, k, 1.0);
  for (int i = 0; i < static_cast<int>(wear.size()); ++i)
    for (const auto& [row, opening] : wear[static_cast<std::size_t>(i)].opens)
      entries.emplace_back(row, count + i, -opening);
  SparseMatrix shares(count, count + static_cast<int>(wear.size()));
  shares.setFromTriplets(entries.begin(), entries.end());
  return shares;
}

/// Columns over the components of all points, in the frames of their bodies: forces per unknown, Q^T along, or motions
/// per equation, of counted ones Q^T row / covered.
struct Columns {
  SparseMatrix force, motion;
};

/// Bodies per point where any turns; else empty, and all are in space.
std::vector<int> bodies_of_points(const SolidSystem& system) {
  if (!system.turns()) return {};
  std::vector<int> body(static_cast<std::size_t>(system.points()));
  for (std::size_t b = 0; b < system.bodies.size(); ++b)
    for (int p = system.first_point[b]; p < system.first_point[b + 1]; ++p) body[p] = static_cast<int>(b);
  return body;
}

/// The direction in which the place of a point of a body counts: slip seen from a body that turns turns along.
Vec3 direction_of(const Counted& counted, const ReducedState& state, int body) {
  const auto& twist = state.standing.twist[counted.contact];
  return counted.slides && !twist.empty() ? Vec3(counted.row - twist[body].turn.cross(counted.row)) : counted.row;
}

/// Adds factor x Q^T direction of a point as a column; `direction`: of the point with a number.
template <class Direction>
void add_column(const contact::SkinPlace& place, int point, double factor, int column, Direction direction,
                std::vector<Triplet>& entries) {
  for (contact::SkinRows::InnerIterator it(place.Q, point); it; ++it) {
    const Vec3 along = direction(static_cast<std::size_t>(it.col()));
    for (int d = 0; d < 3; ++d)
      if (along[d] != 0.0)
        entries.emplace_back(3 * static_cast<int>(it.col()) + d, column, factor * it.value() * along[d]);
  }
}

Columns columns_of(const SolidSystem& system, const ReducedState& state, const std::vector<ReducedRow>& rows,
                   const std::vector<Counted>& counted, const SparseMatrix& shares) {
  std::vector<Triplet> force, motion;
  const auto body_of = bodies_of_points(system);
  const auto framed = [&](std::size_t point, const Vec3& in_space) -> Vec3 {
    if (body_of.empty() || !system.turning[body_of[point]]) return in_space;
    return state.standing.poses[body_of[point]].R.transpose() * in_space;
  };
  const int size = 3 * system.points(), count = static_cast<int>(rows.size());
  for (int k = 0; k < count; ++k)
    add_column(
        state.places[rows[k].contact], rows[k].point, 1.0, k,
        [&](std::size_t point) { return framed(point, rows[k].along); }, force);
  for (int k = 0; k < static_cast<int>(counted.size()); ++k) {
    const auto& place = state.places[counted[k].contact];
    add_column(
        place, counted[k].point, 1.0 / place.covered[counted[k].point], k,
        [&](std::size_t point) {
          return body_of.empty() ? counted[k].row : framed(point, direction_of(counted[k], state, body_of[point]));
        },
        motion);
  }
  Columns columns{SparseMatrix(size, count), SparseMatrix(size, static_cast<int>(counted.size()))};
  columns.force.setFromTriplets(force.begin(), force.end());
  columns.motion.setFromTriplets(motion.begin(), motion.end());
  if (counted.size() > rows.size()) columns.motion = SparseMatrix(columns.motion * shares.transpose());
  return columns;
}

/// J -= motion^T C force of one body.
void subtract_compliance(const body::PointCompliance& C, const Columns& columns, int begin, Matrix& J) {
  const SparseMatrix motion = columns.motion.middleRows(begin, C.rows());
  const SparseMatrix force = columns.force.middleRows(begin, C.rows());
  C.subtract_product(motion, force, J.topLeftCorner(motion.cols(), force.cols()));
}

void add_free_motions(const SolidSystem& system, const Columns& columns, Matrix& J) {
  const int count = static_cast<int>(columns.force.cols());
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const Matrix& A = system.bodies[b].A();
    if (A.cols() == 0) continue;
    const int begin = 3 * system.first_point[b], free = count + system.first_free[b];
    const SparseMatrix motion = columns.motion.middleRows(begin, A.rows());
    const SparseMatrix force = columns.force.middleRows(begin, A.rows());
    const Matrix resultants = A.transpose() * force;
    if (system.yields[b])
      algebra::add_product(1.0, motion.transpose() * system.relief[b], resultants, J.topLeftCorner(count, count));
    if (system.turning[b]) continue;
    J.block(0, free, count, A.cols()).noalias() += motion.transpose() * A;
    J.block(free, 0, A.cols(), count) -= resultants;
  }
}

/// What the unknown motions of bodies that turn do to each counted motion.
Matrix counted_of_turning(const SolidSystem& system, const ReducedState& state, const std::vector<Counted>& counted) {
  const auto body_of = bodies_of_points(system);
  Matrix changes = Matrix::Zero(static_cast<Eigen::Index>(counted.size()), system.free());
  for (int k = 0; k < static_cast<int>(counted.size()); ++k) {
    const auto& place = state.places[counted[k].contact];
    const Matrix& seen = state.tangent.seen[counted[k].contact];
    auto change = changes.row(k);
    for (contact::SkinRows::InnerIterator it(place.Q, counted[k].point); it; ++it) {
      const double share = it.value() / place.covered[counted[k].point];
      const Vec3 row = share * direction_of(counted[k], state, body_of[it.col()]);
      const auto at = 3 * it.col();
      change.noalias() += row.transpose() * state.tangent.places.middleRows<3>(at);
      if (counted[k].slides && seen.size() > 0)
        change.noalias() += share * counted[k].row.transpose() * seen.middleRows<3>(at);
    }
  }
  return changes;
}

void add_turning(const SolidSystem& system, const ReducedState& state, const std::vector<Counted>& counted,
                 const SparseMatrix& shares, const Columns& columns, Matrix& J) {
  const auto count = columns.force.cols();
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (!system.turning[b]) continue;
    const int begin = 3 * system.first_point[b];
    const Matrix directions = body::balance_directions(*system.turning[b], state.standing.poses[b]);
    const SparseMatrix force = columns.force.middleRows(begin, directions.rows());
    J.block(count + system.first_free[b], 0, directions.cols(), count) -= directions.transpose() * force;
  }
  J.bottomRightCorner(system.free(), system.free()) += state.tangent.balance;
  J.topRightCorner(count, system.free()) += shares * counted_of_turning(system, state, counted);
}

/// Wear by the tractions of its own points, in the gaps that it opens.
void add_wear_of_traction(const std::vector<ReducedRow>& rows, const std::vector<WearRow>& wear, Matrix& J) {
  const int count = static_cast<int>(rows.size());
  std::map<std::pair<int, int>, std::vector<int>> unknowns;
  for (int k = 0; k < count; ++k) unknowns[{rows[k].contact, rows[k].point}].push_back(k);
  for (const auto& worn : wear)
    for (const int k : unknowns[{worn.contact, worn.point}])
      for (const auto& [row, opening] : worn.opens) J(row, k) -= opening * worn.of_traction.dot(rows[k].along);
}

Matrix matrix_of(const SolidSystem& system, const ReducedState& state, const std::vector<ReducedRow>& rows,
                 const std::vector<WearRow>& wear) {
  const int count = static_cast<int>(rows.size());
  const auto counted = counted_motions(rows, wear);
  const SparseMatrix shares = shares_of(wear, count);
  const Columns columns = columns_of(system, state, rows, counted, shares);
  Matrix J = Matrix::Zero(count + system.free(), count + system.free());
  for (std::size_t b = 0; b < system.bodies.size(); ++b)
    if (system.yields[b]) subtract_compliance(system.bodies[b].C(), columns, 3 * system.first_point[b], J);
  add_free_motions(system, columns, J);
  if (system.turns()) add_turning(system, state, counted, shares, columns, J);
  add_wear_of_traction(rows, wear, J);
  for (int k = 0; k < count; ++k) J(k, k) += rows[k].diagonal;
  return J;
}

/// Tractions first, then the motions that cost force; the others stay. `scale` makes motions comparable.
ReducedStep solve_beside_neutral(const Matrix& J, const Vector& right, const Vector& scale, double forces) {
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
  stiffness -= algebra::product(resultants, by_free);
  left -= resultants * z0;
  const auto [values, U, V] = algebra::singular_values(stiffness);
  ReducedStep step{Vector(), Vector::Zero(free)};
  for (Eigen::Index k = 0; k < free; ++k) {
    const double along = U.col(k).dot(left);
    if (values[k] > 1e-10 * values[0])
      step.a += along / values[k] * V.col(k);
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

void ReducedSystem::factor(const SolidSystem& system, const ReducedState& state, const std::vector<ReducedRow>& rows,
                           const std::vector<WearRow>& wear) {
  count_ = rows.size();
  neutral_.resize(0, 0);
  if (static_cast<int>(count_) + system.free() == 0) return;
  Matrix J = matrix_of(system, state, rows, wear);
  try {
    factor_.factor(J);
  } catch (const base::SolveError&) {
    if (!system.turns() || system.unheld == 0) throw;
    neutral_ = matrix_of(system, state, rows, wear);
    scale_ = motion_scale(system);
  }
}

ReducedStep ReducedSystem::solve(const std::vector<ReducedRow>& rows, const Vector& imbalance, double forces) const {
  const auto count = static_cast<Eigen::Index>(rows.size());
  if (count + imbalance.size() == 0) return {Vector(), Vector()};
  Vector right(count + imbalance.size());
  for (Eigen::Index k = 0; k < count; ++k) right[k] = -rows[static_cast<std::size_t>(k)].residual;
  right.tail(imbalance.size()) = -imbalance;
  if (neutral_.size() > 0) return solve_beside_neutral(neutral_, right, scale_, forces);
  const Vector x = factor_.solve(right);
  return {x.head(count), x.tail(imbalance.size())};
}

}  // namespace reye::solver
