#pragma once
#include <array>

#include "sim/problem/problem.hpp"
#include "sim/problem/records.hpp"

namespace reye::sim {

/// Both sides of a contact as tables along their boundaries (mesh::arc_chains).
/// Pressure is force per length on X; a node covered by less than half reports lambda D / A. Slip and depth are the
/// values at the node. Pressure and shear are means weighted by its function: in the middle of a curve of length h the
/// error of a mean is h^2 p'' / 40, and that of an interpolation of the means h^2 p'' / 10. Shear is the traction on
/// the side's own body along increasing arc length. The primary side repeats M^T lambda / A, without the tension that
/// the changing sign of M causes near the ends of contact.
std::array<SurfaceRecord, 2> surface_records(const contact::Setup& setup, const contact::ContactState& state,
                                             const std::vector<body::ShapePtr>& shapes, const PlacedContact& placed);

/// Largest pressure of the table of the secondary side.
double peak_pressure(const contact::Setup& setup, const contact::ContactState& state);

}  // namespace reye::sim
