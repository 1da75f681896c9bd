#pragma once
#include <array>
#include <string>
#include <vector>

#include "output/export/worn_bodies.hpp"

/// Triangles of worn shapes, and the STL file of them.
namespace reye::output {

/// Corners counter-clockwise seen from outside [mm].
using SpaceTriangle = std::array<base::Vec3, 3>;

/// The skin of a solid: quadrilaterals as two triangles, facets of second order as four.
std::vector<SpaceTriangle> triangles_of(const WornSolid& solid);

/// A plane body extruded from z = 0 to its thickness [mm]; edges of second order are two chords. Needs cells.
std::vector<SpaceTriangle> extruded(const WornBody& body, double thickness_mm);

/// Volume inside closed triangles [mm^3].
double enclosed_volume(const std::vector<SpaceTriangle>& triangles);

/// Binary STL, whose header of 80 bytes begins with `note`. Its numbers have single precision, as the format says.
std::string stl(const std::vector<SpaceTriangle>& triangles, const std::string& note);

}  // namespace reye::output
