#include "cad/solid/raw_solid.hpp"

namespace reye::cad {

std::string to_string(FaceType type) {
  static const std::array<std::string, 6> words = {"plane", "cylinder", "sphere", "cone", "torus", "spline"};
  return words[static_cast<std::size_t>(type)];
}

double SizeZone::distance(const base::Vec3& p) const {
  if (radius > 0.0) return std::max(0.0, (p - centre).norm() - radius);
  return ((p - centre).cwiseAbs() - half_widths).cwiseMax(0.0).norm();
}

}  // namespace reye::cad
