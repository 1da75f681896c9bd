#pragma once
#include "adapt/solid/skin_step.hpp"

namespace reye::adapt {

/// A moved skin, or why it could not be moved.
struct MovedSkin {
  Points3 X;           ///< all nodes; those that do not wear as they were
  double theta = 1.0;  ///< of all parts, the one farthest from 1
  int parts = 1;
  std::string failure;
};

/// Moves the worn nodes by their whole loss, in as many equal parts as the limits on one part ask for: no node goes
/// farther than 0.2 of the smallest height of its facets, and the factor that makes the strip exact is within 1e-2
/// of 1. Mid nodes stay between 0.4 and 0.6 of their chord.   (README, 14)
MovedSkin move_skin(const mesh::SolidMesh& mesh, const FacetsAtNodes& facets_at, const WornSkin& worn);

}  // namespace reye::adapt
