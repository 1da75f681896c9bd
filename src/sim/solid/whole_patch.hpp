#pragma once
#include <array>
#include <vector>

#include "sim/solid/solid_state.hpp"

namespace reye::sim {

/// Points of a contact that press, with those that planes of symmetry stand for.
struct WholePatch {
  Points3 x;
  std::vector<double> area_mm2;
  std::vector<char> sticks;

  double area() const;
  double stick_area() const;
  /// Side of a square of the area of its largest point [mm].
  double element() const;
  /// Half widths of the ellipse with the same second moments of area, the larger first; zero where there is no patch.
  std::array<double, 2> half_widths() const;
};

/// The points in contact mirrored at each plane of symmetry (a plane face held along its normal alone) that the contact
/// reaches.
WholePatch whole_patch(const SolidProblem& problem, const solver::SolidSystem& system,
                       const solver::SolidSolution& solution, std::size_t contact);

/// The patch where those of its points stick that have not `slid` (per secondary point).
WholePatch whole_patch(const SolidProblem& problem, const solver::SolidSystem& system,
                       const solver::SolidSolution& solution, std::size_t contact, const std::vector<char>& slid);

}  // namespace reye::sim
