#include "fem/solid/solid_stiffness.hpp"

#include <algorithm>

#include "algebra/product.hpp"
#include "fem/solid/solid_element.hpp"
#include "fem/solid/solid_pattern.hpp"

namespace reye::fem {

namespace {

using Local = Eigen::MatrixXd;

/// The dofs of a cell with special nodes, and L with u = L y of its nodes.
struct LocalDofs {
  std::vector<int> dofs;
  Local L;

  LocalDofs(const SolidDofs& all, const mesh::SolidCell& cell, int count) {
    for (int a = 0; a < count; ++a) add_dofs(all, cell[a]);
    L = Local::Zero(3 * count, static_cast<Eigen::Index>(dofs.size()));
    for (int a = 0; a < count; ++a) set_rows(all, cell[a], a);
    for (int m = 4; m < count; ++m) {
      if (all.between[cell[m]][0] < 0) continue;
      const auto [i, j] = mesh::edge_of(mesh::SolidKind::tet10, m - 4);
      L.middleRows<3>(3 * m) = 0.5 * L.middleRows<3>(3 * m) + 0.25 * (L.middleRows<3>(3 * i) + L.middleRows<3>(3 * j));
    }
  }

 private:
  int place(int dof) const { return static_cast<int>(std::find(dofs.begin(), dofs.end(), dof) - dofs.begin()); }

  void add_dofs(const SolidDofs& all, int node) {
    for (int k = 0; k < all.count[node]; ++k) dofs.push_back(all.first[node] + k);
    if (all.special[node] < 0) return;
    for (const auto& term : all.nodes[all.special[node]].shared)
      if (place(all.own + term.dof) == static_cast<int>(dofs.size())) dofs.push_back(all.own + term.dof);
  }

  void set_rows(const SolidDofs& all, int node, int a) {
    const int special = all.special[node];
    for (int k = 0; k < all.count[node]; ++k)
      L.block<3, 1>(3 * a, place(all.first[node] + k)) =
          special < 0 ? Vec3(Vec3::Unit(k)) : Vec3(all.nodes[special].basis.col(k));
    if (special < 0) return;
    for (const auto& [dof, direction] : all.nodes[special].shared)
      L.block<3, 1>(3 * a, place(all.own + dof)) += direction;
  }
};

/// Assembles the upper triangle; entries of shared dofs are collected apart and set at its end.
class Assembly {
 public:
  Assembly(const mesh::SolidMesh& mesh, const SolidDofs& dofs)
      : mesh_(mesh), dofs_(dofs), pattern_(mesh, dofs), K_(pattern_.zero()) {
    for (int k = 0; k < dofs.shared; ++k) shared_.emplace_back(dofs.own + k, k, 0.0);
  }

  template <class Stiffness>
  void add(int cell, Stiffness& Ke) {
    constexpr int count = Stiffness::RowsAtCompileTime / 3;
    const auto& nodes = mesh_.cells[cell];
    const bool plain = std::all_of(nodes.begin(), nodes.begin() + count,
                                   [&](int k) { return dofs_.special[k] < 0 && dofs_.between[k][0] < 0; });
    if (!plain) {
      Ke.template triangularView<Eigen::StrictlyLower>() = Ke.transpose();
      return add_special(LocalDofs(dofs_, nodes, count), Ke);
    }
    for (int b = 0; b < count; ++b)
      for (int a = 0; a <= b; ++a) pattern_.add(nodes[a], nodes[b], Ke.template block<3, 3>(3 * a, 3 * b), K_);
  }

  base::SparseMatrix take() {
    base::SparseMatrix last(dofs_.size(), dofs_.shared);
    last.setFromTriplets(shared_.begin(), shared_.end());
    const Eigen::Index before = K_.outerIndexPtr()[dofs_.own];
    K_.data().resize(before + last.nonZeros());
    std::copy_n(last.innerIndexPtr(), last.nonZeros(), K_.innerIndexPtr() + before);
    std::copy_n(last.valuePtr(), last.nonZeros(), K_.valuePtr() + before);
    for (int k = 0; k <= dofs_.shared; ++k)
      K_.outerIndexPtr()[dofs_.own + k] = static_cast<int>(before) + last.outerIndexPtr()[k];
    return std::move(K_);
  }

 private:
  void add_special(const LocalDofs& local, const Local& Ke) {
    const Local K = algebra::transposed_product(local.L, algebra::product(Ke, local.L));
    for (int j = 0; j < K.cols(); ++j)
      for (int i = 0; i <= j; ++i) {
        const auto [row, column] = std::minmax(local.dofs[i], local.dofs[j]);
        if (column < dofs_.own)
          pattern_.add(row, column, K(i, j), K_);
        else
          shared_.emplace_back(row, column - dofs_.own, K(i, j));
      }
  }

  const mesh::SolidMesh& mesh_;
  const SolidDofs& dofs_;
  SolidPattern pattern_;
  base::SparseMatrix K_;
  std::vector<base::Triplet> shared_;
};

}  // namespace

base::SparseMatrix upper_stiffness(const mesh::SolidMesh& mesh, const material::Material& material,
                                   const SolidDofs& dofs) {
  Assembly assembly(mesh, dofs);
  with_element(mesh.kind, [&]<mesh::SolidKind kind>(const SolidElement<kind>& element) {
    const CellModuli C(material, SolidElement<kind>::b_bar);
    CellGradients<kind> gradients;
    typename SolidElement<kind>::Stiffness Ke;
    for (int cell = 0; cell < mesh.cell_count(); ++cell) {
      set_gradients(element, mesh, cell, gradients);
      set_stiffness(gradients, C, Ke);
      // Blocks on the diagonal are symmetric to round-off; what stands below it there is never read.
      assembly.add(cell, Ke);
    }
  });
  return assembly.take();
}

base::SparseMatrix stiffness(const mesh::SolidMesh& mesh, const material::Material& material) {
  const base::SparseMatrix upper = upper_stiffness(mesh, material, plain_dofs(mesh.node_count()));
  return upper.selfadjointView<Eigen::Upper>();
}

base::SparseMatrix node_graph(const mesh::SolidMesh& mesh, const std::vector<int>& place) {
  SolidDofs dofs = plain_dofs(mesh.node_count());
  dofs.own = mesh.node_count();
  dofs.first = place;
  dofs.count.assign(mesh.X.size(), 1);
  base::SparseMatrix graph = SolidPattern(mesh, dofs).zero();
  graph.coeffs().setOnes();
  return graph;
}

}  // namespace reye::fem
