#include <gtest/gtest.h>

#include "sim/solid/solid_drive.hpp"
#include "sim/solid/solid_player.hpp"
#include "solver/solid/solid_iterate.hpp"
#include "support/solid_hertz.hpp"

using namespace reye;

namespace {

double relative_error(const solver::SolidIterate& iterate) {
  const auto error = iterate.error();
  return error.traction_MPa / error.largest_MPa;
}

/// Errors of an increment in which a ball is pressed and moved aside at once, so that part of its contact slips: the
/// integrals follow the bodies until the error is below 1e-1 and no point changes, and are held from then on.
std::vector<double> errors_with_held_integrals(const support::HertzCase& c) {
  auto problem = support::hertz_problem(c, 1.0);
  for (auto& input : problem.inputs)
    for (auto& support : input.supports)
      if (support.name == "top") support.along[0] = support::moved(0.001, "press");
  problem.scene.steps = {support::step_of(1, {"press"})};
  auto state = sim::initial_solid_state(problem);
  const sim::SolidPlayer player(problem, state, std::nullopt);
  const auto& system = player.system();
  const auto old = solver::initial_state(system);
  const auto target = sim::target_at(problem, system, old, {{"press", 1.0}}, problem.scene.steps[0], {}, 0.0, 1.0);
  solver::SolidIterate iterate(system, old, target, solver::SolidStart::sticking);
  std::vector<double> errors;
  for (int i = 0; i < 60 && (errors.empty() || errors.back() > 1e-13); ++i) {
    const bool changed = iterate.classify(i > 10);
    const double error = relative_error(iterate);
    if (changed) errors.clear();
    if (!errors.empty() || (!changed && error < 0.1)) errors.push_back(error);
    iterate.step(false, false);
    if (errors.empty())
      iterate.integrate();
    else
      iterate.evaluate();
  }
  return errors;
}

}  // namespace

TEST(SolidTail, IsQuadraticWhileTheIntegralsAreHeld) {
  // Cone and gap are linearised exactly: with D, M and the normals held an error is at most in proportion to the
  // square of the one before, down to round-off. What errors of whole increments fall by is what the integrals leave.
  support::HertzCase c;
  c.mu = 0.3;
  c.half = true;
  c.elements = 4.0;
  const auto errors = errors_with_held_integrals(c);
  ASSERT_GE(errors.size(), 3U);
  EXPECT_GE(errors[0], 1e-3);
  for (std::size_t i = 0; i + 1 < errors.size(); ++i) EXPECT_LE(errors[i + 1], std::max(errors[i] * errors[i], 1e-12));
}
