#pragma once
#include "cad/solid/solid_size.hpp"

namespace reye::cad {

/// A closed surface of triangles, outward, to be filled with tetrahedra of first order: of size min(far, size of each
/// zone or point + (growth - 1) distance from it).
struct SkinFilling {
  Points3 X;
  std::vector<std::array<int, 3>> triangles;
  double far_size = 1.0;
  double growth = 1.3;
  std::vector<SizeZone> zones;
  std::vector<SizePoint> points;
};

}  // namespace reye::cad
