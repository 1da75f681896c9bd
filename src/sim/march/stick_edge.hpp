#pragma once
#include <vector>

#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

/// Partial slip on elements of first order. As wear empties the annulus around a stick zone, pressure and shear become
/// singular at its edge, and elements of first order make the edge force of a sheared punch `edge_ratio` times that of
/// a pressed one (results/partial_slip_life). The final stick zone then ends at C' instead of C = stick over contact
/// half width,
///     edge_ratio Q / mu P = 1 - C'^2,   Q / mu P = 1 - C^2,
/// and the largest depth of the end is that of C' (`sim/measure/stick_zone`).
namespace reye::sim {

inline constexpr double edge_ratio = 1.13;  ///< for quads at nu = 0.3; 1.08 at nu = 0, 1.22 at 0.45

/// Stick over contact half width of a worn Hertz contact on elements of first order; zero where sticking ends.
double receded(double stick_share);

/// Path of slip per secondary node of every contact.
std::vector<std::vector<double>> slip_paths(const State& state);

/// After a block on unchanged meshes: warns of each contact of first order that wears while some of its nodes never
/// slipped in it, and of each, of either order, that forces alone drive, where the stick zone has receded by more than
/// two elements, or has so few that its edge leaves the depth open.
void warn_of_stick_edge(const Problem& problem, const solver::System& system,
                        const std::vector<std::vector<double>>& slip_before, State& state, const Observer& observer);

}  // namespace reye::sim
