#include "mesh/solid/solid_skin.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/errors.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::mesh {

namespace {

constexpr int tet_faces[4][6]{{0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {0, 3, 2, 7, 9, 6}};
constexpr int hex_faces[6][4]{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

/// A face of a cell under a key that both of its sides share.
struct Side {
  std::array<int, 4> corners;  ///< ascending
  int cell, face;
  bool operator<(const Side& other) const {
    return corners != other.corners ? corners < other.corners : cell < other.cell;
  }
};

std::vector<Side> sides_of(SolidKind kind, const std::vector<SolidCell>& cells) {
  const int faces = kind == SolidKind::hex8 ? 6 : 4, corners = kind == SolidKind::hex8 ? 4 : 3;
  std::vector<Side> sides;
  sides.reserve(cells.size() * static_cast<size_t>(faces));
  for (int c = 0; c < static_cast<int>(cells.size()); ++c)
    for (int f = 0; f < faces; ++f) {
      const Facet facet = face_of(kind, cells[c], f);
      Side side{{facet.nodes[0], facet.nodes[1], facet.nodes[2], corners == 4 ? facet.nodes[3] : -1}, c, f};
      std::sort(side.corners.begin(), side.corners.end());
      sides.push_back(side);
    }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// Unit normal in the middle of an edge of a facet.
Vec3 edge_normal(const Points3& X, const Facet& facet, int edge) {
  const int n = facet_corners(facet.kind);
  const Vec2 middle = 0.5 * (reference_node(facet.kind, edge) + reference_node(facet.kind, (edge + 1) % n));
  return normal_at(X, facet, middle).normalized();
}

int root(std::vector<int>& parent, int k) {
  while (parent[k] != k) k = parent[k] = parent[parent[k]];
  return k;
}

}  // namespace

Facet face_of(SolidKind kind, const SolidCell& cell, int f) {
  Facet facet{facet_kind(kind)};
  for (int a = 0; a < facet.count(); ++a)
    facet.nodes[a] = cell[kind == SolidKind::hex8 ? hex_faces[f][a] : tet_faces[f][a]];
  return facet;
}

std::vector<Facet> faces_of_one_cell(SolidKind kind, const std::vector<SolidCell>& cells) {
  const auto sides = sides_of(kind, cells);
  std::vector<std::pair<int, int>> single;
  for (size_t k = 0, next = 0; k < sides.size(); k = next) {
    for (next = k + 1; next < sides.size() && sides[next].corners == sides[k].corners;) ++next;
    if (next - k > 2)
      throw base::MeshError("cells " + std::to_string(sides[k].cell) + ", " + std::to_string(sides[k + 1].cell) +
                            " and " + std::to_string(sides[k + 2].cell) + " share one face");
    if (next - k == 1) single.emplace_back(sides[k].cell, sides[k].face);
  }
  std::sort(single.begin(), single.end());
  std::vector<Facet> facets;
  for (const auto& [cell, face] : single) facets.push_back(face_of(kind, cells[cell], face));
  return facets;
}

void group_by_angle(const Points3& X, std::vector<Facet>& skin, double angle) {
  std::vector<int> parent(skin.size());
  std::iota(parent.begin(), parent.end(), 0);
  std::map<std::pair<int, int>, std::pair<int, int>> met;  // directed edge: facet and its edge
  for (int f = 0; f < static_cast<int>(skin.size()); ++f)
    for (int e = 0, n = facet_corners(skin[f].kind); e < n; ++e) {
      const int a = skin[f].nodes[e], b = skin[f].nodes[(e + 1) % n];
      met[{a, b}] = {f, e};
      const auto other = met.find({b, a});
      if (other == met.end()) continue;
      const auto [g, of_g] = other->second;
      if (edge_normal(X, skin[f], e).dot(edge_normal(X, skin[g], of_g)) > std::cos(angle))
        parent[root(parent, f)] = root(parent, g);
    }
  std::map<int, int> number;
  for (int f = 0; f < static_cast<int>(skin.size()); ++f)
    skin[f].group = number.try_emplace(root(parent, f), static_cast<int>(number.size())).first->second;
}

std::vector<Facet> skin_of(const Points3& X, SolidKind kind, const std::vector<SolidCell>& cells, double angle) {
  std::vector<Facet> skin = faces_of_one_cell(kind, cells);
  group_by_angle(X, skin, angle);
  return skin;
}

}  // namespace reye::mesh
