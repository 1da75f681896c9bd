#include "body/solid/elastic_solid.hpp"

#include <cmath>

#include "algebra/decompose.hpp"
#include "base/errors.hpp"
#include "fem/solid/solid_stiffness.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::body {

/// S of the unknowns and of what is prescribed.
struct ElasticSolid::Split {
  Matrix unknown, mixed, prescribed;  ///< unknowns x unknowns, prescribed x unknowns, prescribed x prescribed
};

namespace {

/// Largest product of a diagonal entry and that of the inverse: above it the supports hold a motion by round-off alone.
constexpr double largest_condition = 1e12;

/// Puts a sparse matrix's shares of a special node, or of a plain one, for the three rows of a retained point.
void add_point_rows(const fem::SolidDofs& dofs, int node, int row, int interior, int active,
                    std::vector<base::Triplet>& unknown, std::vector<base::Triplet>& prescribed) {
  const auto add = [&](std::vector<base::Triplet>& to, int column, const Vec3& direction) {
    for (int c = 0; c < 3; ++c)
      if (direction[c] != 0.0) to.emplace_back(row + c, column, direction[c]);
  };
  const int special = dofs.special[node], own = dofs.own - interior;
  for (int k = 0; k < dofs.count[node]; ++k)
    add(unknown, dofs.first[node] + k - interior,
        special < 0 ? Vec3(Vec3::Unit(k)) : Vec3(dofs.nodes[special].basis.col(k)));
  if (special < 0) return;
  for (const auto& [dof, direction] : dofs.nodes[special].shared)
    if (dof < active)
      add(unknown, own + dof, direction);
    else
      add(prescribed, dof - active, direction);
}

}  // namespace

ElasticSolid::ElasticSolid(const SolidInput& input, const std::vector<SolidPlace>& places,
                           const std::vector<int>& retained, std::optional<algebra::SchurFactor> spare,
                           SolidMatrices& out)
    : columns_(number_columns(input, places, retained)) {
  set_retained_motion(retained);
  set_free_modes(input, places, out);
  set_loads(input, out);
  factorise(fem::upper_stiffness(*input.mesh, input.material, columns_.dofs), std::move(spare));
  set_driven(out);
  condense(input, split(input), out);
}

void ElasticSolid::factorise(base::SparseMatrix K, std::optional<algebra::SchurFactor> spare) {
  const int last = columns_.dofs.size() - columns_.interior;
  if (spare && spare->size() == K.cols() && spare->retained() == last) {
    factor_ = std::move(spare);
    factor_->refactor(K);
    return;
  }
  spare.reset();  // its memory is free before that of the other is asked for
  factor_.emplace(std::move(K), last, algebra::SchurAnalysisPtr{}, algebra::Ordering::nested_dissection);
}

void ElasticSolid::set_retained_motion(const std::vector<int>& retained) {
  std::vector<base::Triplet> unknown, prescribed;
  int row = 0;
  plain_ = true;
  for (int node : retained) {
    plain_ = plain_ && columns_.dofs.special[node] < 0;
    add_point_rows(columns_.dofs, node, row, columns_.interior, static_cast<int>(columns_.active.size()), unknown,
                   prescribed);
    row += 3;
  }
  of_unknown_.resize(row, columns_.unknown());
  of_unknown_.setFromTriplets(unknown.begin(), unknown.end());
  of_prescribed_.resize(row, static_cast<Eigen::Index>(columns_.prescribed.size()));
  of_prescribed_.setFromTriplets(prescribed.begin(), prescribed.end());
}

void ElasticSolid::set_free_modes(const SolidInput& input, const std::vector<SolidPlace>& places, SolidMatrices& out) {
  const double size = mesh::box_diagonal(input.mesh->X);
  out.modes = free_modes(held_rows(input, places, out.centre, true), size);
  const auto& dofs = columns_.dofs;
  modes_ = Matrix::Zero(columns_.unknown(), out.modes.cols());
  for (int node = 0; node < input.mesh->node_count(); ++node) {
    if (dofs.count[node] == 0 || dofs.first[node] < columns_.interior) continue;
    const Matrix u = modes_at(columns_.points[node], out.centre) * out.modes;
    const base::Mat3 basis =
        dofs.special[node] < 0 ? base::Mat3(base::Mat3::Identity()) : dofs.nodes[dofs.special[node]].basis;
    modes_.middleRows(dofs.first[node] - columns_.interior, dofs.count[node]) =
        basis.leftCols(dofs.count[node]).transpose() * u;
  }
  const int own = dofs.own - columns_.interior;
  for (int k = 0; k < static_cast<int>(columns_.active.size()); ++k) {
    const auto& [s, m, probe] = columns_.active[k];
    modes_.row(own + k) = row_of(input.supports[s], s, m, places[s].centre, out.centre).row.transpose() * out.modes;
  }
}

void ElasticSolid::set_loads(const SolidInput& input, const SolidMatrices& out) {
  loads_.resize(out.driven.size());
  const bool any = !input.loads.empty();
  const base::SparseMatrix T = any ? fem::expansion(columns_.dofs) : base::SparseMatrix();
  for (size_t k = 0; k < out.driven.size(); ++k)
    if (out.driven[k].load >= 0) loads_[k] = T.transpose() * nodal_forces(*input.mesh, input.loads[out.driven[k].load]);
}

void ElasticSolid::set_driven(SolidMatrices& out) {
  const auto driven = static_cast<Eigen::Index>(out.driven.size());
  const int unknown = columns_.unknown(), own = columns_.dofs.own - columns_.interior;
  condensed_loads_ = Matrix::Zero(columns_.dofs.size() - columns_.interior, driven);
  for (size_t k = 0; k < loads_.size(); ++k)
    if (loads_[k].size() > 0) condensed_loads_.col(static_cast<Eigen::Index>(k)) = factor_->condense(loads_[k]);
  prescribed_ = Matrix::Zero(static_cast<Eigen::Index>(columns_.prescribed.size()), driven);
  for (size_t k = 0; k < columns_.prescribed.size(); ++k) {
    const auto& [s, m, probe] = columns_.prescribed[k];
    const int value = probe ? -1 : driven_motion(out.driven, s, m);
    if (value >= 0) prescribed_(static_cast<Eigen::Index>(k), value) = 1.0;
  }
  pushed_ = condensed_loads_.topRows(unknown);
  out.B = Matrix::Zero(out.modes.cols(), driven);
  for (size_t k = 0; k < loads_.size(); ++k)
    if (loads_[k].size() > 0)
      out.B.col(static_cast<Eigen::Index>(k)) =
          out.modes.transpose() * out.load_resultant[static_cast<size_t>(out.driven[k].load)];
  for (int k = 0; k < static_cast<int>(columns_.active.size()); ++k) {
    const int value = driven_motion(out.driven, columns_.active[k].support, columns_.active[k].motion);
    if (value < 0) continue;
    pushed_(own + k, value) += 1.0;
    out.B.col(value) += modes_.row(own + k).transpose();
  }
}

ElasticSolid::Split ElasticSolid::split(const SolidInput& input) {
  const int unknown = columns_.unknown(), prescribed = static_cast<int>(columns_.prescribed.size());
  Matrix S = factor_->take_schur();
  Split result{{}, S.bottomLeftCorner(prescribed, unknown), S.bottomRightCorner(prescribed, prescribed)};
  if (prescribed == 0)
    result.unknown = std::move(S);
  else
    result.unknown = S.topLeftCorner(unknown, unknown);
  const int own = columns_.dofs.own - columns_.interior;
  for (int k = 0; k < static_cast<int>(columns_.active.size()); ++k)
    result.unknown(own + k, own + k) +=
        motion_of(input.supports[columns_.active[k].support], columns_.active[k].motion).stiffness;
  return result;
}

/// Springs as stiff as the body on as many unknowns as there are free modes, so chosen that the modes differ in them:
/// forces that are in balance with a load leave them without force.
void ElasticSolid::hold_free_modes(Matrix& S) const {
  const auto count = modes_.cols();
  if (count == 0) return;
  if (modes_.rows() < count)
    throw base::SolveError("a rigid motion is free, and too few nodes are retained to hold it");
  Matrix scaled = modes_;
  for (int k = 0; k < count; ++k) scaled.col(k) /= std::max(scaled.col(k).cwiseAbs().maxCoeff(), 1e-300);
  const auto [leading, lengths] = algebra::leading_columns(scaled.transpose());
  if (!(lengths[count - 1] > 1e-6 * lengths[0]))
    throw base::SolveError("a rigid motion is free, and the retained nodes do not show it");
  for (const int held : leading) S(held, held) *= 2.0;
}

void ElasticSolid::condense(const SolidInput& input, Split S, SolidMatrices& out) {
  hold_free_modes(S.unknown);
  const Vector diagonal = S.unknown.diagonal();
  Matrix X = std::move(S.unknown);
  if (X.rows() > 0) algebra::invert(X);
  if (X.rows() > 0 && !(X.diagonal().cwiseProduct(diagonal).maxCoeff() < largest_condition))
    throw base::SolveError("the stiffness of body \"" + input.name +
                           "\" is singular to working precision; its supports may leave a motion almost free");
  const Matrix Y = X * (pushed_ - S.mixed.transpose() * prescribed_);
  const Matrix mixed_X = S.mixed * X;
  const auto active = static_cast<Eigen::Index>(columns_.active.size());
  active_f_ = Matrix(X.bottomRows(active)) * of_unknown_.transpose();
  active_s_ = Y.bottomRows(active);
  active_a_ = modes_.bottomRows(active);
  out.U = of_unknown_ * Y + of_prescribed_ * prescribed_;
  out.A = of_unknown_ * modes_;
  const Matrix of_f = mixed_X * of_unknown_.transpose() - Matrix(of_prescribed_.transpose());
  const Matrix of_s = S.mixed * Y + S.prescribed * prescribed_ - condensed_loads_.bottomRows(prescribed_.rows());
  set_resultants(input, of_f, of_s, out);
  if (!plain_) {
    const Matrix half = of_unknown_ * X;
    out.C = half * of_unknown_.transpose();
    out.C.triangularView<Eigen::StrictlyLower>() = out.C.transpose();
  } else if (active == 0) {
    out.C = std::move(X);
  } else {
    out.C = X.topLeftCorner(of_unknown_.rows(), of_unknown_.rows());
  }
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
  for (size_t k = 0; k < columns_.prescribed.size(); ++k)
    if (columns_.prescribed[k].probe || input.supports[columns_.prescribed[k].support].rigid)
      add(columns_.prescribed[k], of_f.row(static_cast<Eigen::Index>(k)), of_s.row(static_cast<Eigen::Index>(k)));
  for (size_t k = 0; k < columns_.active.size(); ++k) {
    const auto& [s, m, probe] = columns_.active[k];
    const auto row = static_cast<Eigen::Index>(k);
    const double stiffness = motion_of(input.supports[s], m).stiffness;
    Eigen::RowVectorXd applied = -stiffness * active_s_.row(row);
    if (const int value = driven_motion(out.driven, s, m); value >= 0) applied[value] += 1.0;
    add(columns_.active[k], -stiffness * active_f_.row(row), applied);
  }
}

Points3 ElasticSolid::displacements(const SolidMatrices& matrices, const std::vector<int>& retained, const Vector& f,
                                    const Vector& s, const Vector& a) const {
  const auto& dofs = columns_.dofs;
  const int own = dofs.own - columns_.interior;
  const auto active = static_cast<Eigen::Index>(columns_.active.size());
  const Vector points = matrices.C * f + matrices.U * s + matrices.A * a;
  Vector last(dofs.size() - columns_.interior);
  for (size_t k = 0; k < retained.size(); ++k) {
    const int node = retained[k];
    const base::Mat3 basis =
        dofs.special[node] < 0 ? base::Mat3(base::Mat3::Identity()) : dofs.nodes[dofs.special[node]].basis;
    last.segment(dofs.first[node] - columns_.interior, dofs.count[node]) =
        basis.leftCols(dofs.count[node]).transpose() * points.segment<3>(3 * static_cast<Eigen::Index>(k));
  }
  last.segment(own, active) = active_f_ * f + active_s_ * s + active_a_ * a;
  last.tail(prescribed_.rows()) = prescribed_ * s;
  Vector load = Vector::Zero(dofs.size());
  for (size_t k = 0; k < loads_.size(); ++k)
    if (loads_[k].size() > 0) load += s[static_cast<Eigen::Index>(k)] * loads_[k];
  const Vector u = fem::expansion(dofs) * factor_->recover(load, last);
  Points3 nodes(dofs.first.size());
  for (size_t k = 0; k < nodes.size(); ++k) nodes[k] = u.segment<3>(3 * static_cast<Eigen::Index>(k));
  return nodes;
}

}  // namespace reye::body
