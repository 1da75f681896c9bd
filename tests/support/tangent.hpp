#pragma once
#include "fem/finite.hpp"

namespace reye::support {

/// K = df/du of all cells at u, from the state before the increment, on the places of `pattern`.
inline base::SparseMatrix tangent(const mesh::Mesh& mesh, const fem::Solid& solid, const base::Vector& u,
                                  const fem::GaussState& before, const fem::Pattern& pattern) {
  auto of_cells = fem::cell_tangents(mesh);
  fem::renew(mesh, solid, u, before, {}, of_cells);
  auto K = pattern.zero();
  fem::assemble(mesh, of_cells, {}, pattern, K);
  return K;
}

}  // namespace reye::support
