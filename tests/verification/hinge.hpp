#pragma once
#include "verification/wear_scene.hpp"

namespace reye::verification {

/// The hinge for a few cycles.
inline std::string hinge(const Replacements& changes) {
  Replacements all{{"cycles     = 1e6", "cycles     = 1e4"},
                   {"{ tolerance = 0.01 }", "5000"},
                   {"per_decade = 5", "every_blocks = 1"}};
  all.insert(all.end(), changes.begin(), changes.end());
  return scene_text("hinge", all);
}

inline const Replacements rigid{{"at       = [0, -7]\nmaterial = \"steel\"", "at    = [0, -7]\nrigid = true"}};

}  // namespace reye::verification
