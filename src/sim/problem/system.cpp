#include "sim/problem/system.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/cores.hpp"

namespace reye::sim {

namespace {

/// Parts of a body that a new system reuses: all of it while its shape is unchanged, else at most the analysis.
struct Legacy {
  std::optional<body::Operator> kept;
  algebra::SchurAnalysisPtr analysis;
};

/// Clears the cache except for these parts: the factor at the old shape is released before the one at the new shape is
/// made, and a failure leaves nothing that could be mistaken for this state's.
std::vector<Legacy> take_over(const SystemKey& key, Cache& cache) {
  cache.newton.reset();
  const auto before = std::exchange(cache.key, {});
  const auto system = std::exchange(cache.system, nullptr);
  std::vector<Legacy> legacies(key.shapes.size());
  for (std::size_t b = 0; b < before.shapes.size(); ++b)
    if (before.shapes[b] == key.shapes[b] && before.kinematics[b] == key.kinematics[b])
      legacies[b].kept = system->bodies[b];
    else if (const auto* linear = std::get_if<body::LinearBody>(&system->bodies[b]))
      legacies[b].analysis = linear->analysis();
  return legacies;
}

bool made_of(const SystemKey& key, const Problem& problem, const State& state) {
  return key.shapes == state.shapes &&
         std::ranges::equal(key.kinematics, problem.inputs, {}, {}, &body::BodyInput::kinematics);
}

SystemKey key_of(const Problem& problem, const State& state) {
  SystemKey key{state.shapes, {}};
  for (const auto& input : problem.inputs) key.kinematics.push_back(input.kinematics);
  return key;
}

body::Operator made(const body::ShapePtr& shape, const body::BodyInput& input, bool rigid, Legacy& legacy) {
  if (legacy.kept) return std::move(*legacy.kept);
  if (rigid) return body::RigidBody(shape, input);
  if (is_nonlinear(input)) return body::NonlinearBody(shape, input);
  return body::LinearBody(shape, input, std::move(legacy.analysis));
}

std::vector<body::Operator> made_side_by_side(const Problem& problem, const State& state,
                                              std::vector<Legacy>& legacies) {
  std::vector<std::optional<body::Operator>> made_ones(legacies.size());
  base::side_by_side(static_cast<int>(legacies.size()), [&](int body) {
    const auto b = static_cast<std::size_t>(body);
    made_ones[b] = made(state.shapes[b], problem.inputs[b], problem.rigid[b], legacies[b]);
  });
  std::vector<body::Operator> bodies;
  for (auto& one : made_ones) bodies.push_back(std::move(*one));
  return bodies;
}

}  // namespace

SystemPtr system_of(const Problem& problem, const State& state, Cache& cache) {
  if (made_of(cache.key, problem, state)) return cache.system;
  auto key = key_of(problem, state);
  auto legacies = take_over(key, cache);
  auto bodies = made_side_by_side(problem, state, legacies);
  std::vector<contact::Setup> contacts;
  for (const auto& c : problem.contacts)
    contacts.push_back(contact::make_setup(c.options, problem.scene.analysis, c.secondary, c.primary, state.shapes,
                                           bodies, c.modulus_MPa, problem.inputs[c.secondary.body].kinematics));
  for (const auto& b : problem.bonds)
    contacts.push_back(contact::make_setup(b.options, problem.scene.analysis, b.secondary, b.primary, state.shapes,
                                           bodies, b.modulus_MPa));
  cache.system = std::make_shared<const solver::System>(solver::make_system(std::move(bodies), std::move(contacts)));
  cache.key = std::move(key);
  return cache.system;
}

Cache::Cache() = default;
Cache::~Cache() = default;

}  // namespace reye::sim
