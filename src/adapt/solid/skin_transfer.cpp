#include "adapt/solid/skin_transfer.hpp"

#include <algorithm>
#include <cassert>

#include "adapt/solid/skin_locator.hpp"
#include "adapt/transfer/kept_sum.hpp"
#include "mesh/solid/facet_control_points.hpp"
#include "mortar/solid/facet_functions.hpp"
#include "mortar/solid/facet_geometry.hpp"

namespace reye::adapt {

namespace {

using NodalValues = std::vector<double>;

/// The nearest places of `on` for all points of `skin`, of control points for the middle of their edge.
std::vector<SkinFoot> feet_of(const mortar::Skin& on, const mortar::Skin& skin) {
  const SkinLocator locator(on);
  std::vector<SkinFoot> feet;
  for (const Vec3& x : mesh::middle_nodes(skin.facets, skin.x)) feet.push_back(locator.nearest(x));
  return feet;
}

double value_at(const mortar::Skin& skin, const NodalValues& values, const SkinFoot& foot) {
  const auto& facet = skin.facets[foot.facet];
  const auto N = mortar::skin_functions(facet.kind, foot.xi);
  double value = 0.0;
  for (int a = 0; a < facet.count(); ++a) value += N[a] * values[facet.nodes[a]];
  return value;
}

NodalValues values_at(const mortar::Skin& from, const NodalValues& values, const mortar::Skin& to,
                      const std::vector<SkinFoot>& feet) {
  NodalValues result;
  for (const SkinFoot& foot : feet) result.push_back(value_at(from, values, foot));
  return mesh::control_points(to.facets, result);
}

/// The point of a facet whose function is largest there; of equal ones the first.
int nearest_point(const mortar::Skin& skin, const SkinFoot& foot) {
  const auto& facet = skin.facets[foot.facet];
  const Vec3 x = place_on(skin, foot.facet, foot.xi);
  int nearest = 0;
  double least = 0.0;
  for (int a = 0; a < facet.count(); ++a) {
    const Vec3 point = place_on(skin, foot.facet, mortar::reference_place(facet.kind, a));
    const double distance = (point - x).norm();
    if (a > 0 && distance >= least) continue;
    nearest = facet.nodes[a];
    least = distance;
  }
  return nearest;
}

NodalValues labels_at(const mortar::Skin& from, const NodalValues& values, const std::vector<SkinFoot>& feet) {
  NodalValues result;
  for (const SkinFoot& foot : feet) result.push_back(values[nearest_point(from, foot)]);
  return result;
}

/// Each old share given to the points of the new facet it lies on, by their functions there.
NodalValues shares_landed(const mortar::Skin& from, const NodalValues& values, const mortar::Skin& to) {
  NodalValues result(to.x.size(), 0.0);
  const auto feet = feet_of(to, from);
  for (std::size_t j = 0; j < values.size(); ++j) {
    const auto& facet = to.facets[feet[j].facet];
    const auto N = mortar::skin_functions(facet.kind, feet[j].xi);
    for (int a = 0; a < facet.count(); ++a) result[facet.nodes[a]] += N[a] * values[j];
  }
  return result;
}

NodalValues shares_at(const mortar::Skin& from, const NodalValues& values, const mortar::Skin& to,
                      const std::vector<SkinFoot>& feet) {
  const NodalValues density = densities(values, mortar::nodal_areas(from));
  NodalValues result = values_at(from, density, to, feet);
  keep_sign(result, density);
  const base::Vector area = mortar::nodal_areas(to);
  for (std::size_t k = 0; k < result.size(); ++k) result[k] *= area[static_cast<int>(k)];
  if (std::abs(total_of(values) - total_of(result)) > magnitude_of(result)) result = shares_landed(from, values, to);
  if (magnitude_of(result) > 0.0L) keep_sum(result, total_of(values));
  return result;
}

}  // namespace

SurfaceTransfer carry(const mortar::Skin& from, const std::vector<SurfaceField>& fields, const mortar::Skin& to) {
  SurfaceTransfer result;
  if (fields.empty()) return result;
  const auto feet = feet_of(from, to);
  for (const SkinFoot& foot : feet) result.largest_distance = std::max(result.largest_distance, foot.distance);
  for (const auto& [name, kind, values] : fields) {
    assert(values.size() == from.x.size());
    result.fields.push_back({name, kind,
                             kind == SurfaceKind::summed    ? shares_at(from, values, to, feet)
                             : kind == SurfaceKind::nearest ? labels_at(from, values, feet)
                                                            : values_at(from, values, to, feet)});
  }
  return result;
}

}  // namespace reye::adapt
