#include "adapt/correct.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reye::adapt {

namespace {

using base::Vec2;

Points at(const Points& X, const std::vector<int>& nodes) {
  Points points;
  for (int node : nodes) points.push_back(X[node]);
  return points;
}

double length(const Points& p) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) sum += (p[i + 1] - p[i]).norm();
  return sum;
}

/// Outward unit normal times weight at every point; zero at the ends.
Points directions(const Points& p) {
  const double whole = length(p), taper = 2.0 * whole / static_cast<double>(p.size() - 1);
  Points d(p.size(), Vec2::Zero());
  double s = 0.0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    const Vec2 in = p[i] - p[i - 1], out = p[i + 1] - p[i];
    s += in.norm();
    d[i] = std::min(1.0, std::min(s, whole - s) / taper) *
           base::right_of(in / in.squaredNorm() + out / out.squaredNorm()).normalized();
  }
  return d;
}

Points moved(const Points& p, const Points& d, double by) {
  Points q = p;
  for (std::size_t i = 0; i < p.size(); ++i) q[i] += by * d[i];
  return q;
}

/// Length by which points are to be moved along d to gain `volume`.
double gain(Analysis analysis, const Points& p, const Points& d, double volume) {
  if (volume == 0.0) return 0.0;
  const double start = fan_volume(analysis, p), target = start + volume;
  double radius = 1.0;
  if (analysis == Analysis::axisymmetric) {
    radius = 0.0;
    for (const Vec2& x : p) radius += 2.0 * std::numbers::pi * x.x() / static_cast<double>(p.size());
  }
  double by = 0.0, excess = -volume, next = volume / (length(p) * radius);
  for (int i = 0; i < 30; ++i) {
    const double f = fan_volume(analysis, moved(p, d, next)) - target;
    if (!(std::abs(f) < std::abs(excess))) break;  // round-off reached
    const double slope = (f - excess) / (next - by);
    by = next;
    excess = f;
    if (f == 0.0) break;
    next = by - f / slope;
  }
  return by;
}

}  // namespace

double fan_volume(Analysis analysis, const Points& p) {
  const bool ring = analysis == Analysis::axisymmetric;
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    const double area = 0.5 * base::cross(p[i] - p[0], p[i + 1] - p[i]);
    sum += ring ? 2.0 * std::numbers::pi / 3.0 * area * (p[0].x() + p[i].x() + p[i + 1].x()) : area;
  }
  return sum;
}

Correction correct(Analysis analysis, const Points& before, const Points& after, const std::vector<EdgePair>& edges) {
  Correction c{Points(after.size(), Vec2::Zero())};
  std::vector<double> missing;
  std::size_t longest = edges.size();
  for (std::size_t k = 0; k < edges.size(); ++k) {
    missing.push_back(fan_volume(analysis, at(before, edges[k].before)) - fan_volume(analysis, at(after, edges[k].after)));
    c.residue -= missing[k];
    if (!edges[k].worn || edges[k].after.size() < 3) continue;
    if (longest == edges.size() || length(at(after, edges[k].after)) > length(at(after, edges[longest].after))) longest = k;
  }
  for (std::size_t k = 0; k < edges.size(); ++k)
    if (!edges[k].worn || edges[k].after.size() < 3) {
      (longest < edges.size() ? missing[longest] : c.left) += missing[k];
      missing[k] = 0.0;
    }
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const Points p = at(after, edges[k].after), d = directions(p);
    const double by = gain(analysis, p, d, missing[k]);
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
      c.shift[edges[k].after[i]] = by * d[i];
      c.largest_mm = std::max(c.largest_mm, (by * d[i]).norm());
    }
  }
  return c;
}

}  // namespace reye::adapt
