#include "mortar/solid/skin_pairs.hpp"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mortar/solid/facet_geometry.hpp"

namespace reye::mortar {

namespace {

using SkinBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

/// A turn [rad] of a secondary facet that the pairs allow for.
constexpr double allowed_turn = 0.1;

/// The box round the points of a facet, which holds the facet, since its shape functions are never negative.
SkinBox box_round(const Skin& skin, int f, const Vec3& wider) {
  const auto& facet = skin.facets[f];
  Vec3 lo = skin.x[facet.nodes[0]], hi = lo;
  for (int j = 1; j < facet.count(); ++j) {
    lo = lo.cwiseMin(skin.x[facet.nodes[j]]);
    hi = hi.cwiseMax(skin.x[facet.nodes[j]]);
  }
  lo -= wider;
  hi += wider;
  return {CGAL::Bbox_3(lo.x(), lo.y(), lo.z(), hi.x(), hi.y(), hi.z()), f};
}

/// Boxes that reach by the search distance along the normals, and by the margin.
std::vector<SkinBox> reaching_boxes(const SkinPairs& pairs) {
  std::vector<SkinBox> result;
  result.reserve(pairs.secondary.facets.size());
  for (int f = 0; f < static_cast<int>(pairs.secondary.facets.size()); ++f) {
    const Vec3 along = (pairs.normals[f].cwiseAbs().array() + allowed_turn).min(1.0);
    result.push_back(box_round(pairs.secondary, f, (pairs.search_mm * along.array() + pairs.reach_mm).matrix()));
  }
  return result;
}

std::vector<SkinBox> plain_boxes(const Skin& skin) {
  std::vector<SkinBox> result;
  result.reserve(skin.facets.size());
  for (int f = 0; f < static_cast<int>(skin.facets.size()); ++f) result.push_back(box_round(skin, f, Vec3::Zero()));
  return result;
}

double mean_size(const Skin& skin) {
  double sum = 0.0;
  for (const auto& facet : skin.facets) sum += (skin.x[facet.nodes[2]] - skin.x[facet.nodes[0]]).norm();
  return skin.facets.empty() ? 0.0 : sum / static_cast<double>(skin.facets.size());
}

bool same_facets(const Skin& a, const Skin& b) {
  return a.x.size() == b.x.size() &&
         std::equal(a.facets.begin(), a.facets.end(), b.facets.begin(), b.facets.end(),
                    [](const mesh::Facet& f, const mesh::Facet& g) { return f.kind == g.kind && f.nodes == g.nodes; });
}

/// The largest distance of a point from where it was.
double largest_motion(const Points3& a, const Points3& b) {
  double square = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) square = std::max(square, (a[i] - b[i]).squaredNorm());
  return std::sqrt(square);
}

}  // namespace

void find_pairs(const Skin& secondary, const Skin& primary, double search_mm, SkinPairs& pairs) {
  pairs.search_mm = search_mm;
  pairs.reach_mm = pairs.margin_mm > 0.0 ? pairs.margin_mm : 0.5 * mean_size(secondary);
  pairs.secondary = secondary;
  pairs.primary = primary;
  pairs.normals = facet_normals(secondary);
  auto near = reaching_boxes(pairs), others = plain_boxes(primary);
  std::vector<std::array<int, 2>> found;
  CGAL::box_intersection_d(near.begin(), near.end(), others.begin(), others.end(),
                           [&](const SkinBox& a, const SkinBox& b) {
                             found.push_back({a.info(), b.info()});
                           });
  std::sort(found.begin(), found.end());
  pairs.first.assign(secondary.facets.size() + 1, 0);
  pairs.opposite.clear();
  pairs.blocks.clear();
  for (const auto& [f, other] : found) {
    ++pairs.first[f + 1];
    pairs.opposite.push_back(other);
  }
  for (std::size_t f = 0; f < secondary.facets.size(); ++f) pairs.first[f + 1] += pairs.first[f];
}

bool pairs_hold(const SkinPairs& pairs, const Skin& secondary, const Skin& primary, double search_mm) {
  if (pairs.first.size() != secondary.facets.size() + 1 || search_mm > pairs.search_mm) return false;
  if (!same_facets(pairs.secondary, secondary) || !same_facets(pairs.primary, primary)) return false;
  const Points3 normals = facet_normals(secondary);
  return largest_motion(pairs.normals, normals) <= allowed_turn &&
         largest_motion(pairs.secondary.x, secondary.x) + largest_motion(pairs.primary.x, primary.x) <= pairs.reach_mm;
}

}  // namespace reye::mortar
