#pragma once
#include <string>
#include <vector>

#include "base/analysis.hpp"
#include "output/export/worn_bodies.hpp"

/// How much of the bodies is left, and how much of the wear their shapes show.
namespace reye::output {

/// The content of a shape: area of a plane body [mm^2], volume of an axisymmetric one, 2 pi int r dA, or of a solid
/// [mm^3].
double content(const WornBody& body, base::Analysis analysis);
double content(const WornSolid& solid);

/// What the depths at the nodes of its outline amount to: int depth ds, in axisymmetry int 2 pi r depth ds; near to
/// what is worn off, exact on straight outlines.
double depth_amount(const WornBody& body, base::Analysis analysis);

/// Wear that a frame counts and its shapes do not show yet: shapes move at the end of blocks, those of solids once
/// their wear is no longer small.
struct Lag {
  std::size_t shown = 0;                      ///< the first frame with these shapes
  double deepest_mm = 0.0, lacking_mm = 0.0;  ///< the largest depth, and what it has grown since that frame
};
Lag lag_of(const std::string& dir, bool solid, std::size_t frame);

}  // namespace reye::output
