#include "fem/pattern.hpp"

#include <algorithm>

namespace reye::fem {

using base::SparseMatrix;

Pattern::Pattern(const mesh::Mesh& mesh) : start_{0} {
  const int count = mesh::nodes_per_cell(mesh.kind);
  std::vector<std::vector<int>> lists(mesh.X.size());
  for (const auto& cell : mesh.cells)
    for (int a = 0; a < count; ++a) lists[cell[a]].insert(lists[cell[a]].end(), cell.begin(), cell.begin() + count);
  for (auto& list : lists) {
    std::sort(list.begin(), list.end());
    nodes_.insert(nodes_.end(), list.begin(), std::unique(list.begin(), list.end()));
    start_.push_back(static_cast<int>(nodes_.size()));
  }
}

int Pattern::position(int of, int neighbour) const {
  const auto first = nodes_.begin() + start_[of];
  return static_cast<int>(std::lower_bound(first, nodes_.begin() + start_[of + 1], neighbour) - first);
}

SparseMatrix Pattern::zero() const {
  const int n = static_cast<int>(start_.size()) - 1;
  SparseMatrix K(2 * n, 2 * n);
  K.resizeNonZeros(4 * static_cast<Eigen::Index>(nodes_.size()));
  int* outer = K.outerIndexPtr();
  int* inner = K.innerIndexPtr();
  for (int b = 0; b < n; ++b)
    for (int c = 0; c < 2; ++c) {
      int at = 4 * start_[b] + 2 * c * count(b);
      outer[2 * b + c] = at;
      for (int k = start_[b]; k < start_[b + 1]; ++k)
        for (int r = 0; r < 2; ++r) inner[at++] = 2 * nodes_[k] + r;
    }
  outer[2 * n] = 4 * static_cast<int>(nodes_.size());
  std::fill_n(K.valuePtr(), K.nonZeros(), 0.0);
  return K;
}

}  // namespace reye::fem
