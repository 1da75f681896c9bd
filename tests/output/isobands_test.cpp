#include "output/report/isobands.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace reye;
using output::isobands;

namespace {

/// n x n squares of two triangles on the unit square.
struct Grid {
  base::Points x;
  std::vector<std::array<int, 3>> triangles;

  explicit Grid(int n) {
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) x.emplace_back(static_cast<double>(i) / n, static_cast<double>(j) / n);
    const auto id = [n](int i, int j) { return j * (n + 1) + i; };
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
        triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
      }
  }

  template <class Value>
  std::vector<double> values(const Value& value) const {
    std::vector<double> all;
    for (const auto& p : x) all.push_back(value(p));
    return all;
  }
};

double area(const std::vector<output::Loop>& loops) {
  double sum = 0.0;
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto &a = loop[i], &b = loop[(i + 1) % loop.size()];
      sum += 0.5 * (a.x() * b.y() - b.x() * a.y());
    }
  return sum;
}

}  // namespace

// Bands of a linear value are strips: their areas are the distances of the levels, each is one loop, and values beyond
// the levels belong to the first and last band.
TEST(Isobands, OfALinearValueAreStrips) {
  const Grid grid(7);
  const auto bands =
      isobands(grid.x, grid.values([](const auto& p) { return p.x(); }), grid.triangles, {0.25, 0.4, 0.5, 0.6});
  ASSERT_EQ(bands.size(), 3u);
  const double areas[] = {0.4, 0.1, 0.5};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(bands[k].size(), 1u);
    EXPECT_NEAR(area(bands[k]), areas[k], 1e-12);
  }
}

// The bands of any value cover the triangles once, also where nodes lie exactly on levels.
TEST(Isobands, CoverOnce) {
  const Grid grid(16);
  const auto wave = grid.values([](const auto& p) { return std::round(4.0 * std::sin(9.0 * p.x() * p.y())) / 4.0; });
  double sum = 0.0;
  for (const auto& band : isobands(grid.x, wave, grid.triangles, {-1.0, -0.5, 0.0, 0.25, 0.5, 1.0})) sum += area(band);
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

// A band round a hill has its hole: two loops, and the area between two circles.
TEST(Isobands, KeepHoles) {
  const Grid grid(64);
  const auto hill = grid.values([](const auto& p) { return (p - base::Vec2(0.5, 0.5)).norm(); });
  const auto bands = isobands(grid.x, hill, grid.triangles, {0.0, 0.2, 0.4, 1.0});
  EXPECT_EQ(bands[1].size(), 2u);
  EXPECT_NEAR(area(bands[1]), M_PI * (0.16 - 0.04), 1e-3);
}
