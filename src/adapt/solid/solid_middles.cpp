#include "adapt/solid/solid_middles.hpp"

#include <map>
#include <optional>

#include "adapt/solid/skin_locator.hpp"
#include "cad/solid/solid_shape.hpp"
#include "mesh/solid/facet_control_points.hpp"

namespace reye::adapt {

namespace {

PatchEdge between(int a, int b) { return std::minmax(a, b); }

/// Mid nodes of the worn skin by the corners of their edges.
std::map<PatchEdge, int> worn_middles(const mesh::SolidMesh& worn) {
  std::map<PatchEdge, int> middles;
  for (const mesh::Facet& facet : worn.skin)
    for (int e = 0; e < 3; ++e) {
      const auto [i, j] = mesh::edge_of(facet.kind, e);
      middles[between(facet.nodes[i], facet.nodes[j])] = facet.nodes[3 + e];
    }
  return middles;
}

/// The worn surface of one group, where it is not plane.
struct GroupSurface {
  mortar::Skin skin;
  std::optional<SkinLocator> locator;
};

class WornSurfaces {
 public:
  explicit WornSurfaces(const mesh::SolidMesh& worn) : worn_(worn) {}

  Vec3 beside(int group, const Vec3& p) {
    const auto [entry, is_new] = surfaces_.try_emplace(group);
    if (is_new) set(group, entry->second);
    return entry->second.locator ? entry->second.locator->nearest(p).at : p;
  }

 private:
  void set(int group, GroupSurface& surface) const {
    std::vector<int> facets;
    for (int f = 0; f < static_cast<int>(worn_.skin.size()); ++f)
      if (worn_.skin[f].group == group) facets.push_back(f);
    if (plane_of(worn_, facets)) return;
    surface.skin.x = mesh::control_points(worn_.skin, worn_.X);
    for (int f : facets) surface.skin.facets.push_back(worn_.skin[f]);
    surface.locator.emplace(surface.skin);
  }

  const mesh::SolidMesh& worn_;
  std::map<int, GroupSurface> surfaces_;
};

/// Places of mid nodes of all edges of a drawn skin, by its points.
std::map<PatchEdge, Vec3> skin_middles(const mesh::SolidMesh& mesh, const DrawnSkin& drawn,
                                       const mesh::SolidMesh& worn) {
  const auto known = worn_middles(worn);
  WornSurfaces surfaces(worn);
  std::map<PatchEdge, Vec3> places;
  for (const DrawnFacet& facet : drawn.facets)
    for (int k = 0; k < 3; ++k) {
      const int a = facet.corners[k], b = facet.corners[(k + 1) % 3];
      const auto [entry, is_new] = places.try_emplace(between(a, b));
      if (!is_new) continue;
      const auto old =
          drawn.from[a] >= 0 && drawn.from[b] >= 0 ? known.find(between(drawn.from[a], drawn.from[b])) : known.end();
      entry->second = old != known.end() ? worn.X[old->second]
                                         : surfaces.beside(worn.skin[facet.like].group, 0.5 * (mesh.X[a] + mesh.X[b]));
    }
  return places;
}

}  // namespace

void add_middles(mesh::SolidMesh& mesh, const DrawnSkin& drawn, const mesh::SolidMesh& worn) {
  const auto places = skin_middles(mesh, drawn, worn);
  std::map<PatchEdge, int> number;
  const auto middle = [&](int a, int b) {
    const auto [entry, is_new] = number.try_emplace(between(a, b), mesh.node_count());
    if (!is_new) return entry->second;
    const auto place = places.find(between(a, b));
    mesh.X.push_back(place != places.end() ? place->second : Vec3(0.5 * (mesh.X[a] + mesh.X[b])));
    return entry->second;
  };
  mesh.kind = mesh::SolidKind::tet10;
  for (mesh::SolidCell& cell : mesh.cells)
    for (int e = 0; e < 6; ++e) {
      const auto [a, b] = mesh::edge_of(mesh.kind, e);
      cell[4 + e] = middle(cell[a], cell[b]);
    }
  for (mesh::Facet& facet : mesh.skin) {
    facet.kind = mesh::FacetKind::tri6;
    for (int e = 0; e < 3; ++e) {
      const auto [a, b] = mesh::edge_of(facet.kind, e);
      facet.nodes[3 + e] = middle(facet.nodes[a], facet.nodes[b]);
    }
  }
}

int straighten_skin(mesh::SolidMesh& mesh, const std::vector<char>& fresh) {
  constexpr double least_fresh = 0.2, least_of_all = 0.05;
  if (mesh.kind != mesh::SolidKind::tet10) return 0;
  std::vector<char> is_fresh(mesh.X.size(), 0);
  for (std::size_t f = 0; f < mesh.skin.size(); ++f)
    for (int e = 0; fresh[f] && e < 3; ++e) is_fresh[mesh.skin[f].nodes[3 + e]] = 1;
  int count = 0;
  for (bool again = true; again;) {
    again = false;
    for (const mesh::SolidCell& cell : mesh.cells) {
      const double least = cad::least_jacobian(mesh.X, mesh.kind, cell);
      for (int e = 0; least < least_fresh && e < 6; ++e) {
        const auto [a, b] = mesh::edge_of(mesh.kind, e);
        const Vec3 middle = 0.5 * (mesh.X[cell[a]] + mesh.X[cell[b]]);
        Vec3& own = mesh.X[cell[4 + e]];
        const bool curved = (own - middle).norm() > 1e-9 * (mesh.X[cell[a]] - mesh.X[cell[b]]).norm();
        if (!curved || !(is_fresh[cell[4 + e]] || least < least_of_all)) continue;
        own = middle;
        again = true;
        ++count;
      }
    }
  }
  return count;
}

}  // namespace reye::adapt
