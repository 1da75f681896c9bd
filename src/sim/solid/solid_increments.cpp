#include "sim/solid/solid_increments.hpp"

#include <algorithm>

#include "sim/problem/drive.hpp"

namespace reye::sim {

namespace {

using base::Vec3;

/// The largest turn of a support between two moments of a step [rad].
double most_turned_between(const scene::SolidScene& scene, const scene::Step& step, double from, double to) {
  double most = 0.0;
  for (const auto& support : scene.supports) {
    Vec3 turn = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
      if (support.about[k].drive == body::Drive::moved)
        turn[k] = slid_between(scene.histories, step, support.about[k].parts, from, to, false);
    most = std::max(most, turn.norm());
  }
  return most;
}

}  // namespace

std::vector<double> solid_increment_ends(const scene::SolidScene& scene, const scene::Step& step) {
  return divided_ends(step_corners(scene.histories, step),
                      [&](double from, double to) { return most_turned_between(scene, step, from, to); });
}

double solid_increments_of(const scene::SolidScene& scene, const scene::Step& step) {
  return divided_count(step_corners(scene.histories, step),
                       [&](double from, double to) { return most_turned_between(scene, step, from, to); });
}

}  // namespace reye::sim
