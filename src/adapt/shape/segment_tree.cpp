#include "adapt/shape/segment_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace reye::adapt {

namespace {

std::vector<SegmentTree::Segment> as_segments(const Points& points) {
  std::vector<SegmentTree::Segment> segments;
  for (const Vec2& x : points) segments.push_back({x, x});
  return segments;
}

SegmentTree::Foot foot(const SegmentTree::Segment& segment, int number, const Vec2& p) {
  const Vec2 e = segment[1] - segment[0];
  const double square = e.squaredNorm();
  const double s = square > 0.0 ? std::clamp(e.dot(p - segment[0]) / square, 0.0, 1.0) : 0.0;
  const Vec2 at = s < 0.5 ? Vec2(segment[0] + s * e) : Vec2(segment[1] - (1.0 - s) * e);  // both ends to the bit
  return {number, s, (p - at).norm()};
}

}  // namespace

SegmentTree::SegmentTree(std::vector<Segment> segments) : segments_(std::move(segments)), order_(segments_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!order_.empty()) build(0, static_cast<int>(order_.size()));
}

SegmentTree::SegmentTree(const Points& points) : SegmentTree(as_segments(points)) {}

int SegmentTree::build(int begin, int end) {
  constexpr int leaf = 4;
  Box box{segments_[order_[begin]][0], segments_[order_[begin]][0], begin, end};
  for (int i = begin; i < end; ++i)
    for (const Vec2& x : segments_[order_[i]]) {
      box.low = box.low.min(x.array());
      box.high = box.high.max(x.array());
    }
  const int self = static_cast<int>(boxes_.size());
  boxes_.push_back(box);
  if (end - begin <= leaf) return self;
  const int along = box.high[0] - box.low[0] >= box.high[1] - box.low[1] ? 0 : 1, middle = (begin + end) / 2;
  const auto key = [&](int k) { return std::pair{segments_[k][0][along] + segments_[k][1][along], k}; };
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](int i, int j) { return key(i) < key(j); });
  const int left = build(begin, middle), right = build(middle, end);
  boxes_[self].left = left;
  boxes_[self].right = right;
  return self;
}

SegmentTree::Foot SegmentTree::nearest(const Vec2& p, const std::function<bool(int)>& wanted, double within) const {
  Foot best;
  const auto away = [&](int b) {
    return (boxes_[b].low - p.array()).max(p.array() - boxes_[b].high).max(0.0).matrix().norm();
  };
  const auto bound = [&] { return std::min(within, best.distance); };
  std::vector<std::pair<double, int>> open;
  if (!boxes_.empty()) open.emplace_back(away(0), 0);
  while (!open.empty()) {
    const auto [distance, b] = open.back();
    open.pop_back();
    if (distance > bound()) continue;
    const Box& box = boxes_[b];
    if (box.left >= 0) {
      std::pair near{away(box.left), box.left}, far{away(box.right), box.right};
      if (far < near) std::swap(near, far);
      open.push_back(far);
      open.push_back(near);
      continue;
    }
    for (int i = box.begin; i < box.end; ++i) {
      if (wanted && !wanted(order_[i])) continue;
      const Foot f = foot(segments_[order_[i]], order_[i], p);
      if (f.distance <= within && std::pair{f.distance, f.segment} < std::pair{best.distance, best.segment}) best = f;
    }
  }
  return best;
}

}  // namespace reye::adapt
