#include "solver/solid/near_facets.hpp"

#include <algorithm>
#include <cmath>

namespace reye::solver {

namespace {

/// A gap is a mean with weights of both signs, and may change by more than points move.
constexpr double much = 10.0;

double largest_motion(const contact::SkinSide& side, const Vector& moved) {
  double square = 0.0;
  for (const auto& point : side.points) square = std::max(square, moved.segment<3>(3 * point.column).squaredNorm());
  return std::sqrt(square);
}

}  // namespace

std::vector<char> near_facets(const contact::SkinSetup& setup, const contact::SkinPlace& place,
                              const std::vector<contact::SkinStatus>& status, const WholeIntegrals& whole,
                              const Vector& u) {
  const Vector moved = u - whole.u;
  const double reach = much * (largest_motion(setup.secondary, moved) + largest_motion(setup.primary, moved));
  const auto near = [&](int j) {
    return place.carries[j] && (status[j] != contact::SkinStatus::open || !(whole.gap[j] > reach));
  };
  std::vector<char> marks;
  for (const auto& facet : setup.secondary.skin.facets) {
    const auto* nodes = facet.nodes.data();
    const bool linear = setup.options.dual == mortar::SkinDual::linear;  // then control points carry nothing anyway
    const bool known = std::all_of(nodes, nodes + (linear ? mesh::facet_corners(facet.kind) : facet.count()),
                                   [&](int j) { return static_cast<bool>(place.carries[j]); });
    marks.push_back(!known || std::any_of(nodes, nodes + facet.count(), near));
  }
  return marks;
}

}  // namespace reye::solver
