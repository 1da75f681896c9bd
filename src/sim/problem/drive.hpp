#pragma once
#include <functional>

#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

/// Histories, and the values they impose at a moment of a step.
namespace reye::sim {

/// The remaining share of drawn overlaps, as a history from 1 to 0 over the step that lets them in. No scene can name
/// it.
inline const std::string overlap_left = "drawn overlap";

/// Factor of a history at a progress in [0, 1], linear between its corners.
double factor_at(const scene::History& history, double progress);

using Histories = std::map<std::string, scene::History>;

/// Ends of the equal parts of a step, and the corners of the histories it plays.
std::vector<double> step_corners(const Histories& histories, const scene::Step& step);

/// Into how many increments a turn is divided: of at most 0.3 rad each.
double parts_of_turn(double turn_rad);

/// Ends of increments where each span between corners is divided as the turn in it, `turned(from, to)` in rad, asks
/// for.
std::vector<double> divided_ends(const std::vector<double>& corners,
                                 const std::function<double(double, double)>& turned);

/// Their number, which may be beyond all memory.
double divided_count(const std::vector<double>& corners, const std::function<double(double, double)>& turned);

/// Ends of the increments of a step: equal parts, every corner of the histories it plays, and more between them where a
/// support would turn its body by more than 0.3 rad.
std::vector<double> increment_ends(const scene::Scene& scene, const scene::Step& step);

/// Their number, which may be beyond all memory.
double increments_of(const scene::Scene& scene, const scene::Step& step);

/// Factors of all histories while a step plays.
std::map<std::string, double> factors_at(const Histories& histories, const scene::Step& step, double progress,
                                         const std::map<std::string, double>& held);

/// Sum of the parts at these factors.
double sum_at(const base::Parts& parts, const std::map<std::string, double>& factors);

/// The imposed slip between two moments of a step: the change of each part, those without history evenly, where
/// `evenly` says so.
double slid_between(const Histories& histories, const scene::Step& step, const base::Parts& parts, double from,
                    double to, bool evenly);

/// The controls at the given factors; `from`, `to`: the part of the step's play in this increment.
solver::Controls controls_at(const Problem& problem, const solver::System& system,
                             const std::map<std::string, double>& factors, const scene::Step& step, double from,
                             double to, double jump);

/// Distance of the primary side of a contact inside its body while its drawn overlap is let in: overlap x remaining
/// share [mm].
double inset_at(const PlacedContact& contact, const std::map<std::string, double>& factors);

/// Sets what contacts do at a cycle: the coefficient of friction of those that have a table of it, constant before and
/// after, and the cycle itself for formulas.
void set_cycle(solver::Controls& controls, const Problem& problem, double cycle);

/// Counts prescribed motions from the positions at which the references of their bodies were renewed.
void count_from_renewal(solver::Controls& controls, const Problem& problem, const solver::System& system,
                        const State& state);

/// Moment on the body of each support of the scene that is a rigid edge, about the middle of the edge; none in
/// axisymmetry, where no edge turns.
std::vector<std::optional<double>> support_moments(const Problem& problem, const solver::System& system,
                                                   const Vector& reactions);

/// Force on the body of each support of the scene, in x and y.
std::vector<Vec2> support_forces(const Problem& problem, const solver::System& system, const Vector& reactions);

}  // namespace reye::sim
