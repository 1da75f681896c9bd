#include "adapt/shape/strip.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/quadratic_edge.hpp"

namespace reye::adapt {

namespace {

/// Bernstein functions of a, b and c at t in [0, 1], and their slopes.
std::array<double, 3> bernstein(double t) { return {(1.0 - t) * (1.0 - t), t * t, 2.0 * t * (1.0 - t)}; }
std::array<double, 3> slopes(double t) { return {-2.0 * (1.0 - t), 2.0 * t, 2.0 - 4.0 * t}; }

Vec2 combined(const std::array<double, 3>& weight, const std::array<Vec2, 3>& p) {
  return weight[0] * p[0] + weight[1] * p[1] + weight[2] * p[2];
}

/// Calls f(t, weight) at the Gauss points of [0, 1].
template <class F>
void for_each_point(F f) {
  for (const auto& [xi, weight] : mesh::edge_rule()) f(0.5 * (1.0 + xi), 0.5 * weight);
}

}  // namespace

Points control_points(const std::vector<Facet>& facets, Points X) {
  for (const auto& [a, b, c] : facets)
    if (c >= 0) X[c] = 2.0 * X[c] - 0.5 * (X[a] + X[b]);
  return X;
}

Points middle_nodes(const std::vector<Facet>& facets, Points P) {
  for (const auto& [a, b, c] : facets)
    if (c >= 0) P[c] = 0.5 * P[c] + 0.25 * (P[a] + P[b]);
  return P;
}

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
  for_each_point([&](double t, double weight_t) {
    const Vec2 x = combined(bernstein(t), facet), x_t = combined(slopes(t), facet);
    const Vec2 d = combined(bernstein(t), displacement), d_t = combined(slopes(t), displacement);
    for_each_point([&](double s, double weight_s) {
      sum += weight_t * weight_s * base::out_of_plane(analysis, (x + s * d).x()) * base::cross(x_t + s * d_t, d);
    });
  });
  return sum;
}

double strip_volume(Analysis analysis, const Points& X, const std::vector<Facet>& facets, const Points& step,
                    double factor) {
  double sum = 0.0;
  for (const auto& [a, b, c] : facets) {
    const Vec2 da = factor * step[a], db = factor * step[b];
    sum += c < 0 ? swept_volume(analysis, std::array{X[a], X[b]}, std::array{da, db})
                 : swept_volume(analysis, std::array{X[a], X[b], X[c]}, std::array<Vec2, 3>{da, db, factor * step[c]});
  }
  return sum;
}

double strip_between(Analysis analysis, const Points& before, const Points& after, const std::vector<Facet>& facets) {
  Points moved(before.size());
  for (std::size_t j = 0; j < before.size(); ++j) moved[j] = after[j] - before[j];
  return strip_volume(analysis, control_points(facets, before), facets, control_points(facets, std::move(moved)));
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

std::array<double, 3> nodal_lengths(Analysis analysis, const std::array<Vec2, 3>& facet) {
  std::array<double, 3> shares{};
  for_each_point([&](double t, double weight) {
    const auto B = bernstein(t);
    const double ds = weight * combined(slopes(t), facet).norm();
    for (std::size_t j = 0; j < 3; ++j) shares[j] += B[j] * ds * base::out_of_plane(analysis, combined(B, facet).x());
  });
  return shares;
}

}  // namespace reye::adapt
