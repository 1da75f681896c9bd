#include "scene/force_driven.hpp"

#include <algorithm>

namespace reye::scene {

CycleDrives::CycleDrives(const std::vector<Step>& steps) {
  for (const auto& step : steps)
    if (step.wear && step.cycles > 0.0) cycled_.insert(step.play.begin(), step.play.end());
}

void CycleDrives::add(const body::Motion& motion) {
  const auto varies = [&](const base::Part& part) { return cycled_.contains(part.history); };
  if (std::none_of(motion.parts.begin(), motion.parts.end(), varies)) return;
  moved_ = moved_ || ((motion.drive == body::Drive::moved || motion.stiffness > 0.0) && nonzero(motion));
  loaded_ = loaded_ || motion.drive == body::Drive::loaded;
}

bool only_forces_drive(const Scene& scene) {
  CycleDrives drives(scene.steps);
  for (const auto& support : scene.supports)
    for (int m = 0; m < 3; ++m) drives.add(body::motion_of(support, m));
  for (const auto& load : scene.boundary_loads) drives.add_load(load.history);
  for (const auto& load : scene.point_loads) drives.add_load(load.history);
  for (const auto& force : scene.body_forces) drives.add_load(force.history);
  return drives.forces_alone();
}

}  // namespace reye::scene
