#pragma once
#include <vector>

#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

namespace reye::sim {

/// Displacement of all mesh nodes of a body.
std::vector<Vec2> displacements(const body::Operator& op, const Vector& q, const body::Interior& interior,
                                const Vector& load_factors);

/// Rotation of a linear body [rad].
double turned_by(const body::Operator& op, const Vector& q);

/// Displacement of all nodes of a body.
base::Points recovered(const Problem& problem, const State& state, const solver::System& system, int body);
/// Displacement of all nodes in the frame of a linear body that turns, from which strain follows.
base::Points recovered_in_frame(const Problem& problem, const State& state, const solver::System& system, int body);

}  // namespace reye::sim
