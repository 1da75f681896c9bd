#pragma once
#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/records.hpp"
#include "sim/problem/state.hpp"

/// Checks contacts during a run and warns of what makes their numbers inaccurate.
namespace reye::sim {

/// Below so many elements across, the peak pressure of a round contact is off by more than some 3 %. Before wear has
/// widened it, a contact that wears may have fewer: the error of its first blocks is levelled, if its edge is not one
/// element's.
inline constexpr double fewest_across = 8.0, fewest_before_wear = 3.0;
/// Elements this many times longer than the size of a fine zone lie beside it.
inline constexpr double coarse_in_zone = 2.0;

/// The fine zone of a contact that the body was meshed with, of several the nearest to X; none where its mesh came with
/// its file.
const cad::FineZone* zone_round(const body::Shape& shape, const std::string& contact, const Vec2& X);

/// Number of elements that a contact needs before it has worn.
double wanted_across(const Problem& problem, const contact::ContactOptions& contact);

/// Warns of fewer than `wanted` elements across a contact; `how`: the source of that number.
void warn_of_resolution(std::vector<Warning>& warnings, const std::string& contact, double across, double wanted,
                        double length_mm, const std::string& how);

/// Warns of facets that the load does not press flat: their sagitta against 2 P / E*, which is pi times the approach
/// a^2 / 2R of a line contact of half width a, and of the order of the approach of one that conforms.
void warn_of_facets(std::vector<Warning>& warnings, const std::string& contact, double sagitta_mm, double approach_mm,
                    double size_mm);

/// Warns at the end of a block, by the increment of the largest force in it, if that was at least half of the largest
/// so far.
void warn_of_block(const Problem& problem, State& state, const Observer& observer);

/// Warns at the end of a run: of contacts that never closed or never slipped though they should wear, and limits that
/// watch the side that wears much less; a ledger that does not close.
void warn_of_run(const Problem& problem, State& state, const Summary& summary, const Observer& observer);

/// Warns of a fresh mesh that changed the pressure.
void warn_of_remesh(State& state, const Observer& observer, const RemeshRecord& record);

}  // namespace reye::sim
