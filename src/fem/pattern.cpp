#include "fem/pattern.hpp"

#include <algorithm>
#include <numeric>

namespace reye::fem {

using base::SparseMatrix;

Pattern::Pattern(const mesh::Mesh& mesh) : start_{0} {
  const int count = mesh::nodes_per_cell(mesh.kind);
  std::vector<std::size_t> first(mesh.X.size() + 1, 0);  // of each node among the cells around it
  for (const auto& cell : mesh.cells)
    for (int a = 0; a < count; ++a) ++first[static_cast<std::size_t>(cell[a]) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<const mesh::Cell*> around(first.back());
  auto next = first;
  for (const auto& cell : mesh.cells)
    for (int a = 0; a < count; ++a) around[next[static_cast<std::size_t>(cell[a])]++] = &cell;
  std::vector<int> list;
  for (std::size_t node = 0; node < mesh.X.size(); ++node) {
    list.clear();
    for (auto k = first[node]; k < first[node + 1]; ++k)
      list.insert(list.end(), around[k]->begin(), around[k]->begin() + count);
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
