#include "adapt/solid/redraw_skin.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "adapt/solid/keep_content.hpp"
#include "mesh/solid/facet_control_points.hpp"

namespace reye::adapt {

namespace {

/// A part of the scar as a patch of its own, with the nodes of the worn mesh that its points are.
struct NumberedPatch {
  TrianglePatch patch;
  std::vector<int> node;
};

NumberedPatch patch_of(const mesh::SolidMesh& worn, const ScarPart& part) {
  NumberedPatch result;
  std::map<int, int> place;
  for (int f : part.facets) {
    PatchTriangle triangle = corners_of(worn.skin[f]);
    for (int& corner : triangle) {
      const auto [entry, fresh] = place.try_emplace(corner, static_cast<int>(result.node.size()));
      if (fresh) {
        result.node.push_back(corner);
        result.patch.X.push_back(worn.X[corner]);
      }
      corner = entry->second;
    }
    result.patch.triangles.push_back(triangle);
  }
  for (const auto& [a, b] : part.fixed) result.patch.fixed.insert(std::minmax(place.at(a), place.at(b)));
  return result;
}

double worst_shape(const Points3& X, const std::vector<PatchTriangle>& triangles) {
  double worst = 1.0;
  for (const auto& triangle : triangles) worst = std::min(worst, triangle_shape(X, triangle));
  return worst;
}

/// Puts new points where they belong on the worn surface.
void place_new_points(const mesh::SolidMesh& worn, const Points3& control, const ScarPart& part, RemeshedPatch& made) {
  std::vector<char> movable(made.X.size(), 0);
  for (std::size_t k = 0; k < movable.size(); ++k) movable[k] = made.from[k] < 0;
  if (const auto plane = plane_of(worn, part.facets)) {
    for (std::size_t k = 0; k < movable.size(); ++k)
      if (movable[k]) made.X[k] -= plane->normal.dot(made.X[k] - plane->origin) * plane->normal;
    return;
  }
  mortar::Skin skin{{}, control};
  for (int f : part.facets) skin.facets.push_back(worn.skin[f]);
  const SkinLocator locator(skin);
  for (std::size_t k = 0; k < movable.size(); ++k)
    if (movable[k]) made.X[k] = locator.nearest(made.X[k]).at;
  if (worn.skin[part.facets.front()].kind == mesh::FacetKind::tri3)
    keep_heights(locator, made.X, made.triangles, movable);
}

/// The points of a skin under way, each node of the worn mesh once.
class SkinPoints {
 public:
  SkinPoints(const mesh::SolidMesh& worn, DrawnSkin& skin) : worn_(worn), skin_(skin), place_(worn.X.size(), -1) {}

  int old(int node) {
    if (place_[node] < 0) place_[node] = fresh(worn_.X[node], node);
    return place_[node];
  }
  int fresh(const Vec3& x, int from = -1) {
    skin_.X.push_back(x);
    skin_.from.push_back(from);
    return static_cast<int>(skin_.X.size()) - 1;
  }

 private:
  const mesh::SolidMesh& worn_;
  DrawnSkin& skin_;
  std::vector<int> place_;
};

void add_made(const RemeshedPatch& made, const std::vector<int>& node, int like, SkinPoints& points, DrawnSkin& skin) {
  std::vector<int> place;
  for (std::size_t k = 0; k < made.X.size(); ++k)
    place.push_back(made.from[k] >= 0 ? points.old(node[made.from[k]]) : points.fresh(made.X[k]));
  for (const auto& [a, b, c] : made.triangles) skin.facets.push_back({{place[a], place[b], place[c]}, like, true});
}

}  // namespace

DrawnSkin draw_skin(const mesh::SolidMesh& worn, const std::vector<ScarPart>& parts) {
  DrawnSkin skin;
  SkinPoints points(worn, skin);
  const Points3 control = mesh::control_points(worn.skin, worn.X);
  std::vector<char> replaced(worn.skin.size(), 0);
  std::vector<std::pair<const ScarPart*, std::pair<RemeshedPatch, std::vector<int>>>> drawn;
  for (const ScarPart& part : parts) {
    const auto [patch, node] = patch_of(worn, part);
    auto made = remeshed(patch, part.length);
    if (!made || made->triangles.empty()) continue;
    place_new_points(worn, control, part, *made);
    constexpr double good_enough = 0.25;
    if (worst_shape(made->X, made->triangles) < std::min(good_enough, worst_shape(patch.X, patch.triangles))) continue;
    for (int f : part.facets) replaced[f] = 1;
    drawn.push_back({&part, {std::move(*made), node}});
  }
  for (int f = 0; f < static_cast<int>(worn.skin.size()); ++f) {
    if (replaced[f]) continue;
    PatchTriangle corners = corners_of(worn.skin[f]);
    for (int& corner : corners) corner = points.old(corner);
    skin.facets.push_back({corners, f, false});
  }
  for (const auto& [part, made] : drawn) add_made(made.first, made.second, part->facets.front(), points, skin);
  return skin;
}

}  // namespace reye::adapt
