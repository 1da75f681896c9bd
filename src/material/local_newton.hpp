#pragma once
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "base/dual.hpp"
#include "base/errors.hpp"

/// Local scalar equations inside a stress function: solved in double, differentiated by one more step in T.
namespace reye::material {

/// The search for a root: the first guess and bounds that enclose it.
struct Search {
  double start, low, high;
};

/// A root and the slope of the function there.
struct Root {
  double x, slope;
};

/// Root of f, negative below and positive above it; f maps Dual<1> to Dual<1>. Newton steps, each halving of the
/// bracket in their place when they leave it, shrink too slowly or have no finite slope. Empty when f is not finite or
/// nothing is found: the bounds do not hold a root.
template <class F>
std::optional<Root> root(const F& f, Search s) {
  double x = s.start, last_step = s.high - s.low, step_before = last_step;
  for (int i = 0; i < 200; ++i) {
    const base::Dual<1> r = f(base::Dual<1>::variable(x, 0));
    if (!std::isfinite(r.v)) return std::nullopt;
    const double slope = r.d[0], newton = x - r.v / slope;
    (r.v < 0.0 ? s.low : s.high) = x;
    const bool good = std::isfinite(slope) && newton >= s.low && newton <= s.high &&
                      std::abs(newton - x) <= 0.5 * std::abs(step_before);
    const double next = good ? newton : 0.5 * (s.low + s.high);
    step_before = last_step;
    last_step = next - x;
    if (good && std::abs(last_step) <= 1e-12 * std::abs(x) + 1e-14) return Root{x, slope};
    x = next;
  }
  return std::nullopt;
}

/// Numbers as constants of another scalar.
template <class S, class T, std::size_t n>
std::array<S, n> lifted(const std::array<T, n>& numbers) {
  std::array<S, n> result;
  for (std::size_t i = 0; i < n; ++i) result[i] = S(base::value(numbers[i]));
  return result;
}

/// x(a) with f(a, x) = 0 and its exact derivative in a: x0 in double, then x = x0 - f(a, x0) / f_x(x0) in T.
/// f(a, x) takes any scalar; `what` names the unknown and `a` in the message.
/// Throws base::SolveError when there is no root within the bounds of the search.
template <class T, std::size_t n, class F>
T solved(const F& f, const std::array<T, n>& a, const Search& search, const char* what) {
  const auto constants = lifted<base::Dual<1>>(a);
  const auto found = root([&](const base::Dual<1>& x) { return base::Dual<1>(f(constants, x)); }, search);
  if (found) return T(found->x) - f(a, T(found->x)) * (1.0 / found->slope);
  std::string at;
  for (const auto& number : a) at += " " + std::to_string(base::value(number));
  throw base::SolveError(std::string("no ") + what + at);
}

}  // namespace reye::material
