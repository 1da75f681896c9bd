#include "sim/problem/system.hpp"

#include <utility>

namespace reye::sim {

namespace {

/// Parts of a body that a new system reuses: all of it while its shape is unchanged, else at most the analysis.
struct Legacy {
  std::optional<body::Operator> kept;
  algebra::SchurAnalysisPtr analysis;
};

/// Clears the cache except for these parts: the factor at the old shape is released before the one at the new shape is
/// made, and a failure leaves nothing that could be mistaken for this state's.
std::vector<Legacy> take_over(const State& state, Cache& cache) {
  cache.newton.reset();
  const auto shapes = std::exchange(cache.shapes, {});
  auto bodies = std::exchange(cache.system, {}).bodies;
  std::vector<Legacy> legacies(state.shapes.size());
  for (std::size_t b = 0; b < shapes.size(); ++b)
    if (shapes[b] == state.shapes[b])
      legacies[b].kept = std::move(bodies[b]);
    else if (const auto* linear = std::get_if<body::LinearBody>(&bodies[b]))
      legacies[b].analysis = linear->analysis();
  return legacies;
}

body::Operator made(const body::ShapePtr& shape, const body::BodyInput& input, bool rigid, Legacy& legacy) {
  if (legacy.kept) return std::move(*legacy.kept);
  if (rigid) return body::RigidBody(shape, input);
  if (is_nonlinear(input)) return body::NonlinearBody(shape, input);
  return body::LinearBody(shape, input, std::move(legacy.analysis));
}

}  // namespace

const solver::System& system_of(const Problem& problem, const State& state, Cache& cache) {
  if (cache.shapes == state.shapes) return cache.system;
  auto legacies = take_over(state, cache);
  std::vector<body::Operator> bodies;
  for (std::size_t b = 0; b < state.shapes.size(); ++b)
    bodies.push_back(made(state.shapes[b], problem.inputs[b], problem.rigid[b], legacies[b]));
  std::vector<contact::Setup> contacts;
  for (const auto& c : problem.contacts)
    contacts.push_back(contact::make_setup(c.options, problem.scene.analysis, c.secondary, c.primary, state.shapes,
                                           bodies, c.modulus_MPa, problem.inputs[c.secondary.body].kinematics));
  for (const auto& b : problem.bonds)
    contacts.push_back(contact::make_setup(b.options, problem.scene.analysis, b.secondary, b.primary, state.shapes,
                                           bodies, b.modulus_MPa));
  cache.system = solver::make_system(std::move(bodies), std::move(contacts));
  cache.shapes = state.shapes;
  return cache.system;
}

Cache::Cache() = default;
Cache::Cache(const Cache&) = default;
Cache::Cache(Cache&&) noexcept = default;
Cache& Cache::operator=(const Cache&) = default;
Cache& Cache::operator=(Cache&&) noexcept = default;
Cache::~Cache() = default;

}  // namespace reye::sim
