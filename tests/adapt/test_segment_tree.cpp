#include <gtest/gtest.h>

#include "adapt/fields.hpp"
#include "adapt/shape/segment_tree.hpp"
#include "support/meshes.hpp"
#include "support/surfaces.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::SegmentTree;

std::vector<SegmentTree::Segment> scattered_segments(int count) {
  std::mt19937 random(5);
  std::vector<SegmentTree::Segment> segments;
  for (int k = 0; k < count; ++k) {
    const Vec2 a = anywhere(random);
    segments.push_back({a, k % 5 ? Vec2(a + 0.1 * (anywhere(random) - Vec2(0.5, 0.5))) : a});
  }
  return segments;
}

double distance_to(const SegmentTree::Segment& s, const Vec2& p) {
  const Vec2 e = s[1] - s[0];
  const double t = e.squaredNorm() > 0.0 ? std::clamp(e.dot(p - s[0]) / e.squaredNorm(), 0.0, 1.0) : 0.0;
  return (s[0] + t * e - p).norm();
}

// The nearest of all segments and points is found, with and without leaving some out.
TEST(SegmentTree, AgreesWithTryingAll) {
  const auto segments = scattered_segments(500);
  const SegmentTree tree(segments);
  std::mt19937 random(6);
  for (int k = 0; k < 500; ++k) {
    const Vec2 p = 2.0 * anywhere(random) - Vec2(0.5, 0.5);
    for (int step : {1, 3}) {
      double least = 1e300;
      for (int i = 0; i < 500; i += step) least = std::min(least, distance_to(segments[i], p));
      const auto foot = tree.nearest(p, [step](int i) { return i % step == 0; });
      EXPECT_EQ(foot.segment % step, 0);
      EXPECT_NEAR(foot.distance, least, 1e-15);
      const auto& [a, b] = segments[foot.segment];
      EXPECT_NEAR((a + foot.s * (b - a) - p).norm(), least, 1e-15);
      EXPECT_EQ(tree.nearest(p, {}, 0.99 * tree.nearest(p).distance).segment, -1);
    }
  }
}

// Equally near ones: the smallest number. None at all: -1.
TEST(SegmentTree, TiesAndNothing) {
  EXPECT_EQ(SegmentTree(base::Points(20, Vec2(1.0, 1.0))).nearest({0.0, 0.0}).segment, 0);
  EXPECT_EQ(SegmentTree(base::Points{}).nearest({0.0, 0.0}).segment, -1);
}

// A search looks at few of many segments: under 40 of 1e4 on a line, whatever the order of their numbers.
TEST(SegmentTree, LooksAtFew) {
  std::vector<SegmentTree::Segment> segments;
  for (int k = 0; k < 10000; ++k) {
    const double x = 1e-4 * ((k * 7919) % 10000);
    segments.push_back({Vec2(x, x * x), Vec2(x + 1e-4, (x + 1e-4) * (x + 1e-4))});
  }
  const SegmentTree tree(segments);
  long looked_at = 0;
  for (int k = 0; k < 1000; ++k) tree.nearest({1e-3 * k, 1e-6 * k * k + 1e-6}, [&](int) { return ++looked_at > 0; });
  EXPECT_LT(looked_at, 40 * 1000);
}

}  // namespace
}  // namespace reye
