#include "fem/solid/solid_dofs.hpp"

#include <numeric>

namespace reye::fem {

namespace {

void add_point(const SolidDofs& dofs, int node, int row_node, double weight, std::vector<base::Triplet>& entries) {
  const auto add = [&](int dof, const Vec3& direction) {
    for (int c = 0; c < 3; ++c)
      if (direction[c] != 0.0) entries.emplace_back(3 * row_node + c, dof, weight * direction[c]);
  };
  const int special = dofs.special[node];
  const Mat3 basis = special < 0 ? Mat3(Mat3::Identity()) : dofs.nodes[special].basis;
  for (int k = 0; k < dofs.count[node]; ++k) add(dofs.first[node] + k, basis.col(k));
  if (special < 0) return;
  for (const auto& [dof, direction] : dofs.nodes[special].shared) add(dofs.own + dof, direction);
}

}  // namespace

SolidDofs plain_dofs(int nodes) {
  const auto n = static_cast<size_t>(nodes);
  SolidDofs dofs{3 * nodes,
                 0,
                 std::vector<int>(n),
                 std::vector<int>(n, 3),
                 std::vector<int>(n, -1),
                 std::vector<std::array<int, 2>>(n, {-1, -1}),
                 {}};
  for (int k = 0; k < nodes; ++k) dofs.first[k] = 3 * k;
  return dofs;
}

base::SparseMatrix expansion(const SolidDofs& dofs) {
  std::vector<base::Triplet> entries;
  const int n = static_cast<int>(dofs.first.size());
  entries.reserve(static_cast<size_t>(dofs.own));
  for (int k = 0; k < n; ++k) {
    const auto& [a, b] = dofs.between[k];
    add_point(dofs, k, k, a < 0 ? 1.0 : 0.5, entries);
    for (int end : {a, b})
      if (end >= 0) add_point(dofs, end, k, 0.25, entries);
  }
  base::SparseMatrix T(3 * n, dofs.size());
  T.setFromTriplets(entries.begin(), entries.end());
  return T;
}

}  // namespace reye::fem
