#include "body/solid/elastic_solid.hpp"

#include <cmath>

#include "algebra/close_system.hpp"
#include "algebra/product.hpp"
#include "base/errors.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::body {

namespace {

/// Largest product of a diagonal entry and that of the inverse: above it the supports hold a motion by round-off alone.
constexpr double largest_condition = 1e12;

/// Displacements of all nodes for values of the independent dofs.
Points3 nodes_of(const fem::SolidDofs& dofs, const Vector& y) {
  const Vector u = fem::expansion(dofs) * y;
  Points3 nodes(dofs.first.size());
  for (size_t k = 0; k < nodes.size(); ++k) nodes[k] = u.segment<3>(3 * static_cast<Eigen::Index>(k));
  return nodes;
}

/// X T^T, column by column: most rows of T take one column as it is.
Matrix columns_combined(const Matrix& X, const base::SparseMatrix& T) {
  const Eigen::SparseMatrix<double, Eigen::RowMajor> rows = T;
  Matrix combined = Matrix::Zero(X.rows(), rows.rows());
  for (Eigen::Index j = 0; j < rows.rows(); ++j)
    for (decltype(rows)::InnerIterator it(rows, j); it; ++it) combined.col(j) += it.value() * X.col(it.col());
  return combined;
}

}  // namespace

ElasticSolid::ElasticSolid(const SolidInput& input, const std::vector<SolidPlace>& places,
                           const std::vector<int>& retained, std::optional<algebra::SchurFactor> spare,
                           SolidMatrices& out)
    : rows_(input, places, retained, out.driven, out.centre) {
  out.modes = rows_.free;
  factorise(rows_.stiffness(input), std::move(spare));
  set_driven(out);
  condense(input, out);
}

void ElasticSolid::factorise(base::SparseMatrix K, std::optional<algebra::SchurFactor> spare) {
  const int last = rows_.last();
  if (spare && spare->size() == K.cols() && spare->retained() == last) {
    factor_ = std::move(spare);
    factor_->refactor(K, rows_.held());
    return;
  }
  spare.reset();  // its memory is free before that of the other is asked for
  factor_.emplace(std::move(K), last, algebra::Ordering::nested_dissection, rows_.held());
}

void ElasticSolid::set_driven(SolidMatrices& out) {
  const auto driven = static_cast<Eigen::Index>(out.driven.size());
  condensed_loads_ = Matrix::Zero(rows_.last(), driven);
  for (size_t k = 0; k < rows_.loads.size(); ++k)
    if (rows_.loads[k].size() > 0)
      condensed_loads_.col(static_cast<Eigen::Index>(k)) = factor_->condense(rows_.loads[k]);
  pushed_ = condensed_loads_.topRows(rows_.columns.unknown()) + rows_.pushed;
  out.B = algebra::transposed_product(rows_.modes, rows_.pushed);
  for (size_t k = 0; k < rows_.loads.size(); ++k)
    if (rows_.loads[k].size() > 0)
      out.B.col(static_cast<Eigen::Index>(k)) +=
          out.modes.transpose() * out.load_resultant[static_cast<size_t>(out.driven[k].load)];
}

void ElasticSolid::condense(const SolidInput& input, SolidMatrices& out) {
  const int unknown = rows_.columns.unknown(), prescribed = static_cast<int>(rows_.columns.prescribed.size());
  const Matrix S = factor_->schur_rows(unknown);  // of what is prescribed
  const Matrix mixed = S.leftCols(unknown);
  auto [X, condition] = factor_->take_inverse(unknown);
  if (!(condition < largest_condition))
    throw base::SolveError("the stiffness of body \"" + input.name +
                           "\" is singular to working precision; its supports may leave a motion almost free");
  const Matrix left = pushed_ - algebra::transposed_product(mixed, rows_.prescribed);
  const Matrix Y = algebra::product(X, left);
  const Matrix mixed_X = algebra::product(mixed, X);
  const auto active = static_cast<Eigen::Index>(rows_.columns.active.size());
  active_f_ = Matrix(X.bottomRows(active)) * rows_.of_unknown.transpose();
  active_s_ = Y.bottomRows(active);
  active_a_ = rows_.modes.bottomRows(active);
  out.U = rows_.of_unknown * Y + rows_.of_prescribed * rows_.prescribed;
  out.A = rows_.of_unknown * rows_.modes;
  const Matrix of_f = mixed_X * rows_.of_unknown.transpose() - Matrix(rows_.of_prescribed.transpose());
  const Matrix of_s = algebra::product(mixed, Y) + algebra::product(S.rightCols(prescribed), rows_.prescribed) -
                      condensed_loads_.bottomRows(rows_.prescribed.rows());
  set_resultants(input, of_f, of_s, out);
  if (rows_.plain) {
    out.C = PointCompliance(std::move(X), rows_.of_unknown.rows());
    return;
  }
  Matrix half = columns_combined(X, rows_.of_unknown);
  X.resize(0, 0);
  half.transposeInPlace();
  Matrix C = columns_combined(half, rows_.of_unknown);
  algebra::mirror_lower(C);
  out.C = PointCompliance(std::move(C), rows_.of_unknown.rows());
}

void ElasticSolid::set_resultants(const SolidInput& input, const Matrix& of_f, const Matrix& of_s,
                                  SolidMatrices& out) const {
  const auto supports = static_cast<Eigen::Index>(input.supports.size());
  out.F = Matrix::Zero(6 * supports, of_f.cols());
  out.G = Matrix::Zero(6 * supports, of_s.cols());
  const auto add = [&](const SharedMotion& motion, const Eigen::RowVectorXd& f, const Eigen::RowVectorXd& s) {
    const int first = 6 * motion.support + (motion.motion < 3 ? 0 : 3), axis = motion.motion % 3;
    const Vec3 direction = motion.probe ? Vec3(Vec3::Unit(axis)) : Vec3(input.supports[motion.support].axes.col(axis));
    out.F.middleRows<3>(first) += direction * f;
    out.G.middleRows<3>(first) += direction * s;
  };
  for (size_t k = 0; k < rows_.columns.prescribed.size(); ++k)
    if (rows_.columns.prescribed[k].probe || input.supports[rows_.columns.prescribed[k].support].rigid)
      add(rows_.columns.prescribed[k], of_f.row(static_cast<Eigen::Index>(k)), of_s.row(static_cast<Eigen::Index>(k)));
  for (size_t k = 0; k < rows_.columns.active.size(); ++k) {
    const auto& [s, m, probe] = rows_.columns.active[k];
    const auto row = static_cast<Eigen::Index>(k);
    const double stiffness = motion_of(input.supports[s], m).stiffness;
    Eigen::RowVectorXd applied = -stiffness * active_s_.row(row);
    if (const int value = driven_motion(out.driven, s, m); value >= 0) applied[value] += 1.0;
    add(rows_.columns.active[k], -stiffness * active_f_.row(row), applied);
  }
}

Points3 ElasticSolid::displacements(const SolidMatrices& matrices, const std::vector<int>& retained, const Vector& f,
                                    const Vector& s, const Vector& a) const {
  const auto& dofs = rows_.columns.dofs;
  const int own = dofs.own - rows_.columns.interior;
  const auto active = static_cast<Eigen::Index>(rows_.columns.active.size());
  const Vector points = matrices.C.times(f) + matrices.U * s + matrices.A * a;
  Vector last(dofs.size() - rows_.columns.interior);
  for (size_t k = 0; k < retained.size(); ++k) {
    const int node = retained[k];
    const base::Mat3 basis =
        dofs.special[node] < 0 ? base::Mat3(base::Mat3::Identity()) : dofs.nodes[dofs.special[node]].basis;
    last.segment(dofs.first[node] - rows_.columns.interior, dofs.count[node]) =
        basis.leftCols(dofs.count[node]).transpose() * points.segment<3>(3 * static_cast<Eigen::Index>(k));
  }
  last.segment(own, active) = active_f_ * f + active_s_ * s + active_a_ * a;
  last.tail(rows_.prescribed.rows()) = rows_.prescribed * s;
  Vector load = Vector::Zero(dofs.size());
  for (size_t k = 0; k < rows_.loads.size(); ++k)
    if (rows_.loads[k].size() > 0) load += s[static_cast<Eigen::Index>(k)] * rows_.loads[k];
  return nodes_of(dofs, factor_->recover(load, last));
}

std::optional<Points3> ElasticSolid::displacements_in(const SolidInput& shape, const std::vector<SolidPlace>& places,
                                                      const std::vector<int>& retained, const SolidMatrices& matrices,
                                                      const Vector& f, const Vector& s, const Vector& a) const {
  const Vec3 centre = mesh::box_centre(shape.mesh->X);
  const SolidRows rows(shape, places, retained, matrices.driven, centre);
  if (rows.columns.dofs.size() != factor_->size() || rows.last() != factor_->retained()) return {};
  base::SparseMatrix K = rows.stiffness(shape);
  const Eigen::Index prescribed = rows.prescribed.rows(), count = K.rows() - prescribed;
  for (const int row : rows.held())  // motions that nothing holds; what is prescribed is left out
    if (const int at = rows.columns.interior + row; at < count) K.coeffRef(at, at) *= 2.0;
  Vector y = Vector::Zero(K.rows()), load = Vector::Zero(K.rows());
  y.tail(prescribed) = rows.prescribed * s;
  for (size_t k = 0; k < rows.loads.size(); ++k)
    if (rows.loads[k].size() > 0) load += s[static_cast<Eigen::Index>(k)] * rows.loads[k];
  load.segment(rows.columns.interior, rows.columns.unknown()) += rows.of_unknown.transpose() * f + rows.pushed * s;
  const base::SparseMatrix to_prescribed = K.rightCols(prescribed);
  load.head(count) -= to_prescribed.topRows(count) * y.tail(prescribed);
  const auto solved = algebra::solve_close(K.topLeftCorner(count, count), load.head(count), *factor_);
  if (!solved) return {};
  y.head(count) = *solved;
  Points3 nodes = nodes_of(rows.columns.dofs, y);
  for (size_t k = 0; k < nodes.size(); ++k) nodes[k] += modes_at(shape.mesh->X[k], centre) * (rows.free * a);
  return nodes;
}

}  // namespace reye::body
