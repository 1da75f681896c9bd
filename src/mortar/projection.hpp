#pragma once
#include <algorithm>

#include "mortar/facet.hpp"

/// Images of primary points on a secondary facet and projections of secondary points onto primary facets. Roots are
/// found in double; one Newton step in T adds their derivative.
namespace reye::mortar {

/// Coordinate on a straight facet of the image of point p along the normal field, clipped to [-1, 1]: the root of
/// cross(n(xi), p - x(xi)) = c0 + c1 xi + c2 xi^2, known to be inside when the signs at the ends differ.   (3)
template <class T>
T straight_image(const FacetInput<T>& in, const Pair<T>& p) {
  const Pair<T> nm = (in.n[0] + in.n[1]) * 0.5, nd = (in.n[1] - in.n[0]) * 0.5;
  const Pair<T> r = p - (in.x[0] + in.x[1]) * 0.5, xd = (in.x[1] - in.x[0]) * 0.5;
  const T c0 = cross(nm, r), c1 = cross(nd, r) - cross(nm, xd), c2 = -1.0 * cross(nd, xd);
  const double a = value(c0), b = value(c1), c = value(c2);
  if (a - b + c <= 0.0) return T(-1.0);
  if (a + b + c >= 0.0) return T(1.0);
  const double q = -0.5 * (b + std::copysign(std::sqrt(std::max(0.0, b * b - 4.0 * a * c)), b));
  double xi = a / q;
  if (std::abs(xi) > 1.0 && c != 0.0) xi = q / c;
  return xi - (c0 + c1 * xi + c2 * xi * xi) / (b + 2.0 * c * xi);
}

template <class T>
std::array<Pair<double>, 3> values(const std::array<Pair<T>, 3>& p) {
  std::array<Pair<double>, 3> v;
  for (std::size_t j = 0; j < 3; ++j) v[j] = {value(p[j].x), value(p[j].y)};
  return v;
}

/// Image of p on a curved facet: the root of a quartic, positive at -1 and negative at 1 when the root is inside.
/// Newton's method, held inside the bracket.   (3)
template <class T>
T curved_image(const FacetInput<T>& in, const Pair<T>& p) {
  const auto x = values(in.x), n = values(in.n);
  const Pair<double> at{value(p.x), value(p.y)};
  const auto off_normal = [&](double xi) {
    const auto N = mesh::facet_functions(LineKind::line3, xi);
    return cross(combined(3, n, N), at - combined(3, x, N));
  };
  const auto slope = [&](double xi) {
    const auto N = mesh::facet_functions(LineKind::line3, xi), d = mesh::facet_slopes(LineKind::line3, xi);
    return cross(combined(3, n, d), at - combined(3, x, N)) - cross(combined(3, n, N), combined(3, x, d));
  };
  if (off_normal(-1.0) <= 0.0) return T(-1.0);
  if (off_normal(1.0) >= 0.0) return T(1.0);
  double lo = -1.0, hi = 1.0, xi = 0.0;
  for (int round = 0; round < 60; ++round) {
    const double f = off_normal(xi);
    (f > 0.0 ? lo : hi) = xi;
    double next = xi - f / slope(xi);
    if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
    const double way = std::abs(next - xi);
    xi = next;
    if (way < 1e-14) break;
  }
  const auto N = mesh::facet_functions(LineKind::line3, xi);
  return xi - cross(combined(3, in.n, N), p - combined(3, in.x, N)) / slope(xi);
}

template <class T>
T image(const FacetInput<T>& in, const Pair<T>& p) {
  return in.kind == LineKind::line2 ? straight_image(in, p) : curved_image(in, p);
}

/// Coordinate s in [0, 1] where the line from x along n meets the curve (p_0, p_1; control point p_2): the root of
/// cross(n, p(s) - x) = c0 + c1 s + c2 s^2 that is nearer to the curve's middle.   (4)
template <class T>
T meeting(const std::array<Pair<T>, 3>& p, const Pair<T>& x, const Pair<T>& n) {
  const T c0 = cross(n, p[0] - x), c1 = cross(n, (p[2] - p[0]) * 2.0), c2 = cross(n, p[0] + p[1] - p[2] * 2.0);
  const double a = value(c0), b = value(c1), c = value(c2);
  const double q = -0.5 * (b + std::copysign(std::sqrt(std::max(0.0, b * b - 4.0 * a * c)), b));
  double s = a / q;
  if (c != 0.0 && std::abs(q / c - 0.5) < std::abs(s - 0.5)) s = q / c;
  return s - (c0 + c1 * s + c2 * s * s) / (b + 2.0 * c * s);
}

/// Projects the secondary point at xi along the normal onto primary facet `pair`.   (4)
template <class T>
Quadrature<T> project(const FacetInput<T>& in, int pair, const T& xi) {
  Quadrature<T> q;
  q.pair = pair;
  q.xi = xi;
  q.N = mesh::facet_functions(in.kind, xi);
  const Pair<T> x = combined(in.count(), in.x, q.N), n = combined(in.count(), in.n, q.N);
  const auto& [first, last, control] = in.pairs[pair];
  const Pair<T> a = in.xm[first];
  if (control < 0) {
    const Pair<T> edge = in.xm[last] - a;
    const T s = cross(n, x - a) / cross(n, edge);
    q.Nm[0] = 1.0 - s;
    q.Nm[1] = s;
    q.gap = dot(n, a + edge * s - x);
  } else {
    const std::array<Pair<T>, 3> p{a, in.xm[last], in.xm[control]};
    q.Nm = mesh::facet_functions(LineKind::line3, T(2.0 * meeting(p, x, n) - 1.0));
    q.gap = dot(n, combined(3, p, q.Nm) - x);
  }
  return q;
}

/// True when the chords of the two facets face each other: n_s . n_m < -0.1.
template <class T>
bool facing(const FacetInput<T>& in, int pair) {
  const int a = in.pairs[pair][0], b = in.pairs[pair][1];
  const double tx = value(in.x[1].x) - value(in.x[0].x), ty = value(in.x[1].y) - value(in.x[0].y);
  const double mx = value(in.xm[b].x) - value(in.xm[a].x), my = value(in.xm[b].y) - value(in.xm[a].y);
  return tx * mx + ty * my < -0.1 * std::sqrt((tx * tx + ty * ty) * (mx * mx + my * my));
}

}  // namespace reye::mortar
