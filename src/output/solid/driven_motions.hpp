#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/space.hpp"
#include "scene/solid/solid_scene.hpp"

namespace reye::output {

/// A motion that a scene imposes, over the progress of each step, and the columns of the history in which its force
/// stands.
struct DrivenMotion {
  std::string label;    ///< "x of shaker"
  std::string unit;     ///< "mm" | "rad"
  std::string columns;  ///< "<support>_force_", before "x_N" ...
  std::string force_unit;
  base::Vec3 direction = base::Vec3::Zero();  ///< of the motion; the force is its part along it
  struct Played {
    std::string step;
    std::vector<std::array<double, 2>> values;  ///< progress, motion
  };
  std::vector<Played> steps{};
};

/// The imposed motions of supports and the imposed sliding of contacts that change in some step. A history keeps its
/// last factor in the steps that do not play it.
std::vector<DrivenMotion> driven_motions(const scene::SolidScene& scene);

}  // namespace reye::output
