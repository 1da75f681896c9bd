#include "sim/solid/solid_drive.hpp"

#include <Eigen/Geometry>

#include "sim/problem/drive.hpp"

namespace reye::sim {

namespace {

/// The slip that a contact imposes at a place, of the secondary side against the primary.
Vec3 imposed_slip(const contact::ImposedSliding& sliding, double amount, const Vec3& x) {
  if (!sliding.direction.isZero(0.0)) return amount * sliding.direction.normalized();
  return amount * sliding.axis.normalized().cross(x - sliding.point_mm);
}

Points3 imposed(const SolidProblem& problem, const contact::SkinSetup& setup, const solver::SolidState& state,
                const scene::Step& step, double from, double to) {
  Points3 slip(setup.secondary.points.size(), Vec3::Zero());
  for (const auto& sliding : setup.options.sliding) {
    const double amount =
        slid_between(problem.scene.histories, step, sliding.parts, from, to, step.wear || step.cycles > 0.0);
    if (amount == 0.0) continue;
    for (std::size_t j = 0; j < slip.size(); ++j) {
      const auto& point = setup.secondary.points[j];
      slip[j] += imposed_slip(sliding, amount, setup.secondary.skin.x[j] + state.u.segment<3>(3 * point.column));
    }
  }
  return slip;
}

/// Adds what contacts are expected to wear from progress `to` on, where the play is continued: they see it already. Not
/// where points have come to them, since the block is then repeated.
void see_ahead(const SolidCycles& cycles, const std::vector<contact::SkinWear>& wear, double to,
               solver::SolidTarget& target) {
  if (!cycles.continued) return;
  const auto& expected = *cycles.continued->expected;
  auto ahead = expected.after(to, cycles.jump / expected.cycles);
  if (!same_sizes(ahead, removed_volumes(wear))) return;
  for (std::size_t c = 0; c < ahead.size(); ++c) {
    target.wear[c].ahead_secondary = std::move(ahead[c][0]);
    target.wear[c].ahead_primary = std::move(ahead[c][1]);
  }
}

}  // namespace

solver::SolidTarget target_at(const SolidProblem& problem, const solver::SolidSystem& system,
                              const solver::SolidState& state, const std::map<std::string, double>& factors,
                              const scene::Step& step, const SolidCycles& cycles, double from, double to) {
  solver::SolidTarget target;
  target.s = base::Vector::Zero(system.driven());
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const auto& driven = system.driven_values(b);
    for (std::size_t k = 0; k < driven.size(); ++k)
      target.s[system.first_driven[b] + static_cast<int>(k)] = sum_at(driven[k].parts, factors);
  }
  for (const auto& setup : system.contacts) {
    target.friction.push_back(setup.options.friction);
    target.slip.push_back(imposed(problem, setup, state, step, from, to));
    target.wear.push_back({.on = step.wear && setup.options.wear.wears(),
                           .jump = cycles.jump,
                           .duration_s = (to - from) * step.period_s,
                           .cycle = cycles.continued ? cycles.continued->cycle : cycles.cycle});
  }
  see_ahead(cycles, state.wear, to, target);
  return target;
}

}  // namespace reye::sim
