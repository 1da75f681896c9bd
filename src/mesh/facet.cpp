#include "mesh/facet.hpp"

namespace reye::mesh {

namespace {

std::array<double, 3> straight_shares(const Vec2& a, const Vec2& b, base::Analysis analysis) {
  const double length = (b - a).norm();
  if (analysis != base::Analysis::axisymmetric) return {0.5 * length, 0.5 * length, 0.0};
  const double c = 2.0 * std::numbers::pi * length / 6.0;
  return {c * (2.0 * a.x() + b.x()), c * (a.x() + 2.0 * b.x()), 0.0};
}

}  // namespace

Points middle_nodes(const std::vector<LineFacet>& facets, Points P) {
  for (const auto& [a, b, c] : facets)
    if (c >= 0) P[c] = 0.5 * P[c] + 0.25 * (P[a] + P[b]);
  return P;
}

std::array<double, 3> nodal_shares(LineKind kind, const std::array<Vec2, 3>& x, base::Analysis analysis) {
  if (kind == LineKind::line2) return straight_shares(x[0], x[1], analysis);
  std::array<double, 3> shares{};
  for (const auto& [xi, weight] : gauss5) {
    const auto N = facet_functions(kind, xi), d = facet_slopes(kind, xi);
    const double length = (d[0] * x[0] + d[1] * x[1] + d[2] * x[2]).norm();
    const double r = N[0] * x[0].x() + N[1] * x[1].x() + N[2] * x[2].x();
    const double ds = weight * length * base::out_of_plane(analysis, r);
    for (std::size_t j = 0; j < 3; ++j) shares[j] += ds * N[j];
  }
  return shares;
}

}  // namespace reye::mesh
