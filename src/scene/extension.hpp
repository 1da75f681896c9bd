#pragma once
#include <set>
#include <string>
#include <vector>

#include "scene/document.hpp"
#include "scene/scene.hpp"

/// A run that resumes with more than was asked of it at first: other limits, or more cycles of its last step.
namespace reye::scene {

/// What makes a scene the extension of another one.
struct Extension {
  std::vector<std::string> changes;  ///< in words, "step[1].cycles = 800, was 400"
  std::set<std::string> limits;      ///< names of those that are new, measured otherwise or bound otherwise
  std::string cycles_key;            ///< of the cycles of the last step
};

/// How `now` extends the scene of the text `was`, whose `fixed_sha256` was `was_fixed`. Throws base::InputError with a
/// line per value that may not be another.
Extension extension_of(const std::string& was, const std::string& was_fixed, const Scene& now);

}  // namespace reye::scene
