#include "body/solid/solid_rows.hpp"

#include <algorithm>

#include "algebra/decompose.hpp"
#include "base/errors.hpp"
#include "fem/solid/solid_stiffness.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::body {

namespace {

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

SolidRows::SolidRows(const SolidInput& input, const std::vector<SolidPlace>& places, const std::vector<int>& retained,
                     const std::vector<Driven>& driven, const Vec3& centre)
    : columns(number_columns(input, places, retained)) {
  set_retained_motion(retained);
  set_free_modes(input, places, centre);
  set_driven(input, driven);
}

void SolidRows::set_retained_motion(const std::vector<int>& retained) {
  std::vector<base::Triplet> unknown, prescribed;
  int row = 0;
  plain = true;
  for (int node : retained) {
    plain = plain && columns.dofs.special[node] < 0;
    add_point_rows(columns.dofs, node, row, columns.interior, static_cast<int>(columns.active.size()), unknown,
                   prescribed);
    row += 3;
  }
  of_unknown.resize(row, columns.unknown());
  of_unknown.setFromTriplets(unknown.begin(), unknown.end());
  of_prescribed.resize(row, static_cast<Eigen::Index>(columns.prescribed.size()));
  of_prescribed.setFromTriplets(prescribed.begin(), prescribed.end());
}

void SolidRows::set_free_modes(const SolidInput& input, const std::vector<SolidPlace>& places, const Vec3& centre) {
  const double size = mesh::box_diagonal(input.mesh->X);
  free = free_modes(held_rows(input, places, centre, true), size);
  const auto& dofs = columns.dofs;
  modes = Matrix::Zero(columns.unknown(), free.cols());
  for (int node = 0; node < input.mesh->node_count(); ++node) {
    if (dofs.count[node] == 0 || dofs.first[node] < columns.interior) continue;
    const Matrix u = modes_at(columns.points[node], centre) * free;
    const base::Mat3 basis =
        dofs.special[node] < 0 ? base::Mat3(base::Mat3::Identity()) : dofs.nodes[dofs.special[node]].basis;
    modes.middleRows(dofs.first[node] - columns.interior, dofs.count[node]) =
        basis.leftCols(dofs.count[node]).transpose() * u;
  }
  const int own = dofs.own - columns.interior;
  for (int k = 0; k < static_cast<int>(columns.active.size()); ++k) {
    const auto& [s, m, probe] = columns.active[k];
    modes.row(own + k) = row_of(input.supports[s], s, m, places[s].centre, centre).row.transpose() * free;
  }
}

void SolidRows::set_driven(const SolidInput& input, const std::vector<Driven>& driven) {
  loads.resize(driven.size());
  const bool any = !input.loads.empty();
  const base::SparseMatrix T = any ? fem::expansion(columns.dofs) : base::SparseMatrix();
  for (size_t k = 0; k < driven.size(); ++k)
    if (driven[k].load >= 0) loads[k] = T.transpose() * nodal_forces(*input.mesh, input.loads[driven[k].load]);
  const auto count = static_cast<Eigen::Index>(driven.size());
  prescribed = Matrix::Zero(static_cast<Eigen::Index>(columns.prescribed.size()), count);
  for (size_t k = 0; k < columns.prescribed.size(); ++k) {
    const auto& [s, m, probe] = columns.prescribed[k];
    const int value = probe ? -1 : driven_motion(driven, s, m);
    if (value >= 0) prescribed(static_cast<Eigen::Index>(k), value) = 1.0;
  }
  pushed = Matrix::Zero(columns.unknown(), count);
  for (int k = 0; k < static_cast<int>(columns.active.size()); ++k) {
    const int value = driven_motion(driven, columns.active[k].support, columns.active[k].motion);
    if (value >= 0) pushed(columns.dofs.own - columns.interior + k, value) = 1.0;
  }
}

base::SparseMatrix SolidRows::stiffness(const SolidInput& input) const {
  auto K = fem::upper_stiffness(*input.mesh, input.material, columns.dofs);
  for (int k = 0; k < static_cast<int>(columns.active.size()); ++k) {
    const int at = columns.dofs.own + k;
    const double spring = motion_of(input.supports[columns.active[k].support], columns.active[k].motion).stiffness;
    if (spring != 0.0) K.coeffRef(at, at) += spring;
  }
  return K;
}

std::vector<int> SolidRows::held() const {
  std::vector<int> rows;
  for (int k = 0; k < static_cast<int>(columns.prescribed.size()); ++k) rows.push_back(columns.unknown() + k);
  const auto count = modes.cols();
  if (count == 0) return rows;
  if (modes.rows() < count) throw base::SolveError("a rigid motion is free, and too few nodes are retained to hold it");
  Matrix scaled = modes;
  for (int k = 0; k < count; ++k) scaled.col(k) /= std::max(scaled.col(k).cwiseAbs().maxCoeff(), 1e-300);
  const auto [leading, lengths] = algebra::leading_columns(scaled.transpose());
  if (!(lengths[count - 1] > 1e-6 * lengths[0]))
    throw base::SolveError("a rigid motion is free, and the retained nodes do not show it");
  rows.insert(rows.end(), leading.begin(), leading.end());
  return rows;
}

}  // namespace reye::body
