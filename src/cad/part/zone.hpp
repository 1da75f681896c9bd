#pragma once
#include <optional>
#include <vector>

#include "cad/part/options.hpp"
#include "cad/part/part.hpp"

namespace reye::cad {

/// A stretch of one edge.
struct Stretch {
  int edge = 0;
  double begin = 0.0, end = 0.0;  ///< arc lengths on the edge
};

/// The part of an outline that a fine zone refines: stretches following one another round one loop.
struct ZoneOutline {
  int loop = 0;
  std::vector<Stretch> stretches;
  bool smooth_begin = true;  ///< ends inside an edge or at a smooth joint, not at a corner
  bool smooth_end = true;
  int centre_edge = 0;  ///< where the zone's centre falls on the outline
  double centre_arc = 0.0;
  double size = 0.0, depth = 0.0;

  double length() const;
};

/// Walks from the outline point nearest to the zone's centre both ways, round smooth joints, up to half_width
/// along the zone's direction or the next corner (30 degrees). A remainder shorter than an element is taken in.
/// Nothing where the outline stays farther from the centre than half_width + depth and the zone does not
/// name the body.
std::optional<ZoneOutline> zone_outline(const Part& part, const FineZone& zone, bool named);

/// The zone, of at least one, that x belongs to: its width, a straight line, passes nearest to x.
std::size_t zone_at(const std::vector<const FineZone*>& zones, const Vec2& x);

/// The zone's stretch of outline as a line that leaves it by less than a twentieth of the depth, for the size field.
Points sampled(const Part& part, const ZoneOutline& zone);

}  // namespace reye::cad
