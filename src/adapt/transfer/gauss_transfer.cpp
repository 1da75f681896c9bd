#include "adapt/transfer/gauss_transfer.hpp"

#include <Eigen/Eigenvalues>
#include <cassert>
#include <cmath>

#include "adapt/shape/segment_tree.hpp"
#include "adapt/transfer/gauss_points.hpp"
#include "adapt/transfer/locate.hpp"
#include "adapt/transfer/projection.hpp"
#include "adapt/transfer/recovery.hpp"

namespace reye::adapt {

namespace {

using base::Matrix;
using material::ElasticState;

Matrix picked(const GaussPoints& old, const Matrix& values, const GaussPoints& fresh) {
  const SegmentTree tree(old.x);
  Matrix result(static_cast<Eigen::Index>(fresh.x.size()), values.cols());
  for (std::size_t i = 0; i < fresh.x.size(); ++i)
    result.row(static_cast<Eigen::Index>(i)) = values.row(tree.nearest(fresh.x[i]).segment);
  return result;
}

Matrix interpolated(const mesh::Mesh& from, const Matrix& nodal, const GaussPoints& fresh) {
  const Locator locator(from);
  Matrix result = Matrix::Zero(static_cast<Eigen::Index>(fresh.x.size()), nodal.cols());
  for (std::size_t i = 0; i < fresh.x.size(); ++i) {
    const auto place = locator.find(fresh.x[i]);
    for (int a = 0; a < mesh::nodes_per_cell(from.kind); ++a)
      result.row(static_cast<Eigen::Index>(i)) += place.weights[a] * nodal.row(from.cells[place.cell][a]);
  }
  return result;
}

constexpr int state_columns = 5;  ///< eps_e 11, 22, 12, 33, p

Matrix rows_of(const std::vector<ElasticState>& state) {
  Matrix rows(static_cast<Eigen::Index>(state.size()), state_columns);
  for (std::size_t i = 0; i < state.size(); ++i) {
    const auto& e = state[i].strain;
    rows.row(static_cast<Eigen::Index>(i)) << e[0], e[1], e[2], e[3], state[i].accumulated;
  }
  return rows;
}

enum Carried { log_11, log_22, log_12, log_33, cosine, sine, carried_columns };

Eigen::RowVectorXd logarithm(const Eigen::RowVectorXd& F) {
  const double angle = std::atan2(F[2] - F[1], F[0] + F[3]), c = std::cos(angle), s = std::sin(angle);
  Eigen::Matrix2d inplane, R;
  inplane << F[0], F[1], F[2], F[3];
  R << c, -s, s, c;
  assert(inplane.determinant() > 0.0 && F[4] > 0.0);
  const Eigen::Matrix2d U = R.transpose() * inplane;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal;
  principal.computeDirect(0.5 * (U + U.transpose()));
  const Eigen::Matrix2d H = principal.eigenvectors() * principal.eigenvalues().array().log().matrix().asDiagonal() *
                            principal.eigenvectors().transpose();
  Eigen::RowVectorXd row(static_cast<int>(carried_columns));
  row << H(0, 0), H(1, 1), H(0, 1), std::log(F[4]), c, s;
  return row;
}

Eigen::RowVectorXd exponential(const Eigen::RowVectorXd& row) {
  const double angle = std::atan2(row[sine], row[cosine]), c = std::cos(angle), s = std::sin(angle);
  Eigen::Matrix2d H, R;
  H << row[log_11], row[log_12], row[log_12], row[log_22];
  R << c, -s, s, c;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal;
  principal.computeDirect(H);
  const Eigen::Matrix2d F = R * principal.eigenvectors() * principal.eigenvalues().array().exp().matrix().asDiagonal() *
                            principal.eigenvectors().transpose();
  Eigen::RowVectorXd result(5);
  result << F(0, 0), F(0, 1), F(1, 0), F(1, 1), std::exp(row[log_33]);
  return result;
}

}  // namespace

Matrix transfer_gauss(const mesh::Mesh& from, const Matrix& values, const mesh::Mesh& to, const GaussOptions& options,
                      const std::vector<int>& nonnegative) {
  const auto old = gauss_points(from, options.analysis), fresh = gauss_points(to, options.analysis);
  assert(values.rows() == static_cast<Eigen::Index>(old.x.size()));
  if (options.how == GaussTransfer::nearest) return picked(old, values, fresh);
  if (options.how == GaussTransfer::l2) return project({from, old}, values, {to, fresh}, options.analysis, nonnegative);
  Matrix nodal = at_nodes(from, old, values);
  Matrix result = interpolated(from, nodal, fresh);
  for (int column : nonnegative) result.col(column) = result.col(column).cwiseMax(0.0);
  return result;
}

std::vector<ElasticState> transfer_elastic(const mesh::Mesh& from, const std::vector<ElasticState>& state,
                                           const mesh::Mesh& to, const GaussOptions& options) {
  const Matrix rows = transfer_gauss(from, rows_of(state), to, options, {state_columns - 1});
  std::vector<ElasticState> result;
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    result.push_back({{rows(i, 0), rows(i, 1), rows(i, 2), rows(i, 3)}, rows(i, 4)});
  return result;
}

Matrix transfer_deformation(const mesh::Mesh& from, const Matrix& F, const mesh::Mesh& to,
                            const GaussOptions& options) {
  if (options.how == GaussTransfer::nearest) return transfer_gauss(from, F, to, options);
  Matrix old(F.rows(), static_cast<int>(carried_columns));
  for (Eigen::Index i = 0; i < F.rows(); ++i) old.row(i) = logarithm(F.row(i));
  const Matrix fresh = transfer_gauss(from, old, to, options);
  Matrix result(fresh.rows(), F.cols());
  for (Eigen::Index i = 0; i < fresh.rows(); ++i) result.row(i) = exponential(fresh.row(i));
  return result;
}

}  // namespace reye::adapt
