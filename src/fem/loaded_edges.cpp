#include "fem/loaded_edges.hpp"

#include <algorithm>

#include "base/errors.hpp"
#include "fem/places.hpp"
#include "mesh/arc.hpp"
#include "mesh/facet.hpp"
#include "mesh/quadratic_edge.hpp"

namespace reye::fem {

using mesh::Chain;
using mesh::Mesh;

namespace {

/// The interval by the length from the first node of a chain that runs with the body on its left.
std::array<double, 2> along_chain(const mesh::ArcChain& chain, const BoundaryLoad& load) {
  const double total = chain.arc.back();
  const std::array<double, 2> interval = load.interval_mm.value_or(std::array<double, 2>{-1.0, total + 1.0});
  if (!chain.along) return {total - interval[1], total - interval[0]};
  return interval;
}

void add_straight(const Mesh& mesh, const Chain& chain, const std::array<double, 2>& interval,
                  std::vector<LoadedEdge>& edges) {
  double s = 0.0;
  for (size_t k = 0; k + 1 < chain.size(); ++k) {
    const double h = (mesh.X[chain[k + 1]] - mesh.X[chain[k]]).norm();
    const double a = std::clamp((interval[0] - s) / h, 0.0, 1.0), b = std::clamp((interval[1] - s) / h, 0.0, 1.0);
    if (b > a) edges.push_back({{chain[k], chain[k + 1], -1}, 2, 2.0 * a - 1.0, 2.0 * b - 1.0});
    s += h;
  }
}

void add_quadratic(const Mesh& mesh, const Chain& chain, const std::array<double, 2>& interval,
                   std::vector<LoadedEdge>& edges) {
  double s = 0.0;
  for (size_t k = 0; k + 2 < chain.size(); k += 2) {
    const mesh::QuadraticEdge edge{mesh.X[chain[k]], mesh.X[chain[k + 1]], mesh.X[chain[k + 2]]};
    const double a = edge.parameter_at(interval[0] - s), b = edge.parameter_at(interval[1] - s);
    if (b > a) edges.push_back({{chain[k], chain[k + 1], chain[k + 2]}, 3, a, b});
    s += edge.length();
  }
}

}  // namespace

std::vector<LoadedEdge> loaded_edges(const Mesh& mesh, const BoundaryLoad& load) {
  std::vector<LoadedEdge> edges;
  boundary_of(mesh, load.edge, "load." + load.name + ".edge");
  const auto add = mesh::order(mesh.kind) == 1 ? add_straight : add_quadratic;
  for (mesh::ArcChain& chain : mesh::arc_chains(mesh, load.edge)) {
    const auto interval = along_chain(chain, load);
    if (!chain.along) std::reverse(chain.nodes.begin(), chain.nodes.end());
    add(mesh, chain.nodes, interval, edges);
  }
  if (edges.empty()) throw base::InputError({{"load." + load.name + ".interval_mm", "", "meets no part of the edge"}});
  return edges;
}

std::array<EdgePoint, 5> edge_points(const LoadedEdge& edge) {
  std::array<EdgePoint, 5> points;
  const double half = 0.5 * (edge.to - edge.from);
  int k = 0;
  for (const auto& [point, share] : mesh::gauss5) {
    const double xi = 0.5 * (edge.from + edge.to) + half * point;
    EdgePoint& p = points[k++];
    p.weight = half * share;
    if (edge.count == 2) {
      p.N = {0.5 * (1.0 - xi), 0.5 * (1.0 + xi), 0.0};
      p.slope = {-0.5, 0.5, 0.0};
    } else {
      p.N = {0.5 * xi * (xi - 1.0), 1.0 - xi * xi, 0.5 * xi * (xi + 1.0)};
      p.slope = {xi - 0.5, -2.0 * xi, xi + 0.5};
    }
  }
  return points;
}

}  // namespace reye::fem
