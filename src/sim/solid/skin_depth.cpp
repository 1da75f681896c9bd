#include "sim/solid/skin_depth.hpp"

#include <algorithm>

#include "mesh/solid/facet_control_points.hpp"
#include "mortar/solid/facet_geometry.hpp"

namespace reye::sim {

std::vector<double> point_areas(const contact::SkinSide& side) {
  const base::Vector areas = mortar::nodal_areas(side.skin);
  return {areas.begin(), areas.end()};
}

std::vector<double> skin_depths(const contact::SkinSide& side, const std::vector<double>& removed) {
  const auto area = point_areas(side);
  std::vector<double> depth(removed.size(), 0.0);
  for (std::size_t j = 0; j < depth.size(); ++j)
    if (area[j] > 0.0) depth[j] = removed[j] / area[j];
  return mesh::middle_nodes(side.skin.facets, depth);
}

std::vector<double> worn_depths(const contact::SkinSetup& setup, const contact::SkinWear& wear, Side side) {
  const bool secondary = side == Side::secondary;
  const auto& own = secondary ? setup.secondary : setup.primary;
  const auto& moved = secondary ? wear.moved_secondary : wear.moved_primary;
  const auto& pending = secondary ? wear.pending_secondary : wear.pending_primary;
  const auto area = point_areas(own);
  std::vector<double> depth(moved);
  for (std::size_t j = 0; j < depth.size(); ++j)
    if (area[j] > 0.0) depth[j] += pending[j] / area[j];
  return mesh::middle_nodes(own.skin.facets, depth);
}

double deepest_worn(const contact::SkinSetup& setup, const contact::SkinWear& wear, Side side) {
  const auto depth = worn_depths(setup, wear, side);
  return depth.empty() ? 0.0 : std::max(0.0, *std::max_element(depth.begin(), depth.end()));
}

double deepest_of(const contact::SkinSide& side, const std::vector<double>& removed) {
  const auto depth = skin_depths(side, removed);
  return depth.empty() ? 0.0 : std::max(0.0, *std::max_element(depth.begin(), depth.end()));
}

}  // namespace reye::sim
