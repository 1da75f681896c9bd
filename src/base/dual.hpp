#pragma once
#include <array>
#include <cmath>

namespace reye::base {

/// Forward dual number: a value and its derivatives in N directions. Every operation carries the
/// exact first derivative, so a formula templated on its scalar yields its own consistent tangent.
template <int N>
struct Dual {
  double v = 0.0;
  std::array<double, N> d{};

  Dual() = default;
  Dual(double value) : v(value) {}  // NOLINT: constants mix freely with duals

  /// An independent variable: value and unit derivative in one direction.
  static Dual variable(double value, int direction) {
    Dual x(value);
    x.d[direction] = 1.0;
    return x;
  }

  friend Dual operator+(const Dual& a, const Dual& b) {
    return made(a.v + b.v, [&](int i) { return a.d[i] + b.d[i]; });
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return made(a.v - b.v, [&](int i) { return a.d[i] - b.d[i]; });
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return made(a.v * b.v, [&](int i) { return a.d[i] * b.v + a.v * b.d[i]; });
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double inverse = 1.0 / b.v, ratio = a.v * inverse;
    return made(ratio, [&](int i) { return (a.d[i] - ratio * b.d[i]) * inverse; });
  }
  friend Dual operator+(const Dual& a, double b) { return chain(a, a.v + b, 1.0); }
  friend Dual operator+(double b, const Dual& a) { return a + b; }
  friend Dual operator-(const Dual& a, double b) { return a + (-b); }
  friend Dual operator-(double b, const Dual& a) { return chain(a, b - a.v, -1.0); }
  friend Dual operator*(const Dual& a, double b) { return chain(a, a.v * b, b); }
  friend Dual operator*(double b, const Dual& a) { return a * b; }
  friend Dual operator/(const Dual& a, double b) { return a * (1.0 / b); }
  friend Dual operator-(const Dual& a) { return chain(a, -a.v, -1.0); }

  Dual& operator+=(const Dual& b) {
    v += b.v;
    for (int i = 0; i < N; ++i) d[i] += b.d[i];
    return *this;
  }
  Dual& operator-=(const Dual& b) {
    v -= b.v;
    for (int i = 0; i < N; ++i) d[i] -= b.d[i];
    return *this;
  }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend bool operator<(const Dual& a, const Dual& b) { return a.v < b.v; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.v > b.v; }

  friend Dual sqrt(const Dual& a) {
    const double root = std::sqrt(a.v);
    return chain(a, root, 0.5 / root);
  }
  friend Dual abs(const Dual& a) { return a.v < 0.0 ? -a : a; }
  friend Dual log(const Dual& a) { return chain(a, std::log(a.v), 1.0 / a.v); }
  friend Dual log1p(const Dual& a) { return chain(a, std::log1p(a.v), 1.0 / (1.0 + a.v)); }
  friend Dual exp(const Dual& a) {
    const double e = std::exp(a.v);
    return chain(a, e, e);
  }
  friend Dual expm1(const Dual& a) {
    const double e = std::expm1(a.v);
    return chain(a, e, 1.0 + e);
  }
  friend Dual sin(const Dual& a) { return chain(a, std::sin(a.v), std::cos(a.v)); }
  friend Dual cos(const Dual& a) { return chain(a, std::cos(a.v), -std::sin(a.v)); }

 private:
  /// A value and its derivatives. Nothing is copied first: numbers stored one by one and loaded as vectors stall.
  template <class Slope>
  static Dual made(double value, const Slope& slope) {
    Dual result(value);
    for (int i = 0; i < N; ++i) result.d[i] = slope(i);
    return result;
  }
  /// f(a) with f'(a.v) = slope.
  static Dual chain(const Dual& a, double value, double slope) {
    return made(value, [&](int i) { return slope * a.d[i]; });
  }
};

/// The plain value behind a scalar, for decisions that must not be differentiated.
inline double value(double x) { return x; }
template <int N>
double value(const Dual<N>& x) {
  return x.v;
}

}  // namespace reye::base
