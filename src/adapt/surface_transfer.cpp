#include "adapt/surface_transfer.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "adapt/locate.hpp"

namespace reye::adapt {

namespace {

using mortar::Surface;
using Values = std::vector<double>;
using Foot = SegmentTree::Foot;

/// Two distances are the same within this share of the largest coordinate.
constexpr double round_off = 1e-13;

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

SegmentTree facets_of(const Surface& surface) {
  std::vector<SegmentTree::Segment> segments;
  for (const auto& [a, b, mid] : surface.facets) segments.push_back({surface.X[a], surface.X[b]});
  return SegmentTree(std::move(segments));
}

/// The closest point of `on` (its facets in `tree`) for every node of `nodes`.
std::vector<Foot> feet(const Surface& on, const SegmentTree& tree, const Surface& nodes) {
  const double same = round_off * largest_coordinate(on);
  std::vector<Foot> result;
  for (int k = 0; k < nodes.node_count(); ++k) {
    const Foot any = tree.nearest(nodes.X[k]);
    const auto fits = [&](int facet) { return runs_along(nodes, k, direction(on, facet)); };
    const Foot own = fits(any.segment) ? any : tree.nearest(nodes.X[k], fits, any.distance + same);
    result.push_back(own.segment < 0 ? any : own);
  }
  return result;
}

Values interpolated(const Surface& from, const Values& values, const std::vector<Foot>& feet) {
  Values result;
  for (const auto& [facet, s, distance] : feet) {
    const auto [a, b, mid] = from.facets[facet];
    result.push_back(s == 0.0 ? values[a] : s == 1.0 ? values[b] : (1.0 - s) * values[a] + s * values[b]);
  }
  return result;
}

Values nearest(const Surface& from, const Values& values, const std::vector<Foot>& feet) {
  Values result;
  for (const auto& foot : feet) result.push_back(values[from.facets[foot.segment][foot.s > 0.5 ? 1 : 0]]);
  return result;
}

long double sum(const Values& values) {
  long double total = 0.0L;
  for (double v : values) total += v;
  return total;
}

long double magnitude(const Values& values) {
  long double total = 0.0L;
  for (double v : values) total += std::abs(v);
  return total;
}

/// Each old share given to the new facet it lies on, split by area: for fields the new nodes are too coarse to see.
Values landed(const Surface& from, const Values& values, const Surface& to) {
  const auto tree = facets_of(to);
  const auto places = feet(to, tree, from);
  Values result(to.X.size(), 0.0);
  for (std::size_t j = 0; j < values.size(); ++j) {
    const auto [a, b, mid] = to.facets[places[j].segment];
    const double share = to.area[a] / (to.area[a] + to.area[b]);
    result[a] += share * values[j];
    result[b] += (1.0 - share) * values[j];
  }
  return result;
}

/// In proportion to the magnitude of each share: what is zero stays zero, what is not negative stays so.
void keep_sum(Values& values, long double total) {
  const long double factor = (total - sum(values)) / magnitude(values);
  for (double& v : values) v = static_cast<double>(v + factor * std::abs(v));
}

Values summed(const Surface& from, const Values& values, const Surface& to, const std::vector<Foot>& feet) {
  Values density(values.size(), 0.0);
  for (std::size_t j = 0; j < values.size(); ++j)
    if (from.area[j] > 0.0) density[j] = values[j] / from.area[j];
  Values result = interpolated(from, density, feet);
  for (std::size_t k = 0; k < result.size(); ++k) result[k] *= to.area[k];
  if (std::abs(sum(values) - sum(result)) > magnitude(result)) result = landed(from, values, to);
  if (magnitude(result) > 0.0L) keep_sum(result, sum(values));
  return result;
}

}  // namespace

SurfaceTransfer carry(const Surface& from, const std::vector<SurfaceField>& fields, const Surface& to) {
  SurfaceTransfer result;
  if (fields.empty()) return result;
  assert(from.facet_count() > 0 && to.facet_count() > 0);
  const auto tree = facets_of(from);
  const auto places = feet(from, tree, to);
  for (const auto& place : places) result.largest_distance = std::max(result.largest_distance, place.distance);
  for (const auto& [name, kind, values] : fields) {
    assert(values.size() == from.X.size());
    result.fields.push_back({name, kind,
                             kind == SurfaceKind::summed    ? summed(from, values, to, places)
                             : kind == SurfaceKind::nearest ? nearest(from, values, places)
                                                            : interpolated(from, values, places)});
  }
  return result;
}

}  // namespace reye::adapt
