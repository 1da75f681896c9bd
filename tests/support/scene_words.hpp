#pragma once
#include <string>
#include <utility>
#include <vector>

/// Words that scenes of tests have in common.
namespace reye::support {

/// Steel, and bodies of it, each with the words of its mesh.
inline std::string steel_bodies(const std::vector<std::pair<std::string, std::string>>& bodies,
                                const std::string& E_MPa = "200e3") {
  std::string text = "[material.steel]\nE_MPa = " + E_MPa + "\nnu    = 0.3\n";
  for (const auto& [name, mesh] : bodies)
    text += "[body." + name + "]\nmaterial = \"steel\"\nmesh     = { " + mesh + " }\n";
  return text;
}

/// The histories: "press" alone, and a step that plays it in so many increments without wear.
inline std::string press_step(int increments) {
  return R"([history]
press = [[0.0, 0.0], [1.0, 1.0]]
[[step]]
name = "press"
play = ["press"]
increments = )" +
         std::to_string(increments) + "\nwear = false\n";
}

}  // namespace reye::support
