#pragma once
#include <algorithm>
#include <optional>
#include <string>

#include "base/linalg.hpp"
#include "base/part.hpp"

namespace reye::body {

/// Kind of one motion of a support. `moved` imposes the sum of its parts, `loaded` applies it as a force (or moment)
/// and leaves the motion to the equations, a spring beside it that pulls back by stiffness times the motion. A moving
/// far end of the spring is a force, stiffness times its displacement, among the parts.
enum class Drive { free, fixed, moved, loaded };

struct Motion {
  Drive drive = Drive::free;
  base::Parts parts{};  ///< mm or rad (moved); N per mm or N (loaded); N*mm per mm (rotation loaded)
  double stiffness =
      0.0;  ///< > 0, of a loaded motion: a spring between edge and ground, force (or moment) per mm (or rad)
};

/// A support on an edge or at a point. Its axes are x, y turned by angle_deg; with `edge_axes`
/// they are the tangent and outward normal of the edge at each node (then `x` is the tangent).
///
/// Rigid (an edge moves as a rigid line; three shared motions) or by node (each node of the edge takes
/// the same imposed value of the held direction and is free in the other). On an edge it is rigid when a
/// rotation is named or a motion is loaded; `rigid` overrides.
struct Support {
  std::string name;
  std::string edge;                    ///< boundary name, or
  std::optional<base::Vec2> point_mm;  ///< the node nearest to this point (of `body`, or of any body)
  std::string body;
  double angle_deg = 0.0;
  bool edge_axes = false;
  bool rigid = false;
  Motion x, y, rotation;
};

/// The motion of a support with that number: x, y, rotation.
inline const Motion& motion_of(const Support& s, int m) { return m == 0 ? s.x : m == 1 ? s.y : s.rotation; }

/// Whether a motion is fixed or imposed, or a spring acts against it.
inline bool holds(const Motion& m) { return m.drive == Drive::fixed || m.drive == Drive::moved || m.stiffness > 0.0; }

/// Whether any part of a motion is other than zero.
inline bool nonzero(const Motion& m) {
  return std::any_of(m.parts.begin(), m.parts.end(), [](const base::Part& part) { return part.value != 0.0; });
}

/// Whether a motion is fixed, or imposed with nothing but zeros.
inline bool keeps_still(const Motion& m) { return m.drive == Drive::fixed || (m.drive == Drive::moved && !nonzero(m)); }

}  // namespace reye::body
