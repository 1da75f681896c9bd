#include "sim/problem/scene_line.hpp"

#include <algorithm>

#include "sim/problem/drive.hpp"

namespace reye::sim {

std::string key_of_step(const std::vector<scene::Step>& steps, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& step : steps)
    if (step.name != overlap_left && std::find(names.begin(), names.end(), step.name) == names.end())
      names.push_back(step.name);
  const auto found = std::find(names.begin(), names.end(), name);
  return "step[" + std::to_string(found - names.begin()) + "]";
}

std::string scene_line(const scene::Scene& scene, const std::string& about) {
  const auto space = about.find(' ');
  if (space == std::string::npos) return {};
  const std::string kind = about.substr(0, space), name = about.substr(space + 1);
  const auto line = scene.lines.find(kind == "step"    ? key_of_step(scene.steps, name)
                                     : kind == "probe" ? "output.probes." + name
                                                       : kind + "." + name);
  return line == scene.lines.end() ? std::string() : scene.path + ":" + std::to_string(line->second) + ": ";
}

}  // namespace reye::sim
