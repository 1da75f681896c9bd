#include "sim/problem/problem.hpp"

#include <algorithm>

#include "material/parameters.hpp"

namespace reye::sim {

bool is_nonlinear(const body::BodyInput& input) {
  return input.kinematics == base::Kinematics::finite || material::has_history(input.material);
}

bool may_yield(const Problem& problem) {
  return std::any_of(problem.inputs.begin(), problem.inputs.end(),
                     [](const body::BodyInput& input) { return material::has_history(input.material); });
}

std::optional<double> chosen_small_error(const Problem& problem) {
  std::optional<double> largest;
  for (std::size_t b = 0; b < problem.kinematics.size(); ++b)
    if (const auto& choice = problem.kinematics[b]; choice && problem.inputs[b].kinematics == base::Kinematics::small)
      largest = std::max(largest.value_or(0.0), choice->largest.error());
  return largest;
}

Problem::Problem() = default;
Problem::Problem(const Problem&) = default;
Problem::Problem(Problem&&) noexcept = default;
Problem& Problem::operator=(const Problem&) = default;
Problem& Problem::operator=(Problem&&) noexcept = default;
Problem::~Problem() = default;

bool wear_is_in_gaps(const Problem& problem) {
  return std::none_of(problem.contacts.begin(), problem.contacts.end(), [](const PlacedContact& contact) {
    return contact.options.wear.wears() && !contact.options.implicit_wear;
  });
}

bool outlines_may_wait(const Problem& problem) {
  return problem.scene.remesh.every_blocks == 0 && wear_is_in_gaps(problem) &&
         std::none_of(problem.inputs.begin(), problem.inputs.end(), is_nonlinear);
}

}  // namespace reye::sim
