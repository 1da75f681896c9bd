#include <algorithm>
#include <array>

#include "cad/meshing/region.hpp"

namespace reye::cad {

namespace {

struct Segment {
  Vec2 a, b;
  double left, right;
};

/// Whether the open segments share a point; touching ends do not count.
bool cross_each_other(const Segment& s, const Segment& t) {
  const auto side = [](const Segment& u, const Vec2& p) { return base::cross(u.b - u.a, p - u.a); };
  return side(s, t.a) * side(s, t.b) < 0.0 && side(t, s.a) * side(t, s.b) < 0.0;
}

/// The point where two crossing segments meet.
Vec2 meeting_point(const Segment& s, const Segment& t) {
  const Vec2 along = s.b - s.a, other = t.b - t.a;
  return s.a + base::cross(t.a - s.a, other) / base::cross(along, other) * along;
}

void add_segments(std::vector<Segment>& segments, const Points& X, const std::vector<int>& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Vec2 &a = X[nodes[i]], &b = X[nodes[(i + 1) % nodes.size()]];
    segments.push_back({a, b, std::min(a.x(), b.x()), std::max(a.x(), b.x())});
  }
}

std::optional<Vec2> first_crossing(std::vector<Segment> segments) {
  std::sort(segments.begin(), segments.end(), [](const Segment& s, const Segment& t) { return s.left < t.left; });
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t k = i + 1; k < segments.size() && segments[k].left <= segments[i].right; ++k)
      if (cross_each_other(segments[i], segments[k])) return meeting_point(segments[i], segments[k]);
  return std::nullopt;
}

/// Corners and every second node from each corner onward: the coarse outline that all-quad meshing starts from.
std::vector<int> thinned(const RegionLoop& loop) {
  const std::size_t count = loop.nodes.size();
  const std::size_t start = std::find(loop.corner.begin(), loop.corner.end(), true) - loop.corner.begin();
  std::vector<int> nodes;
  std::size_t since = 0;
  for (std::size_t i = 0; i < count; ++i, ++since) {
    const std::size_t k = (start + i) % count;
    if (loop.corner[k]) since = 0;
    if (since % 2 == 0) nodes.push_back(loop.nodes[k]);
  }
  return nodes;
}

}  // namespace

std::optional<Vec2> crossing(const Region& region) {
  std::vector<Segment> fine, coarse;
  for (const RegionLoop& loop : region.loops) {
    add_segments(fine, region.X, loop.nodes);
    if (region.kind == mesh::CellKind::quad4) add_segments(coarse, region.X, thinned(loop));
  }
  if (const auto place = first_crossing(std::move(fine))) return place;
  return first_crossing(std::move(coarse));
}

}  // namespace reye::cad
