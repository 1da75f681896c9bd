#pragma once
#include <vector>

#include "solver/solid/reduced_system.hpp"

namespace reye::solver {

/// A closed point: its contact and number, c [MPa/mm] and the coefficient of friction.
struct ClosedPoint {
  int contact = 0, point = 0;
  double stiffness = 0.0, friction = 0.0;
};

/// Adds the unknowns of one point: pressure and shear where it sticks; pressure, which brings its friction along, and
/// the shear across the slip where it slips (`contact::SlipStep`).
void add_rows(const ClosedPoint& at, const contact::SkinFrame& frame, const contact::SkinNode& node,
              contact::SkinStatus status, std::vector<ReducedRow>& rows);

}  // namespace reye::solver
