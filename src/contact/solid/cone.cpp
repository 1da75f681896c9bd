#include "contact/solid/cone.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace reye::contact {

double pressure(const SkinNode& node, const SkinFrame& frame) { return node.traction.dot(frame.normal); }

base::Vec3 shear(const SkinNode& node, const SkinFrame& frame) { return frame.across(node.traction); }

double softened(const SkinNode& node, double c) { return c / (1.0 + c * node.own_wear); }

double trial_pressure(const SkinNode& node, const SkinFrame& frame, double c) {
  return pressure(node, frame) - softened(node, c) * node.gap;
}

base::Vec3 trial(const SkinNode& node, const SkinFrame& frame, double c) { return shear(node, frame) + c * node.slip; }

SkinStatus tangential_status(const SkinNode& node, const SkinFrame& frame, double mu, double c) {
  if (frame.free == 0) return SkinStatus::stick;
  return trial(node, frame, c).norm() <= mu * std::max(0.0, pressure(node, frame)) ? SkinStatus::stick
                                                                                   : SkinStatus::slip;
}

bool slides(SkinStatus status, double mu) {
  return status == SkinStatus::slip || (status == SkinStatus::stick && mu == 0.0);
}

SlipStep slip_step(const SkinNode& node, const SkinFrame& frame, double mu, double c) {
  SlipStep step;
  const base::Vec3 y = trial(node, frame, c);
  const double length = y.norm();
  step.d = length > 0.0 ? base::Vec3(y / length) : frame.tangent[0];
  step.e = frame.normal.cross(step.d);
  step.share = length > 0.0 ? std::min(1.0, mu * std::max(0.0, pressure(node, frame)) / length) : 1.0;
  return step;
}

double violation(const SkinNode& node, const SkinFrame& frame, SkinStatus status, double mu, double c) {
  const double soft = softened(node, c);
  if (status == SkinStatus::open) return std::max(node.traction.norm(), -soft * std::min(0.0, node.gap));
  const double normal = soft * std::abs(node.gap);
  if (status == SkinStatus::stick) return std::max(normal, mu > 0.0 ? c * node.slip.norm() : 0.0);
  const auto step = slip_step(node, frame, mu, c);
  const base::Vec3 off = shear(node, frame) - mu * std::max(0.0, pressure(node, frame)) * step.d;
  return std::max(normal, off.norm());
}

}  // namespace reye::contact
