#pragma once
#include "mesh/mesh.hpp"

namespace reye::mesh {

/// The place of a point relative to a body.
struct Place {
  bool inside = false;
  Vec2 nearest{0.0, 0.0};  ///< the place of the outline nearest to it
  double distance = 0.0;   ///< from there [mm]
  double facet = 0.0;      ///< length of the outline's facet there [mm]
};

/// The place of a point relative to the polygon of the outline, quadratic edges as two chords; a point in a hole lies
/// outside. Needs an outline.
Place place_of(const Mesh& mesh, const Vec2& point);

}  // namespace reye::mesh
