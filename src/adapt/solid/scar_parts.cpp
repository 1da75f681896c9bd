#include "adapt/solid/scar_parts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "mesh/solid/solid_measure.hpp"

namespace reye::adapt {

namespace {

using base::Vec3;

/// Sizes in one part differ by this factor at most; shape below which a facet is poor, and the share of what it had at
/// birth; mean edge beyond this factor of its wish.
constexpr double like_sizes = 2.25, poor_shape = 0.5, lost_shape = 0.7, lost_size = 1.6;
constexpr std::size_t fewest_facets = 6;

double mean_edge(const Points3& X, const PatchTriangle& t) {
  return ((X[t[1]] - X[t[0]]).norm() + (X[t[2]] - X[t[1]]).norm() + (X[t[0]] - X[t[2]]).norm()) / 3.0;
}

Vec3 corner_normal(const Points3& X, const PatchTriangle& t) {
  return (X[t[1]] - X[t[0]]).cross(X[t[2]] - X[t[0]]).normalized();
}

PatchEdge patch_edge(const PatchTriangle& t, int k) { return std::minmax(t[k], t[(k + 1) % 3]); }

/// Moved facets by group and names.
std::vector<std::vector<int>> moved_surfaces(const mesh::SolidMesh& worn, const mesh::SolidMesh& born) {
  std::vector<std::vector<std::string>> names(worn.skin.size());
  for (const auto& [name, facets] : worn.faces)
    for (int f : facets) names[f].push_back(name);
  const auto moved = moved_facets(worn, born);
  std::map<std::pair<int, std::vector<std::string>>, std::vector<int>> surfaces;
  for (int f = 0; f < static_cast<int>(worn.skin.size()); ++f)
    if (moved[f]) surfaces[{worn.skin[f].group, names[f]}].push_back(f);
  std::vector<std::vector<int>> result;
  for (auto& [key, facets] : surfaces) result.push_back(std::move(facets));
  return result;
}

/// The length that edges of each facet are to have: that at birth, evened out over neighbours, or the wish.
std::map<int, double> edge_lengths(const mesh::SolidMesh& worn, const mesh::SolidMesh& born,
                                   const std::vector<int>& facets, const cad::SolidSize& wished) {
  constexpr int passes = 4;
  std::map<int, double> length;
  for (int f : facets) length[f] = mean_edge(born.X, corners_of(born.skin[f]));
  for (int pass = 0; pass < passes; ++pass) {
    std::map<int, std::pair<double, int>> at_node;
    for (int f : facets)
      for (int node : corners_of(worn.skin[f])) {
        at_node[node].first += length[f];
        ++at_node[node].second;
      }
    for (int f : facets) {
      double sum = 0.0;
      for (int node : corners_of(worn.skin[f])) sum += at_node[node].first / at_node[node].second;
      length[f] = sum / 3.0;
    }
  }
  for (int f : facets) {
    const auto t = corners_of(worn.skin[f]);
    length[f] = std::min(length[f], wished((worn.X[t[0]] + worn.X[t[1]] + worn.X[t[2]]) / 3.0));
  }
  return length;
}

std::vector<ScarPart> divided_by_size(const std::vector<int>& facets, const std::map<int, double>& length) {
  double least = length.at(facets.front());
  for (int f : facets) least = std::min(least, length.at(f));
  std::map<int, ScarPart> parts;
  for (int f : facets) {
    ScarPart& part = parts[static_cast<int>(std::log(length.at(f) / least) / std::log(like_sizes))];
    part.facets.push_back(f);
    part.length += std::log(length.at(f));
  }
  std::vector<ScarPart> result;
  for (auto& [bin, part] : parts) {
    part.length = std::exp(part.length / static_cast<double>(part.facets.size()));
    result.push_back(std::move(part));
  }
  return result;
}

/// Finds the edges that stay, and leaves out facets at those that are too long, which brings others to the border.
void settle_edges(const mesh::SolidMesh& worn, ScarPart& part) {
  const double longest = 4.0 / 3.0 * part.length, crease = std::cos(std::numbers::pi / 9.0);
  for (std::size_t before = 0; before != part.facets.size();) {
    before = part.facets.size();
    std::map<PatchEdge, std::vector<int>> at_edge;
    for (int f : part.facets)
      for (int k = 0; k < 3; ++k) at_edge[patch_edge(corners_of(worn.skin[f]), k)].push_back(f);
    part.fixed.clear();
    std::set<int> left;
    for (const auto& [edge, at] : at_edge) {
      const bool turns =
          at.size() == 2 &&
          corner_normal(worn.X, corners_of(worn.skin[at[0]])).dot(corner_normal(worn.X, corners_of(worn.skin[at[1]]))) <
              crease;
      if (at.size() == 2 && !turns) continue;
      if (turns) part.fixed.insert(edge);
      if ((worn.X[edge.first] - worn.X[edge.second]).norm() > longest) left.insert(at.begin(), at.end());
    }
    std::erase_if(part.facets, [&](int f) { return left.contains(f); });
  }
}

bool has_lost(const mesh::SolidMesh& worn, const mesh::SolidMesh& born, const ScarPart& part) {
  return std::any_of(part.facets.begin(), part.facets.end(), [&](int f) {
    const auto t = corners_of(worn.skin[f]);
    const double shape = triangle_shape(worn.X, t), size = mean_edge(worn.X, t) / mean_edge(born.X, t);
    return (shape < poor_shape && shape < lost_shape * triangle_shape(born.X, t)) || size > lost_size ||
           size < 1.0 / lost_size || mean_edge(worn.X, t) > lost_size * part.length;
  });
}

}  // namespace

PatchTriangle corners_of(const mesh::Facet& facet) { return {facet.nodes[0], facet.nodes[1], facet.nodes[2]}; }

double triangle_shape(const Points3& X, const PatchTriangle& t) {
  const Vec3 a = X[t[1]] - X[t[0]], b = X[t[2]] - X[t[0]];
  return 2.0 * std::sqrt(3.0) * a.cross(b).norm() / (a.squaredNorm() + b.squaredNorm() + (a - b).squaredNorm());
}

std::vector<char> moved_facets(const mesh::SolidMesh& worn, const mesh::SolidMesh& born) {
  std::vector<char> moved(worn.skin.size(), 0);
  for (std::size_t f = 0; f < moved.size(); ++f)
    for (int a = 0; a < worn.skin[f].count(); ++a)
      if (const int node = worn.skin[f].nodes[a]; worn.X[node] != born.X[node]) moved[f] = 1;
  return moved;
}

std::optional<FacetsPlane> plane_of(const mesh::SolidMesh& mesh, const std::vector<int>& facets) {
  FacetsPlane plane{mesh.X[mesh.skin[facets.front()].nodes[0]], Vec3::Zero()};
  for (int f : facets) plane.normal += mesh::area_vector(mesh.X, mesh.skin[f]);
  plane.normal.normalize();
  double size = 0.0, off = 0.0;
  for (int f : facets)
    for (int a = 0; a < mesh.skin[f].count(); ++a) {
      const Vec3 &x = mesh.X[mesh.skin[f].nodes[a]], d = x - plane.origin;
      size = std::max({size, d.norm(), 0.1 * x.cwiseAbs().maxCoeff()});
      off = std::max(off, std::abs(plane.normal.dot(d)));
    }
  constexpr double round_off = 1e-11;
  return off <= round_off * size ? std::optional(plane) : std::nullopt;
}

std::vector<ScarPart> scar_parts(const mesh::SolidMesh& worn, const mesh::SolidMesh& born, const cad::SolidSize& wished,
                                 bool all) {
  std::vector<ScarPart> result;
  for (const auto& facets : moved_surfaces(worn, born))
    for (ScarPart& part : divided_by_size(facets, edge_lengths(worn, born, facets, wished))) {
      settle_edges(worn, part);
      if (part.facets.size() >= fewest_facets && (all || has_lost(worn, born, part))) result.push_back(std::move(part));
    }
  return result;
}

}  // namespace reye::adapt
