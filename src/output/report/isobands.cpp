#include "output/report/isobands.hpp"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>

namespace reye::output {

namespace {

/// A corner of a band: a node (twice, -1), or where an edge between two nodes, the smaller first, meets a level; in one
/// number, because the corners are sorted.
struct Corner {
  std::uint64_t key;
  Corner(int a, int b, int level)
      : key(static_cast<std::uint64_t>(a) << 36 | static_cast<std::uint64_t>(b) << 8 |
            static_cast<std::uint64_t>(level + 1)) {}
  std::size_t smaller() const { return key >> 36; }
  std::size_t larger() const { return key >> 8 & 0xfffffff; }
  int level() const { return static_cast<int>(key & 0xff) - 1; }
  auto operator<=>(const Corner&) const = default;
};
using Edge = std::pair<Corner, Corner>;

/// The directed edges round a band. Two triangles pass the edge between them in opposite directions: it is inside.
class Outline {
 public:
  void add(const Corner& from, const Corner& to) {
    if (from != to) edges_.push_back({std::minmax(from, to), from < to});
  }

  /// The edges joined end to end, as the corners of closed polygons.
  std::vector<std::vector<Corner>> loops() {
    std::vector<std::vector<Corner>> all;
    for (auto edges = outer(); !edges.empty();) {
      std::vector<Corner> loop;
      Corner at = edges.begin()->first;
      for (auto next = edges.begin(); next != edges.end() && next->first == at;
           next = edges.lower_bound({at, Corner(0, 0, -1)})) {
        loop.push_back(at);
        at = next->second;
        edges.erase(next);
      }
      all.push_back(std::move(loop));
    }
    return all;
  }

 private:
  /// Those that are passed in one direction alone.
  std::set<Edge> outer() {
    std::sort(edges_.begin(), edges_.end());
    std::set<Edge> all;
    for (auto begin = edges_.begin(), end = begin; begin != edges_.end(); begin = end) {
      const auto [ends, forward] = *begin;
      while (end != edges_.end() && end->first == ends) ++end;
      if (std::prev(end)->second == forward) all.insert(forward ? ends : Edge{ends.second, ends.first});
    }
    return all;
  }

  std::vector<std::pair<Edge, bool>> edges_;  ///< the smaller corner first, and whether it is passed from there
};

/// Cuts triangles along the levels.
class Bands {
 public:
  Bands(const base::Points& x, const std::vector<double>& value, const std::vector<double>& levels)
      : x_(x), value_(value), levels_(levels), outlines_(levels.size() - 1) {}

  void add(const std::array<int, 3>& triangle) {
    const auto [low, high] = std::minmax({band_of(triangle[0]), band_of(triangle[1]), band_of(triangle[2])});
    for (int band = low; band <= high; ++band) add_part(triangle, band);
  }

  std::vector<std::vector<Loop>> take() {
    std::vector<std::vector<Loop>> bands;
    for (auto& outline : outlines_) {
      bands.emplace_back();
      for (const auto& corners : outline.loops()) {
        bands.back().emplace_back();
        for (const Corner& corner : corners) bands.back().back().push_back(place(corner));
      }
    }
    return bands;
  }

 private:
  int band_of(int node) const {
    const auto above = std::upper_bound(levels_.begin(), levels_.end(), value_[static_cast<std::size_t>(node)]);
    const auto most = static_cast<std::ptrdiff_t>(levels_.size()) - 2;
    return static_cast<int>(std::clamp(above - levels_.begin() - 1, std::ptrdiff_t{0}, most));
  }

  /// The part of a triangle in a band: its nodes there and, between them, where its edges enter and leave.
  void add_part(const std::array<int, 3>& triangle, int band) {
    std::vector<Corner> part;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = triangle[k], b = triangle[(k + 1) % 3];
      const int from = band_of(a), to = band_of(b);
      if (from == band) part.emplace_back(a, a, -1);
      const auto cross = [&](int level) { part.emplace_back(std::min(a, b), std::max(a, b), level); };
      if (from < band && to >= band) cross(band);
      if (from <= band && to > band) cross(band + 1);
      if (from > band && to <= band) cross(band + 1);
      if (from >= band && to < band) cross(band);
    }
    for (std::size_t k = 0; k < part.size(); ++k)
      outlines_[static_cast<std::size_t>(band)].add(part[k], part[(k + 1) % part.size()]);
  }

  base::Vec2 place(const Corner& corner) const {
    const auto a = corner.smaller(), b = corner.larger();
    if (corner.level() < 0) return x_[a];
    const double level = levels_[static_cast<std::size_t>(corner.level())];
    const double t = std::clamp((level - value_[a]) / (value_[b] - value_[a]), 0.0, 1.0);
    return x_[a] + t * (x_[b] - x_[a]);
  }

  const base::Points& x_;
  const std::vector<double>& value_;
  const std::vector<double>& levels_;
  std::vector<Outline> outlines_;
};

}  // namespace

std::vector<std::vector<Loop>> isobands(const base::Points& x, const std::vector<double>& value,
                                        const std::vector<std::array<int, 3>>& triangles,
                                        const std::vector<double>& levels) {
  Bands bands(x, value, levels);
  for (const auto& triangle : triangles) bands.add(triangle);
  return bands.take();
}

}  // namespace reye::output
