#include "fem/solid/solid_pattern.hpp"

#include <algorithm>

namespace reye::fem {

namespace {

/// Cells of each node, one list after the other.
struct CellsOfNodes {
  std::vector<int> start, cells;

  explicit CellsOfNodes(const mesh::SolidMesh& mesh) : start(mesh.X.size() + 1, 0) {
    const int count = mesh::solid_nodes(mesh.kind);
    for (const auto& cell : mesh.cells)
      for (int a = 0; a < count; ++a) ++start[cell[a] + 1];
    for (size_t k = 1; k < start.size(); ++k) start[k] += start[k - 1];
    cells.resize(static_cast<size_t>(start.back()));
    std::vector<int> next(start.begin(), start.end() - 1);
    for (int c = 0; c < mesh.cell_count(); ++c)
      for (int a = 0; a < count; ++a) cells[next[mesh.cells[c][a]]++] = c;
  }
};

}  // namespace

SolidPattern::SolidPattern(const mesh::SolidMesh& mesh, const SolidDofs& dofs)
    : dofs_(dofs), owner_(static_cast<size_t>(dofs.own)), start_{0} {
  const CellsOfNodes of(mesh);
  const int n = mesh.node_count(), count = mesh::solid_nodes(mesh.kind);
  std::vector<int> seen(mesh.X.size(), -1);
  const auto before = [&](int a, int b) { return dofs.first[a] < dofs.first[b]; };
  for (int b = 0; b < n; ++b) {
    for (int k = 0; k < dofs.count[b]; ++k) owner_[dofs.first[b] + k] = b;
    for (int at = of.start[b]; dofs.count[b] > 0 && at < of.start[b + 1]; ++at)
      for (int k = 0; k < count; ++k) {
        const int a = mesh.cells[of.cells[at]][k];
        if (seen[a] == b || dofs.count[a] == 0 || before(b, a)) continue;
        seen[a] = b;
        nodes_.push_back(a);
      }
    std::sort(nodes_.begin() + start_.back(), nodes_.end(), before);
    int rows = 0;
    for (size_t k = static_cast<size_t>(start_.back()); k < nodes_.size(); ++k) {
      offset_.push_back(rows);
      rows += dofs.count[nodes_[k]];
    }
    start_.push_back(static_cast<int>(nodes_.size()));
  }
}

int SolidPattern::position(int of, int in_column) const {
  const auto first = nodes_.begin() + start_[in_column], last = nodes_.begin() + start_[in_column + 1];
  const auto found =
      std::lower_bound(first, last, dofs_.first[of], [&](int node, int dof) { return dofs_.first[node] < dof; });
  return static_cast<int>(found - nodes_.begin());
}

base::SparseMatrix SolidPattern::zero() const {
  const int n = dofs_.size();
  base::SparseMatrix K(n, n);
  int* outer = K.outerIndexPtr();
  Eigen::Index total = 0;
  for (int j = 0; j < dofs_.own; ++j) {
    outer[j] = static_cast<int>(total);
    const int b = owner_[j];
    total += offset_[start_[b + 1] - 1] + j - dofs_.first[b] + 1;
  }
  std::fill(outer + dofs_.own, outer + n + 1, static_cast<int>(total));
  K.resizeNonZeros(total);
  int* inner = K.innerIndexPtr();
  for (int j = 0; j < dofs_.own; ++j)
    for (int k = start_[owner_[j]]; k < start_[owner_[j] + 1]; ++k)
      for (int r = 0; r < dofs_.count[nodes_[k]] && dofs_.first[nodes_[k]] + r <= j; ++r)
        *inner++ = dofs_.first[nodes_[k]] + r;
  std::fill_n(K.valuePtr(), total, 0.0);
  return K;
}

}  // namespace reye::fem
