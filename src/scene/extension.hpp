#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "scene/document.hpp"
#include "scene/scene.hpp"

/// Extensions of a run beyond its first scene: other limits, or more cycles of its last step.
namespace reye::scene {

/// The differences by which a scene extends another one.
struct Extension {
  std::vector<std::string> changes;  ///< in words, "step[1].cycles = 800, was 400"
  std::set<std::string> limits;      ///< names of those that are new, measured otherwise or bound otherwise
  std::string cycles_key;            ///< of the cycles of the last step
};

/// A scene of any kind as its extension is judged.
struct Written {
  const std::string &text, &fixed_sha256, &path;
  const std::map<std::string, int>& lines;
  double accuracy = 0.0;  ///< by which elements and jumps were chosen; 0: they are the scene's own
};

/// How `now` extends the scene of the text `was`, whose `fixed_sha256` was `was_fixed`. Throws base::InputError with a
/// line per value that may not differ.
Extension extension_of(const std::string& was, const std::string& was_fixed, const Written& now);
Extension extension_of(const std::string& was, const std::string& was_fixed, const Scene& now);

}  // namespace reye::scene
