#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "adapt/graphs.hpp"
#include "adapt/transfer/surface_transfer.hpp"
#include "support/surfaces.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::carry;
using adapt::SurfaceField;
using adapt::SurfaceKind;
using base::Analysis;
using mortar::Surface;

constexpr std::array analyses{Analysis::plane_strain, Analysis::axisymmetric};

template <class F>
Values sampled(const Surface& s, F f) {
  Values values;
  for (const Vec2& x : s.X) values.push_back(f(x));
  return values;
}

/// Nodal sums of a density.
template <class F>
Values shares(const Surface& s, F density) {
  auto values = sampled(s, density);
  for (std::size_t j = 0; j < values.size(); ++j) values[j] *= s.area[j];
  return values;
}

long double exact_sum(const Values& values) { return std::accumulate(values.begin(), values.end(), 0.0L); }
double magnitude(const Values& values) {
  return std::accumulate(values.begin(), values.end(), 0.0, [](double m, double v) { return m + std::abs(v); });
}

double affine_density(const Vec2& x) { return 2.0 - 0.4 * x.x() + 3.0 * x.y(); }

Surface circle(int n) {
  Points X;
  mesh::Chain chain;
  for (int k = 0; k < n; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / n;
    X.push_back(Vec2(5.0, 0.0) + Vec2(std::cos(angle), std::sin(angle)));
    chain.push_back(k);
  }
  chain.push_back(0);
  std::vector<int> nodes;
  return mortar::make_surface(X, {chain}, Analysis::axisymmetric, nodes);
}

// On the same surface, open or closed, interpolated values and labels come back to the bit, sums to round-off.
TEST(SurfaceTransfer, IdentityIsExact) {
  std::mt19937 random(3);
  for (const auto& surface : {graph(40, 1, wavy), graph(40, 1, wavy, Analysis::axisymmetric), circle(30)}) {
    const auto values = sampled(surface, [&](const Vec2&) { return noise(random); });
    const auto result = carry(surface,
                              {{"u", SurfaceKind::interpolated, values},
                               {"status", SurfaceKind::nearest, values},
                               {"force", SurfaceKind::summed, values}},
                              surface);
    EXPECT_EQ(result.largest_distance, 0.0);
    EXPECT_EQ(result.fields.at(0).values, values);
    EXPECT_EQ(result.fields.at(1).values, values);
    EXPECT_LT(largest_difference(result.fields.at(2).values, values), 1e-15);
    EXPECT_EQ(result.fields.at(2).name, "force");
  }
}

// Where the outlines coincide an affine field is exact, as a value and as the density of a sum, coarse and fine.
TEST(SurfaceTransfer, AffineFieldsAreExact) {
  for (auto analysis : analyses)
    for (int n : {7, 23, 90}) {
      const auto from = graph(31, 1, level, analysis), to = graph(n, 2, level, analysis);
      EXPECT_LT(largest_difference(carried(from, SurfaceKind::interpolated, sampled(from, affine_density), to),
                                   sampled(to, affine_density)),
                1e-13);
      const auto density = carried(from, SurfaceKind::summed, shares(from, affine_density), to);
      const auto expected = shares(to, affine_density);
      for (std::size_t k = 0; k < density.size(); ++k) EXPECT_NEAR(density[k] / expected[k], 1.0, 1e-13);
    }
}

// Between two meshes of a curved outline, values and densities of a smooth field lose at second order.
TEST(SurfaceTransfer, SecondOrder) {
  const auto smooth = [](const Vec2& x) { return 2.0 + std::sin(4.0 * x.x()) + x.y(); };
  for (auto analysis : analyses)
    for (auto kind : {SurfaceKind::interpolated, SurfaceKind::summed}) {
      std::vector<double> errors;
      for (int n : {20, 80, 320, 1280}) {
        const auto from = graph(n, 1, wavy, analysis), to = graph(5 * n / 4, 2, wavy, analysis);
        auto values =
            carried(from, kind, kind == SurfaceKind::summed ? shares(from, smooth) : sampled(from, smooth), to);
        double square = 0.0;
        for (std::size_t k = 0; k < values.size(); ++k)
          square += std::pow(values[k] / (kind == SurfaceKind::summed ? to.area[k] : 1.0) - smooth(to.X[k]), 2);
        errors.push_back(std::sqrt(square / static_cast<double>(values.size())));
      }
      for (int k = 0; k < 3; ++k) EXPECT_GT(std::log(errors[k] / errors[k + 1]) / std::log(4.0), 1.9);
    }
}

// Sums are kept to 1e-14 of what they are made of, in plane and axisymmetry, up to 1e4 nodes, with signs too.
TEST(SurfaceTransfer, SumsAreKept) {
  const auto wave = [](const Vec2& x) { return std::sin(9.0 * x.x()) + 0.1; };
  for (auto analysis : analyses)
    for (int n : {15, 60, 10000}) {
      const auto from = graph(200, 1, wavy, analysis), to = graph(n, 2, wavy, analysis);
      for (const auto& values : {shares(from, bump), shares(from, wave)}) {
        const auto there = carried(from, SurfaceKind::summed, values, to);
        const auto back = carried(to, SurfaceKind::summed, there, from);
        EXPECT_LT(std::abs(static_cast<double>(exact_sum(there) - exact_sum(values))), 1e-14 * magnitude(values));
        EXPECT_LT(std::abs(static_cast<double>(exact_sum(back) - exact_sum(values))), 1e-14 * magnitude(values));
      }
    }
}

// Removed volume stays where wear was: never negative, and zero farther from the scar than one old facet.
TEST(SurfaceTransfer, ZerosAndSignsStay) {
  for (auto analysis : analyses)
    for (int n : {20, 100, 1000}) {
      const auto from = graph(100, 1, wavy, analysis), to = graph(n, 2, wavy, analysis);
      const auto values = carried(from, SurfaceKind::summed, shares(from, bump), to);
      for (std::size_t k = 0; k < values.size(); ++k) {
        EXPECT_GE(values[k], 0.0);
        EXPECT_TRUE(values[k] == 0.0 || std::abs(to.X[k].x() - 2.1) < 0.4 + 0.04) << k;
      }
      const auto opposite = carried(from, SurfaceKind::summed, shares(from, [](Vec2 x) { return -bump(x); }), to);
      for (std::size_t k = 0; k < values.size(); ++k) EXPECT_EQ(opposite[k], -values[k]);
    }
}

// What is too narrow for the new nodes to see is not lost: it goes to the facet it lies on.
TEST(SurfaceTransfer, NarrowSumsAreNotLost) {
  for (auto analysis : analyses) {
    const auto from = graph(1000, 1, level, analysis), to = graph(10, 2, level, analysis);
    Values values(from.X.size(), 0.0);
    values[455] = 2.0;
    const double x = from.X[455].x();
    const auto result = carried(from, SurfaceKind::summed, values, to);
    EXPECT_NEAR(static_cast<double>(exact_sum(result)), 2.0, 1e-14);
    for (int k = 0; k < to.node_count(); ++k) EXPECT_TRUE(result[k] == 0.0 || std::abs(to.X[k].x() - x) < 0.35) << k;
    const int nodes = static_cast<int>(std::count_if(result.begin(), result.end(), [](double v) { return v > 0.0; }));
    EXPECT_EQ(nodes, 2);
  }
}

// Labels are those of the nearest old node: nothing in between appears.
TEST(SurfaceTransfer, LabelsAreNotMixed) {
  const auto from = graph(30, 1, level), to = graph(77, 2, level);
  const auto values = carried(from, SurfaceKind::nearest, sampled(from, [](Vec2 x) { return x.x(); }), to);
  for (int k = 0; k < to.node_count(); ++k) {
    double least = 1e300;
    for (const Vec2& x : from.X) least = std::min(least, (x - to.X[k]).norm());
    const auto found = std::find_if(from.X.begin(), from.X.end(), [&](const Vec2& x) { return x.x() == values[k]; });
    ASSERT_NE(found, from.X.end());
    EXPECT_NEAR((*found - to.X[k]).norm(), least, 1e-14);
  }
}

/// Two walls facing away from each other: the lower one runs to larger x, the upper one back.
Surface two_walls() {
  std::vector<int> nodes;
  const Points X{{0, 0}, {0.5, 0}, {1, 0}, {1, 0.125}, {0.5, 0.125}, {0, 0.125}};
  return mortar::make_surface(X, {{0, 1, 2}, {3, 4, 5}}, Analysis::plane_strain, nodes);
}

// A node as near to one wall as to the other takes the wall that runs its own way.
TEST(SurfaceTransfer, OppositeWallsDoNotCaptureNodes) {
  const auto from = two_walls();
  const Values values{1, 1, 1, 2, 2, 2};
  const auto forth = polyline({{0.2, 0.0625}, {0.4, 0.0625}, {0.8, 0.0625}});
  const auto back = polyline({{0.8, 0.0625}, {0.4, 0.0625}, {0.2, 0.0625}});
  for (auto kind : {SurfaceKind::interpolated, SurfaceKind::nearest}) {
    EXPECT_EQ(carried(from, kind, values, forth), Values(3, 1.0));
    EXPECT_EQ(carried(from, kind, values, back), Values(3, 2.0));
  }
}

// Around a corner the value follows the outline, and the distance of the farthest new node is reported.
TEST(SurfaceTransfer, CornersAndDistance) {
  const auto from = polyline({{0, 1}, {0, 0.5}, {0, 0}, {0.5, 0}, {1, 0}});
  const auto to = polyline({{0, 1}, {0, 0.1}, {0.001, 0.001}, {0.1, 0}, {1, 0}});
  const auto result = carry(from, {{"s", SurfaceKind::interpolated, {0, 0.5, 1, 1.5, 2}}}, to);
  const Values expected{0, 0.9, 1, 1.1, 2};
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(result.fields[0].values[k], expected[k], 1e-3 + 1e-15) << k;
  EXPECT_NEAR(result.largest_distance, 0.001, 1e-16);
}

// Without fields nothing is searched.
TEST(SurfaceTransfer, NoFieldsNoWork) {
  const auto result = carry({}, {}, graph(5, 1, level));
  EXPECT_TRUE(result.fields.empty());
  EXPECT_EQ(result.largest_distance, 0.0);
}

}  // namespace
}  // namespace reye
