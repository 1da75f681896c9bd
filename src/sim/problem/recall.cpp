#include "sim/problem/recall.hpp"

namespace reye::sim {

const solver::Guess* recalled(const Recall& recall, int step, double from, double to) {
  const auto found = recall.played.find({from, to});
  if (step != recall.step || found == recall.played.end()) return nullptr;
  return &found->second;
}

std::vector<std::vector<char>> touched(const Recall& recall, int step) {
  std::vector<std::vector<char>> result;
  if (step != recall.step) return result;
  for (const auto& [progress, guess] : recall.played) {
    result.resize(guess.status.size());
    for (std::size_t c = 0; c < result.size(); ++c) {
      result[c].resize(guess.status[c].size(), 0);
      for (std::size_t j = 0; j < result[c].size(); ++j)
        if (guess.status[c][j] != contact::ContactStatus::inactive) result[c][j] = 1;
    }
  }
  return result;
}

void note(Recall& recall, int step, double from, double to, const solver::SolverState& before,
          const solver::SolverState& after) {
  if (step != recall.step) recall = {step, {}};
  solver::Guess& guess = recall.played[{from, to}];
  guess = {after.q.high - before.q.high, {}, {}, {}};
  for (std::size_t b = 0; b < after.interiors.size(); ++b)
    guess.inside.push_back((after.interiors[b].y - before.interiors[b].y).high);
  for (const auto& contact : after.contacts) {
    guess.lambda.push_back(contact.lambda);
    guess.status.push_back(contact.status);
  }
}

}  // namespace reye::sim
