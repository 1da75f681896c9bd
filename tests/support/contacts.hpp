#pragma once
#include "contact/interface.hpp"
#include "support/surfaces.hpp"

/// A contact between two polylines, without bodies, at a random state.
namespace reye::support {

using contact::ContactOptions;
using contact::Interface;

struct ContactCase {
  contact::Setup setup;
  contact::ContactState before;
  Points xs0, xm0, xs, xm;  ///< at the start of the increment; now
  std::vector<Vec2> lambda;
  contact::IncrementOptions increment;
};

inline ContactOptions frictional(double friction, wear::Law law = {}) {
  ContactOptions o;
  o.friction = friction;
  o.wear = law;
  return o;
}

inline contact::Setup setup_of(const Facing& f, const ContactOptions& options) {
  contact::Setup s;
  s.options = options;
  s.analysis = f.analysis;
  s.measure = f.measure;
  s.secondary = f.secondary;
  s.primary = f.primary;
  const auto ns = f.secondary.X.size();
  s.cut.assign(ns, 0);
  for (int j = 0; j < s.secondary.node_count(); ++j)
    if (options.dual == contact::DualOrder::linear) s.cut[j] = s.secondary.is_control_point(j);
  s.freedom.assign(ns, {});
  s.stiffness.assign(ns, 1000.0);
  s.search = 0.5;
  return s;
}

/// Places the contact at the start of its increment and takes D and M there as slip reference.
inline ContactCase case_of(const Facing& f, const ContactOptions& options) {
  ContactCase c;
  c.setup = setup_of(f, options);
  c.before = contact::fresh_state(c.setup);
  c.xs = c.xs0 = f.xs;
  c.xm = c.xm0 = f.xm;
  c.lambda = c.before.lambda;
  Interface face;
  face.begin(c.setup, c.before, c.xs0, c.xm0, {});
  face.integrate(c.xs0, c.xm0);
  face.renew_reference(c.before);
  return c;
}

/// The interface at the case's present state, decided in the given iteration (0: all stick) and evaluated.
/// `c` must outlive it.
inline Interface interface_of(const ContactCase& c, int iteration) {
  Interface face;
  face.begin(c.setup, c.before, c.xs0, c.xm0, c.increment);
  face.integrate(c.xs, c.xm);
  face.decide(c.lambda, iteration);
  face.evaluate(c.lambda);
  return face;
}

/// Multipliers of given pressure and shear along the present normals.
inline void press(ContactCase& c, double pressure, double shear) {
  Interface face;
  face.begin(c.setup, c.before, c.xs0, c.xm0, {});
  face.integrate(c.xs, c.xm);
  for (std::size_t j = 0; j < c.lambda.size(); ++j) {
    const Vec2 n = face.normal()[j];
    c.lambda[j] = pressure * n + shear * Vec2(-n.y(), n.x());
  }
}

/// Turns the present positions of both sides.
inline void turn(ContactCase& c, double angle, const Vec2& shift = Vec2::Zero()) {
  for (auto* side : {&c.xs, &c.xm})
    for (Vec2& x : *side) x = turned(x, angle) + shift;
}

/// Every node moved, worn before on both sides and loaded: pressures 60 to 140, shear up to 60 MPa.
inline ContactCase random_case(const FacingOptions& o, const ContactOptions& options) {
  ContactCase c = case_of(facing(o), options);
  std::mt19937 random(o.seed + 7);
  for (Vec2& x : c.xs) x += turned(Vec2(-0.06, 0.0), o.angle);  // slip whose sign no small step changes
  turn(c, 0.3);
  for (auto* side : {&c.xs, &c.xm})
    for (Vec2& x : *side) x += 0.01 * Vec2(noise(random), noise(random));
  press(c, 100.0, 0.0);
  for (Vec2& l : c.lambda) l += 40.0 * Vec2(noise(random), noise(random));
  for (double& v : c.before.pending_secondary) v = 1e-3 * (1.5 + noise(random));
  for (double& v : c.before.pending_primary) v = 1e-3 * (1.5 + noise(random));
  c.increment.jump = 3.0;
  c.setup.stiffness.assign(c.xs.size(), 10.0);  // so that every covered node is active
  return c;
}

/// Rows and forces in one vector: what `linearise` differentiates.
inline Vector equations(Interface& face, const ContactCase& c, const Vector& direction, double step) {
  const int ns = static_cast<int>(c.xs.size());
  Points xs = c.xs, xm = c.xm;
  std::vector<Vec2> lambda = c.lambda;
  for (int k = 0; k < ns; ++k) xs[k] += step * direction.segment<2>(2 * k);
  for (int k = 0; k < static_cast<int>(xm.size()); ++k) xm[k] += step * direction.segment<2>(2 * (ns + k));
  face.integrate(xs, xm);
  const Vector forces = face.forces(c.lambda);
  for (int k = 0; k < ns; ++k) lambda[k] += step * direction.segment<2>(face.dofs() + 2 * k);
  face.evaluate(lambda);
  Vector all = Vector::Zero(2 * ns + face.dofs());
  for (int j = 0; j < ns; ++j) all.segment<2>(2 * j) << face.residual_normal(j), face.residual_tangential(j);
  all.tail(face.dofs()) = forces;
  return all;
}

/// The derivative along a direction, from `linearise`.
inline Vector slope_along(Interface& face, const ContactCase& c, const Vector& direction) {
  const int ns = static_cast<int>(c.xs.size());
  face.integrate(c.xs, c.xm);
  face.evaluate(c.lambda);
  contact::Linearised lin;
  face.linearise(c.lambda, lin);
  Vector slope = Vector::Zero(2 * ns + face.dofs());
  for (const auto& e : lin.rows) slope[e.row] += e.value * direction[e.col];
  for (const auto& e : lin.force) slope[2 * ns + e.row] += e.value * direction[e.col];
  return slope;
}

}  // namespace reye::support
