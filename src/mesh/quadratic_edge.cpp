#include "mesh/quadratic_edge.hpp"

#include <algorithm>
#include <cmath>

namespace reye::mesh {

Vec2 QuadraticEdge::at(double xi) const {
  return mid + 0.5 * xi * (last - first) + 0.5 * xi * xi * (first + last - 2.0 * mid);
}

Vec2 QuadraticEdge::tangent(double xi) const { return 0.5 * (last - first) + xi * (first + last - 2.0 * mid); }

/// With z = p . q/|q| + xi |q|, b = p x q/|q| and r = sqrt(z^2 + b^2) the speed is r, and its integral over z is
/// (z r + b^2 asinh(z / b)) / 2. The differences are written so that nothing cancels as |q| -> 0.
double QuadraticEdge::length(double from, double to) const {
  const Vec2 p = 0.5 * (last - first), q = first + last - 2.0 * mid;
  const double bend = q.norm();
  if (bend == 0.0) return (to - from) * p.norm();
  const double a = p.dot(q) / bend, b = base::cross(p, q) / bend;
  const double z1 = a + from * bend, z2 = a + to * bend, h = z2 - z1;
  const double r1 = std::hypot(z1, b), r2 = std::hypot(z2, b), sum = r1 + r2;
  if (h == 0.0) return 0.0;
  const double difference = 0.5 * sum + 0.5 * (z1 + z2) * (z1 + z2) / sum;  // (z2 r2 - z1 r1) / h
  double bow = 0.0;                                                         // b^2 (asinh(z2/b) - asinh(z1/b)) / h
  if (z1 * z2 > 0.0)
    bow = b * b * std::asinh(h * (z1 + z2) / (z2 * r1 + z1 * r2)) / h;
  else if (b != 0.0)
    bow = b * b * std::asinh((z2 * r1 - z1 * r2) / (b * b)) / h;
  return 0.5 * (to - from) * (difference + bow);
}

double QuadraticEdge::parameter_at(double s) const {
  const double whole = length();
  if (s <= 0.0) return -1.0;
  if (s >= whole) return 1.0;
  double low = -1.0, high = 1.0, xi = 2.0 * s / whole - 1.0;
  constexpr int most_steps = 60;  // Newton in a shrinking bracket: a handful, bisection at worst
  for (int k = 0; k < most_steps && high > low; ++k) {
    const double excess = length(-1.0, xi) - s;
    (excess > 0.0 ? high : low) = xi;
    const double newton = xi - excess / tangent(xi).norm();
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (std::abs(next - xi) <= 1e-15) return next;
    xi = next;
  }
  return xi;
}

}  // namespace reye::mesh
