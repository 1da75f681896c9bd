#include "adapt/transfer/surface_transfer.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "adapt/shape/segment_tree.hpp"
#include "adapt/transfer/kept_sum.hpp"

namespace reye::adapt {

namespace {

using mortar::Surface;
using Values = std::vector<double>;
using Foot = SegmentTree::Foot;

/// Two distances are equal within this share of the largest coordinate.
constexpr double same_place = 1e-13;

double largest_coordinate(const Surface& surface) {
  double largest = 0.0;
  for (const Vec2& x : surface.X) largest = std::max(largest, x.cwiseAbs().maxCoeff());
  return largest;
}

Vec2 direction(const Surface& s, int facet) { return s.X[s.facets[facet][1]] - s.X[s.facets[facet][0]]; }

bool runs_along(const Surface& s, int node, const Vec2& way) {
  for (int facet : {s.before[node], s.after[node]})
    if (facet >= 0 && direction(s, facet).dot(way) > 0.0) return true;
  return false;
}

/// Values of the nodes of a facet at t in [0, 1]: linear, or by Bernstein functions.
template <class T>
T at(const mortar::LineFacet& facet, double t, const std::vector<T>& values) {
  const auto [a, b, c] = facet;
  if (t == 0.0) return values[a];
  if (t == 1.0) return values[b];
  if (c < 0) return (1.0 - t) * values[a] + t * values[b];
  return (1.0 - t) * (1.0 - t) * values[a] + t * t * values[b] + 2.0 * t * (1.0 - t) * values[c];
}

/// Where a node is on the surface: a control point in the middle of its curve.
Vec2 place(const Surface& s, int node) {
  return s.is_control_point(node) ? at(s.facets[s.before[node]], 0.5, s.X) : s.X[node];
}

/// Facets as chords to be searched: curved ones in pieces.
struct Line {
  struct Piece {
    int facet = -1;
    double from = 0.0, to = 1.0;
  };
  std::vector<Piece> pieces;
  SegmentTree tree;
};

Line line_of(const Surface& surface) {
  constexpr int chords = 4;  // of a curved facet
  std::vector<Line::Piece> pieces;
  std::vector<SegmentTree::Segment> segments;
  for (int f = 0; f < surface.facet_count(); ++f) {
    const auto& facet = surface.facets[f];
    const int n = facet[2] < 0 ? 1 : chords;
    for (int i = 0; i < n; ++i) {
      pieces.push_back({f, static_cast<double>(i) / n, static_cast<double>(i + 1) / n});
      segments.push_back({at(facet, pieces.back().from, surface.X), at(facet, pieces.back().to, surface.X)});
    }
  }
  return {std::move(pieces), SegmentTree(std::move(segments))};
}

/// The point of a curved facet closest to p: Newton for (x(t) - p) . x'(t) = 0 from t on, clamped to the facet.
Foot on_curve(const Surface& s, int facet, double t, const Vec2& p) {
  const auto [a, b, c] = s.facets[facet];
  const Vec2 start = 2.0 * (s.X[c] - s.X[a]), bend = 2.0 * (s.X[a] + s.X[b] - 2.0 * s.X[c]);  // x' = start + t bend
  for (int step = 0; step < 20; ++step) {
    const Vec2 tangent = start + t * bend, off = at(s.facets[facet], t, s.X) - p;
    const double slope = std::max(tangent.squaredNorm() + off.dot(bend), 0.1 * tangent.squaredNorm());
    const double next = std::clamp(t - off.dot(tangent) / slope, 0.0, 1.0);
    if (std::abs(next - t) < 1e-15) break;
    t = next;
  }
  return {facet, t, (at(s.facets[facet], t, s.X) - p).norm()};
}

/// The point of the surface beside the foot on a chord; past the end of a curved facet that of the next one.
Foot refined(const Surface& s, const Line& line, const Foot& on_chord, const Vec2& p) {
  const auto& [facet, from, to] = line.pieces[on_chord.segment];
  if (s.facets[facet][2] < 0) return {facet, on_chord.s, on_chord.distance};
  const Foot own = on_curve(s, facet, from + on_chord.s * (to - from), p);
  const bool first = own.s == 0.0;
  if (!first && own.s < 1.0) return own;
  const int next = first ? s.before[s.facets[facet][0]] : s.after[s.facets[facet][1]];
  if (next < 0 || s.facets[next][2] < 0) return own;
  const Foot beside = on_curve(s, next, first ? 1.0 : 0.0, p);
  return beside.distance < own.distance ? beside : own;
}

/// The closest point of `on` (its facets in `line`) for every node of `nodes`.
std::vector<Foot> feet(const Surface& on, const Line& line, const Surface& nodes) {
  const double same = same_place * largest_coordinate(on);
  std::vector<Foot> result;
  for (int k = 0; k < nodes.node_count(); ++k) {
    const Vec2 x = place(nodes, k);
    const Foot any = line.tree.nearest(x);
    const auto fits = [&](int piece) { return runs_along(nodes, k, direction(on, line.pieces[piece].facet)); };
    const Foot own = fits(any.segment) ? any : line.tree.nearest(x, fits, any.distance + same);
    result.push_back(refined(on, line, own.segment < 0 ? any : own, x));
  }
  return result;
}

Values interpolated(const Surface& from, const Values& values, const Surface& to, const std::vector<Foot>& feet) {
  Values result;
  for (const auto& [facet, s, distance] : feet) result.push_back(at(from.facets[facet], s, values));
  return mesh::control_points(to.facets, std::move(result));
}

Values nearest(const Surface& from, const Values& values, const std::vector<Foot>& feet) {
  Values result;
  for (const auto& [facet, s, distance] : feet) {
    const auto [a, b, c] = from.facets[facet];
    result.push_back(values[c >= 0 && std::abs(s - 0.5) <= 0.25 ? c : s > 0.5 ? b : a]);
  }
  return result;
}

/// Each old share given to the new facet it lies on, split by area: for fields that the new nodes do not resolve.
Values landed(const Surface& from, const Values& values, const Surface& to) {
  const auto places = feet(to, line_of(to), from);
  Values result(to.X.size(), 0.0);
  for (std::size_t j = 0; j < values.size(); ++j) {
    const auto [a, b, c] = to.facets[places[j].segment];
    const double middle = c < 0 ? 0.0 : to.area[c] / (to.area[a] + to.area[b] + to.area[c]);
    const double share = to.area[a] / (to.area[a] + to.area[b]);
    if (c >= 0) result[c] += middle * values[j];
    const double rest = (1.0 - middle) * values[j];
    result[a] += share * rest;
    result[b] += (1.0 - share) * rest;
  }
  return result;
}

Values summed(const Surface& from, const Values& values, const Surface& to, const std::vector<Foot>& feet) {
  const Values density = densities(values, from.area);
  Values result = interpolated(from, density, to, feet);
  keep_sign(result, density);
  for (std::size_t k = 0; k < result.size(); ++k) result[k] *= to.area[k];
  if (std::abs(total_of(values) - total_of(result)) > magnitude_of(result)) result = landed(from, values, to);
  if (magnitude_of(result) > 0.0L) keep_sum(result, total_of(values));
  return result;
}

}  // namespace

SurfaceTransfer carry(const Surface& from, const std::vector<SurfaceField>& fields, const Surface& to) {
  SurfaceTransfer result;
  if (fields.empty()) return result;
  assert(from.facet_count() > 0 && to.facet_count() > 0);
  const auto places = feet(from, line_of(from), to);
  for (const auto& place : places) result.largest_distance = std::max(result.largest_distance, place.distance);
  for (const auto& [name, kind, values] : fields) {
    assert(values.size() == from.X.size());
    result.fields.push_back({name, kind,
                             kind == SurfaceKind::summed    ? summed(from, values, to, places)
                             : kind == SurfaceKind::nearest ? nearest(from, values, places)
                                                            : interpolated(from, values, to, places)});
  }
  return result;
}

}  // namespace reye::adapt
