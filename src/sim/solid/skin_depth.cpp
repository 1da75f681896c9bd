#include "sim/solid/skin_depth.hpp"

#include <algorithm>

#include "mesh/solid/facet_control_points.hpp"
#include "mortar/solid/facet_geometry.hpp"

namespace reye::sim {

namespace {

/// A depth at each point and its volume over its area, at the nodes.
std::vector<double> depths(const contact::SkinSide& side, std::vector<double> depth,
                           const std::vector<double>& volume) {
  const auto area = point_areas(side);
  for (std::size_t j = 0; j < depth.size(); ++j)
    if (area[j] > 0.0) depth[j] += volume[j] / area[j];
  return mesh::middle_nodes(side.skin.facets, depth);
}

double largest(const std::vector<double>& depth) {
  return depth.empty() ? 0.0 : std::max(0.0, *std::max_element(depth.begin(), depth.end()));
}

}  // namespace

std::vector<double> point_areas(const contact::SkinSide& side) {
  const base::Vector areas = mortar::nodal_areas(side.skin);
  return {areas.begin(), areas.end()};
}

std::vector<double> skin_depths(const contact::SkinSide& side, const std::vector<double>& removed) {
  return depths(side, std::vector<double>(removed.size(), 0.0), removed);
}

std::vector<double> worn_depths(const contact::SkinSetup& setup, const contact::SkinWear& wear, Side side) {
  return side == Side::secondary ? depths(setup.secondary, wear.moved_secondary, wear.pending_secondary)
                                 : depths(setup.primary, wear.moved_primary, wear.pending_primary);
}

double deepest_worn(const contact::SkinSetup& setup, const contact::SkinWear& wear, Side side) {
  return largest(worn_depths(setup, wear, side));
}

double deepest_of(const contact::SkinSide& side, const std::vector<double>& removed) {
  return largest(skin_depths(side, removed));
}

}  // namespace reye::sim
