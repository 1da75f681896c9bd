#pragma once
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/scars.hpp"
#include "scene/scene.hpp"
#include "scene/solid/solid_scene.hpp"
#include "sim/problem/records.hpp"
#include "sim/study/scar_family.hpp"

/// Runs whose scars are compared with measured ones.
namespace reye::sim {

/// What a run has of all that was measured, after each of its blocks: families of the scars, then of the figures.
struct ScarRun {
  std::vector<ScarFamily> families;
  double cycles = 0.0;
  Counts counts;
  std::optional<double> jump_error;  ///< of its worn depths by the cycle jump, where known
  std::vector<Warning> warnings;
  std::string failure;  ///< why it ended before its time; empty where it did not
};

/// Coefficients of a run over those of the scene; every contact has both factors.
struct WearFactors {
  double secondary = 1.0, primary = 1.0;
};

/// When a run ends before its last cycle.
struct ScarStop {
  std::function<bool(const ScarRun&)> enough;  ///< asked after each block
  std::function<bool()> interrupted{};         ///< asked after each increment; may be empty
};

/// Plays the scene with its wear coefficients times `factors`, in its wearing step for at most so many cycles; 0: for
/// those of the scene. Limits do not end it. Throws what `prepare` throws.
ScarRun play_scars(scene::Scene scene, const scene::MeasuredScars& measured, const WearFactors& factors, double cycles,
                   const ScarStop& stop);
ScarRun play_scars(scene::SolidScene scene, const scene::MeasuredScars& measured, const WearFactors& factors,
                   double cycles, const ScarStop& stop);

}  // namespace reye::sim
