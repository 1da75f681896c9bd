#pragma once
#include <utility>

#include "base/linalg.hpp"

namespace reye::base {

/// A sum and its rounding error: a + b = sum + rest exactly.
struct ExactSum {
  double sum = 0.0, rest = 0.0;
};

inline ExactSum exact_sum(double a, double b) {
  const double sum = a + b, of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// A vector with twice the digits, high + low; high is its nearest vector of doubles.
struct TwoPart {
  Vector high, low;

  TwoPart() = default;
  TwoPart(Vector nearest, Vector rest) : high(std::move(nearest)), low(std::move(rest)) {}
  /// A vector of doubles as a TwoPart, with low = 0.
  template <class Doubles>
  TwoPart(const Eigen::MatrixBase<Doubles>& doubles) : high(doubles), low(Vector::Zero(doubles.size())) {}

  Eigen::Index size() const { return high.size(); }
  TwoPart segment(Eigen::Index first, Eigen::Index count) const {
    return {high.segment(first, count), low.segment(first, count)};
  }

  TwoPart& operator+=(const Vector& step) {
    for (Eigen::Index i = 0; i < high.size(); ++i) {
      const auto [moved, rest] = exact_sum(high[i], step[i]);
      const auto [sum, small] = exact_sum(moved, rest + low[i]);
      high[i] = sum;
      low[i] = small;
    }
    return *this;
  }
};

inline TwoPart operator-(const TwoPart& a, const TwoPart& b) {
  TwoPart difference = a;
  difference += -b.high;
  return difference += -b.low;
}

}  // namespace reye::base
