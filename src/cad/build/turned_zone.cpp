#include "cad/build/turned_zone.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cad/part/zone.hpp"

namespace reye::cad {

namespace {

/// x turned about a centre.
Vec2 turned(const Vec2& x, const Vec2& centre, double angle) {
  const Vec2 d = x - centre;
  const double c = std::cos(angle), s = std::sin(angle);
  return centre + Vec2(c * d.x() - s * d.y(), s * d.x() + c * d.y());
}

}  // namespace

FineZone turned_zone(const Part& part, FineZone zone, const Turn& turn, double most_nodes) {
  const double radius = (zone.centre_mm - turn.centre).norm(), range = turn.most - turn.least;
  if (!(range * radius >= zone.size_mm)) return zone;  // round its own centre, too, where a motion has no angle
  zone.turns = true;
  const double half = 0.5 * range + std::asin(std::min(1.0, zone.half_width_mm / radius));
  if (half < 0.5 * std::numbers::pi) {
    const double back = -0.5 * (turn.least + turn.most);  // of the contact, seen from the body
    zone.centre_mm = turned(zone.centre_mm, turn.centre, back);
    zone.angle_deg += back * 180.0 / std::numbers::pi;
    zone.half_width_mm = radius * std::sin(half);
  } else {
    zone.half_width_mm = 10.0 * (radius + zone.half_width_mm);  // no part of the ring is beyond it
  }
  if (const auto outline = zone_outline(part, zone, true))
    zone.size_mm = std::max(zone.size_mm, outline->length() / most_nodes);
  return zone;
}

}  // namespace reye::cad
