#pragma once
#include <array>
#include <vector>

#include "base/space.hpp"

/// Surfaces of flat triangles.
namespace reye::cad {

using Triangle = std::array<base::Vec3, 3>;

double area_of(const std::vector<Triangle>& surface);

/// How often the closed surface goes round p: 1 inside where its triangles are counter-clockwise seen from outside.
double winding_number(const std::vector<Triangle>& surface, const base::Vec3& p);

/// The point of the surface that is nearest to p. Precondition: the surface is not empty.
base::Vec3 nearest_on(const std::vector<Triangle>& surface, const base::Vec3& p);

}  // namespace reye::cad
