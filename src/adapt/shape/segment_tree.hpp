#pragma once
#include <array>
#include <functional>
#include <limits>
#include <vector>

#include "base/linalg.hpp"

namespace reye::adapt {

using base::Points;
using base::Vec2;

/// Segments a -> b in the plane, searched for the nearest one; a == b is a point.
class SegmentTree {
 public:
  using Segment = std::array<Vec2, 2>;
  explicit SegmentTree(std::vector<Segment> segments);
  explicit SegmentTree(const Points& points);

  /// Place a + s (b - a), 0 <= s <= 1, of the segment nearest to a point; segment -1: no wanted one is near enough.
  struct Foot {
    int segment = -1;
    double s = 0.0;
    double distance = std::numeric_limits<double>::infinity();
  };
  /// The nearest segment; of equally near ones that with the smallest number. `wanted` leaves segments out, null: none;
  /// `within` [mm] bounds the search.
  Foot nearest(const Vec2& p, const std::function<bool(int)>& wanted = {},
               double within = std::numeric_limits<double>::infinity()) const;

 private:
  struct Box {
    Eigen::Array2d low, high;
    int begin = 0, end = 0;     ///< range of order_
    int left = -1, right = -1;  ///< boxes_ of the two halves, -1 in a leaf
  };
  int build(int begin, int end);

  std::vector<Segment> segments_;
  std::vector<int> order_;
  std::vector<Box> boxes_;
};

}  // namespace reye::adapt
