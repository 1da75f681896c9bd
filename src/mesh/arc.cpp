#include "mesh/arc.hpp"

#include <algorithm>
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
  for (std::size_t i = 0; i + 1 < chain.size(); i += static_cast<std::size_t>(order(mesh.kind))) vertices.push_back(chain[i]);
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
      if (std::find(ends.begin(), ends.end(), origin) != ends.end()) chains.push_back(counted_from(mesh, chain, origin));
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

int opposite(const Mesh& mesh, const Chain& ring, const Vec2& p) {
  const auto vertices = candidates(mesh, ring);
  const ArcChain from_p = counted_from(mesh, ring, nearest(mesh.X, vertices, p));
  const double half = 0.5 * from_p.arc.back();
  const auto at = [&](std::size_t i) { return std::abs(from_p.arc[i] - half); };
  std::size_t best = 0;
  for (std::size_t i = 0; i < from_p.nodes.size(); i += static_cast<std::size_t>(order(mesh.kind)))
    if (at(i) < at(best)) best = i;
  return from_p.nodes[best];
}

}  // namespace reye::mesh
