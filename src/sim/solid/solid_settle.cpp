#include <utility>

#include "sim/solid/solid_drive.hpp"
#include "sim/solid/solid_player.hpp"

/// Equilibria of the player that no increment of a step is.
namespace reye::sim {

/// Solves the state again for a target without wear; a reason where that fails.
std::string SolidPlayer::settle_for(SolidRunState& state, solver::SolidTarget target) const {
  for (auto& wearing : target.wear) wearing.on = false;
  const solver::SolidOptions options{.max_newton = 2 * problem_.scene.max_newton};
  auto solution = solver::solve_increment(system(), state.solution, target, options);
  state.mortar_s += solution.mortar_s;
  state.interface_s += solution.interface_s;
  state.counts.equilibrium_iterations += solution.iterations;
  if (!solution.converged) return solution.reason;
  state.solved = std::move(solution);
  state.solution = state.solved->state;
  return {};
}

std::string SolidPlayer::settle(SolidRunState& state, const scene::Step& step) const {
  fit(state);
  auto why = settle_for(
      state, target_at(problem_, system(), state.solution, state.factors, step, {state.cycle, 1.0}, 1.0, 1.0));
  return why.empty() ? why : "the state cannot be solved on the fresh mesh: " + why;
}

/// Lets bodies settle into the wear that the increments of a continued play see from its start on (`march/block`): the
/// slip of that motion is no cycle's, and counts in none. Where friction alone holds a body its shear follows the
/// motion.
std::string SolidPlayer::settle_ahead(SolidRunState& state, const SolidSpan& span) const {
  if (!span.continued) return {};
  auto target = target_at(problem_, system(), state.solution, state.factors, *span.step,
                          {state.cycle, span.jump, span.continued}, 0.0, 0.0);
  for (auto& wearing : target.wear) wearing.jump = 0.0;
  target.keeps_shear = true;
  if (settle_for(state, target).empty()) return {};
  target.keeps_shear = false;
  return settle_for(state, std::move(target));
}

}  // namespace reye::sim
