#pragma once
#include <array>

#include "fem/solid/solid_stiffness.hpp"
#include "support/solid_blocks.hpp"

/// What solids are condensed from in benches.
namespace reye::bench {

/// A block of hexahedra, its rigid motions held by a millionth of the diagonal, with a patch of `side` x `side` nodes
/// of its top in the last rows.
inline base::SparseMatrix patch_last(std::array<int, 3> parts, int side) {
  const auto mesh = support::block(mesh::SolidKind::hex8, parts, {1.0, 1.0, 1.0});
  base::SparseMatrix K =
      fem::upper_stiffness(mesh, material::LinearElastic{2.1e5, 0.3}, fem::plain_dofs(mesh.node_count()));
  const double mean = K.diagonal().mean();
  for (Eigen::Index i = 0; i < K.rows(); ++i) K.coeffRef(i, i) += 1e-6 * mean;
  const auto kept = [&](int node) {
    const int i = node % (parts[0] + 1), j = node / (parts[0] + 1) % (parts[1] + 1);
    const int k = node / ((parts[0] + 1) * (parts[1] + 1));
    const int first_i = (parts[0] + 1 - side) / 2, first_j = (parts[1] + 1 - side) / 2;
    return k == parts[2] && i >= first_i && i < first_i + side && j >= first_j && j < first_j + side;
  };
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> to(K.rows());
  int place = 0;
  for (const bool last : {false, true})
    for (int node = 0; node < mesh.node_count(); ++node)
      if (kept(node) == last)
        for (int c = 0; c < 3; ++c) to.indices()[3 * node + c] = place++;
  base::SparseMatrix ordered(K.rows(), K.cols());
  ordered.selfadjointView<Eigen::Upper>() = K.selfadjointView<Eigen::Upper>().twistedBy(to);
  return base::SparseMatrix(Eigen::SparseMatrix<double, Eigen::RowMajor>(ordered));  // there and back, rows are sorted
}

}  // namespace reye::bench
