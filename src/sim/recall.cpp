#include "sim/recall.hpp"

#include <algorithm>

namespace reye::sim {

const solver::Guess* recalled(const Recall& recall, int step, double from, double to, const solver::System& system) {
  const auto found = recall.played.find({from, to});
  if (step != recall.step || found == recall.played.end()) return nullptr;
  const bool nonlinear = std::any_of(system.bodies.begin(), system.bodies.end(),
                                     [](const auto& body) { return std::holds_alternative<body::NonlinearBody>(body); });
  return nonlinear ? nullptr : &found->second;
}

void note(Recall& recall, int step, double from, double to, const solver::SolverState& before, const solver::SolverState& after) {
  if (step != recall.step) recall = {step, {}};
  solver::Guess& guess = recall.played[{from, to}];
  guess = {after.q - before.q, {}, {}};
  for (const auto& contact : after.contacts) {
    guess.lambda.push_back(contact.lambda);
    guess.status.push_back(contact.status);
  }
}

}  // namespace reye::sim
