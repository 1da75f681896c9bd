#include "cad/part/zone.hpp"
#include "mesh/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace reye::cad {

namespace {

constexpr double remainder_elements = 0.75;  // shorter leftovers of an edge join the zone

struct Place {
  int loop = 0, edge = 0;
  Foot foot;
  double alignment = 0.0;
};

Vec2 direction(const FineZone& zone) {
  const double angle = zone.angle_deg * std::numbers::pi / 180.0;
  return {std::cos(angle), std::sin(angle)};
}

/// Outline point nearest to the centre; at a corner the edge that runs more along the zone.
Place nearest_place(const Part& part, const FineZone& zone) {
  Place best{0, 0, {0.0, std::numeric_limits<double>::infinity()}, 0.0};
  const Vec2 along = direction(zone);
  for (int loop = 0; loop < static_cast<int>(part.loops.size()); ++loop)
    for (int edge = 0; edge < static_cast<int>(part.loops[loop].size()); ++edge) {
      const Edge& candidate = part.loops[loop][edge];
      const Foot foot = foot_on(candidate, zone.centre_mm);
      const double alignment = std::abs(tangent_at(candidate, foot.s).dot(along));
      const double gain = best.foot.distance - foot.distance;
      if (gain > 1e-9 || (gain > -1e-9 && alignment > best.alignment + 1e-9)) best = {loop, edge, foot, alignment};
    }
  return best;
}

/// First arc length from `from` onward (step +1) or backward (-1) at which the edge leaves |along| <= half_width;
/// the edge's end if it never does.
double exit_arc(const Edge& edge, double from, int step, const FineZone& zone) {
  const Vec2 along = direction(zone);
  const auto outside = [&](double s) {
    return std::abs(along.dot(at(edge, s) - zone.centre_mm)) > zone.half_width_mm * (1.0 + 1e-12);
  };
  const double end = step > 0 ? edge.length() : 0.0;
  double inner = from;
  const int knots = static_cast<int>(edge.arc.size());
  for (int k = step > 0 ? 0 : knots - 1; k >= 0 && k < knots; k += step) {
    double outer = edge.arc[k];
    if ((outer - from) * step <= 0.0) continue;
    if (!outside(outer)) {
      inner = outer;
      continue;
    }
    for (int bisection = 0; bisection < 60; ++bisection) {
      const double middle = 0.5 * (inner + outer);
      (outside(middle) ? outer : inner) = middle;
    }
    return inner;
  }
  return end;
}

/// Extends the zone from its centre in one direction, at most once round; stretches in the order walked, whether it
/// ends smoothly.
std::pair<std::vector<Stretch>, bool> walk(const Loop& loop, const Place& start, int step, const FineZone& zone) {
  const int edges = static_cast<int>(loop.size());
  std::vector<Stretch> stretches;
  double from = start.foot.s;
  for (int n = 0; n <= edges; ++n) {
    const int k = (start.edge + step * n % edges + edges) % edges;
    const Edge& edge = loop[k];
    if (n > 0) from = step > 0 ? 0.0 : edge.length();
    const double end = n == edges ? start.foot.s : step > 0 ? edge.length() : 0.0;
    double reached = exit_arc(edge, from, step, zone);
    if ((reached - end) * step > 0.0) reached = end;
    if (n > 0 && std::abs(reached - from) < remainder_elements * zone.size_mm) return {stretches, true};
    if (std::abs(end - reached) < remainder_elements * zone.size_mm) reached = end;
    if (std::abs(reached - from) > 1e-9 * edge.length())
      stretches.push_back({k, std::min(from, reached), std::max(from, reached)});
    if (reached != end) return {stretches, true};
    const Edge& next = loop[(k + step + edges) % edges];
    if (n < edges && (step > 0 ? kink(edge, next) : kink(next, edge)) > mesh::corner_angle) return {stretches, false};
  }
  return {stretches, false};
}

/// Joins the two stretches that meet in the centre where it lies close to an end of their edge: no sliver is left
/// between the two.
void join_at_centre(const Loop& loop, std::vector<Stretch>& back, std::vector<Stretch>& forth, double size) {
  if (back.empty() || forth.empty()) return;
  Stretch &before = back.front(), &after = forth.front();
  const auto sliver = [&](const Stretch& s) {
    const bool at_end = s.begin <= 0.0 || s.end >= loop[s.edge].length();
    return at_end && s.end - s.begin < 2.0 * size;
  };
  if (before.edge != after.edge || before.end != after.begin || !(sliver(before) || sliver(after))) return;
  after.begin = before.begin;
  back.erase(back.begin());
}

}  // namespace

double ZoneOutline::length() const {
  double sum = 0.0;
  for (const Stretch& stretch : stretches) sum += stretch.end - stretch.begin;
  return sum;
}

std::optional<ZoneOutline> zone_outline(const Part& part, const FineZone& zone, bool named) {
  const Place place = nearest_place(part, zone);
  if (!named && place.foot.distance > zone.half_width_mm + zone.depth_mm) return std::nullopt;
  const Loop& loop = part.loops[place.loop];
  auto [back, smooth_begin] = walk(loop, place, -1, zone);
  auto [forth, smooth_end] = walk(loop, place, +1, zone);
  double whole = 0.0, reach = 0.0;
  for (const Edge& edge : loop) whole += edge.length();
  for (const Stretch& stretch : back) reach += stretch.end - stretch.begin;
  const bool round = reach > whole * (1.0 - 1e-9);
  if (round) forth.clear();
  join_at_centre(loop, back, forth, zone.size_mm);
  ZoneOutline outline{
      place.loop,   {back.rbegin(), back.rend()}, smooth_begin, smooth_end, place.edge, place.foot.s, zone.size_mm,
      zone.depth_mm};
  for (const Stretch& stretch : forth) outline.stretches.push_back(stretch);
  if (round || outline.length() > whole * (1.0 - 1e-9)) outline.smooth_begin = outline.smooth_end = false;
  if (outline.stretches.empty()) return std::nullopt;
  return outline;
}

std::size_t zone_at(const std::vector<const FineZone*>& zones, const Vec2& x) {
  const auto away = [&](const FineZone* zone) {
    const Vec2 d = x - zone->centre_mm, along = direction(*zone);
    return (d - std::clamp(along.dot(d), -zone->half_width_mm, zone->half_width_mm) * along).norm();
  };
  const auto nearer = [&](const FineZone* a, const FineZone* b) { return away(a) < away(b); };
  return static_cast<std::size_t>(std::min_element(zones.begin(), zones.end(), nearer) - zones.begin());
}

Points sampled(const Part& part, const ZoneOutline& zone) {
  Points line;
  for (const Stretch& stretch : zone.stretches) {
    const Edge& edge = part.loops[zone.loop][stretch.edge];
    const double length = stretch.end - stretch.begin;
    const double turn = turning(edge) * length / edge.length();
    // Sagitta of a piece is length * angle / 8.
    const double pieces = std::sqrt(length * turn / (8.0 * 0.05 * std::max(zone.depth, zone.size)));
    const int count = std::clamp(static_cast<int>(std::ceil(pieces)), 1, 400);
    for (int i = line.empty() ? 0 : 1; i <= count; ++i) line.push_back(at(edge, stretch.begin + length * i / count));
  }
  return line;
}

}  // namespace reye::cad
