#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/space.hpp"
#include "contact/solid/skin_place.hpp"

/// Conditions of one point of a contact between solids: Signorini's and Coulomb's, as complementarity functions.
namespace reye::contact {

enum class SkinStatus : char { open, stick, slip };

/// The traction z of a secondary point (z.n = pressure; its shear points along the slip it resists) and its motion.
struct SkinNode {
  base::Vec3 traction = base::Vec3::Zero();  ///< [MPa]
  double gap = 0.0;                          ///< -n.w, opened by wear, this increment's included [mm]
  base::Vec3 slip = base::Vec3::Zero();      ///< of this increment, across the normal [mm]
  double own_wear = 0.0;                     ///< how the gap opens by the point's own wear, per pressure [mm/MPa]
};

inline double pressure(const SkinNode& node, const SkinFrame& frame) { return node.traction.dot(frame.normal); }
inline base::Vec3 shear(const SkinNode& node, const SkinFrame& frame) { return frame.across(node.traction); }

/// c against normal motion, softened by the point's own wear as by a spring in series: beside strong wear c alone would
/// make much of gaps that little pressure closes.
inline double softened(const SkinNode& node, double c) { return c / (1.0 + c * node.own_wear); }

/// Signorini: p >= 0, g >= 0, p g = 0 as p = max(0, p - c g): closed where the trial value p - c g > 0, c softened.
inline double trial_pressure(const SkinNode& node, const SkinFrame& frame, double c) {
  return pressure(node, frame) - softened(node, c) * node.gap;
}

/// y = z_t + c u_t: what the shear would be without slip.
inline base::Vec3 trial(const SkinNode& node, const SkinFrame& frame, double c) {
  return shear(node, frame) + c * node.slip;
}

/// Coulomb: max(mu p, |y|) z_t = mu p y: sticks where |y| <= mu p.            (Hueeber, Stadler and Wohlmuth 2008)
inline SkinStatus tangential_status(const SkinNode& node, const SkinFrame& frame, double mu, double c) {
  if (frame.free == 0) return SkinStatus::stick;
  return trial(node, frame, c).norm() <= mu * std::max(0.0, pressure(node, frame)) ? SkinStatus::stick
                                                                                   : SkinStatus::slip;
}

/// Whether a point with this status slides: without friction every closed one may.
inline bool slides(SkinStatus status, double mu) {
  return status == SkinStatus::slip || (status == SkinStatus::stick && mu == 0.0);
}

/// A slipping point in the frame of its trial traction: d along it, e across it. Newton's step of
/// z_t = mu p d(y), d = y / |y|:
///   dz_d = mu dp,   (1 - s) dz_e - s c du_e = -z_e,   s = mu p / |y|
struct SlipStep {
  base::Vec3 d = base::Vec3::Zero(), e = base::Vec3::Zero();
  double share = 0.0;  ///< s
};

inline SlipStep slip_step(const SkinNode& node, const SkinFrame& frame, double mu, double c) {
  SlipStep step;
  const base::Vec3 y = trial(node, frame, c);
  const double length = y.norm();
  step.d = length > 0.0 ? base::Vec3(y / length) : frame.tangent[0];
  step.e = frame.normal.cross(step.d);
  step.share = length > 0.0 ? std::min(1.0, mu * std::max(0.0, pressure(node, frame)) / length) : 1.0;
  return step;
}

/// How far a point is from its conditions [MPa]: softened c times the gap, c times the slip of sticking points, and the
/// distance of the shear from the cone of slipping ones; of an open point its traction.
inline double violation(const SkinNode& node, const SkinFrame& frame, SkinStatus status, double mu, double c) {
  const double soft = softened(node, c);
  if (status == SkinStatus::open) return std::max(node.traction.norm(), -soft * std::min(0.0, node.gap));
  const double normal = soft * std::abs(node.gap);
  if (status == SkinStatus::stick) return std::max(normal, mu > 0.0 ? c * node.slip.norm() : 0.0);
  const auto step = slip_step(node, frame, mu, c);
  const base::Vec3 off = shear(node, frame) - mu * std::max(0.0, pressure(node, frame)) * step.d;
  return std::max(normal, off.norm());
}

}  // namespace reye::contact
