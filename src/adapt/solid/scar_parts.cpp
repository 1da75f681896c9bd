#include "adapt/solid/scar_parts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

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

/// Facets of the skin by group and names.
std::vector<std::vector<int>> named_surfaces(const mesh::SolidMesh& mesh) {
  std::vector<std::vector<std::string>> names(mesh.skin.size());
  for (const auto& [name, facets] : mesh.faces)
    for (int f : facets) names[f].push_back(name);
  std::map<std::pair<int, std::vector<std::string>>, std::vector<int>> surfaces;
  for (int f = 0; f < static_cast<int>(mesh.skin.size()); ++f) surfaces[{mesh.skin[f].group, names[f]}].push_back(f);
  std::vector<std::vector<int>> result;
  for (auto& [key, facets] : surfaces) result.push_back(std::move(facets));
  return result;
}

/// How often each node is met by facets.
std::map<int, int> visits(const mesh::SolidMesh& mesh, const std::vector<int>& facets) {
  std::map<int, int> count;
  for (int f : facets)
    for (int node : corners_of(mesh.skin[f])) ++count[node];
  return count;
}

/// Whether nodes inside a surface have moved, and not on its edges alone.
bool moved_inside(const mesh::SolidMesh& worn, const mesh::SolidMesh& born, const std::map<int, int>& in_surface,
                  const std::map<int, int>& in_skin) {
  return std::any_of(in_surface.begin(), in_surface.end(), [&](const auto& entry) {
    return worn.X[entry.first] != born.X[entry.first] && entry.second == in_skin.at(entry.first);
  });
}

/// What has moved of a surface; where that is its edge alone, which has slid along a curved face, with the facets that
/// are in its way.
std::vector<int> moved_part(const mesh::SolidMesh& worn, const std::vector<char>& moved,
                            const std::vector<int>& surface, bool inside) {
  constexpr int rings_in_the_way = 3;
  std::set<int> chosen;
  for (int f : surface)
    if (moved[f]) chosen.insert(f);
  for (int ring = 0; !inside && !chosen.empty() && ring < rings_in_the_way; ++ring) {
    const auto nodes = visits(worn, {chosen.begin(), chosen.end()});
    for (int f : surface)
      for (int node : corners_of(worn.skin[f]))
        if (nodes.contains(node)) chosen.insert(f);
  }
  return {chosen.begin(), chosen.end()};
}

/// Facets of one group and one set of names; whether only the edge of that surface has moved.
struct MovedSurface {
  std::vector<int> facets;
  bool by_its_edge = false;
};

/// What of the skin may be drawn again, by group and names.
std::vector<MovedSurface> moved_surfaces(const mesh::SolidMesh& worn, const mesh::SolidMesh& born) {
  const auto moved = moved_facets(worn, born);
  std::vector<int> all(worn.skin.size());
  std::iota(all.begin(), all.end(), 0);
  const auto in_skin = visits(worn, all);
  std::vector<MovedSurface> result;
  for (const auto& surface : named_surfaces(worn)) {
    const bool inside = moved_inside(worn, born, visits(worn, surface), in_skin);
    auto facets = moved_part(worn, moved, surface, inside);
    if (!facets.empty()) result.push_back({std::move(facets), !inside});
  }
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

/// Facets at each edge of a part.
std::map<PatchEdge, std::vector<int>> facets_at_edges(const mesh::SolidMesh& worn, const std::vector<int>& facets) {
  std::map<PatchEdge, std::vector<int>> at_edge;
  for (int f : facets)
    for (int k = 0; k < 3; ++k) at_edge[patch_edge(corners_of(worn.skin[f]), k)].push_back(f);
  return at_edge;
}

/// Whether wear has left a crease between two facets: of flat ones, which are squeezed, the normals say nothing.
bool is_crease(const mesh::SolidMesh& worn, int f, int g) {
  constexpr double least_shape = 0.4;
  const double smooth = std::cos(std::numbers::pi / 9.0);
  const auto a = corners_of(worn.skin[f]), b = corners_of(worn.skin[g]);
  return corner_normal(worn.X, a).dot(corner_normal(worn.X, b)) < smooth &&
         std::min(triangle_shape(worn.X, a), triangle_shape(worn.X, b)) > least_shape;
}

/// Finds the edges that stay: those of the border, and creases. They set the length where they are longer, up to half
/// as much again; facets at those that are longer still are left out, which brings others to the border.
void settle_edges(const mesh::SolidMesh& worn, ScarPart& part) {
  constexpr double longest_edge = 4.0 / 3.0, most_growth = 1.5;
  const double most = most_growth * part.length;
  for (std::size_t before = 0; before != part.facets.size();) {
    before = part.facets.size();
    part.fixed.clear();
    std::set<int> left;
    for (const auto& [edge, at] : facets_at_edges(worn, part.facets)) {
      const bool turns = at.size() == 2 && is_crease(worn, at[0], at[1]);
      if (at.size() == 2 && !turns) continue;
      if (turns) part.fixed.insert(edge);
      const double least = (worn.X[edge.first] - worn.X[edge.second]).norm() / longest_edge;
      if (least > most)
        left.insert(at.begin(), at.end());
      else
        part.length = std::max(part.length, least);
    }
    std::erase_if(part.facets, [&](int f) { return left.contains(f); });
  }
}

/// Mean length of the edges of the border.
double border_edge(const mesh::SolidMesh& worn, const std::vector<int>& facets) {
  double sum = 0.0;
  int count = 0;
  for (const auto& [edge, at] : facets_at_edges(worn, facets))
    if (at.size() == 1) {
      sum += (worn.X[edge.first] - worn.X[edge.second]).norm();
      ++count;
    }
  return count > 0 ? sum / count : 0.0;
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
  for (const auto& [facets, by_its_edge] : moved_surfaces(worn, born))
    for (ScarPart& part : divided_by_size(facets, edge_lengths(worn, born, facets, wished))) {
      // What slides is squeezed each time: its edge, which keeps its nodes, is the measure.
      if (by_its_edge) part.length = std::max(part.length, border_edge(worn, part.facets));
      settle_edges(worn, part);
      if (part.facets.size() >= fewest_facets && (all || by_its_edge || has_lost(worn, born, part)))
        result.push_back(std::move(part));
    }
  return result;
}

}  // namespace reye::adapt
