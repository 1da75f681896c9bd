#pragma once
#include <vector>

#include "cad/solid/raw_solid.hpp"

namespace reye::cad {

/// A point of a curved face at which elements of this size follow the curve.
struct SizePoint {
  base::Vec3 at = base::Vec3::Zero();
  double size = 0.0;
};

/// Wished element size in space [mm]: min(far, size of each zone or point + (growth - 1) distance from it).
class SolidSize {
 public:
  SolidSize(double far_size, double growth, std::vector<SizeZone> zones, std::vector<SizePoint> points);
  double operator()(const base::Vec3& p) const;

 private:
  /// A box of points: its two halves, or a few points themselves.
  struct Branch {
    base::Vec3 low, high;
    double least = 0.0;  ///< size of its points
    int begin = 0, end = 0;
    int second = -1;  ///< the first half is the next branch; none: a leaf
  };
  int grow(int begin, int end);

  double far_ = 1.0, slope_ = 0.3;
  std::vector<SizeZone> zones_;
  std::vector<SizePoint> points_;
  std::vector<Branch> branches_;
};

/// Nodes of tetrahedra of first order in a body of this volume and box, about: 0.6 int dV / size^3 (HXT's edges are 1.3
/// times as long as the size), where a zone and its surroundings lie in the body as far as they lie in its box.
double estimated_solid_nodes(double volume, const SolidBox& box, const SolidOrder& order);

}  // namespace reye::cad
