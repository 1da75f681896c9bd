#include "sim/solid/turn_issues.hpp"

#include "base/formatted.hpp"
#include "body/solid/solid_pivot.hpp"
#include "scene/histories.hpp"
#include "sim/problem/scene_line.hpp"
#include "sim/solid/solid_increments.hpp"

namespace reye::sim {

std::vector<base::Issue> turn_issues(const scene::SolidScene& scene, const std::vector<body::SolidInput>& inputs) {
  constexpr double most_rad = 0.05;
  std::vector<base::Issue> issues =
      endless_steps(scene.steps, [&](const scene::Step& step) { return solid_increments_of(scene, step); });
  for (const auto& input : inputs) {
    const std::string keeper = body::solid_keeps_direction(input);
    if (keeper.empty()) continue;
    for (const auto& support : input.supports)
      for (int m = 3; m < body::normal_motion; ++m) {
        const auto& motion = body::motion_of(support, m);
        if (motion.drive != body::Drive::moved) continue;
        const double most = scene::largest_value({scene.histories, scene.steps}, motion.parts);
        if (most > most_rad)
          issues.push_back(
              {"support." + support.name + '.' + body::solid_motion_names[m], "",
               base::formatted("turns by %.4g rad; beside support \"%s\", whose directions do not turn with "
                               "the body, rotations are linear, and 0.05 rad, which stretches by 0.1 %%, is "
                               "the most",
                               most, keeper.c_str())});
      }
  }
  return issues;
}

}  // namespace reye::sim
