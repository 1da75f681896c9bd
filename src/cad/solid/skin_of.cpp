#include "cad/solid/skin_of.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <unordered_map>

#include "base/errors.hpp"
#include "cad/solid/solid_text.hpp"

namespace reye::cad {

namespace {

using base::Vec3;
using SkinEdge = std::pair<int, int>;  ///< smaller node first

struct HashOfCorners {
  std::size_t operator()(const FacetCorners& corners) const {
    std::size_t hash = 1469598103934665603ull;
    for (int corner : corners) hash = (hash ^ static_cast<std::size_t>(corner + 1)) * 1099511628211ull;
    return hash;
  }
};

/// Corners of a cell's facets, counter-clockwise seen from outside, then mid nodes of their edges.
std::vector<mesh::Facet> facets_of_cell(mesh::SolidKind kind, const mesh::SolidCell& cell) {
  constexpr int of_tet[4][6] = {{0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {2, 0, 3, 6, 7, 9}};
  constexpr int of_hex[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::vector<mesh::Facet> facets(kind == mesh::SolidKind::hex8 ? 6 : 4);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    facets[f].kind = mesh::facet_kind(kind);
    for (int k = 0; k < facets[f].count(); ++k)
      facets[f].nodes[k] = cell[kind == mesh::SolidKind::hex8 ? of_hex[f][k] : of_tet[f][k]];
  }
  return facets;
}

/// Facets at each edge of the skin, with whether they run from its smaller node to the larger.
using EdgesOfSkin = std::map<SkinEdge, std::vector<std::pair<int, bool>>>;

EdgesOfSkin edges_of_skin(const std::vector<mesh::Facet>& skin) {
  EdgesOfSkin edges;
  for (std::size_t f = 0; f < skin.size(); ++f) {
    const int n = mesh::facet_corners(skin[f].kind);
    for (int k = 0; k < n; ++k) {
      const int a = skin[f].nodes[k], b = skin[f].nodes[(k + 1) % n];
      edges[std::minmax(a, b)].emplace_back(static_cast<int>(f), a < b);
    }
  }
  return edges;
}

void turn_facet_over(mesh::Facet& facet) {
  const int n = mesh::facet_corners(facet.kind);
  std::reverse(facet.nodes.begin(), facet.nodes.begin() + n);
  if (facet.kind == mesh::FacetKind::tri6) std::swap(facet.nodes[3], facet.nodes[4]);
}

Vec3 normal_of_facet(const Points3& X, const mesh::Facet& facet) {
  const auto& n = facet.nodes;
  if (facet.kind == mesh::FacetKind::quad4) return (X[n[2]] - X[n[0]]).cross(X[n[3]] - X[n[1]]).normalized();
  return (X[n[1]] - X[n[0]]).cross(X[n[2]] - X[n[0]]).normalized();
}

/// Joins what belongs together: `root` of two is equal when they do.
struct Joined {
  std::vector<int> parent;
  explicit Joined(std::size_t count) : parent(count) { std::iota(parent.begin(), parent.end(), 0); }
  int root(int k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  }
  void join(int a, int b) { parent[std::max(root(a), root(b))] = std::min(root(a), root(b)); }
};

/// Turns facets until neighbours run along their common edge in opposite directions. Returns the pieces of the skin.
std::vector<std::vector<int>> orient_alike(std::vector<mesh::Facet>& skin) {
  const EdgesOfSkin edges = edges_of_skin(skin);
  std::vector<std::vector<std::pair<int, bool>>> beside(skin.size());  // facet, and whether it runs the same way
  for (const auto& [edge, at] : edges) {
    const bool alike = at[0].second == at[1].second;
    beside[at[0].first].emplace_back(at[1].first, alike);
    beside[at[1].first].emplace_back(at[0].first, alike);
  }
  std::vector<char> done(skin.size(), 0), turned(skin.size(), 0);
  std::vector<std::vector<int>> pieces;
  for (int first = 0; first < static_cast<int>(skin.size()); ++first) {
    if (done[first]) continue;
    done[first] = 1;
    std::vector<int>& piece = pieces.emplace_back(1, first);
    for (std::size_t k = 0; k < piece.size(); ++k)
      for (const auto& [other, alike] : beside[piece[k]]) {
        const char wanted = static_cast<char>(turned[piece[k]] != static_cast<char>(alike));
        if (done[other] && turned[other] != wanted) throw base::MeshError("its surface has one side only");
        if (done[other]) continue;
        done[other] = 1;
        turned[other] = wanted;
        piece.push_back(other);
      }
  }
  for (std::size_t f = 0; f < skin.size(); ++f)
    if (turned[f]) turn_facet_over(skin[f]);
  return pieces;
}

/// The integrals of f(x, n dA) over a facet: at 7 points of triangles, 2 x 2 of quadrilaterals.
template <class F>
void integrate_over_facet(const Points3& X, const mesh::Facet& facet, F f) {
  const auto& n = facet.nodes;
  if (facet.kind == mesh::FacetKind::tri3)
    return f(Vec3((X[n[0]] + X[n[1]] + X[n[2]]) / 3.0), Vec3(0.5 * (X[n[1]] - X[n[0]]).cross(X[n[2]] - X[n[0]])));
  if (facet.kind == mesh::FacetKind::quad4) {
    const double g = 1.0 / std::sqrt(3.0);
    for (double r : {-g, g})
      for (double s : {-g, g}) {
        const Vec3 x = 0.25 * ((1 - r) * (1 - s) * X[n[0]] + (1 + r) * (1 - s) * X[n[1]] + (1 + r) * (1 + s) * X[n[2]] +
                               (1 - r) * (1 + s) * X[n[3]]);
        const Vec3 xr = 0.25 * ((1 - s) * (X[n[1]] - X[n[0]]) + (1 + s) * (X[n[2]] - X[n[3]]));
        const Vec3 xs = 0.25 * ((1 - r) * (X[n[3]] - X[n[0]]) + (1 + r) * (X[n[2]] - X[n[1]]));
        f(x, Vec3(xr.cross(xs)));
      }
    return;
  }
  constexpr double a = 0.059715871789770, b = 0.470142064105115, c = 0.797426985353087, d = 0.101286507323456;
  constexpr double points[7][4] = {{1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 0.225},
                                   {a, b, b, 0.132394152788506},
                                   {b, a, b, 0.132394152788506},
                                   {b, b, a, 0.132394152788506},
                                   {c, d, d, 0.125939180544827},
                                   {d, c, d, 0.125939180544827},
                                   {d, d, c, 0.125939180544827}};
  for (const auto& [l0, l1, l2, weight] : points) {
    const double N[6] = {l0 * (2 * l0 - 1), l1 * (2 * l1 - 1), l2 * (2 * l2 - 1),
                         4 * l0 * l1,       4 * l1 * l2,       4 * l2 * l0};
    const double dr[6] = {1 - 4 * l0, 4 * l1 - 1, 0, 4 * (l0 - l1), 4 * l2, -4 * l2};
    const double ds[6] = {1 - 4 * l0, 0, 4 * l2 - 1, -4 * l1, 4 * l1, 4 * (l0 - l2)};
    Vec3 x = Vec3::Zero(), xr = Vec3::Zero(), xs = Vec3::Zero();
    for (int k = 0; k < 6; ++k) x += N[k] * X[n[k]], xr += dr[k] * X[n[k]], xs += ds[k] * X[n[k]];
    f(x, Vec3(0.5 * weight * xr.cross(xs)));
  }
}

}  // namespace

FacetCorners sorted_corners(const mesh::Facet& facet) {
  FacetCorners corners{-1, -1, -1, -1};
  std::copy_n(facet.nodes.begin(), mesh::facet_corners(facet.kind), corners.begin());
  std::sort(corners.begin(), corners.end());
  return corners;
}

std::vector<mesh::Facet> skin_of_cells(const RawSolidMesh& mesh) {
  std::unordered_map<FacetCorners, int, HashOfCorners> times, groups;
  for (const mesh::Facet& facet : mesh.facets) groups[sorted_corners(facet)] = facet.group;
  for (const mesh::SolidCell& cell : mesh.cells)
    for (const mesh::Facet& facet : facets_of_cell(mesh.kind, cell))
      if (++times[sorted_corners(facet)] > 2) throw base::MeshError("three cells share a facet");
  std::vector<mesh::Facet> skin;
  for (const mesh::SolidCell& cell : mesh.cells)
    for (mesh::Facet& facet : facets_of_cell(mesh.kind, cell)) {
      const FacetCorners corners = sorted_corners(facet);
      if (times[corners] != 1) continue;
      const auto found = groups.find(corners);
      facet.group = found == groups.end() ? -1 : found->second;
      skin.push_back(facet);
    }
  return skin;
}

void check_closed(const Points3& X, const std::vector<mesh::Facet>& skin) {
  for (const auto& [edge, at] : edges_of_skin(skin)) {
    const std::string where = " round " + text(Vec3(0.5 * (X[edge.first] + X[edge.second])));
    if (at.size() == 1) throw base::MeshError("its surface has a hole" + where);
    if (at.size() != 2)
      throw base::MeshError(std::to_string(at.size()) + " of its facets meet at one edge" + where +
                            ": a solid must be as thick as a wall there, not touch itself along a line");
  }
}

void turn_outward(const Points3& X, std::vector<mesh::Facet>& skin) {
  check_closed(X, skin);
  const std::vector<std::vector<int>> pieces = orient_alike(skin);
  std::vector<std::vector<Triangle>> surfaces;
  for (const std::vector<int>& piece : pieces) {
    std::vector<mesh::Facet> own;
    for (int f : piece) own.push_back(skin[f]);
    if (enclosed_volume(X, own) < 0.0) {
      for (int f : piece) turn_facet_over(skin[f]);
      for (mesh::Facet& facet : own) turn_facet_over(facet);
    }
    surfaces.push_back(triangles_of(X, own));
  }
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    int round = 0;  // pieces that hold this one
    for (std::size_t q = 0; q < pieces.size(); ++q)
      if (p != q && winding_number(surfaces[q], surfaces[p].front()[0]) > 0.5) ++round;
    if (round % 2 == 1)
      for (int f : pieces[p]) turn_facet_over(skin[f]);
  }
}

std::vector<std::set<std::string>> group_by_angle(const RawSolidMesh& mesh, std::vector<mesh::Facet>& skin) {
  const double least_cosine = std::cos(std::numbers::pi / 6.0);
  std::vector<std::set<std::string>> names;
  Points3 normals;
  for (const mesh::Facet& facet : skin) {
    const auto found = mesh.names.find(sorted_corners(facet));
    names.push_back(found == mesh.names.end() ? std::set<std::string>{} : found->second);
    normals.push_back(normal_of_facet(mesh.nodes, facet));
  }
  Joined joined(skin.size());
  for (const auto& [edge, at] : edges_of_skin(skin)) {
    if (at.size() != 2) continue;
    const int a = at[0].first, b = at[1].first;
    if (names[a] == names[b] && normals[a].dot(normals[b]) > least_cosine) joined.join(a, b);
  }
  std::vector<std::set<std::string>> of_groups;
  std::map<int, int> number;
  for (std::size_t f = 0; f < skin.size(); ++f) {
    const auto [entry, is_new] = number.try_emplace(joined.root(static_cast<int>(f)), static_cast<int>(number.size()));
    if (is_new) of_groups.push_back(names[f]);
    skin[f].group = entry->second;
  }
  return of_groups;
}

std::set<std::pair<int, int>> smooth_joints(const Points3& X, const std::vector<mesh::Facet>& skin) {
  const double least_cosine = std::cos(std::numbers::pi * 25.0 / 180.0);
  std::map<std::pair<int, int>, std::pair<double, int>> met;  // sum of cosines, and how many
  for (const auto& [edge, at] : edges_of_skin(skin)) {
    if (at.size() != 2) continue;
    const mesh::Facet &one = skin[at[0].first], &other = skin[at[1].first];
    if (one.group == other.group) continue;
    auto& [sum, count] = met[std::minmax(one.group, other.group)];
    sum += normal_of_facet(X, one).dot(normal_of_facet(X, other));
    ++count;
  }
  std::set<std::pair<int, int>> joints;
  for (const auto& [groups, cosines] : met)
    if (cosines.first > least_cosine * cosines.second) joints.insert(groups);
  return joints;
}

std::vector<Triangle> triangles_of(const Points3& X, const std::vector<mesh::Facet>& facets) {
  constexpr int quad[2][3] = {{0, 1, 2}, {0, 2, 3}};
  constexpr int tri6[4][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
  std::vector<Triangle> triangles;
  for (const mesh::Facet& facet : facets) {
    const auto add = [&](const int(&k)[3]) {
      triangles.push_back({X[facet.nodes[k[0]]], X[facet.nodes[k[1]]], X[facet.nodes[k[2]]]});
    };
    if (facet.kind == mesh::FacetKind::tri3) add({0, 1, 2});
    if (facet.kind == mesh::FacetKind::quad4)
      for (const auto& k : quad) add(k);
    if (facet.kind == mesh::FacetKind::tri6)
      for (const auto& k : tri6) add(k);
  }
  return triangles;
}

double enclosed_volume(const Points3& X, const std::vector<mesh::Facet>& skin) {
  const Vec3 origin = X[skin.front().nodes[0]];
  double volume = 0.0;
  for (const mesh::Facet& facet : skin)
    integrate_over_facet(X, facet, [&](const Vec3& x, const Vec3& dA) { volume += (x - origin).dot(dA) / 3.0; });
  return volume;
}

double facets_area(const Points3& X, const std::vector<mesh::Facet>& skin, const std::vector<int>& which) {
  double area = 0.0;
  for (int f : which) integrate_over_facet(X, skin[f], [&](const Vec3&, const Vec3& dA) { area += dA.norm(); });
  return area;
}

}  // namespace reye::cad
