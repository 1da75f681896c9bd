#include "adapt/shape/strip.hpp"

#include <numbers>

#include "adapt/shape/exact_factor.hpp"

namespace reye::adapt {

namespace {

using mesh::LineKind;

Vec2 combined(const std::array<double, 3>& weight, const std::array<Vec2, 3>& p) {
  return weight[0] * p[0] + weight[1] * p[1] + weight[2] * p[2];
}

}  // namespace

double swept_volume(Analysis analysis, const std::array<Vec2, 2>& facet, const std::array<Vec2, 2>& displacement) {
  const auto& [a, b] = facet;
  const auto& [da, db] = displacement;
  const Vec2 e = b - a;
  const double first = 0.5 * base::cross(e, db);                           // triangle a, b, b + db
  const double second = 0.5 * (base::cross(e, da) + base::cross(db, da));  // triangle a, b + db, a + da
  if (analysis != Analysis::axisymmetric) return first + second;
  const double r = a.x() + b.x() + b.x() + db.x(), s = a.x() + b.x() + db.x() + a.x() + da.x();
  return 2.0 * std::numbers::pi / 3.0 * (first * r + second * s);  // Pappus, exact for triangles
}

double swept_volume(Analysis analysis, const std::array<Vec2, 3>& facet, const std::array<Vec2, 3>& displacement) {
  double sum = 0.0;
  for (const auto& [xi, weight] : mesh::gauss5) {
    const auto N = mesh::facet_functions(LineKind::line3, xi), slope = mesh::facet_slopes(LineKind::line3, xi);
    const Vec2 x = combined(N, facet), x_xi = combined(slope, facet);
    const Vec2 d = combined(N, displacement), d_xi = combined(slope, displacement);
    for (const auto& [eta, weight_s] : mesh::gauss5) {
      const double s = 0.5 * (1.0 + eta);
      sum += 0.5 * weight * weight_s * base::out_of_plane(analysis, (x + s * d).x()) * base::cross(x_xi + s * d_xi, d);
    }
  }
  return sum;
}

double strip_volume(Analysis analysis, const Points& X, const std::vector<LineFacet>& facets, const Points& step,
                    double factor) {
  double sum = 0.0;
  for (const auto& [a, b, c] : facets) {
    const Vec2 da = factor * step[a], db = factor * step[b];
    sum += c < 0 ? swept_volume(analysis, std::array{X[a], X[b]}, std::array{da, db})
                 : swept_volume(analysis, std::array{X[a], X[b], X[c]}, std::array<Vec2, 3>{da, db, factor * step[c]});
  }
  return sum;
}

double strip_between(Analysis analysis, const Points& before, const Points& after,
                     const std::vector<LineFacet>& facets) {
  Points moved(before.size());
  for (std::size_t j = 0; j < before.size(); ++j) moved[j] = after[j] - before[j];
  return strip_volume(analysis, mesh::control_points(facets, before), facets,
                      mesh::control_points(facets, std::move(moved)));
}

double exact_factor(Analysis analysis, const Points& X, const std::vector<LineFacet>& facets, const Points& step,
                    double volume) {
  return exact_factor(volume, [&](double theta) { return strip_volume(analysis, X, facets, step, theta); });
}

}  // namespace reye::adapt
