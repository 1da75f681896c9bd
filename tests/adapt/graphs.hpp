#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "adapt/transfer/surface_transfer.hpp"
#include "support/surfaces.hpp"

/// Surfaces along graphs, and what is carried from one to another.
namespace reye::support {

using Values = std::vector<double>;

/// n uneven facets of the graph of `height` over 1 <= x <= 3, those of order 2 with middle nodes on it, body below:
/// from x = 3 to x = 1.
template <class F>
mortar::Surface graph(int n, unsigned seed, F height, base::Analysis analysis = base::Analysis::plane_strain,
                      int order = 1) {
  std::mt19937 random(seed);
  Points X;
  for (int i = 0; i <= n; ++i) {
    const double x = 3.0 - 2.0 / n * (i + (i == 0 || i == n ? 0.0 : 0.3 * noise(random)));
    if (order == 2 && i > 0) {
      const double middle = 0.5 * (X.back().x() + x);
      X.push_back({middle, height(middle)});
    }
    X.push_back({x, height(x)});
  }
  return polyline(X, analysis, order);
}

inline double level(double x) { return 0.1 * x; }
inline double wavy(double x) { return 0.1 * std::sin(3.0 * x); }

/// A density that ends within the graph.
inline double bump(const Vec2& x) { return std::max(0.0, 1.0 - std::pow((x.x() - 2.1) / 0.4, 2)); }

inline Values carried(const mortar::Surface& from, adapt::SurfaceKind kind, const Values& values,
                      const mortar::Surface& to) {
  return adapt::carry(from, {{"field", kind, values}}, to).fields.at(0).values;
}

inline double largest_difference(const Values& a, const Values& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

}  // namespace reye::support
