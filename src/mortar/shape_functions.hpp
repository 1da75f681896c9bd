#pragma once
#include <array>

/// Shape functions of facets and the quadrature rules along them.
namespace reye::mortar {

/// N_j(xi), xi in [-1, 1]: hats on a facet of two nodes; Bernstein polynomials on one of three (first, last, control
/// point): not negative, adding up to one.
template <class T>
std::array<T, 3> shape_functions(int count, const T& xi) {
  const T a = 0.5 * (1.0 - xi), b = 0.5 * (1.0 + xi);
  if (count == 2) return {a, b, T(0.0)};
  return {a * a, b * b, 2.0 * a * b};
}

/// dN_j/dxi of the Bernstein polynomials.
template <class T>
std::array<T, 3> bernstein_slopes(const T& xi) {
  const T a = 0.5 * (1.0 - xi), b = 0.5 * (1.0 + xi);
  return {-1.0 * a, b, a - b};
}

template <std::size_t n>
struct Rule {
  std::array<double, n> xi, weight;
};

/// Gauss: exact to degree 5 and 9.
inline constexpr Rule<3> gauss3{{-0.7745966692414834, 0.0, 0.7745966692414834}, {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0}};
inline constexpr Rule<5> gauss5{
    {-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831, 0.9061798459386640},
    {0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665, 0.2369268850561891}};

}  // namespace reye::mortar
