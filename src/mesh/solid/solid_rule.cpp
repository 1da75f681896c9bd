#include <cmath>
#include <vector>

#include "mesh/solid/solid_shape.hpp"

namespace reye::mesh {

namespace {

/// Gauss points of [0, 1]: abscissa and weight, exact to degree 7.
constexpr std::array<std::array<double, 2>, 4> gauss4{{{0.0694318442029737, 0.1739274225687269},
                                                       {0.3300094782075719, 0.3260725774312731},
                                                       {0.6699905217924281, 0.3260725774312731},
                                                       {0.9305681557970263, 0.1739274225687269}}};

std::vector<SolidPoint> cube_rule() {
  const double g = 1.0 / std::sqrt(3.0);
  std::vector<SolidPoint> rule;
  for (int a = 0; a < 8; ++a) rule.push_back({g * reference_node(SolidKind::hex8, a), 1.0});
  return rule;
}

/// Four points near the corners, in their order.
std::vector<SolidPoint> tet_rule() {
  const double b = (5.0 - std::sqrt(5.0)) / 20.0;
  std::vector<SolidPoint> rule;
  for (int a = 0; a < 4; ++a)
    rule.push_back({Vec3::Constant(b) + (1.0 - 4.0 * b) * reference_node(SolidKind::tet4, a), 1.0 / 24.0});
  return rule;
}

/// The cube [0, 1]^3 folded onto the tetrahedron: x = r, y = (1 - r) s, z = (1 - r)(1 - s) t.
std::vector<SolidPoint> folded_cube() {
  std::vector<SolidPoint> rule;
  for (const auto& [r, wr] : gauss4)
    for (const auto& [s, ws] : gauss4)
      for (const auto& [t, wt] : gauss4)
        rule.push_back({{r, (1 - r) * s, (1 - r) * (1 - s) * t}, wr * ws * wt * (1 - r) * (1 - r) * (1 - s)});
  return rule;
}

std::vector<FacetPoint> folded_square() {
  std::vector<FacetPoint> rule;
  for (const auto& [r, wr] : gauss4)
    for (const auto& [s, ws] : gauss4) rule.push_back({{r, (1 - r) * s}, wr * ws * (1 - r)});
  return rule;
}

std::vector<FacetPoint> square_rule() {
  const double g = 1.0 / std::sqrt(3.0);
  std::vector<FacetPoint> rule;
  for (int a = 0; a < 4; ++a) rule.push_back({g * reference_node(FacetKind::quad4, a), 1.0});
  return rule;
}

}  // namespace

std::span<const SolidPoint> stiffness_rule(SolidKind kind) {
  static const std::vector<SolidPoint> centre{{Vec3::Constant(0.25), 1.0 / 6.0}}, four = tet_rule(),
                                                                                  eight = cube_rule();
  return kind == SolidKind::tet4 ? centre : kind == SolidKind::tet10 ? four : eight;
}

std::span<const SolidPoint> volume_rule(SolidKind kind) {
  static const std::vector<SolidPoint> four = tet_rule(), folded = folded_cube(), eight = cube_rule();
  return kind == SolidKind::tet4 ? four : kind == SolidKind::tet10 ? folded : eight;
}

std::span<const FacetPoint> area_rule(FacetKind kind) {
  static const std::vector<FacetPoint> three{
      {{1.0 / 6.0, 1.0 / 6.0}, 1.0 / 6.0}, {{2.0 / 3.0, 1.0 / 6.0}, 1.0 / 6.0}, {{1.0 / 6.0, 2.0 / 3.0}, 1.0 / 6.0}};
  static const std::vector<FacetPoint> folded = folded_square(), four = square_rule();
  return kind == FacetKind::tri3 ? three : kind == FacetKind::tri6 ? folded : four;
}

}  // namespace reye::mesh
