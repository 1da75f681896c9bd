#include "body/solid/solid_cost.hpp"

#include "algebra/factor.hpp"
#include "algebra/factor_cost.hpp"
#include "fem/solid/solid_stiffness.hpp"

namespace reye::body {

namespace {

/// Measured on one core [flop/s]: five meshes of 66 to 292 thousand dofs within 15 per cent.
constexpr double sparse_rate = 44e9, dense_rate = 40e9;
/// What supernodes store beyond the entries of L, and the space of their update (measured with these meshes).
constexpr double supernodal_share = 1.25;

/// What the largest of several ranks keeps of the memory of one process, and they take of its time (results/ranks).
double share_of_memory(int ranks) { return ranks > 1 ? 0.36 + 0.67 / ranks : 1.0; }
double share_of_time(int ranks) { return ranks > 1 ? 0.66 + 0.62 / ranks : 1.0; }

/// Retained nodes last, in their order.
std::vector<int> places_of(int nodes, const std::vector<int>& retained) {
  std::vector<int> place(static_cast<size_t>(nodes), -1);
  const int interior = nodes - static_cast<int>(retained.size());
  for (size_t k = 0; k < retained.size(); ++k) place[retained[k]] = interior + static_cast<int>(k);
  int next = 0;
  for (int& p : place)
    if (p < 0) p = next++;
  return place;
}

}  // namespace

SolidCost solid_cost(const mesh::SolidMesh& mesh, const std::vector<int>& retained) {
  const double c = 3.0 * static_cast<double>(retained.size()), entries_per_MB = 1e6 / sizeof(double);
  if (mesh.cells.empty()) return {0.0, c * c / entries_per_MB, 0.0};
  base::SparseMatrix graph = fem::node_graph(mesh, places_of(mesh.node_count(), retained));
  const double stiffness = 9.0 * static_cast<double>(graph.nonZeros());
  const auto cost = algebra::factor_cost(std::move(graph), static_cast<int>(retained.size()), 3);
  const int ranks = algebra::ranks_of(3 * (mesh.node_count() - static_cast<int>(retained.size())));
  // S by a third of c^3, its inverse by c^3; of c x c matrices four live together.
  return {cost.entries,
          (share_of_memory(ranks) * (supernodal_share * cost.entries + 3.0 * stiffness) + 4.0 * c * c) / entries_per_MB,
          share_of_time(ranks) * cost.flops / sparse_rate + 4.0 / 3.0 * c * c * c / dense_rate, ranks};
}

}  // namespace reye::body
