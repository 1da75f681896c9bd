#pragma once
#include <numbers>

#include "support/assembly.hpp"

/// Two blocks in contact, the cases of several tests of the solver.
namespace reye::support {

struct BlocksOptions {
  double friction = 0.0;
  wear::Law wear = {};
  double press = 0.03;  ///< mm that the upper block is pushed down
  double drag = 0.0;    ///< and along the contact
  double angle = 0.0;   ///< the whole scene is turned by this [rad]
  double crown = 0.03;  ///< how far the ends of the lower block lie below its middle [mm]
  bool upper_rigid = false;
  double rotation = 0.0;  ///< of a rigid upper block [rad]
  bool upper_secondary = false;
  mesh::CellKind lower = mesh::CellKind::quad4, upper = mesh::CellKind::quad4;
  contact::DualOrder dual = contact::DualOrder::quadratic;
};

inline body::Support holder(const BlocksOptions& o) {
  body::Support s;
  s.name = "holder";
  s.edge = "top";
  s.angle_deg = o.angle * 180.0 / std::numbers::pi;
  s.x = moved(o.drag);
  s.y = moved(-o.press);
  if (o.upper_rigid) s.rotation = moved(o.rotation);
  return s;
}

/// The lower block [0, 2] x [0, 1] (6 facets) has a crowned top; the upper one lies on its middle (7 facets).
inline Assembly blocks(const BlocksOptions& o) {
  Assembly a;
  const auto crowned = mapped(
      rectangle({.corner = {0, 0}, .size = {2, 1}, .nx = 6, .ny = 3, .kind = o.lower}),
      [&](const base::Vec2& x) { return base::Vec2(x.x(), x.y() * (1.0 - o.crown * (x.x() - 1.0) * (x.x() - 1.0))); });
  a.meshes = {turned(crowned, o.angle),
              turned(rectangle({.corner = {0.1, 1}, .size = {1.7, 1}, .nx = 7, .ny = 3, .kind = o.upper}), o.angle)};
  a.inputs = {elastic(1000.0, 0.3), elastic(2000.0, 0.25)};
  a.inputs[0].supports = {fixed_edge("base", "bottom")};
  a.inputs[1].supports = {holder(o)};
  a.rigid = {0, static_cast<char>(o.upper_rigid)};
  contact::ContactOptions c;
  c.friction = o.friction;
  c.wear = o.wear;
  c.dual = o.dual;
  if (o.upper_secondary)
    touch(a, c, {1, "bottom"}, {0, "top"});
  else
    touch(a, c, {0, "top"}, {1, "bottom"});
  return a;
}

/// Three stacked blocks, and beside the third a fourth: the top of the second is secondary against the third
/// and primary to the fourth, so that the contacts must be eliminated in the order 0, 2, 1.
inline Assembly chain(double friction) {
  Assembly a;
  a.meshes = {rectangle({.corner = {0, 0}, .size = {4, 1}, .nx = 5, .ny = 2}),
              rectangle({.corner = {0, 1}, .size = {4, 1}, .nx = 7, .ny = 2}),
              rectangle({.corner = {0.3, 2}, .size = {1.4, 1}, .nx = 4, .ny = 2}),
              rectangle({.corner = {2.2, 2}, .size = {1.5, 1}, .nx = 3, .ny = 2})};
  for (int b = 0; b < 4; ++b) a.inputs.push_back(elastic(1000.0 + 300.0 * b, 0.3));
  a.inputs[0].supports = {fixed_edge("base", "bottom")};
  a.inputs[1].supports = {pin("pin", {0, 1.5})};
  for (int b : {2, 3}) {
    a.inputs[b].supports = {fixed_edge("holder", "top")};
    a.inputs[b].supports[0].y = moved(-0.02);
    a.inputs[b].supports[0].x = moved(b == 2 ? 0.004 : -0.002);
  }
  contact::ContactOptions c;
  c.friction = friction;
  touch(a, c, {0, "top"}, {1, "bottom"});
  touch(a, c, {1, "top"}, {2, "bottom"});
  touch(a, c, {3, "bottom"}, {1, "top"});
  return a;
}

}  // namespace reye::support
