#include "adapt/shape/relocation.hpp"

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

/// The cells with straight edges between their corners.
mesh::CellKind straight(mesh::CellKind kind) {
  return mesh::corners(kind) == 3 ? mesh::CellKind::tri3 : mesh::CellKind::quad4;
}

/// int N_a,x N_b,x + N_a,y N_b,y over the cell with straight edges, without the stiffness.
CellMatrix laplacian(const mesh::Mesh& mesh, const mesh::Cell& cell) {
  CellMatrix k = CellMatrix::Zero();
  const mesh::CellKind kind = straight(mesh.kind);
  for (const auto& [xi, weight] : fem::stiffness_rule(kind)) {
    const fem::NodeGradients local = fem::shape_gradients(kind, xi);
    Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();  // dX_i / dxi_j
    for (int a = 0; a < mesh::corners(kind); ++a) jacobian += mesh.X[cell[a]] * local.row(a);
    const double det = base::cross(jacobian.col(0), jacobian.col(1));
    Eigen::Matrix2d adjugate;
    adjugate << jacobian(1, 1), -jacobian(0, 1), -jacobian(1, 0), jacobian(0, 0);
    const fem::NodeGradients gradients = local * adjugate;  // times det
    k += weight / det * gradients.lazyProduct(gradients.transpose());
  }
  return k;
}

/// The ends of the edge an inner middle node is on.
struct Middle {
  int node = -1, a = -1, b = -1;
};

/// Numbers of inner vertices and of held nodes (the outline and the vertices of points), each counted from zero.
struct Split {
  std::vector<int> number;
  std::vector<bool> held;
  std::vector<Middle> middles;  ///< inner ones, in the order of their numbers
  int inner = 0, outer = 0;
};

std::vector<Middle> inner_middles(const mesh::Mesh& mesh, const std::vector<bool>& held) {
  std::map<int, Middle> found;
  const int n = mesh::corners(mesh.kind);
  for (const auto& cell : mesh.cells)
    for (int k = n; k < mesh::nodes_per_cell(mesh.kind); ++k)
      if (!held[cell[k]]) found[cell[k]] = {cell[k], cell[k - n], cell[(k - n + 1) % n]};
  std::vector<Middle> middles;
  for (const auto& [node, middle] : found) middles.push_back(middle);
  return middles;
}

Split split(const mesh::Mesh& mesh) {
  Split s{std::vector<int>(mesh.X.size(), -1), std::vector<bool>(mesh.X.size(), false), {}};
  for (const auto& loop : mesh.outline)
    for (int node : loop) s.held[node] = true;
  for (int node : mesh.points) s.held[node] = true;
  s.middles = inner_middles(mesh, s.held);
  std::vector<bool> follows(mesh.X.size(), false);
  for (const Middle& middle : s.middles) follows[middle.node] = true;
  for (int j = 0; j < mesh.node_count(); ++j)
    if (!follows[j]) s.number[j] = s.held[j] ? s.outer++ : s.inner++;
  return s;
}

}  // namespace

struct InteriorMotion::Impl {
  Split split;
  SparseMatrix coupling;                    ///< inner x outline
  std::optional<algebra::Cholesky> factor;  ///< none without inner nodes
  mutable std::mutex solving;               ///< the factor has one workspace

  void move_vertices(Points& displacement) const {
    Matrix outer(split.outer, 2);
    for (std::size_t j = 0; j < displacement.size(); ++j)
      if (split.held[j]) outer.row(split.number[j]) = displacement[j].transpose();
    const Matrix load = -(coupling * outer);
    const std::lock_guard lock(solving);
    const Matrix inner = factor->solve(load);
    for (std::size_t j = 0; j < displacement.size(); ++j)
      if (!split.held[j] && split.number[j] >= 0) displacement[j] = inner.row(split.number[j]).transpose();
  }
};

InteriorMotion::InteriorMotion(const mesh::Mesh& born) {
  auto impl = std::make_unique<Impl>();
  impl->split = split(born);
  const auto& s = impl->split;
  const int n = mesh::corners(born.kind);
  std::vector<Triplet> inner, coupling;
  for (const auto& cell : born.cells) {
    const double stiffness = 1.0 / mesh::cell_area(born.X, straight(born.kind), cell);
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
  if (s.inner > 0) impl_->move_vertices(displacement);
  for (const auto& [node, a, b] : s.middles) displacement[node] = 0.5 * (displacement[a] + displacement[b]);
  return displacement;
}

std::shared_ptr<const InteriorMotion> RelocationCache::of(const std::shared_ptr<const mesh::Mesh>& born) {
  const std::lock_guard lock(mutex_);
  std::erase_if(entries_, [](const auto& entry) { return entry.second.born.expired(); });
  auto& entry = entries_[born.get()];
  if (!entry.motion) entry = {born, std::make_shared<const InteriorMotion>(*born)};
  return entry.motion;
}

void relocate(mesh::Mesh& mesh, const std::shared_ptr<const mesh::Mesh>& born, RelocationCache* cache) {
  RelocationCache own;
  const auto motion = (cache ? *cache : own).of(born);
  std::vector<char> outer(mesh.X.size(), 0);
  for (const auto& loop : mesh.outline)
    for (int node : loop) outer[node] = 1;
  Points displacement(mesh.X.size(), base::Vec2::Zero());
  for (std::size_t j = 0; j < outer.size(); ++j)
    if (outer[j]) displacement[j] = mesh.X[j] - born->X[j];
  displacement = motion->extend(std::move(displacement));
  for (std::size_t j = 0; j < outer.size(); ++j)
    if (!outer[j]) mesh.X[j] = born->X[j] + displacement[j];
}

}  // namespace reye::adapt
