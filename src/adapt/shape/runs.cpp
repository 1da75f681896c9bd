#include "adapt/shape/runs.hpp"

#include <algorithm>
#include <cmath>

namespace reye::adapt {

namespace {

constexpr double two_facets = 1.9;  ///< in facets beside, with room for their unequal lengths

/// Segments [begin, end) of one kind, worn or fresh.
struct Range {
  std::size_t begin = 0, end = 0;
};

double length(const std::vector<Segment>& loop, const Range& r) {
  double sum = 0.0;
  for (std::size_t i = r.begin; i < r.end; ++i) sum += loop[i].length;
  return sum;
}

/// Runs of one kind in a stretch [begin, end) without hard nodes inside.
std::vector<Range> ranges(const std::vector<Segment>& loop, const Range& stretch) {
  std::vector<Range> all;
  for (std::size_t i = stretch.begin; i < stretch.end; ++i) {
    if (all.empty() || loop[i].worn != loop[i - 1].worn) all.push_back({i, i});
    all.back().end = i + 1;
  }
  return all;
}

/// Lengthens one short run of the stretch or joins it to its neighbour; false when all are long enough.
bool settle_one(std::vector<Segment>& loop, const Range& stretch) {
  const auto all = ranges(loop, stretch);
  for (std::size_t k = 0; all.size() > 1 && k < all.size(); ++k) {
    const Range& run = all[k];
    const bool left = k > 0, right = k + 1 < all.size();
    const double before = left ? loop[run.begin - 1].length : 0.0, after = right ? loop[run.end].length : 0.0;
    if (length(loop, run) >= two_facets * std::max(before, after)) continue;
    if (!loop[run.begin].worn) {
      for (std::size_t i = run.begin; i < run.end; ++i) loop[i].worn = true;
    } else {
      const bool to_right = !left || (right && length(loop, all[k + 1]) > length(loop, all[k - 1]));
      loop[to_right ? run.end : run.begin - 1].worn = true;
    }
    return true;
  }
  return false;
}

/// A worn edge of the old drawing is redrawn as a whole; false when nothing changed.
bool spread_over_worn_edges(std::vector<Segment>& loop, const std::vector<bool>& redrawn) {
  bool changed = false;
  for (Segment& segment : loop)
    if (redrawn[segment.edge] && !segment.worn) changed = segment.worn = true;
  return changed;
}

/// Turns the loop so that it starts at a hard node, or else with its longest run of one kind.
void turn(std::vector<Segment>& loop) {
  const std::size_t n = loop.size();
  std::size_t start = 0;
  const auto hard = std::find_if(loop.begin(), loop.end(), [](const Segment& s) { return s.hard; });
  if (hard != loop.end()) {
    start = static_cast<std::size_t>(hard - loop.begin());
  } else {
    double longest = -1.0;
    for (std::size_t i = 0; i < n; ++i) {
      if (loop[i].worn == loop[(i + n - 1) % n].worn) continue;
      double run = 0.0;
      for (std::size_t k = i; loop[k % n].worn == loop[i].worn; ++k) run += loop[k % n].length;
      if (run > longest) {
        longest = run;
        start = i;
      }
    }
  }
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(start), loop.end());
}

std::vector<Range> stretches(const std::vector<Segment>& loop) {
  std::vector<Range> all;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (i == 0 || loop[i].hard) all.push_back({i, i});
    all.back().end = i + 1;
  }
  return all;
}

}  // namespace

double turning_at(const std::vector<Segment>& loop, std::size_t i, const Points& X) {
  const Segment &before = loop[(i + loop.size() - 1) % loop.size()], &after = loop[i];
  const base::Vec2 in = X[before.b] - X[before.mid < 0 ? before.a : before.mid];
  const base::Vec2 out = X[after.mid < 0 ? after.b : after.mid] - X[after.a];
  return std::abs(std::atan2(base::cross(in, out), in.dot(out)));
}

std::vector<bool> corners(const std::vector<Segment>& loop, const Points& X) {
  constexpr double sure = 50.0 * std::numbers::pi / 180.0, against_neighbours = 5.0;
  const std::size_t n = loop.size();
  std::vector<double> turning;
  for (std::size_t i = 0; i < n; ++i) turning.push_back(turning_at(loop, i, X));
  std::vector<bool> corner;
  for (std::size_t i = 0; i < n; ++i) {
    const double beside = 0.5 * (turning[(i + n - 1) % n] + turning[(i + 1) % n]);
    corner.push_back(turning[i] > sure || (turning[i] > least_turning && turning[i] > against_neighbours * beside));
  }
  return corner;
}

std::vector<std::vector<Segment>> runs_of(std::vector<Segment> loop, const std::vector<bool>& worn_edges) {
  turn(loop);
  for (bool changed = true; changed;) {
    std::vector<bool> redrawn = worn_edges;
    for (std::size_t k = 0; k < redrawn.size(); ++k)
      redrawn[k] = redrawn[k] && std::any_of(loop.begin(), loop.end(),
                                             [&](const Segment& s) { return s.worn && s.edge == static_cast<int>(k); });
    changed = spread_over_worn_edges(loop, redrawn);
    for (const Range& stretch : stretches(loop))
      while (settle_one(loop, stretch)) changed = true;
  }
  std::vector<std::vector<Segment>> runs;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const bool begins = i == 0 || loop[i].hard || loop[i].worn != loop[i - 1].worn ||
                        (!loop[i].worn && (loop[i].edge != loop[i - 1].edge || loop[i].starts_edge));
    if (begins) runs.emplace_back();
    runs.back().push_back(loop[i]);
  }
  return runs;
}

}  // namespace reye::adapt
