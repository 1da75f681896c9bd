#include "adapt/strip.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace reye::adapt {

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

double strip_volume(Analysis analysis, const Points& X, const std::vector<Facet>& facets, const Points& step,
                    double factor) {
  double sum = 0.0;
  for (const auto& [a, b] : facets) sum += swept_volume(analysis, {X[a], X[b]}, {factor * step[a], factor * step[b]});
  return sum;
}

double exact_factor(Analysis analysis, const Points& X, const std::vector<Facet>& facets, const Points& step,
                    double volume) {
  const auto excess = [&](double theta) { return strip_volume(analysis, X, facets, step, theta) - volume; };
  double theta = 1.0, f = excess(theta), slope = f + volume;  // the strip is nearly proportional to theta
  if (!(slope > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 30 && f != 0.0; ++i) {
    const double next = theta - f / slope, g = excess(next);
    if (!(std::abs(g) < std::abs(f))) break;  // round-off reached
    slope = (g - f) / (next - theta);
    theta = next;
    f = g;
  }
  return std::abs(f) <= 1e-12 * volume ? theta : std::numeric_limits<double>::quiet_NaN();
}

double nodal_length(Analysis analysis, const Vec2& a, const Vec2& b) {
  const double length = (b - a).norm();
  if (analysis != Analysis::axisymmetric) return 0.5 * length;
  return std::numbers::pi / 3.0 * length * (2.0 * a.x() + b.x());
}

}  // namespace reye::adapt
