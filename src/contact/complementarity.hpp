#pragma once
#include "base/dual.hpp"
#include "contact/state.hpp"
#include "mortar/kernel.hpp"
#include "wear/law.hpp"

namespace reye::contact {

using mortar::Pair;

/// The scalars the conditions of one secondary node depend on.
template <class T>
struct NodeScalars {
  Pair<T> lambda;  ///< multiplier [MPa]
  Pair<T> normal;  ///< unit normal, outward
  T gap{};         ///< weighted gap
  Pair<T> motion;  ///< weighted relative motion of secondary against primary in this increment
  T D{};
  T off{};          ///< shares of control points without multiplier: they slide as this node does
  T worn_others{};  ///< sum_l M_jl w_l of the primary's own depth, and the wear at control points without multiplier,
                    ///< that of this increment included
  T share{};        ///< held shear only: the traction that the whole contact adds to stay in balance, times pressure
};

/// Data of a node that stay fixed while the equations of one increment are solved.
struct NodeConstants {
  double friction = 0.0;
  wear::Formula friction_formula;  ///< of pressure and speed; where it is set, mu is its value
  double sign = 0.0;               ///< direction of slip, frozen for the iteration; 0: out of the plane
  double depth = 0.0;              ///< the secondary's depth at the start of the increment [mm]
  double depth_per_volume = 0.0;   ///< 1 / A_j: this increment's own depth per volume that it removes
  wear::Law law;
  wear::Start start;            ///< the node's data that the wear law needs
  double arc_over_chord = 1.0;  ///< ratio of arc to chord of the sliding while supports turn the sides
  bool imposed = false;         ///< slip is a number: D * imposed_slip
  double imposed_slip = 0.0;
  bool out_of_plane =
      false;                ///< slip is out of the plane: there friction is mu lambda_n, and none is left in the plane
  bool held = false;        ///< shear is given: re-equilibration after the shape moved
  bool unmoved = false;     ///< neither side can move along the surface, nor slides: a sticking node's shear is given
  double held_shear = 0.0;  ///< the shear that is given
  double held_pressure = 0.0, compliance = 0.0;  ///< re-equilibration on springs [MPa, mm/MPa]
  bool anchor = false;
};

template <class T>
struct NodeConditions {
  T normal{}, tangential{};  ///< both zero for an active node in equilibrium
  wear::Worn<T> worn;        ///< volumes that this increment removes
  T lambda_n{}, lambda_t{}, slip{};
  T drag{};               ///< traction of friction along the slip: lambda_t, out of the plane mu lambda_n
  double friction = 0.0;  ///< mu
};

/// mu at a node: a number, or a formula of its pressure and of the speed of its slip.
template <class T>
T coefficient_of_friction(const T& pressure, const T& slip, const T& covered, const NodeConstants& c) {
  if (!c.friction_formula || c.held) return T(c.friction);
  const auto sliding = wear::along_a_line(pressure, T(0.0), slip, covered);
  const wear::Place place{.path = c.start.path, .depth = c.start.depth_secondary, .cycle = c.start.cycle};
  return wear::value_of(c.friction_formula, place, pressure, wear::speed(sliding, c.start));
}

/// Conditions of an active node:                                                   [README (3) to (6)]
///   normal:      weighted gap + D (w_s + dw_s) + sum_l M_jl (w_l + dw_l) = 0, this increment's wear included
///   on springs:  weighted gap + D compliance (lambda_n - held pressure) = 0 with `held` and a compliance;
///   stick:       weighted slip = 0;      slip: lambda_t - mu lambda_n sign = 0
///   held shear:  lambda_t = the given shear (plus its share of the balance), cut to the friction bound;
///                the anchor node sticks instead, so that a body that only friction holds has a unique position.
/// A node that a support holds along the surface obeys the same conditions: its shear loads the support.
template <class T>
NodeConditions<T> conditions(const NodeScalars<T>& s, const NodeConstants& c, ContactStatus status) {
  NodeConditions<T> r;
  const Pair<T> tangent{-1.0 * s.normal.y, s.normal.x};
  r.lambda_n = mortar::dot(s.lambda, s.normal);
  r.lambda_t = mortar::dot(s.lambda, tangent);
  r.slip = c.imposed ? (s.D + s.off) * c.imposed_slip : c.arc_over_chord * mortar::dot(tangent, s.motion);
  const T mu = coefficient_of_friction(r.lambda_n, r.slip, T(s.D + s.off), c);
  r.friction = base::value(mu);
  r.drag = c.out_of_plane ? mu * r.lambda_n : r.lambda_t;
  if (r.friction == 0.0) r.drag = T(0.0);  // the rounding error of the shear does no work
  if (status == ContactStatus::slip && !c.held)
    r.worn = wear::worn(c.law, wear::along_a_line(r.lambda_n, r.drag, r.slip, T(s.D + s.off)), c.start);
  r.normal = s.gap + s.D * (c.depth + c.depth_per_volume * r.worn.secondary) + s.worn_others;
  if (c.compliance > 0.0) r.normal += c.compliance * (s.D + s.off) * (r.lambda_n - c.held_pressure);
  if ((c.held && !c.anchor) || (c.unmoved && status == ContactStatus::stick)) {
    const T given = c.held_shear + s.share;
    const bool cut = std::abs(base::value(given)) > r.friction * base::value(r.lambda_n);
    r.tangential = r.lambda_t - (cut ? std::copysign(1.0, base::value(given)) * mu * r.lambda_n : given);
  } else if (status == ContactStatus::slip && !c.held) {
    r.tangential = r.lambda_t - (c.sign * mu) * r.lambda_n;
  } else {
    r.tangential = r.slip;
  }
  return r;
}

}  // namespace reye::contact
