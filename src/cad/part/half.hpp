#pragma once
#include <array>
#include <vector>

#include "cad/part/part.hpp"
#include "cad/part/select.hpp"

/// Sections through a whole solid of revolution lie on both sides of the axis x = 0; an axisymmetric scene takes what
/// lies at x >= 0.
namespace reye::cad {

/// The half x >= 0 of a part, closed along the axis.
struct Half {
  Part part;
  /// For each loop and edge of the half, which loop and edge of the whole it is (a piece of); {-1, -1}: a line along
  /// the axis.
  std::vector<std::vector<std::array<int, 2>>> whole;
};

/// Cuts a part along the axis. Throws base::MeshError where the half is not one piece. Precondition: it crosses the
/// axis.
Half half_of(const Part& part);

/// The edges chosen on the whole part that belong to its half.
EdgeChoice on_half(const EdgeChoice& choice, const Half& half);

}  // namespace reye::cad
