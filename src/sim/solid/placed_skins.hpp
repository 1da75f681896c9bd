#pragma once
#include <vector>

#include "contact/solid/skin_setup.hpp"

namespace reye::sim {

/// A contact of the scene with its faces found.
struct PlacedSkins {
  contact::SkinContactOptions options;
  contact::FaceRef secondary;
  std::vector<contact::FaceRef> primary;
  double modulus_MPa = 0.0;  ///< of the softer body that deforms
  double search_mm = 0.0;
  double drawn_mm = 0.0;  ///< shortest way between nodes of the two sides, as drawn
};

}  // namespace reye::sim
