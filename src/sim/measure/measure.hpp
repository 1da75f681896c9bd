#pragma once
#include <array>
#include <optional>
#include <utility>

#include "sim/problem/problem.hpp"
#include "sim/problem/records.hpp"

/// Numbers and tables read off a state.
namespace reye::sim {

/// Half width between the two zeros of p^2, from the two outermost loaded nodes of each end: straight lines through
/// p^2 over the distance from the other zero; exact for p = p0 sqrt(1 - x^2 / a^2), wherever the nodes lie.
/// Empty with fewer than four loaded nodes. In axisymmetry a contact that reaches the axis is as wide beyond it.
std::optional<double> contact_half_width(const SurfaceRecord& surface,
                                         base::Analysis analysis = base::Analysis::plane_strain);

/// Half width between the zeros of (mu p - |q|)^2, from the outermost stick nodes; exact for Cattaneo-Mindlin.
std::optional<double> stick_half_width(const SurfaceRecord& surface, double friction,
                                       base::Analysis analysis = base::Analysis::plane_strain);

/// Arc length where depth exceeds 0.5 % of its largest value, ends by linear interpolation. On a ring, as the half
/// widths, wherever its table begins.
double scar_width(const SurfaceRecord& surface);

wear::Ledger ledger(const contact::ContactState& state);

/// Normal and tangential force of a contact, as ContactSummary has them.
std::pair<double, double> forces_of(const contact::ContactState& state, base::Analysis analysis);

ContactSummary summarise(const contact::Setup& setup, const contact::ContactState& state,
                         const std::vector<body::ShapePtr>& shapes, const PlacedContact& placed);

}  // namespace reye::sim
