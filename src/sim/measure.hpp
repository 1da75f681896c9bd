#pragma once
#include <array>
#include <optional>
#include <utility>

#include "sim/problem.hpp"

/// Numbers and tables read off a state.
namespace reye::sim {

/// Both sides of a contact as tables along their boundaries (mesh::arc_chains).
/// Pressure is force per length on X; a node covered by less than half reports lambda D / A. Slip and depth are the
/// values at the node. Pressure and shear are means weighted by its function: in the middle of a curve of length h that
/// is off by h^2 p'' / 40, and what these means interpolate by h^2 p'' / 10.
/// Shear is the traction on the side's own body along increasing arc length. The primary side repeats M^T lambda / A, without
/// the tension that M's change of sign makes of it near the ends of contact.
std::array<SurfaceRecord, 2> surface_records(const contact::Setup& setup, const contact::ContactState& state,
                                             const std::vector<body::ShapePtr>& shapes, const PlacedContact& placed);

/// Largest pressure of the table of the secondary side.
double peak_pressure(const contact::Setup& setup, const contact::ContactState& state);

/// Half width between the two zeros of p^2, from the two outermost loaded nodes of each end: straight lines through
/// p^2 over the distance from the other zero; exact for p = p0 sqrt(1 - x^2 / a^2), wherever the nodes lie.
/// Empty with fewer than four loaded nodes. In axisymmetry a contact that reaches the axis is as wide beyond it.
std::optional<double> contact_half_width(const SurfaceRecord& surface,
                                         base::Analysis analysis = base::Analysis::plane_strain);

/// The same with (mu p - |q|)^2 at the outermost stick nodes; exact for Cattaneo-Mindlin.
std::optional<double> stick_half_width(const SurfaceRecord& surface, double friction,
                                       base::Analysis analysis = base::Analysis::plane_strain);

/// Arc length where depth exceeds 0.5 % of its largest value, ends by linear interpolation. On a ring, as the half
/// widths, wherever its table begins.
double scar_width(const SurfaceRecord& surface);

/// What Bernstein coefficients per node and control point are at the nodes: (a + 2c + b) / 4 in the middle of a curve.
std::vector<double> at_nodes(const mortar::Surface& surface, std::vector<double> coefficients);

/// Depth at each surface node [mm]; its coefficients are removed volume over full nodal length on X.
std::vector<double> depths(const mortar::Surface& surface, const std::vector<double>& removed);

/// The largest of them.
double deepest(const mortar::Surface& surface, const std::vector<double>& removed);

wear::Ledger ledger(const contact::ContactState& state);

/// Normal and tangential force of a contact, as ContactSummary has them.
std::pair<double, double> forces_of(const contact::ContactState& state, base::Analysis analysis);

ContactSummary summarise(const contact::Setup& setup, const contact::ContactState& state,
                         const std::vector<body::ShapePtr>& shapes, const PlacedContact& placed);

/// The value a limit watches.
double limit_measure(const scene::Limit& limit, const contact::Setup& setup, const contact::ContactState& state,
                     const std::vector<body::ShapePtr>& shapes, const PlacedContact& placed);

/// The same of all limits, by name.
std::map<std::string, double> limit_measures(const Problem& problem, const solver::System& system, const State& state);

}  // namespace reye::sim
