#pragma once
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

double pressure(const SkinNode& node, const SkinFrame& frame);
base::Vec3 shear(const SkinNode& node, const SkinFrame& frame);

/// c against normal motion, softened by the point's own wear as by a spring in series: beside strong wear c alone would
/// make much of gaps that little pressure closes.
double softened(const SkinNode& node, double c);

/// Signorini: p >= 0, g >= 0, p g = 0 as p = max(0, p - c g): closed where the trial value p - c g > 0, c softened.
double trial_pressure(const SkinNode& node, const SkinFrame& frame, double c);

/// y = z_t + c u_t: what the shear would be without slip.
base::Vec3 trial(const SkinNode& node, const SkinFrame& frame, double c);

/// Coulomb: max(mu p, |y|) z_t = mu p y: sticks where |y| <= mu p.            (Hueeber, Stadler and Wohlmuth 2008)
SkinStatus tangential_status(const SkinNode& node, const SkinFrame& frame, double mu, double c);

/// Whether a point with this status slides: without friction every closed one may.
bool slides(SkinStatus status, double mu);

/// A slipping point in the frame of its trial traction: d along it, e across it. Newton's step of
/// z_t = mu p d(y), d = y / |y|:
///   dz_d = mu dp,   (1 - s) dz_e - s c du_e = -z_e,   s = mu p / |y|
struct SlipStep {
  base::Vec3 d = base::Vec3::Zero(), e = base::Vec3::Zero();
  double share = 0.0;  ///< s
};

SlipStep slip_step(const SkinNode& node, const SkinFrame& frame, double mu, double c);

/// How far a point is from its conditions [MPa]: softened c times the gap, c times the slip of sticking points, and the
/// distance of the shear from the cone of slipping ones; of an open point its traction.
double violation(const SkinNode& node, const SkinFrame& frame, SkinStatus status, double mu, double c);

}  // namespace reye::contact
