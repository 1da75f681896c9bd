#include "material/parameters.hpp"
#include "sim/kinematics.hpp"
#include "sim/problem.hpp"

namespace reye::sim {

State initial_state(const Problem& problem) {
  State state;
  state.shapes = problem.shapes;
  for (const auto& [name, history] : problem.scene.histories) state.factors[name] = history.front()[1];
  state.small_strain_error = chosen_small_error(problem);
  return state;
}

bool is_nonlinear(const body::BodyInput& input) {
  return input.kinematics == base::Kinematics::finite || material::has_history(input.material);
}

const solver::System& system_of(const Problem& problem, const State& state, Cache& cache) {
  if (cache.shapes == state.shapes) return cache.system;
  std::vector<body::Operator> bodies;
  for (std::size_t b = 0; b < state.shapes.size(); ++b) {
    const bool known = b < cache.shapes.size(), kept = known && cache.shapes[b] == state.shapes[b];
    if (kept)
      bodies.push_back(cache.system.bodies[b]);
    else if (problem.rigid[b])
      bodies.emplace_back(body::RigidBody(state.shapes[b], problem.inputs[b]));
    else if (is_nonlinear(problem.inputs[b]))
      bodies.emplace_back(body::NonlinearBody(state.shapes[b], problem.inputs[b]));
    else
      bodies.emplace_back(body::LinearBody(state.shapes[b], problem.inputs[b],
                                           known ? std::get_if<body::LinearBody>(&cache.system.bodies[b]) : nullptr));
  }
  std::vector<contact::Setup> contacts;
  for (const auto& c : problem.contacts)
    contacts.push_back(contact::make_setup(c.options, problem.scene.analysis, c.secondary, c.primary, state.shapes,
                                           bodies, c.modulus_MPa, problem.inputs[c.secondary.body].kinematics));
  cache.system = solver::make_system(std::move(bodies), std::move(contacts));
  cache.shapes = state.shapes;
  cache.newton.reset();
  return cache.system;
}

}  // namespace reye::sim
