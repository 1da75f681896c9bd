#include "mesh/arc.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/measure.hpp"
#include "mesh/outline.hpp"

namespace reye::mesh {

namespace {

bool before(const Vec2& a, const Vec2& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); }

/// The nodes a chain may count from: its two ends, or the vertices of a ring.
std::vector<int> candidates(const Mesh& mesh, const Chain& chain) {
  if (!is_closed(chain)) return {chain.front(), chain.back()};
  std::vector<int> vertices;
  for (std::size_t i = 0; i + 1 < chain.size(); i += static_cast<std::size_t>(order(mesh.kind)))
    vertices.push_back(chain[i]);
  return vertices;
}

int chosen_origin(const Mesh& mesh, const Chain& chain) {
  const bool from_last = !is_closed(chain) && before(mesh.X[chain.back()], mesh.X[chain.front()]);
  return from_last ? chain.back() : chain.front();
}

ArcChain counted_from(const Mesh& mesh, Chain nodes, int origin) {
  ArcChain chain;
  if (is_closed(nodes)) {
    nodes.pop_back();
    std::rotate(nodes.begin(), std::find(nodes.begin(), nodes.end(), origin), nodes.end());
    nodes.push_back(origin);
  } else if (nodes.front() != origin) {
    chain.along = false;
    std::reverse(nodes.begin(), nodes.end());
  }
  chain.arc = arc_lengths(mesh.X, nodes, order(mesh.kind));
  chain.nodes = std::move(nodes);
  return chain;
}

/// The one of some nodes nearest to p.
int nearest(const Points& X, const std::vector<int>& nodes, const Vec2& p) {
  return *std::min_element(nodes.begin(), nodes.end(),
                           [&](int a, int b) { return (X[a] - p).squaredNorm() < (X[b] - p).squaredNorm(); });
}

/// Places each origin on the chain that has the nearest candidate, each chain once.
std::vector<int> placed(const Mesh& mesh, const Boundary& boundary, const Points& origins) {
  std::vector<std::vector<int>> free;
  for (const Chain& chain : boundary) free.push_back(candidates(mesh, chain));
  std::vector<int> result;
  for (const Vec2& p : origins) {
    std::size_t best = free.size();
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < free.size(); ++c) {
      if (free[c].empty()) continue;
      const double d = (mesh.X[nearest(mesh.X, free[c], p)] - p).norm();
      if (d < distance) {
        distance = d;
        best = c;
      }
    }
    if (best == free.size()) break;
    result.push_back(nearest(mesh.X, free[best], p));
    free[best].clear();
  }
  return result;
}

}  // namespace

std::vector<int> arc_origins(const Mesh& mesh, const std::string& name) {
  const auto known = mesh.arc_origin.find(name);
  if (known != mesh.arc_origin.end()) return known->second;
  std::vector<int> origins;
  for (const Chain& chain : mesh.boundaries.at(name)) origins.push_back(chosen_origin(mesh, chain));
  std::stable_sort(origins.begin(), origins.end(), [&](int a, int b) { return before(mesh.X[a], mesh.X[b]); });
  return origins;
}

std::vector<ArcChain> arc_chains(const Mesh& mesh, const std::string& name) {
  const Boundary& boundary = mesh.boundaries.at(name);
  std::vector<ArcChain> chains;
  for (int origin : arc_origins(mesh, name))
    for (const Chain& chain : boundary) {
      const auto ends = candidates(mesh, chain);
      if (std::find(ends.begin(), ends.end(), origin) != ends.end())
        chains.push_back(counted_from(mesh, chain, origin));
    }
  return chains;
}

void follow_arc_origins(Mesh& mesh, const Mesh& former) {
  for (const auto& [name, boundary] : mesh.boundaries) {
    Points origins;
    for (int node : arc_origins(former, name)) origins.push_back(former.X[node]);
    mesh.arc_origin[name] = placed(mesh, boundary, origins);
  }
}

int farthest_from(const Mesh& mesh, const Chain& ring, const Points& points) {
  const auto vertices = candidates(mesh, ring);
  const ArcChain from_first = counted_from(mesh, ring, nearest(mesh.X, vertices, points.front()));
  const double length = from_first.arc.back();
  std::vector<double> arcs;
  for (const Vec2& p : points) {
    const auto node = std::find(from_first.nodes.begin(), from_first.nodes.end(), nearest(mesh.X, vertices, p));
    arcs.push_back(from_first.arc[static_cast<std::size_t>(node - from_first.nodes.begin())]);
  }
  const double middle = amid_longest_gap(arcs, length);
  const auto at = [&](std::size_t i) { return std::abs(from_first.arc[i] - middle); };
  std::size_t best = 0;
  for (std::size_t i = 0; i < from_first.nodes.size(); i += static_cast<std::size_t>(order(mesh.kind)))
    if (at(i) < at(best)) best = i;
  return from_first.nodes[best];
}

double amid_longest_gap(std::vector<double> arcs, double length) {
  std::sort(arcs.begin(), arcs.end());
  double longest = length - (arcs.back() - arcs.front()), middle = arcs.back() + 0.5 * longest;
  for (std::size_t i = 1; i < arcs.size(); ++i)
    if (arcs[i] - arcs[i - 1] > longest) {
      longest = arcs[i] - arcs[i - 1];
      middle = 0.5 * (arcs[i] + arcs[i - 1]);
    }
  return std::fmod(middle, length);
}

}  // namespace reye::mesh
