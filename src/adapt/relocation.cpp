#include "adapt/relocation.hpp"

#include <optional>
#include <utility>

#include "algebra/factor.hpp"
#include "base/linalg.hpp"
#include "fem/element.hpp"
#include "mesh/measure.hpp"

namespace reye::adapt {

namespace {

using base::Matrix;
using base::SparseMatrix;
using base::Triplet;
using CellMatrix = Eigen::Matrix<double, mesh::most_cell_nodes, mesh::most_cell_nodes>;

/// int N_a,x N_b,x + N_a,y N_b,y over the cell, without the stiffness.
CellMatrix laplacian(const mesh::Mesh& mesh, const mesh::Cell& cell) {
  CellMatrix k = CellMatrix::Zero();
  for (const auto& [xi, weight] : fem::stiffness_rule(mesh.kind)) {
    const fem::NodeGradients local = fem::shape_gradients(mesh.kind, xi);
    Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();  // dX_i / dxi_j
    for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a) jacobian += mesh.X[cell[a]] * local.row(a);
    const double det = base::cross(jacobian.col(0), jacobian.col(1));
    Eigen::Matrix2d adjugate;
    adjugate << jacobian(1, 1), -jacobian(0, 1), -jacobian(1, 0), jacobian(0, 0);
    const fem::NodeGradients gradients = local * adjugate;  // times det
    k += weight / det * gradients * gradients.transpose();
  }
  return k;
}

/// Numbers of inner and outline nodes, each counted from zero.
struct Split {
  std::vector<int> number;
  std::vector<bool> held;
  int inner = 0, outer = 0;
};

Split split(const mesh::Mesh& mesh) {
  Split s{std::vector<int>(mesh.X.size(), -1), std::vector<bool>(mesh.X.size(), false)};
  for (const auto& loop : mesh.outline)
    for (int node : loop) s.held[node] = true;
  for (int j = 0; j < mesh.node_count(); ++j) s.number[j] = s.held[j] ? s.outer++ : s.inner++;
  return s;
}

}  // namespace

struct InteriorMotion::Impl {
  Split split;
  SparseMatrix coupling;                    ///< inner x outline
  std::optional<algebra::Cholesky> factor;  ///< none without inner nodes
  mutable std::mutex solving;               ///< the factor has one workspace
};

InteriorMotion::InteriorMotion(const mesh::Mesh& born) {
  auto impl = std::make_unique<Impl>();
  impl->split = split(born);
  const auto& s = impl->split;
  const int n = mesh::nodes_per_cell(born.kind);
  std::vector<Triplet> inner, coupling;
  for (const auto& cell : born.cells) {
    const double stiffness = 1.0 / mesh::cell_area(born.X, born.kind, cell);
    const CellMatrix k = stiffness * laplacian(born, cell);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        if (!s.held[cell[i]])
          (s.held[cell[j]] ? coupling : inner).emplace_back(s.number[cell[i]], s.number[cell[j]], k(i, j));
  }
  SparseMatrix K(s.inner, s.inner);
  K.setFromTriplets(inner.begin(), inner.end());
  impl->coupling.resize(s.inner, s.outer);
  impl->coupling.setFromTriplets(coupling.begin(), coupling.end());
  if (s.inner > 0) impl->factor.emplace(K);
  impl_ = std::move(impl);
}

InteriorMotion::~InteriorMotion() = default;

Points InteriorMotion::extend(Points displacement) const {
  const auto& s = impl_->split;
  if (s.inner == 0) return displacement;
  Matrix outer(s.outer, 2);
  for (std::size_t j = 0; j < displacement.size(); ++j)
    if (s.held[j]) outer.row(s.number[j]) = displacement[j].transpose();
  const Matrix load = -(impl_->coupling * outer);
  const std::lock_guard lock(impl_->solving);
  const Matrix inner = impl_->factor->solve(load);
  for (std::size_t j = 0; j < displacement.size(); ++j)
    if (!s.held[j]) displacement[j] = inner.row(s.number[j]).transpose();
  return displacement;
}

std::shared_ptr<const InteriorMotion> RelocationCache::of(const std::shared_ptr<const mesh::Mesh>& born) {
  const std::lock_guard lock(mutex_);
  std::erase_if(entries_, [](const auto& entry) { return entry.second.born.expired(); });
  auto& entry = entries_[born.get()];
  if (!entry.motion) entry = {born, std::make_shared<const InteriorMotion>(*born)};
  return entry.motion;
}

}  // namespace reye::adapt
