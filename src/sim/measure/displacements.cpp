#include "sim/measure/displacements.hpp"

#include "fem/frame.hpp"
#include "sim/problem/drive.hpp"

namespace reye::sim {

std::vector<Vec2> displacements(const body::Operator& op, const Vector& q, const body::Interior& interior,
                                const Vector& load_factors) {
  if (const auto* nonlinear = std::get_if<body::NonlinearBody>(&op)) return nonlinear->recover(q, interior.y);
  if (const auto* linear = std::get_if<body::LinearBody>(&op)) return linear->recover(q, load_factors);
  return std::get<body::RigidBody>(op).recover(q, load_factors);
}

double turned_by(const body::Operator& op, const Vector& q) {
  const auto* linear = std::get_if<body::LinearBody>(&op);
  return linear ? linear->angle(q) : 0.0;
}

base::Points recovered(const Problem& problem, const State& state, const solver::System& system, int body) {
  const scene::Step none;
  const auto controls = controls_at(problem, system, state.factors, none, 0.0, 0.0, 1.0);
  return displacements(system.bodies[body], system.part(state.solution.q.high, body), state.solution.interiors[body],
                       controls.load_factors[body]);
}

base::Points recovered_in_frame(const Problem& problem, const State& state, const solver::System& system, int body) {
  const auto* linear = std::get_if<body::LinearBody>(&system.bodies[body]);
  if (!linear) return recovered(problem, state, system, body);
  const scene::Step none;
  const auto controls = controls_at(problem, system, state.factors, none, 0.0, 0.0, 1.0);
  return linear->recover_in_frame(system.part(state.solution.q.high, body), controls.load_factors[body]);
}

}  // namespace reye::sim
