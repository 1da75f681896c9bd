#pragma once
#include "cad/part/options.hpp"
#include "cad/part/part.hpp"

namespace reye::cad {

/// Angles of a body about a centre, from its drawn place [rad].
struct Turn {
  Vec2 centre{0.0, 0.0};
  double least = 0.0, most = 0.0;
};

/// The fine zone of a body that turns while its contact stays where it is: wide enough for the arc that passes under
/// the zone, or the whole ring where that is more than half a turn. Its elements are long enough that it has at most
/// `most_nodes` nodes. The zone is returned unchanged where the turn moves it by less than an element.
FineZone turned_zone(const Part& part, FineZone zone, const Turn& turn, double most_nodes);

}  // namespace reye::cad
