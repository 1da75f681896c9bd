#pragma once
#include <optional>
#include <string>

#include "fem/distortion.hpp"
#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

/// Whether small strain is good enough.
namespace reye::sim {

/// Estimated relative error up to which a body that leaves its kinematics to the run is small-strained.
inline constexpr double small_strain_bound = 0.01;

/// Mean strain (with the rotation of a body that keeps its direction) without a trial: the bound of a warning, and that
/// at which a run ends whose scene does not ask for small strain.
inline constexpr double strain_warned_of = 0.01, strain_refused = 0.05;

/// Largest estimated error of the bodies whose small strain was chosen, at a state; empty where there is none.
std::optional<double> small_strain_error(const Problem& problem, const State& state, const solver::System& system);

/// Mean strain and rotation of a body in the frame that turns with it.
fem::Distortion distortion_of(const Problem& problem, const State& state, const solver::System& system, int body);

/// Checks the bodies whose small strain no trial chose: warns, or returns why the run ends.
std::string check_small_strain(const Problem& problem, State& state, const solver::System& system,
                               const Observer& observer);

}  // namespace reye::sim
