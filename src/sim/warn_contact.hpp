#pragma once
#include "sim/observer.hpp"
#include "sim/problem.hpp"
#include "sim/records.hpp"
#include "sim/state.hpp"

/// Checks contacts during a run and warns of what makes their numbers inaccurate.
namespace reye::sim {

/// Below so many elements across, the peak pressure of a round contact is off by more than some 3 %. Before wear has
/// widened it, a contact that wears may have fewer: the error of its first blocks is levelled, if its edge is not one
/// element's.
inline constexpr double fewest_across = 8.0, fewest_before_wear = 3.0;
/// Elements beside a fine zone are longer than so many times what the zone asks for.
inline constexpr double coarse_in_zone = 2.0;

/// The fine zone of a contact that the body was meshed with, of several the nearest to X; none where its mesh came with
/// its file.
const cad::FineZone* zone_round(const body::Shape& shape, const std::string& contact, const Vec2& X);

/// How many of them a contact wants at a time when it has not yet worn.
double wanted_across(const Problem& problem, const contact::ContactOptions& contact);

/// Fewer than `wanted` elements across a contact; `how`: how that is known.
void warn_of_resolution(std::vector<Warning>& warnings, const std::string& contact, double across, double wanted,
                        double length_mm, const std::string& how);

/// Facets that the load does not press flat: their sagitta against 2 P / E*, which is pi times the approach a^2 / 2R of
/// a line contact of half width a, and of the order of the approach of one that conforms.
void warn_of_facets(std::vector<Warning>& warnings, const std::string& contact, double sagitta_mm, double approach_mm,
                    double size_mm);

/// At the end of a block: of what pressed hardest in it, when that was at least half of the largest force so far.
void warn_of_block(const Problem& problem, State& state, const Observer& observer);

/// At the end of a run: contacts that never closed or never slipped though they should wear, and limits that watch the
/// side that wears much less; a ledger that does not close.
void warn_of_run(const Problem& problem, State& state, const Summary& summary, const Observer& observer);

/// Of a fresh mesh that changed the pressure.
void warn_of_remesh(State& state, const Observer& observer, const RemeshRecord& record);

}  // namespace reye::sim
