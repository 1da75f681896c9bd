#pragma once
#include <optional>

#include "body/solid/solid_place.hpp"

/// Which solids turn by any angle, and about what.                                                  [README, Turning]
namespace reye::body {

/// What guides a body that turns: six motions along and about three axes of fixed direction, rotations about a centre
/// that moves along with the body.
struct SolidPivot {
  int support = -1;  ///< a rigid one; -1: contact and planes of symmetry alone guide the body
  Vec3 centre = Vec3::Zero();
  base::Mat3 axes = base::Mat3::Identity();
  std::array<Motion, 6> motions{};  ///< 0 to 2 along the axes, 3 to 5 about them
};

/// The pivot of a body; empty where it keeps its direction. A body turns where no support acts on it but contact does,
/// or where one rigid support acts that does not fix all rotations. Beside it faces may be held along one direction of
/// all their nodes, as planes of symmetry are, about which alone the body turns and along which it does not move; and
/// rigid faces may bear a body that turns about one axis, if their centres lie on it and they hold all directions
/// across it alike.
std::optional<SolidPivot> solid_pivot(const SolidInput& input);

/// The support because of which the rotation of a body is taken as small; empty where it turns by any angle, or not at
/// all. That support acts along directions which do not turn with the body.
std::string solid_keeps_direction(const SolidInput& input);

}  // namespace reye::body
