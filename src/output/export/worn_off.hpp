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

/// Volume worn off all bodies of a run of solids until a cycle [mm^3], by its history; 0 where it has no such row.
double worn_volume(const std::string& dir, double cycle);

}  // namespace reye::output
