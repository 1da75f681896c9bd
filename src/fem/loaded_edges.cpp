#include "fem/loaded_edges.hpp"

#include <algorithm>

#include "base/errors.hpp"
#include "fem/assemble_loads.hpp"

namespace reye::fem {

using base::Vec2;
using mesh::Chain;
using mesh::Mesh;

namespace {

double length(const Mesh& mesh, const Chain& chain) {
  double sum = 0.0;
  for (size_t k = 0; k + 1 < chain.size(); ++k) sum += (mesh.X[chain[k + 1]] - mesh.X[chain[k]]).norm();
  return sum;
}

bool measured_from_end(const Mesh& mesh, const Chain& chain) {
  const Vec2 &first = mesh.X[chain.front()], &last = mesh.X[chain.back()];
  return last.x() < first.x() || (last.x() == first.x() && last.y() < first.y());
}

void add_chain(const Mesh& mesh, const Chain& chain, std::array<double, 2> interval, std::vector<LoadedEdge>& edges) {
  if (measured_from_end(mesh, chain)) {
    const double total = length(mesh, chain);
    interval = {total - interval[1], total - interval[0]};
  }
  double s = 0.0;
  for (size_t k = 0; k + 1 < chain.size(); ++k) {
    const double h = (mesh.X[chain[k + 1]] - mesh.X[chain[k]]).norm();
    const double a = std::clamp((interval[0] - s) / h, 0.0, 1.0), b = std::clamp((interval[1] - s) / h, 0.0, 1.0);
    if (b > a) edges.push_back({{chain[k], chain[k + 1], -1}, 2, 2.0 * a - 1.0, 2.0 * b - 1.0});
    s += h;
  }
}

}  // namespace

std::vector<LoadedEdge> loaded_edges(const Mesh& mesh, const BoundaryLoad& load) {
  std::vector<LoadedEdge> edges;
  for (const Chain& chain : boundary_of(mesh, load.edge, "load." + load.name + ".edge")) {
    const std::array<double, 2> whole{-1.0, length(mesh, chain) + 1.0};
    add_chain(mesh, chain, load.interval_mm.value_or(whole), edges);
  }
  if (edges.empty()) throw base::InputError({{"load." + load.name + ".interval_mm", "", "meets no part of the edge"}});
  return edges;
}

}  // namespace reye::fem
