#pragma once
#include "support/solid_hertz.hpp"

/// Two equal balls with nu = 0 under a tangential force that swings between +-q mu P: Cattaneo's and Mindlin's problem,
/// whose solution is exact for them alone.
namespace reye::support {

struct Mindlin {
  double q, mu, a, force, G;

  double stick_radius() const { return a * std::cbrt(1.0 - q); }
  /// 4.8 mu P K {1 - (1-q)^(5/3) - (5 q / 6)(1 + (1-q)^(2/3))} for one cycle, K = (3 mu P / 16 a) (2 (2 - nu) / G).
  double loop() const {
    const double K = 3.0 * mu * force / (16.0 * a) * (4.0 / G);
    return 4.8 * mu * force * K *
           (1.0 - std::pow(1.0 - q, 5.0 / 3.0) - 5.0 * q / 6.0 * (1.0 + std::pow(1.0 - q, 2.0 / 3.0)));
  }
};

inline Mindlin mindlin_of(double q, const HertzCase& c) { return {q, c.mu, c.a_mm, c.force(), 0.5 * c.E_MPa}; }

/// What a run gives beside it.
struct MindlinRun {
  PlayedSolids played;
  Mindlin exact{};
  double stick_radius = 0.0, loop = 0.0;  ///< at the largest force; of one whole cycle [mm; mJ]
};

/// The balls, to be pressed by "press", pushed to one side by "slide" and to the other and back by each "swing".
inline sim::SolidProblem swinging_balls(double q, const HertzCase& c) {
  auto problem = hertz_problem(c, q * c.mu * c.force());
  problem.scene.histories["slide"] = {{0.0, 0.0}, {1.0, 1.0}};
  problem.scene.histories["swing"] = {{0.0, 0.0}, {0.5, -2.0}, {1.0, 0.0}};
  for (auto& input : problem.inputs)
    for (auto& support : input.supports)
      for (auto& motion : support.along)
        if (!motion.parts.empty() && motion.parts.front().history == "slide")
          motion.parts.push_back({motion.parts.front().value, "swing"});
  return problem;
}

/// Presses, slides to the one side and swings once, in `increments`.
inline MindlinRun play_mindlin(double q, const HertzCase& c, int increments) {
  MindlinRun run{{}, mindlin_of(q, c)};
  auto problem = swinging_balls(q, c);
  problem.scene.steps = {step_of(1, {"press"}), step_of(increments / 4, {"slide"}), step_of(increments, {"swing"}, 1)};
  run.played = play(problem);
  if (run.played.summary.status != sim::RunStatus::done) return run;
  const auto& turning = run.played.rows[static_cast<std::size_t>(increments / 4)];
  run.stick_radius = std::sqrt(turning.contacts[0].stick_area_mm2 / c.share() / std::numbers::pi);
  run.loop = *run.played.summary.contacts[0].energy_last_cycle_mJ / c.share();
  return run;
}

}  // namespace reye::support
